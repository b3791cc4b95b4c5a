{%- for line in banner -%}
//! {{ line }}
{% endfor -%}
#![forbid(unsafe_code)]

{% if let Some(arm) = arm -%}
use tpg_runtime::arm::Move;
use tpg_runtime::observation::Source;
{% endif -%}
{% if let Some(provider) = provider -%}
use tpg_runtime::ops::{self, Maths, {{ provider }}};
{% else -%}
use tpg_runtime::ops;
{% endif -%}
use tpg_runtime::policy::{ActionId, Policy};

/// A tangled program graph: branch-free, the same time for every state.
///
/// It sees, one after another:
{% for source in sources -%}
/// - `s[{{ source.places }}]`: {{ source.name }}, {{ source.unit }}, {{ source.range }}
{% endfor -%}
///
/// Values outside the ranges are legal, NaN and infinities too. It answers:
{% for action in actions -%}
/// - {{ loop.index0 }}: {{ action }}
{% endfor -%}
#[derive(Clone, Copy, Debug, Default)]
pub struct {{ name }};

impl {{ name }} {
    /// Values of a state.
    pub const STATE: usize = {{ state_length }};
    /// Actions.
    pub const ACTIONS: usize = {{ actions.len() }};
    /// Teams on the longest walk.
    pub const DEPTH: usize = {{ depth }};
{%- if let Some(arm) = arm %}
    /// The arm's sources that make up a state, in order.
    pub const SOURCES: [Source; {{ arm.sources.len() }}] = {{ layout::array(arm.sources, 4) }};
    /// What each action moves, in motor ticks.
    pub const MOVES: [Move; {{ arm.moves.len() }}] = {{ layout::array(arm.moves, 4) }};
{%- endif %}
}

impl Policy for {{ name }} {
    type State = [{{ scalar }}; {{ state_length }}];
    type Action = ActionId;

    #[allow(
        clippy::all,
        unused_variables,
        reason = "evolved expressions need not make sense"
    )]
    fn decide(&self, s: &[{{ scalar }}; {{ state_length }}]) -> ActionId {
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
        let mut vertex = 0;
        for _ in 0..Self::DEPTH {
            // An action is past the end: it leads to itself.
            vertex = next.get(usize::from(vertex)).copied().unwrap_or(vertex);
        }
        ActionId(vertex.wrapping_sub({{ teams.len() }}) as u16)
    }
}
