{%- let scalar = printer.scalar() -%}
{%- let state_length = printer.graph.state_length() %}

/// The bid of each edge.
{%- let name = "BIDDERS" -%}
{%- let values = cases.bidders -%}
{% include "rust/table.rs" %}

/// Where each edge leads: teams from 0, the root; the actions follow.
{%- let name = "TARGETS" -%}
{%- let values = cases.targets -%}
{% include "rust/table.rs" %}

/// Where each team's edges begin, and where the last team's end.
{%- let name = "TEAMS" -%}
{%- let values = cases.teams -%}
{% include "rust/table.rs" %}
{% if !cases.places.is_empty() %}
/// The place of each edge in its team, which decides ties.
{%- let name = "PLACES" -%}
{%- let values = cases.places -%}
{% include "rust/table.rs" %}

/// Where each team leads if no bid wins.
{%- let name = "OTHERWISE" -%}
{%- let values = cases.otherwise -%}
{% include "rust/table.rs" %}
{% endif %}
{% include "rust/span.rs" %}

/// Goes from the root to the vertex where the walk ends.
fn walk(s: &[{{ scalar }}; {{ state_length }}]) -> usize {
let mut vertex = 0;
for _ in 0..{{ depth }} {
let edges = span(&TEAMS, vertex);
let bidders = BIDDERS.get(edges.clone()).unwrap_or(&[]);
{%- if !cases.places.is_empty() %}
let places = PLACES.get(edges.clone()).unwrap_or(&[]);
let targets = TARGETS.get(edges).unwrap_or(&[]);
let Some(&last) = OTHERWISE.get(vertex) else {
break;
};
// Only bids above minus infinity win; where there is none, the last edge does.
let mut best = {{ scalar }}::MIN;
let (mut winner, mut leader) = (last, 0);
for ((&bidder, &place), &target) in bidders.iter().zip(places).zip(targets) {
{%- else %}
let targets = TARGETS.get(edges).unwrap_or(&[]);
let Some(&last) = targets.last() else {
break;
};
// Only bids above minus infinity win; where there is none, the last edge does.
let mut best = {{ scalar }}::MIN;
let mut winner = last;
for (&bidder, &target) in bidders.iter().zip(targets) {
{%- endif %}
let bid = match bidder {
{%- for bid in bids %}
{%- if bid.before.is_empty() && bid.inside.is_empty() && bid.bound.is_none() %}
{% if loop.last %}_{% else %}{{ loop.index0 }}{% endif %} => {{ bid.value }},
{%- else %}
{% if loop.last %}_{% else %}{{ loop.index0 }}{% endif %} => {
{%- for statement in bid.before %}
{{ statement }}
{%- endfor %}
{%- if let Some(bound) = bid.bound %}
if best > {{ bound }} {
continue;
}
{%- endif %}
{%- for statement in bid.inside %}
{{ statement }}
{%- endfor %}
{{ bid.value }}
}
{%- endif %}
{%- endfor %}
};
{%- for function in functions %}
{% if loop.first %}let bid = {% else %}} else {% endif %}if bidder >= {{ function.first }} {
{%- if let Some(is_low) = function.is_low %}
if {{ is_low }} {
continue;
}
{%- endif %}
{{ function.call }}
{%- if loop.last %}
} else {
bid
};
{%- endif %}
{%- endfor %}
// Unknown to LLVM, which takes `if v > 0 { v } else { 0 }` of a `v = max(0, x)` for v: it is not where x is NaN.
let bid = core::hint::black_box(bid);
{%- if !cases.places.is_empty() %}
if bid >= best && (bid > best || place > leader) {
best = bid;
leader = place;
winner = target;
}
{%- else %}
if bid >= best {
best = bid;
winner = target;
}
{%- endif %}
}
vertex = winner as usize;
}
vertex
}
{% for leaf in leaves %}

/// What leaf {{ leaf.label }} answers, before it is limited.
fn leaf_{{ leaf.label }}(s: &[{{ scalar }}; {{ state_length }}]) -> [{{ scalar }}; {{ outputs }}] {
{%- for statement in leaf.statements %}
{{ statement }}
{%- endfor %}
{{ layout::array(leaf.values, 4) }}
}
{%- endfor %}
