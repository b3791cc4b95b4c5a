
{{ entry.head }}
{
{%- for variable in variables %}
    {{ scalar }} {{ variable }};
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
{% for (variable, value) in leaf.values %}
            {{ variable }} = {{ value }};
{%- endfor %}
            break;
        }
{%- endfor %}
    }
{%- for assignment in assignments %}
    {{ assignment }}
{%- endfor %}
}
