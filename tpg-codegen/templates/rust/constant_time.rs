        let ct = ConstantTime::<{{ scalar }}>::default();
{%- for statement in statements %}
        {{ statement }}
{%- endfor %}

        // What is bid, as integers in the same order.
{%- for bid in keys %}
        let {{ bid.name }} = {{ bid.value }}
{%- endfor %}

{% if only %}        // Where the team leads: the number behind the best bid.
{%- else %}        // Where each team leads: teams are numbered from 0, the root, and the actions follow them.
{%- endif %}
{%- for team in teams %}
        // Team {{ team.label }}
{%- if team.edges.len() == 1 %}
        let t{{ team.number }}: {{ vertex }} = {{ team.edges[0].1 }};
{%- else %}
{%- for (key, to) in team.edges %}
{%- if loop.first %}
        let best = ({{ key }}, {% if only %}{{ to - 1 }}{% else %}{{ to }}{% endif %});
{%- else %}
        let best = ct.challenge(best, ({{ key }}, {% if only %}{{ to - 1 }}{% else %}{{ to }}{% endif %}));
{%- endif %}
{%- endfor %}
{%- if !only %}
        let t{{ team.number }} = best.1{% if vertex != "u32" %} as {{ vertex }}{% endif %};
{%- endif %}
{%- endif %}
{%- endfor %}
{% if !only %}
        // An action leads to itself, and so does what fills the array up to a power of two: it is never come to.
        let next: [{{ vertex }}; {{ size }}] = {{ layout::array(next, 8) }};
        // The longest walk decides {{ depth }} times; a shorter one waits at its action. No loop, and no end to check.
        let vertex = next[0];
{%- for _ in 1..depth %}
        let vertex = next[(vertex & {{ size - 1 }}) as usize];
{%- endfor %}
{%- endif %}
        {{ answer }}
