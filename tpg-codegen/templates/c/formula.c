{%- let entry = printer.entry() -%}
{{ entry.head }}
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

