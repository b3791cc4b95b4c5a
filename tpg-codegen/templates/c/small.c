{%- let entry = printer.entry() -%}
{%- let prefix = printer.prefix -%}
{%- let upper = printer.upper() -%}
{%- let scalar = printer.scalar() -%}
{%- let lowest = printer.lowest() -%}
/* Runs a program: its results follow one another in the frame, and the last is its bid. */
static {{ scalar }} {{ prefix }}_run({{ scalar }} frame[], uint32_t program)
{
    /* Instructions: operation, then the places of both operands. */
    static const {{ code.kind }} code[{{ code.values.len() }}] = {
{%- for line in code.values.chunks(12) %}
        {{ line.join(", ") }},
{%- endfor %}
    };
    /* Where each program begins, and where the last ends. */
    static const {{ programs.kind }} programs[{{ programs.values.len() }}] = {
{%- for line in programs.values.chunks(12) %}
        {{ line.join(", ") }},
{%- endfor %}
    };
    const uint32_t begin = programs[program];
    const uint32_t end = programs[program + 1U];
    {{ scalar }} result = {% if f64 %}0.0{% else %}0.0f{% endif %};
    uint32_t place;

    for (place = begin; place < end; place++) {
        const {{ code.kind }} instruction = code[place];
        const {{ scalar }} a = frame[instruction & {{ operand_mask }}U];
{%- if two_operands %}
        const {{ scalar }} b = frame[(uint32_t)(instruction >> {{ operand_bits }}) & {{ operand_mask }}U];
{%- endif %}

{% if let [case] = cases.as_slice() %}
        result = {{ case.1 }};
{%- else %}
        switch ((uint32_t)(instruction >> {{ operand_bits * 2 }})) {
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
        frame[({{ first_result }}U + place) - begin] = result;
    }
    return result;
}

{{ entry.head }}
{
    /* The program of each edge, and where it leads: teams are numbered from 0, the root, and the {% if outputs.is_empty() %}actions{% else %}leaves{% endif %} follow them. */
    static const {{ bidders.kind }} bidders[{{ bidders.values.len() }}] = {
{%- for line in bidders.values.chunks(12) %}
        {{ line.join(", ") }},
{%- endfor %}
    };
    static const {{ targets.kind }} targets[{{ targets.values.len() }}] = {
{%- for line in targets.values.chunks(12) %}
        {{ line.join(", ") }},
{%- endfor %}
    };
    /* Where each team's edges begin, and where the last team's end. */
    static const {{ teams.kind }} teams[{{ teams.values.len() }}] = {
{%- for line in teams.values.chunks(12) %}
        {{ line.join(", ") }},
{%- endfor %}
    };
{% if !outputs.is_empty() %}
    /* The program of each output of each leaf. */
    static const {{ leaves.kind }} leaves[{{ leaves.values.len() }}] = {
{%- for line in leaves.values.chunks(12) %}
        {{ line.join(", ") }},
{%- endfor %}
    };
    const {{ leaves.kind }} *programs;
{%- endif %}
{% if !constants.is_empty() %}
    static const {{ scalar }} constants[{{ constants.len() }}] = {
{%- for constant in constants %}
        {{ constant }},
{%- endfor %}
    };
{% endif %}
    {{ scalar }} frame[{{ frame }}];
    uint32_t vertex = 0U;
    uint32_t hop;

    (void)memcpy(frame, state, sizeof(*state));
{%- if !constants.is_empty() %}
    (void)memcpy(&frame[{{ state_length }}], constants, sizeof(constants));
{%- endif %}
{%- if let Some(constant) = minus_infinity %}
    frame[{{ first_result - 1 }}] = {{ constant }};
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
