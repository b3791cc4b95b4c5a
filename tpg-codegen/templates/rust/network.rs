//! A soft actor-critic's policy in integers: {{ bytes }} bytes of constants, {{ multiplications }} multiplications a decision.
//!
//! Made by {{ tool }} from weights with SHA-256 {{ source_sha256 }}.
//! Actions: {{ actions }}; mask: {{ mask }}. Do not edit: make it again.

use tpg_arm::sac::fixed::{FixedDecision, Network};
use tpg_arm::sac::{Actions, Mask};
use tpg_runtime::net::{Layer, Rescale};

/// The network.
#[rustfmt::skip]
pub const NETWORK: Network<{{ layers[0].outputs }}, {{ layers[1].outputs }}> = Network {
{%- for layer in layers %}
    {{ layer.name }}: Layer {
        weights: [
{%- for row in layer.rows %}
            [{{ row }}],
{%- endfor %}
        ],
        bias: [{{ layer.bias }}],
        rescale: [
{%- for rescale in layer.rescale %}
            Rescale { factor: {{ rescale.0 }}, shift: {{ rescale.1 }} },
{%- endfor %}
        ],
    },
{%- endfor %}
};

/// What stands behind it.
pub const DECISION: FixedDecision = FixedDecision::new(Actions::{{ actions_variant }}, Mask::{{ mask_variant }}, {{ may_rest }});

/// The network as the kernels read it: what lies in flash.
pub static MODEL: [u32; Network::<{{ layers[0].outputs }}, {{ layers[1].outputs }}>::WORDS] = NETWORK.pack(&DECISION);

/// Words of scratch memory that a decision needs.
pub const SCRATCH: usize = Network::<{{ layers[0].outputs }}, {{ layers[1].outputs }}>::SCRATCH;

const _: () = assert!(NETWORK.is_sound(), "no input may overflow an accumulator");
