{% for function in functions %}
{%- if functions.len() > 1 %}
/* Some of the teams. */
static void {{ prefix }}_teams_{{ loop.index0 }}(const {{ entry.state }} *state, {{ vertex }} *next)
{
    {{ scalar }} best;
    uint32_t to;{{ function }}
}

{% endif %}
{%- endfor %}
{{ entry.head }}
{
{%- if only %}
{%- else if outputs.is_empty() %}
    {{ vertex }} next[{{ upper }}_TEAMS + {{ upper }}_ACTIONS];
{%- else %}
    {{ vertex }} next[{{ upper }}_TEAMS + {{ ends.len() }}U];
{%- endif %}
{%- if functions.len() == 1 %}
    {{ scalar }} best;
    uint32_t to;
{%- endif %}
{%- if !only %}
    uint32_t vertex;
{%- endif %}
{%- for function in functions %}
{%- if functions.len() == 1 -%}
{{ function }}
{%- else %}
{%- if loop.first %}

    /* What teams of several functions need, each computes. */
{%- endif %}
    {{ prefix }}_teams_{{ loop.index0 }}(state, next);
{%- endif %}
{%- endfor %}
{%- if !only %}

    /* {% if outputs.is_empty() %}An action{% else %}A leaf{% endif %} leads to itself. */
{%- for end in ends %}
    next[{{ end }}] = {{ end }};
{%- endfor %}

    /* The longest walk decides {{ depth }} times; a shorter one waits at its {% if outputs.is_empty() %}action{% else %}leaf{% endif %}. No loop: nothing is left to a compiler. */
    vertex = next[0];
{%- for _ in 1..depth %}
    vertex = next[vertex];
{%- endfor %}
    vertex -= {{ upper }}_TEAMS;
{%- endif %}
{%- if outputs.is_empty() %}
    return ({{ entry.action }}){% if only %}to{% else %}vertex{% endif %};
{%- else %}
    {
        /* Every leaf's values, and the choice among them. */
{%- for statement in statements %}
        {{ statement }}
{%- endfor %}
{%- for leaf in leaves %}
{%- if loop.first %}
{%- for value in leaf.values %}
        {{ scalar }} {{ outputs[loop.index0].variable }} = {{ value }};
{%- endfor %}
{% else %}
{%- for value in leaf.values %}
        {{ outputs[loop.index0].variable }} = {{ prefix }}_pick({% if only %}to{% else %}vertex{% endif %}, {{ leaf.number }}U, {{ value }}, {{ outputs[loop.index0].variable }});
{%- endfor %}
{%- endif %}
{%- endfor %}
{% for assignment in assignments %}
        {{ assignment }}
{%- endfor %}
    }
{%- endif %}
}
