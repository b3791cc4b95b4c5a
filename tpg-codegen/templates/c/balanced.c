{%- let entry = printer.entry() -%}
{%- let prefix = printer.prefix -%}
{%- let upper = printer.upper() -%}
{%- let scalar = printer.scalar() -%}
{%- let lowest = printer.lowest() -%}
{% if outputs.is_empty() -%}
{{ entry.head }}
{%- else -%}
static uint32_t {{ prefix }}_leaf(const {{ entry.state }} *state)
{%- endif %}
{
    /* What each edge bids, and where it leads: teams are numbered from 0, the root, and the {% if outputs.is_empty() %}actions{% else %}leaves{% endif %} follow them. */
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
{%- if !places.values.is_empty() %}
    /* The edge's place in its team, which decides ties: cheap bids are computed first. */
    static const {{ places.kind }} places[{{ places.values.len() }}] = {
{%- for line in places.values.chunks(12) %}
        {{ line.join(", ") }},
{%- endfor %}
    };
    /* Where each team leads if no bid wins. */
    static const {{ otherwise.kind }} otherwise[{{ otherwise.values.len() }}] = {
{%- for line in otherwise.values.chunks(12) %}
        {{ line.join(", ") }},
{%- endfor %}
    };
{%- endif %}
    /* Where each team's edges begin, and where the last team's end. */
    static const {{ teams.kind }} teams[{{ teams.values.len() }}] = {
{%- for line in teams.values.chunks(12) %}
        {{ line.join(", ") }},
{%- endfor %}
    };
    uint32_t vertex = 0U;
    uint32_t hop;
{%- if !reads_state %}

    (void)state;
{%- endif %}

    for (hop = 0U; (hop < {{ upper }}_DEPTH) && (vertex < {{ upper }}_TEAMS); hop++) {
        const uint32_t end = teams[vertex + 1U];
        uint32_t edge = teams[vertex];
        {{ scalar }} best = {{ lowest }};
{%- if !places.values.is_empty() %}
        uint32_t leader = 0U;
{%- endif %}

        /* Only bids above minus infinity win; where there is none, the last edge does. */
        vertex = {% if places.values.is_empty() %}targets[end - 1U]{% else %}otherwise[vertex]{% endif %};
        for (; edge < end; edge++) {
            const uint32_t bidder = bidders[edge];
            {{ scalar }} bid;

            switch (bidder) {
{%- for (numbers, bid) in bids %}
{%- if loop.last %}
            default:
{%- else %}
{%- for number in numbers %}
            case {{ number }}U:
{%- endfor %}
{%- endif %}
{%- if bid.before.is_empty() && bid.inside.is_empty() && bid.bound.is_none() %}
                bid = {{ bid.value }};
                break;
{%- else %}
            {
{%- for statement in bid.before %}
                {{ statement }}
{%- endfor %}
{%- if let Some(bound) = bid.bound %}

                if (best > {{ bound }}) {
                    continue; /* it is lower */
                }
{%- endif %}
{%- for statement in bid.inside %}
                {{ statement }}
{%- endfor %}

                bid = {{ bid.value }};
                break;
            }
{%- endif %}
{%- endfor %}
            }
{%- for function in functions %}
            {% if !loop.first %}} else {% endif %}if (bidder >= {{ function.first }}U) {
{%- if let Some(is_low) = function.is_low %}
                if ({{ is_low }}) {
                    continue; /* it is lower */
                }
{%- endif %}
                bid = {{ function.call }};
{%- if loop.last %}
            } else {
                /* it is the bid itself */
            }
{%- endif %}
{%- endfor %}
            if (bid >= best) {
{%- if places.values.is_empty() %}
                best = bid;
                vertex = targets[edge];
{%- else %}
                const uint32_t place = places[edge];

                if ((bid > best) || (place > leader)) {
                    best = bid;
                    leader = place;
                    vertex = targets[edge];
                }
{%- endif %}
            }
        }
    }
    vertex -= {{ upper }}_TEAMS;
{%- if outputs.is_empty() %}
    return ({{ entry.action }})vertex;
{%- else %}
    return vertex;
{%- endif %}
}
{{ over_teams }}
