//! A soft actor-critic's policy in integers: {{ bytes }} bytes of constants, {{ multiplications }} multiplications a decision.
//!
//! Made by {{ tool }} from weights with SHA-256 {{ source_sha256 }}.
//! Numbers: {{ kind }}; actions: {{ actions }}; mask: {{ mask }}. Do not edit: make it again.

use tpg_arm::sac::fixed::{FixedDecision, Rescale};
use tpg_arm::sac::packed::{Kind, LayerRows, Weights, pack};
use tpg_arm::sac::{Actions, Mask};

/// What stands behind the network.
pub const DECISION: FixedDecision = FixedDecision::new(Actions::{{ actions_variant }}, Mask::{{ mask_variant }}, {{ may_rest }});

/// Words of scratch memory that a decision needs.
pub const SCRATCH: usize = {{ scratch }};

/// The network as the kernels read it: what lies in flash.
#[rustfmt::skip]
pub static MODEL: [u32; {{ words }}] = {
    let layers = [
{%- for layer in layers %}
        LayerRows {
            inputs: {{ layer.inputs }},
            kind: Kind::{{ layer.kind }},
            weights: Weights::I16(&[
{%- for row in layer.rows %}
                {{ row }},
{%- endfor %}
            ]),
            bias: &[{{ layer.bias }}],
            rescale: &[
{%- for rescale in layer.rescale %}
                Rescale { factor: {{ rescale.0 }}, shift: {{ rescale.1 }} },
{%- endfor %}
            ],
        },
{%- endfor %}
    ];
    let mut words = [0; {{ words }}];
    assert!(pack(&layers, &DECISION, &mut words), "no input may overflow an accumulator");
    words
};
