{%- let table = printer.table(values) %}
    static const {{ table.kind }} {{ name }}[{{ table.values.len() }}] = {
{%- for line in table.values.chunks(12) %}
        {{ line.join(", ") }},
{%- endfor %}
    };
