{% for team in teams %}
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
    {% if let Some(guard) = bid.guard %}if ({{ guard }}) {% endif %}{
{%- for statement in bid.statements %}
        {{ statement }}
{%- endfor %}
        if ({{ bid.wins }}) {
{%- if !bid.last %}
            best = {{ bid.value }};
{%- endif %}
            {{ team.winner }} = {{ bid.rank }};
        }
    }
{%- endfor %}
    return {% if team.next.is_some() %}next[edge]{% else %}vertex{% endif %};
}
{% endfor %}
{{ walk }}
