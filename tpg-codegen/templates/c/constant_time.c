{%- let entry = printer.entry() -%}
{%- let prefix = printer.prefix -%}
{%- let upper = printer.upper() -%}
{%- let scalar = printer.scalar() %}
{{ entry.head }}
{
{%- if only %}
{%- else if outputs.is_empty() %}
    {{ vertex }} next[{{ upper }}_TEAMS + {{ upper }}_ACTIONS];
{%- else %}
    {{ vertex }} next[{{ upper }}_TEAMS + {{ ends.len() }}U];
{%- endif %}
    {{ scalar }} best;
    uint32_t to;
{%- if !only %}
    uint32_t vertex;
{%- endif %}
{%- if !reads_state %}

    (void)state;
{%- endif %}
{%- for statement in bids %}
    {{ statement }}
{%- endfor %}
{%- if !keys.is_empty() %}

    /* What is bid, so that it can be compared. */
{%- endif %}
{%- for bid in keys %}
    const {{ scalar }} {{ bid.name }} = {{ prefix }}_number({{ bid.value }});
{%- endfor %}

{% if only %}    /* Where the team leads. */{% else %}    /* Where each team leads: teams are numbered from 0, the root, and the actions follow them. */{% endif %}
{%- for team in teams %}
    /* Team {{ team.label }} */
{%- for (key, to) in team.edges %}
{%- if loop.first %}
{%- if team.edges.len() > 1 %}
    best = {{ key }};
{%- endif %}
    to = {% if only %}{{ to - 1 }}{% else %}{{ to }}{% endif %}U;
{%- else %}
    {{ prefix }}_challenge(&best, &to, {{ key }}, {% if only %}{{ to - 1 }}{% else %}{{ to }}{% endif %}U);
{%- endif %}
{%- endfor %}
{%- if !only %}
    next[{{ team.number }}] = ({{ vertex }})to;
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
