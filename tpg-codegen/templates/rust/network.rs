//! A soft actor-critic's policy in integers: {{ policy.bytes() }} bytes of constants, {{ policy.multiplications() }} multiplications a decision.
//!
//! Made by {{ tool }} from weights with SHA-256 {{ policy.source_sha256 }}.
//! Actions: {{ preferences.actions }}; mask: {{ preferences.mask }}. Do not edit: make it again.

use tpg_arm::sac::fixed::{FixedDecision, Network};
use tpg_arm::sac::{Actions, Mask};
use tpg_runtime::net::{Layer, Rescale};

/// The network.
#[rustfmt::skip]
pub const NETWORK: Network<{{ policy.layers[0].outputs }}, {{ policy.layers[1].outputs }}> = Network {
{%- for (name, layer) in layers %}
    {{ name }}: Layer {
        weights: [
{%- for row in layer.rows() %}
            [{{ row|join(", ") }}],
{%- endfor %}
        ],
        bias: [{{ layer.bias|join(", ") }}],
        rescale: [
{%- for rescale in layer.rescales() %}
            Rescale { factor: {{ rescale.factor }}, shift: {{ rescale.shift }} },
{%- endfor %}
        ],
    },
{%- endfor %}
};

/// What stands behind it.
pub const DECISION: FixedDecision = FixedDecision::new(Actions::{% if preferences.actions == "fine" %}Fine{% else %}Coarse{% endif %}, Mask::{% if preferences.mask == "none" %}None{% else %}JointLimits{% endif %}, {{ preferences.may_rest }});

/// The network as the kernels read it: what lies in flash.
pub static MODEL: [u32; Network::<{{ policy.layers[0].outputs }}, {{ policy.layers[1].outputs }}>::WORDS] = NETWORK.pack(&DECISION);

/// Words of scratch memory that a decision needs.
pub const SCRATCH: usize = Network::<{{ policy.layers[0].outputs }}, {{ policy.layers[1].outputs }}>::SCRATCH;

const _: () = assert!(NETWORK.is_sound(), "no input may overflow an accumulator");
