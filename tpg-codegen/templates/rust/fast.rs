{% for leaf in leaves %}

/// What leaf {{ leaf.label }} answers, before it is limited.
fn leaf_{{ leaf.label }}(s: &[{{ scalar }}; {{ state_length }}]) -> {{ answer }} {
{%- for statement in leaf.statements %}
{{ statement }}
{%- endfor %}
{{ layout::array(leaf.values, 4) }}
}
{%- endfor %}
{% for team in teams %}

/// What team {{ team.label }} decides.
{%- if many %}
#[inline(never)]
{%- endif %}
fn team_{{ team.label }}(s: &[{{ scalar }}; {{ state_length }}]) -> {{ answer }} {
{%- if let Some(first) = team.first %}
{%- for statement in first.statements %}
{{ statement }}
{%- endfor %}
{%- endif %}
{%- match team.decision %}
{%- when TeamDecision::Winner | TeamDecision::Ways(_) %}
{%- if let Some(first) = team.first %}
{%- if leads %}
let mut lead = Lead::new({{ first.value }}, {{ first.rank }});
{%- else %}
let mut best = {{ first.value }};
let mut {{ team.winner }} = {{ first.rank }};
{%- endif %}
{%- else if leads %}
let mut lead = Lead::new({{ scalar }}::MIN, {{ team.initial }});
{%- else %}
let mut best = {{ scalar }}::MIN;
let mut {{ team.winner }} = {{ team.initial }};
{%- endif %}
{%- when _ %}
{%- endmatch %}
{%- for bid in team.eager %}
{%- for statement in bid.statements %}
{{ statement }}
{%- endfor %}
{%- match team.decision %}
{%- when TeamDecision::Winner | TeamDecision::Ways(_) %}
{% include "rust/fast_win.rs" %}
{%- when _ %}
{%- endmatch %}
{%- endfor %}
{%- for bid in team.lazy %}
{%- for statement in bid.before %}
{{ statement }}
{%- endfor %}
{%- if let Some(considered) = bid.considered %}
if {{ considered }} {
{%- endif %}
{%- for statement in bid.bound %}
{{ statement }}
{%- endfor %}
{%- if let Some(guard) = bid.guard %}
if {{ guard }} {
{%- endif %}
{%- for statement in bid.statements %}
{{ statement }}
{%- endfor %}
{% include "rust/fast_win.rs" %}
{%- if bid.guard.is_some() %}
}
{%- endif %}
{%- if bid.considered.is_some() %}
}
{%- endif %}
{%- endfor %}
{%- match team.decision %}
{%- when TeamDecision::Always(to) %}
{{ to }}
{%- when TeamDecision::Either(condition, first, second) %}
{{ layout::either(condition, first, second) }}
{%- when TeamDecision::Winner %}
{{ team.winner }}
{%- when TeamDecision::Ways(ways) %}
match {{ team.winner }} {
{%- for (ranks, to) in ways %}
{%- if loop.last %}
_ => {{ to }},
{%- else %}
{%- for rank in ranks %}
{{ rank }} => {{ to }},
{%- endfor %}
{%- endif %}
{%- endfor %}
}
{%- endmatch %}
}
{%- endfor %}
