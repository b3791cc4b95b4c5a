{%- let entry = printer.entry() -%}
{%- let prefix = printer.prefix -%}
{%- let upper = printer.upper() -%}
{%- let scalar = printer.scalar() -%}
{%- let lowest = printer.lowest() -%}
/* Runs a program: its results follow one another in the frame, and the last is its bid. */
static {{ scalar }} {{ prefix }}_run({{ scalar }} frame[], uint32_t program)
{
    /* Instructions: operation, then the places of both operands. */
{%- let name = "code" -%}
{%- let values = bytecode.code -%}
{%- include "c/table.c" %}
    /* Where each program begins, and where the last ends. */
{%- let name = "programs" -%}
{%- let values = bytecode.programs -%}
{%- include "c/table.c" %}
    const uint32_t begin = programs[program];
    const uint32_t end = programs[program + 1U];
    {{ scalar }} result = {{ printer.literal(0.0) }};
    uint32_t place;

    for (place = begin; place < end; place++) {
        const {{ printer.table(bytecode.code).kind }} instruction = code[place];
        const {{ scalar }} a = frame[instruction & {{ bytecode.operand_mask() }}U];
{%- if two_operands %}
        const {{ scalar }} b = frame[(uint32_t)(instruction >> {{ bytecode.operand_bits }}) & {{ bytecode.operand_mask() }}U];
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
    /* The program of each edge, and where it leads: teams are numbered from 0, the root, and the {% if outputs.is_empty() %}actions{% else %}leaves{% endif %} follow them. */
{%- let name = "bidders" -%}
{%- let values = bytecode.bidders -%}
{%- include "c/table.c" %}
{%- let name = "targets" -%}
{%- let values = bytecode.targets -%}
{%- include "c/table.c" %}
    /* Where each team's edges begin, and where the last team's end. */
{%- let name = "teams" -%}
{%- let values = bytecode.teams -%}
{%- include "c/table.c" %}
{%- if !outputs.is_empty() %}
    /* The program of each output of each leaf. */
{%- let name = "leaves" -%}
{%- let values = bytecode.leaves -%}
{%- include "c/table.c" %}
    const {{ printer.table(bytecode.leaves).kind }} *programs;
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
    (void)memcpy(&frame[{{ printer.graph.state_length() }}], constants, sizeof(constants));
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
