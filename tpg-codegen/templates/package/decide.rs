//! Asks the policy about one state: the middle of every range.

{% if it.memory > 0 -%}
use {{ it.name }}::{{ it.camel }};
{%- else -%}
use {{ it.name }}::{Policy, {{ it.camel }}};
{%- endif %}

fn main() {
{%- if it.memory > 0 %}
    let mut memory = {{ it.camel }}::INITIAL;
    let answer = {{ it.camel }}.infer(&[{{ it.state_rust }}], &mut memory);
{%- else %}
    let answer = {{ it.camel }}.decide(&[{{ it.state_rust }}]);
{%- endif %}
    println!("{answer:?}");
}
