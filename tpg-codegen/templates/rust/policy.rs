{%- for line in banner -%}
//! {{ line }}
{% endfor -%}
#![forbid(unsafe_code)]
#![allow(
    clippy::all,
    unused_variables,
    unused_assignments,
    reason = "evolved expressions need not make sense"
)]

{% for import in imports -%}
use tpg_runtime::{{ import }};
{% endfor -%}
use tpg_runtime::policy::{% if outputs.is_empty() %}{ActionId, Policy}{% else %}Policy{% endif %};

/// A tangled program graph: {{ title }}.
///
/// It sees, one after another:
{% for source in sources -%}
/// - `s[{{ source.first }}..{{ source.end }}]`: {{ source.name }}, {{ source.meaning }}
{% endfor -%}
///
{% if integers -%}
/// Every value is legal that the type of its counts holds, `i8` for up to 8 bits, else `i16`{% if !look.is_empty() %}; of an image, every one that
/// `look` writes{% endif %}. It answers:
{% else -%}
/// Values outside the ranges are legal, NaN and infinities too. It answers:
{% endif -%}
{% for action in actions -%}
/// - {{ loop.index0 }}: {{ action }}
{% endfor -%}
{% for output in outputs -%}
/// - `[{{ output.place }}]`: {{ output.name }}, {{ output.meaning }}{% if !integers %}; {{ output.nan }} for NaN{% endif %}
{% endfor -%}
#[derive(Clone, Copy, Debug, Default)]
pub struct {{ name }};

impl {{ name }} {
    /// Values of a state{% if !memory.is_empty() %} and the memory{% endif %}.
    pub const STATE: usize = {{ state_length }};
{%- if outputs.is_empty() %}
    /// Actions.
    pub const ACTIONS: usize = {{ actions.len() }};
{%- for constant in constants %}
    /// An action.
    pub const {{ constant }}: ActionId = ActionId({{ loop.index0 }});
{%- endfor %}
{%- for (name, number) in asks %}
    /// The action that lets another policy decide this step.
    pub const ASKS_{{ name }}: ActionId = ActionId({{ number }});
{%- endfor %}
{%- else %}
    /// Outputs.
    pub const OUTPUTS: usize = {{ outputs.len() - memory.len() }};
{%- endif %}
{%- if !memory.is_empty() %}
    /// The memory before the first decision of an episode.
    pub const INITIAL: [{{ kind }}; {{ memory.len() }}] = {{ layout::array(initial, 4) }};
{%- endif %}
    /// Teams on the longest walk.
    pub const DEPTH: usize = {{ depth }};
{%- if let Some(arm) = arm %}
    /// The sources that make up a state, in order.
    pub const SOURCES: [&str; {{ arm.sources.len() }}] = {{ layout::array(arm.sources, 4) }};
    /// Motor ticks by which each action moves each joint.
    pub const MOVES: [[i8; {{ arm.joints }}]; {{ arm.moves.len() }}] = {{ layout::array(arm.moves, 4) }};
{%- endif %}
}

{% if !memory.is_empty() -%}
impl {{ name }} {
    /// Answers a state, and replaces the memory by the next one: [`INITIAL`](Self::INITIAL) before the first decision.
    pub fn infer(&self, state: &[{{ kind }}; {{ state_length - memory.len() }}], memory: &mut [{{ kind }}; {{ memory.len() }}]) -> [{{ answer }}; {{ outputs.len() - memory.len() }}] {
        let seen = {{ layout::array(seen, 8) }};
        let out = self.decide(&seen);
        *memory = {{ layout::array(remembered, 8) }};
        {{ layout::array(answered, 8) }}
    }
}

/// The decision as a function of a state{% if !memory.is_empty() %} and the memory behind it, to the outputs and the next memory behind them{% endif %}.
{% endif -%}
impl Policy for {{ name }} {
    type State = [{{ kind }}; {{ state_length }}];
    type Action = {% if outputs.is_empty() %}ActionId{% else %}[{{ answer }}; {{ outputs.len() }}]{% endif %};

    fn decide(&self, s: &[{{ kind }}; {{ state_length }}]) -> {% if outputs.is_empty() %}ActionId{% else %}[{{ answer }}; {{ outputs.len() }}]{% endif %} {
{{ body }}
    }
}
{{ items }}
{{ look }}
