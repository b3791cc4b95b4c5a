{%- if leaves.is_empty() %}
        ActionId(walk(s).wrapping_sub({{ teams }}) as u16)
{%- else %}
        let out = match walk(s).wrapping_sub({{ teams }}) {
{%- for (number, label) in leaves %}
            {% if loop.last %}_{% else %}{{ number }}{% endif %} => leaf_{{ label }}(s),
{%- endfor %}
        };
        {{ limited }}
{%- endif %}
