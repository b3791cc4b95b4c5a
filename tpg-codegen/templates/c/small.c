{%- let entry = printer.entry() -%}
{%- let prefix = printer.prefix -%}
{%- let upper = printer.upper() -%}
{%- let scalar = printer.scalar() -%}
{%- let lowest = printer.lowest() -%}
/* Runs a program: its results follow one another in the frame, and the last is its bid. */
static {{ scalar }} {{ prefix }}_run({{ scalar }} frame[], uint32_t program)
{
{%- let tables = of_programs %}
{%- include "c/tables.c" %}
    const uint32_t begin = programs[program];
    const uint32_t end = programs[program + 1U];
    {{ scalar }} result = {% if f64 %}0.0{% else %}0.0f{% endif %};
    uint32_t place;

    for (place = begin; place < end; place++) {
        const {{ instruction }} instruction = code[place];
        const {{ scalar }} a = frame[instruction & {{ operand_mask }}U];
{%- if two_operands %}
        const {{ scalar }} b = frame[(uint32_t)(instruction >> {{ bytecode.operand_bits }}) & {{ operand_mask }}U];
{%- endif %}

{% if let [case] = cases.as_slice() %}
        result = {{ case.1 }};
{%- else %}
        switch ((uint32_t)(instruction >> {{ bytecode.operand_bits * 2 }})) {
{%- for case in cases %}
{%- if loop.last %}
        default:
{%- else %}
        case {{ case.0 }}U:
{%- endif %}
            result = {{ case.1 }};
            break;
{%- endfor %}
        }
{%- endif %}
        frame[({{ bytecode.first_result }}U + place) - begin] = result;
    }
    return result;
}

{{ entry.head }}
{
{%- let tables = of_teams %}
{%- include "c/tables.c" %}
{%- if !outputs.is_empty() %}
    const {{ leaf }} *programs;
{%- endif %}
{% if !constants.is_empty() %}
    static const {{ scalar }} constants[{{ constants.len() }}] = {
{%- for constant in constants %}
        {{ constant }},
{%- endfor %}
    };
{% endif %}
    {{ scalar }} frame[{{ bytecode.frame }}];
    uint32_t vertex = 0U;
    uint32_t hop;

    (void)memcpy(frame, state, sizeof(*state));
{%- if !constants.is_empty() %}
    (void)memcpy(&frame[{{ state_length }}], constants, sizeof(constants));
{%- endif %}
{%- if let Some(constant) = minus_infinity %}
    frame[{{ bytecode.first_result - 1 }}] = {{ constant }};
{%- endif %}
    for (hop = 0U; (hop < {{ upper }}_DEPTH) && (vertex < {{ upper }}_TEAMS); hop++) {
        const uint32_t end = teams[vertex + 1U];
        uint32_t edge = teams[vertex];
        {{ scalar }} best = {{ lowest }};

        /* Only bids above minus infinity win; where there is none, the last edge does. */
        vertex = targets[end - 1U];
        for (; edge < end; edge++) {
            const {{ scalar }} bid = {{ prefix }}_run(frame, bidders[edge]);

            if (bid >= best) {
                best = bid;
                vertex = targets[edge];
            }
        }
    }
    vertex -= {{ upper }}_TEAMS;
{%- if outputs.is_empty() %}
    return ({{ entry.action }})vertex;
{%- else %}
    vertex *= {{ outputs.len() }}U;
    programs = &leaves[vertex];
{%- for assignment in assignments %}
    {{ assignment }}
{%- endfor %}
{%- endif %}
}
