{{ helpers }}
{%- for team in teams %}

/// Where team {{ team.label }} leads.
fn team_{{ team.label }}(s: &[{{ scalar }}; {{ state_length }}]) -> {{ vertex }} {
    let mut best = {{ scalar }}::MIN;
    let mut {{ team.winner }} = {{ team.nobody }};
{%- for bid in team.eager %}
{%- for statement in bid.statements %}
    {{ statement }}
{%- endfor %}
    if {{ bid.wins }} {
        {{ team.winner }} = {{ bid.rank }};
    }
    if {{ bid.value }} > best {
        best = {{ bid.value }};
    }
{%- endfor %}
{%- for bid in team.lazy %}
{%- for statement in bid.bound_statements %}
    {{ statement }}
{%- endfor %}
{%- if let Some(guard) = bid.guard %}
    if {{ guard }} {
{%- for statement in bid.statements %}
        {{ statement }}
{%- endfor %}
        if {{ bid.wins }} {
            {{ team.winner }} = {{ bid.rank }};
        }
        if {{ bid.value }} > best {
            best = {{ bid.value }};
        }
    }
{%- else %}
{%- for statement in bid.statements %}
    {{ statement }}
{%- endfor %}
    if {{ bid.wins }} {
        {{ team.winner }} = {{ bid.rank }};
    }
    if {{ bid.value }} > best {
        best = {{ bid.value }};
    }
{%- endif %}
{%- endfor %}
{%- if let Some((places, last)) = team.next %}
    match edge {
{%- for (place, to) in places %}
        {{ place }} => {{ to }},
{%- endfor %}
        _ => {{ last }},
    }
{%- else %}
    vertex
{%- endif %}
}
{%- endfor %}
