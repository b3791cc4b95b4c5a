const {{ it.name }}_state_t state = { {{ it.state_c }} }; /* the middle of every range */
{%- if it.memory > 0 %}
{{ it.name }}_memory_t memory;
{%- endif %}
{%- if !it.outputs.is_empty() %}
{{ it.name }}_action_t action;
{%- endif %}
{% if it.memory > 0 %}
{{ it.name }}_reset(&memory); /* once an episode */
{%- endif %}
{%- if it.outputs.is_empty() %}
const {{ it.name }}_action_t action = {{ it.name }}_infer(&state);
{%- else %}
{{ it.name }}_infer(&state{% if it.memory > 0 %}, &memory{% endif %}, &action);
{%- endif %}
