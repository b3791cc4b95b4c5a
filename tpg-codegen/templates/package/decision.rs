use {{ it.name }}::{Policy, {{ it.camel }}};
{% if it.memory > 0 %}
let mut memory = {{ it.camel }}::INITIAL; // once an episode
let answer = {{ it.camel }}.infer(&[{{ it.state_rust }}], &mut memory);
{%- else %}
let answer = {{ it.camel }}.decide(&[{{ it.state_rust }}]); // the middle of every range
{%- endif %}
