{% for line in banner -%}
//! {{ line }}
{% endfor -%}
#![forbid(unsafe_code)]
#![allow(
    clippy::all,
    unused_variables,
    unused_assignments,
    reason = "evolved expressions need not make sense"
)]

use tpg_runtime::policy::{% if outputs.is_empty() %}{ActionId, Policy}{% else %}Policy{% endif %};

/// A tangled program graph in integers: counts in, counts out.
///
/// It sees, one after another:
{% for source in sources -%}
/// - {{ source }}
{% endfor -%}
///
/// Every value is legal that the type of its counts holds, `i8` for up to 8 bits, else `i16`{% if !look.is_empty() %}; of an image, every one that
/// `look` writes{% endif %}. It answers:
{% for answer in answers -%}
/// - {{ answer }}
{% endfor -%}
#[derive(Clone, Copy, Debug, Default)]
pub struct {{ name }};

impl {{ name }} {
    /// Values of a state{% if memory > 0 %} and the memory{% endif %}.
    pub const STATE: usize = {{ state_length }};
{%- if outputs.is_empty() %}
    /// Actions.
    pub const ACTIONS: usize = {{ answers.len() }};
{%- else %}
    /// Outputs.
    pub const OUTPUTS: usize = {{ outputs.len() - memory }};
{%- endif %}
{%- if memory > 0 %}
    /// The memory before the first decision of an episode.
    pub const INITIAL: [i32; {{ memory }}] = {{ initial }};
{%- endif %}
}

{% if memory > 0 -%}
impl {{ name }} {
    /// Answers a state, and replaces the memory by the next one: [`INITIAL`](Self::INITIAL) before the first decision.
    pub fn infer(&self, state: &[i32; {{ state_length - memory }}], memory: &mut [i32; {{ memory }}]) -> [i32; {{ outputs.len() - memory }}] {
        let seen = {{ seen }};
        let out = self.decide(&seen);
        *memory = {{ remembered }};
        {{ answered }}
    }
}

/// The decision as a function of a state and the memory behind it, to the outputs and the next memory behind them.
{% endif -%}
impl Policy for {{ name }} {
    type State = [{{ kind }}; {{ state_length }}];
    type Action = {{ action }};

    fn decide(&self, s: &[{{ kind }}; {{ state_length }}]) -> {{ action }} {
{{ body }}
    }
}
{{ look }}
{% for helper in helpers %}
{%- let (int, bits) = (helper.int, helper.end) %}
{% if helper.calls(Function::Divide) %}
/// a / b, rounded down, of a b that is not 0.
fn divide{{ bits }}(a: {{ int }}, b: {{ int }}) -> {{ int }} {
    // Not the operator, which could panic as far as the compiler knows.
    let quotient = a.checked_div(b).unwrap_or(0);
    if quotient * b != a && (a < 0) != (b < 0) { quotient - 1 } else { quotient }
}
{% endif %}
{% if helper.calls(Function::Quotient) %}
/// a / b, rounded down. By 0, the greatest integer with the sign of a, and of 0 / 0 the lowest: as a bid, it loses.
fn quotient{{ bits }}(a: {{ int }}, b: {{ int }}) -> {{ int }} {
    match (b, a.signum()) {
        (0, 1) => 2147483647,
        (0, 0) => -2147483648,
        (0, _) => -2147483647,
        _ => divide{{ bits }}(a, b),
    }
}
{% endif %}
{% if helper.calls(Function::NegateIfLess) %}
fn negate_if_less{{ bits }}(a: {{ int }}, b: {{ int }}) -> {{ int }} {
    if a < b { -a } else { a }
}
{% endif %}
{% if helper.calls(Function::Gate) %}
fn gate{{ bits }}(a: {{ int }}, b: {{ int }}) -> {{ int }} {
    if b != 0 { a } else { 0 }
}
{% endif %}
{% endfor %}
