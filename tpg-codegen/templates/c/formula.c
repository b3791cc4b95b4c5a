void {{ prefix }}_infer(const {{ prefix }}_state_t *state, {{ prefix }}_action_t *action)
{
{%- for statement in statements %}
    {{ statement }}
{%- endfor %}
{%- if !reads_state %}

    (void)state;
{%- endif %}
{% for (name, value) in answers %}
    action->{{ name }} = {{ value }};
{%- endfor %}
}
