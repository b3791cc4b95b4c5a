{%- if !reads_state %}

    (void)state;
{%- endif %}
{%- for statement in statements %}
    {{ statement }}
{%- endfor %}

    /* What is bid, as integers in the same order. */
{%- for bid in keys %}
    const {{ key }} {{ bid.name }} = {{ prefix }}_key({{ bid.value }});
{%- endfor %}

    /* Where each team leads: teams are numbered from 0, the root, and the actions follow them. */
{%- for team in teams %}
    /* Team {{ team.label }} */
{%- for edge in team.edges %}
{%- if loop.first %}
{%- if team.edges.len() > 1 %}
    best = {{ edge.key }};
{%- endif %}
    to = {{ edge.to }}U;
{%- else %}
    {{ prefix }}_challenge(&best, &to, {{ edge.key }}, {{ edge.to }}U);
{%- endif %}
{%- endfor %}
    next[{{ team.number }}] = ({{ vertex }})to;
{%- endfor %}
