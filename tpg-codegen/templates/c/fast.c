{{ leading }}
{% for late in late %}
/* What the edge at a place of team {{ late.label }} bids; others than these have been computed. */
static {{ scalar }} {{ prefix }}_bid_{{ late.label }}(const {{ entry.state }} *state, uint32_t edge, {{ scalar }} computed)
{
    {{ scalar }} bid = computed;
{%- if !late.reads_state %}

    (void)state;
{%- endif %}

{% for bid in late.bids %}    {% if !loop.first %}} else {% endif %}if (edge == {{ bid.rank }}) {
{%- for statement in bid.statements %}
        {{ statement }}
{%- endfor %}

        bid = {{ bid.value }};
{% endfor %}    } else {
        /* it has been computed */
    }
    return bid;
}
{% endfor %}
{% if functions.len() > 1 %}
/* Teams are numbered so that every one comes after all that lead to it; the actions follow them. */
{% else %}
/* Teams in an order in which every one comes after all that lead to it: control only goes forward. */
{% endif %}
{% for function in functions %}
{% if functions.len() > 1 -%}
static uint32_t {{ prefix }}_walk_{{ loop.index0 }}(const {{ entry.state }} *state, uint32_t start)
{%- else -%}
{{ entry.head }}
{%- endif %}
{
{%- if leaves.is_empty() %}
    uint32_t vertex;
{%- else %}
{%- for output in outputs %}
    {{ scalar }} {{ output.variable() }};
{%- endfor %}
{%- endif %}
{%- for value in function.shared %}
    {{ scalar }} {{ value }};
{%- endfor %}
{%- if !function.reads_state %}

    (void)state;
{%- endif %}
{% if !function.entries.is_empty() %}
{% for entry in function.entries %}    {% if !loop.first %}} else {% endif %}if (start == {{ entry.number }}) {
        goto team_{{ entry.label }};
{% endfor %}    } else {
        /* never: every team that may be asked for has a number */
    }
{% endif %}
{% for team in function.teams %}
{%- if team.is_entered %}
team_{{ team.label }}:
{%- endif %}
    {
{%- if team.ways.len() > 1 && team.is_compact %}
{% include "c/fast_team.c" %}
{%- else if team.ways.len() > 1 %}
{%- if let Some(first) = team.first %}
{%- for statement in first.statements %}
        {{ statement }}
{%- endfor %}
        {{ scalar }} best = {{ first.value }};
        uint32_t {{ team.winner }} = {{ first.rank }};
{%- else %}
        {{ scalar }} best = -{{ lowest }};
        uint32_t {{ team.winner }} = {{ team.nobody }};
{%- endif %}
{%- if let Some(infinite) = team.infinite %}
{%- for statement in infinite.statements %}
        {{ statement }}
{%- endfor %}

        if ({{ infinite.condition }}) {
            best = {{ infinity }};
            edge = {{ infinite.rank }};
        }
{%- endif %}
{%- for bid in team.eager %}
{%- for statement in bid.statements %}
        {{ statement }}
{%- endfor %}

        if ({{ bid.value }} >= best) {
{%- if !bid.last %}
            best = {{ bid.value }};
{%- endif %}
            {{ team.winner }} = {{ bid.rank }};
        }
{%- endfor %}
{%- if !team.eager_before.is_empty() %}

        if (best < {{ infinity }}) {
{%- for bid in team.eager_before %}
{%- for statement in bid.statements %}
            {{ statement }}
{%- endfor %}

            if ({{ bid.value }} >= best) {
{%- if bid.ascending %}
                best = {{ bid.value }};
                {{ team.winner }} = {{ bid.rank }};
{%- else %}
                if (({{ bid.value }} > best) || (edge < {{ bid.rank }})) {
                    best = {{ bid.value }};
                    edge = {{ bid.rank }};
                }
{%- endif %}
            }
{%- endfor %}
        }
{%- endif %}
{%- for bid in team.lazy %}
{%- for statement in bid.before %}
        {{ statement }}
{%- endfor %}
{%- if bid.first && !bid.last %}
        {{ scalar }} top = best; /* who leads bids from best to this */
{%- endif %}
{%- if let Some(considered) = bid.considered %}

        if ({{ considered }}) {
{%- endif %}
{%- for statement in bid.bound_statements %}
        {{ statement }}
{%- endfor %}
{%- if let Some((low, high)) = bid.ends %}

        if ({% if let Some(guard) = bid.guard %}{{ guard }}{% endif %}) {
            if ({{ bid.sure }}) {
{%- if !bid.last %}
                best = {{ low }};
                top = {{ high }};
{%- endif %}
                {{ team.winner }} = {{ bid.rank }};
            } else {
                const {{ scalar }} bid = {{ prefix }}_bid_{{ team.label }}(state, {{ bid.rank }}, best);
{%- if bid.pending %}
                const {{ scalar }} lead = {{ prefix }}_bid_{{ team.label }}(state, {{ team.winner }}, best);
{%- if !bid.last %}

                best = lead;
{%- endif %}
{%- endif %}

                if ({{ bid.wins }}) {
{%- if !bid.last %}
                    best = bid;
{%- endif %}
                    {{ team.winner }} = {{ bid.rank }};
                }
{%- if !bid.last %}
                top = best;
{%- endif %}
            }
        }
{%- else %}

        {% if let Some(guard) = bid.guard %}if ({{ guard }}) {% endif %}{
{%- for statement in bid.statements %}
            {{ statement }}
{%- endfor %}
{%- if bid.pending %}

            if ({{ bid.top }} > best) {
                best = {{ prefix }}_bid_{{ team.label }}(state, {{ team.winner }}, best);
            }
{%- endif %}
            if ({{ bid.wins }}) {
{%- if !bid.last %}
                best = {{ bid.value }};
{%- endif %}
                {{ team.winner }} = {{ bid.rank }};
            }
{%- if bid.pending && !bid.last %}
            top = best;
{%- endif %}
        }
{%- endif %}
{%- if bid.considered.is_some() %}
        }
{%- endif %}
{%- endfor %}
{%- endif %}
{%- if team.ways.len() > 1 %}

{% for way in team.ways %}        {% if !loop.last %}{% if !loop.first %}} else {% endif %}if ({{ way.condition }}) {{ "{" }}{% else %}} else {{ "{" }}{% endif %}
{%- if let Some(vertex) = way.vertex %}
            vertex = {{ vertex }};
{%- endif %}
            goto {{ way.label }};
{% endfor %}        }
{%- else %}
{%- for way in team.ways %}
{%- if let Some(vertex) = way.vertex %}
        vertex = {{ vertex }};
{%- endif %}
        goto {{ way.label }};
{%- endfor %}
{%- endif %}
    }
{% endfor %}
{% if leaves.is_empty() %}
decided:
    return {% if functions.len() > 1 %}vertex{% else %}(uint16_t)vertex{% endif %};
{%- else %}
{% for leaf in leaves %}
leaf_{{ leaf.label }}:
    {
{%- for statement in leaf.statements %}
        {{ statement }}
{%- endfor %}
{% for (variable, value) in leaf.values %}
        {{ variable }} = {{ value }};
{%- endfor %}
    }
{%- if !loop.last %}
    goto answered;
{% endif %}
{% endfor %}
{%- if leaves.len() > 1 %}
answered:
{%- endif %}
{%- for assignment in assignments %}
    {{ assignment }}
{%- endfor %}
{%- endif %}
}
{% endfor %}
{% if functions.len() > 1 %}
{% if outputs.is_empty() -%}
{{ entry.head }}
{%- else -%}
static uint32_t {{ prefix }}_leaf(const {{ entry.state }} *state)
{%- endif %}
{
    uint32_t vertex = {{ prefix }}_walk_0(state, 0U);
{% for function in functions %}
{%- if !loop.first %}
    if (vertex < {{ function.end }}U) {
        vertex = {{ prefix }}_walk_{{ loop.index0 }}(state, vertex);
    }
{%- endif %}
{%- endfor %}
    vertex -= {{ upper }}_TEAMS;
{%- if outputs.is_empty() %}
    return (uint16_t)vertex;
{%- else %}
    return vertex;
{%- endif %}
}
{{ over_functions }}
{% endif %}
