{%- if !reads_state %}

    (void)state;
{%- endif %}
{%- for statement in statements %}
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
{%- for edge in team.edges %}
{%- if loop.first %}
{%- if team.edges.len() > 1 %}
    best = {{ edge.key }};
{%- endif %}
    to = {% if only %}{{ edge.to - 1 }}{% else %}{{ edge.to }}{% endif %}U;
{%- else %}
    {{ prefix }}_challenge(&best, &to, {{ edge.key }}, {% if only %}{{ edge.to - 1 }}{% else %}{{ edge.to }}{% endif %}U);
{%- endif %}
{%- endfor %}
{%- if !only %}
    next[{{ team.number }}] = ({{ vertex }})to;
{%- endif %}
{%- endfor %}
