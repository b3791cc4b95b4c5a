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
{%- let name = "bidders" -%}
{%- let values = cases.bidders -%}
{%- include "c/table.c" %}
{%- let name = "targets" -%}
{%- let values = cases.targets -%}
{%- include "c/table.c" %}
{%- if !cases.places.is_empty() %}
    /* The edge's place in its team, which decides ties: cheap bids are computed first. */
{%- let name = "places" -%}
{%- let values = cases.places -%}
{%- include "c/table.c" %}
    /* Where each team leads if no bid wins. */
{%- let name = "otherwise" -%}
{%- let values = cases.otherwise -%}
{%- include "c/table.c" %}
{%- endif %}
    /* Where each team's edges begin, and where the last team's end. */
{%- let name = "teams" -%}
{%- let values = cases.teams -%}
{%- include "c/table.c" %}
    uint32_t vertex = 0U;
    uint32_t hop;
{%- if !reads_state %}

    (void)state;
{%- endif %}

    for (hop = 0U; (hop < {{ upper }}_DEPTH) && (vertex < {{ upper }}_TEAMS); hop++) {
        const uint32_t end = teams[vertex + 1U];
        uint32_t edge = teams[vertex];
        {{ scalar }} best = {{ lowest }};
{%- if !cases.places.is_empty() %}
        uint32_t leader = 0U;
{%- endif %}

        /* Only bids above minus infinity win; where there is none, the last edge does. */
        vertex = {% if cases.places.is_empty() %}targets[end - 1U]{% else %}otherwise[vertex]{% endif %};
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
{%- if cases.places.is_empty() %}
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
