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

        // An action leads to itself; what fills the array up to a power of two is never come to.
        let next: [{{ vertex }}; {{ size }}] = {{ layout::array(next, 8) }};
        // The longest walk decides {{ depth }} times; a shorter one waits at its action. No loop, and no end to check.
        let vertex = next[0];
{%- for _ in 1..depth %}
        let vertex = next[(vertex & {{ size - 1 }}) as usize];
{%- endfor %}
        ActionId(vertex.wrapping_sub({{ teams.len() }}) as u16)
