{% if groups.len() > 1 %}
{% for group in groups %}
static uint32_t {{ prefix }}_walk_{{ loop.index0 }}(uint32_t vertex)
{
    uint32_t next;

    switch (vertex) {
{%- for team in group %}
    case {{ team.vertex }}U:
        next = {{ prefix }}_team_{{ team.label }}();
        break;
{%- endfor %}
    default:
        next = {{ upper }}_TEAMS; /* never: every team has its case */
        break;
    }
    return next;
}
{% endfor %}
{% endif %}
/* Teams are numbered from 0, which is the root; the actions follow them. */
int inferenceTPG(void)
{
    uint32_t vertex = 0U;
    uint32_t hop;

    for (hop = 0U; (hop < {{ upper }}_DEPTH) && (vertex < {{ upper }}_TEAMS); hop++) {
{%- if groups.len() > 1 %}
        switch (vertex / {{ group_size }}U) {
{%- for group in groups %}
        case {{ loop.index0 }}U:
            vertex = {{ prefix }}_walk_{{ loop.index0 }}(vertex);
            break;
{%- endfor %}
{%- else %}
        switch (vertex) {
{%- for group in groups %}
{%- for team in group %}
        case {{ team.vertex }}U:
            vertex = {{ prefix }}_team_{{ team.label }}();
            break;
{%- endfor %}
{%- endfor %}
{%- endif %}
        default:
            vertex = {{ upper }}_TEAMS; /* never: every team has its case */
            break;
        }
    }
    vertex -= {{ upper }}_TEAMS;
    return (int)vertex;
}
