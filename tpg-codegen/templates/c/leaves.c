{%- let entry = printer.entry() -%}
{%- let prefix = printer.prefix -%}
{%- let scalar = printer.scalar() %}
{{ entry.head }}
{
{%- for output in outputs %}
    {{ scalar }} {{ output.variable }};
{%- endfor %}

    switch ({{ prefix }}_leaf(state)) {
{%- for leaf in leaves %}
{%- if loop.last %}
    default:
{%- else %}
    case {{ leaf.number }}U:
{%- endif %}
        { /* leaf {{ leaf.label }} */
{%- for statement in leaf.statements %}
            {{ statement }}
{%- endfor %}
{% for value in leaf.values %}
            {{ outputs[loop.index0].variable }} = {{ value }};
{%- endfor %}
            break;
        }
{%- endfor %}
    }
{%- for assignment in assignments %}
    {{ assignment }}
{%- endfor %}
}
