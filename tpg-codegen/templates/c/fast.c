{% for team in teams %}
{% if !team.late.is_empty() %}
/* What the edge at a place of team {{ team.label }} bids; others than these have been computed. */
static {{ scalar }} {{ prefix }}_bid_{{ team.label }}(const {{ prefix }}_state_t *state, uint32_t edge, {{ scalar }} computed)
{
    {{ scalar }} bid = computed;
{%- if !team.late_reads_state %}

    (void)state;
{%- endif %}

{% for bid in team.late %}    {% if !loop.first %}} else {% endif %}if (edge == {{ bid.rank }}) {
{%- for statement in bid.statements %}
        {{ statement }}
{%- endfor %}

        bid = {{ bid.value }};
{% endfor %}    } else {
        /* it has been computed */
    }
    return bid;
}

{% endif %}
static uint32_t {{ prefix }}_team_{{ team.label }}(const {{ prefix }}_state_t *state)
{
{%- if let Some(next) = team.next %}
    static const {{ vertex }} next[{{ next.len() }}] = { {{ next.join(", ") }} };
{%- endif %}
    {{ scalar }} best = -{{ lowest }};
    uint32_t {{ team.winner }} = {{ team.nobody }};
{%- if !team.reads_state %}

    (void)state;
{%- endif %}
{%- for bid in team.eager %}
{%- for statement in bid.statements %}
    {{ statement }}
{%- endfor %}
    {{ team.winner }} = ({{ bid.value }} >= best) ? {{ bid.rank }} : {{ team.winner }};
{%- if !bid.last %}
    best = ({{ bid.value }} > best) ? {{ bid.value }} : best;
{%- endif %}
{%- endfor %}
{%- for bid in team.lazy %}
{%- for statement in bid.bound_statements %}
    {{ statement }}
{%- endfor %}
{%- if let Some((low, high)) = bid.ends %}
{%- if bid.first && !bid.last %}
    {{ scalar }} top = best; /* who leads bids from best to this */
{%- endif %}
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
{%- endfor %}
    return {% if team.next.is_some() %}next[edge]{% else %}vertex{% endif %};
}
{% endfor %}
{{ walk }}
