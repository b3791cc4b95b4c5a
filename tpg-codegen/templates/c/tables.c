{%- for (name, comment, table) in tables %}
{%- if !comment.is_empty() %}
    /* {{ comment }} */
{%- endif %}
    static const {{ table.kind }} {{ name }}[{{ table.values.len() }}] = {
{%- for line in table.values.chunks(12) %}
        {{ line.join(", ") }},
{%- endfor %}
    };
{%- endfor %}
