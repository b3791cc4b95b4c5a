/* Instructions: operation, then the places of both operands. */
static const {{ code.kind }} {{ prefix }}_code[{{ code.length }}] = {
{%- for line in code.lines %}
    {{ line }},
{%- endfor %}
};
/* Where each program begins, and where the last ends. */
static const {{ programs.kind }} {{ prefix }}_programs[{{ programs.length }}] = {
{%- for line in programs.lines %}
    {{ line }},
{%- endfor %}
};
/* The program of each edge, and where it leads: teams are numbered from 0, the root, and the actions follow them. */
static const {{ bidders.kind }} {{ prefix }}_bidders[{{ bidders.length }}] = {
{%- for line in bidders.lines %}
    {{ line }},
{%- endfor %}
};
static const {{ targets.kind }} {{ prefix }}_targets[{{ targets.length }}] = {
{%- for line in targets.lines %}
    {{ line }},
{%- endfor %}
};
/* Where each team's edges begin, and where the last team's end. */
static const {{ teams.kind }} {{ prefix }}_teams[{{ teams.length }}] = {
{%- for line in teams.lines %}
    {{ line }},
{%- endfor %}
};
{% if !constants.is_empty() %}
static const {{ scalar }} {{ prefix }}_constants[{{ constants.len() }}] = {
{%- for constant in constants %}
    {{ constant }},
{%- endfor %}
};
{% endif %}
/* Runs a program: its results follow one another in the frame, and the last is its bid. */
static {{ scalar }} {{ prefix }}_run({{ scalar }} frame[], uint32_t program)
{
    const uint32_t begin = {{ prefix }}_programs[program];
    const uint32_t end = {{ prefix }}_programs[program + 1U];
    {{ scalar }} result = {% if f64 %}0.0{% else %}0.0F{% endif %};
    uint32_t place;

    for (place = begin; place < end; place++) {
        const {{ code.kind }} instruction = {{ prefix }}_code[place];
        const {{ scalar }} a = frame[instruction & {{ operand_mask }}U];
        const {{ scalar }} b = frame[(uint32_t)(instruction >> {{ operand_bits }}) & {{ operand_mask }}U];

        switch ((uint32_t)(instruction >> {{ operand_bits * 2 }})) {
{%- for case in cases %}
{%- if loop.last %}
        default:
{%- else %}
        case {{ case.number }}U:
{%- endif %}
            result = {{ case.expression }};
            break;
{%- endfor %}
        }
        frame[({{ first_result }}U + place) - begin] = result;
    }
    return result;
}

uint16_t {{ prefix }}_infer(const {{ prefix }}_state_t *state)
{
    {{ scalar }} frame[{{ frame }}];
    uint32_t vertex = 0U;
    uint32_t hop;

    (void)memcpy(frame, state, sizeof(*state));
{%- if !constants.is_empty() %}
    (void)memcpy(&frame[{{ state_length }}], {{ prefix }}_constants, sizeof({{ prefix }}_constants));
{%- endif %}
    for (hop = 0U; (hop < {{ upper }}_DEPTH) && (vertex < {{ upper }}_TEAMS); hop++) {
        const uint32_t end = {{ prefix }}_teams[vertex + 1U];
        uint32_t edge = {{ prefix }}_teams[vertex];
        {{ scalar }} best = -{{ lowest }};

        /* Only bids above minus infinity win; where there is none, the last edge does. */
        vertex = {{ prefix }}_targets[end - 1U];
        for (; edge < end; edge++) {
            const {{ scalar }} bid = {{ prefix }}_run(frame, {{ prefix }}_bidders[edge]);

            if (bid >= best) {
                best = bid;
                vertex = {{ prefix }}_targets[edge];
            }
        }
    }
    return (uint16_t)(vertex - {{ upper }}_TEAMS);
}
