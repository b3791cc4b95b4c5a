        let ct = ConstantTime::<{{ scalar }}>::default();
{%- for statement in statements %}
        {{ statement }}
{%- endfor %}

        // What is bid, as integers in the same order.
{%- for bid in keys %}
        let {{ bid.name }} = {{ bid.value }}
{%- endfor %}

        // Where each team leads: teams are numbered from 0, the root, and the actions follow them.
{%- for team in teams %}
        // Team {{ team.label }}
        let best = ({{ team.first.key }}, {{ team.first.to }});
{%- for edge in team.others %}
        let best = ct.challenge(best, ({{ edge.key }}, {{ edge.to }}));
{%- endfor %}
        let t{{ loop.index0 }} = best.1{% if vertex != "u32" %} as {{ vertex }}{% endif %};
{%- endfor %}

        // An action leads to itself, and so does what fills the array up to a power of two: it is never come to.
        let next: [{{ vertex }}; {{ size }}] = {{ layout::array(next, 8) }};
        // The longest walk decides {{ depth }} times; a shorter one waits at its action. No loop, and no end to check.
        let vertex = next[0];
{%- for _ in 1..depth %}
        let vertex = next[(vertex & {{ size - 1 }}) as usize];
{%- endfor %}
        ActionId(vertex.wrapping_sub({{ teams.len() }}) as u16)
