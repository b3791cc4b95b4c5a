{%- let prefix = printer.prefix -%}
{%- let upper = printer.upper() -%}
{%- let scalar = printer.scalar() -%}
{% for program in programs %}
static {{ scalar }} {{ prefix }}_program_{{ program.label }}(void)
{
{%- for statement in program.statements %}
    {{ statement }}
{%- endfor %}
    return {{ program.result }};
}
{% endfor %}
/* A bid as teams compare it: a NaN counts as minus infinity. */
static {{ scalar }} {{ prefix }}_bid({{ scalar }} value)
{
    return (isnan(value) != 0) ? ({{ scalar }})(-INFINITY) : value;
}

/* The place of the highest bid, of equal ones the last. */
static uint32_t {{ prefix }}_highest(const {{ scalar }} bids[], uint32_t count)
{
    uint32_t best = 0U;
    {{ scalar }} highest = {{ prefix }}_bid(bids[0]);
    uint32_t edge;

    for (edge = 1U; edge < count; edge++) {
        const {{ scalar }} challenger = {{ prefix }}_bid(bids[edge]);

        if (challenger >= highest) {
            best = edge;
            highest = challenger;
        }
    }
    return best;
}
{% for team in module.teams %}
static uint32_t {{ prefix }}_team_{{ team.label }}(void)
{
    static const {{ vertex }} next[{{ team.edges.len() }}] = { {% for edge in team.edges %}{% if !loop.first %}, {% endif %}{{ module.vertex(*edge.to) }}U{% endfor %} };
    {{ scalar }} bids[{{ team.edges.len() }}];
{% for edge in team.edges %}
    bids[{{ loop.index0 }}] = {{ prefix }}_program_{{ module.bidders[edge.bidder].label }}();
{%- endfor %}
    return next[{{ prefix }}_highest(bids, {{ team.edges.len() }}U)];
}
{% endfor %}

/* Teams are numbered from 0, which is the root; the actions follow them. */
int inferenceTPG(void)
{
    uint32_t vertex = 0U;
    uint32_t hop;

    for (hop = 0U; (hop < {{ upper }}_DEPTH) && (vertex < {{ upper }}_TEAMS); hop++) {
        switch (vertex) {
{%- for team in module.teams %}
        case {{ loop.index0 }}U:
            vertex = {{ prefix }}_team_{{ team.label }}();
            break;
{%- endfor %}
        default:
            vertex = {{ upper }}_TEAMS; /* never: every team has its case */
            break;
        }
    }
    vertex -= {{ upper }}_TEAMS;
    return (int)vertex;
}
