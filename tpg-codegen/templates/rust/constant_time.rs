{%- for statement in statements %}
        {{ statement }}
{%- endfor %}

        // Where each team leads: teams are numbered from 0, the root, and the actions follow them.
{%- for team in teams %}
        // Team {{ team.label }}
        let best = (ops::bid({{ team.first.bid }}), {{ team.first.to }}_{{ vertex }});
{%- for edge in team.others %}
        let best = ops::challenge(best, (ops::bid({{ edge.bid }}), {{ edge.to }}));
{%- endfor %}
        let t{{ loop.index0 }} = best.1;
{%- endfor %}
        let next = {{ layout::array(next, 8) }};
        let mut vertex = 0_{{ vertex }};
        for _ in 0..Self::DEPTH {
            // An action is past the end: it leads to itself.
            vertex = next.get(vertex as usize).copied().unwrap_or(vertex);
        }
        ActionId(vertex.wrapping_sub({{ teams.len() }}) as u16)
