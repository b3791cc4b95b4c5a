{%- let table = printer.table(values) %}
const {{ name }}: [{{ table.kind }}; {{ table.values.len() }}] = {{ layout::array(table.values, 0) }};
