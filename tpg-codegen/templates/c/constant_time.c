uint16_t {{ prefix }}_infer(const {{ prefix }}_state_t *state)
{
    {{ vertex }} next[{{ upper }}_TEAMS + {{ upper }}_ACTIONS];
    {{ key }} best;
    uint32_t to;
    uint32_t vertex;
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
    best = {{ edge.key }};
    to = {{ edge.to }};
{%- else %}
    {{ prefix }}_challenge(&best, &to, {{ edge.key }}, {{ edge.to }});
{%- endif %}
{%- endfor %}
    next[{{ loop.index0 }}] = ({{ vertex }})to;
{%- endfor %}

    /* An action leads to itself. */
{%- for action in actions %}
    next[{{ action }}] = {{ action }};
{%- endfor %}

    /* The longest walk decides {{ depth }} times; a shorter one waits at its action. No loop: nothing is left to a compiler. */
    vertex = next[0];
{%- for _ in 1..depth %}
    vertex = next[vertex];
{%- endfor %}
    vertex -= {{ upper }}_TEAMS;
    return (uint16_t)vertex;
}
