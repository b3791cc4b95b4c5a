{% for function in functions %}
{%- if functions.len() > 1 %}
/* Some of the teams. */
static void {{ prefix }}_teams_{{ loop.index0 }}(const {{ prefix }}_state_t *state, {{ vertex }} *next)
{
    {{ key }} best;
    uint32_t to;{{ function }}
}

{% endif %}
{%- endfor %}
uint16_t {{ prefix }}_infer(const {{ prefix }}_state_t *state)
{
    {{ vertex }} next[{{ upper }}_TEAMS + {{ upper }}_ACTIONS];
{%- if functions.len() == 1 %}
    {{ key }} best;
    uint32_t to;
{%- endif %}
    uint32_t vertex;
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
