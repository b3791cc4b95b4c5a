//! A network in integers: {{ policy.bytes() }} bytes of constants, {{ policy.multiplications() }} multiplications a decision.
//!
//! Made by {{ tool }} from weights with SHA-256 {{ policy.source_sha256 }}.
//! Numbers: {{ policy.kind }}. Do not edit: make it again.
//!
//! Inputs:
{%- for input in policy.inputs %}
//! - {{ loop.index0 }}: {{ input.name }}
{%- endfor %}
//!
//! Outputs:
{%- for output in outputs %}
//! - {{ output }}
{%- endfor %}

use tpg_runtime::net::{Kind, LayerRows, Meaning, OutputKind, Rescale, {% if policy.is_scaled() %}Scaling, {% endif %}{% if !policy.output.values().is_empty() %}Squash, Value, {% endif %}Weights, pack};

/// Everything about the network but its layers.
#[rustfmt::skip]
pub const MEANING: Meaning<'static> = Meaning {
    contract: {{ policy.contract() }},
    inputs: &[
{%- if policy.is_scaled() %}
{%- for input in policy.inputs %}
        Scaling { offset: {{ "{:?}"|format(input.offset) }}, scale: {{ "{:?}"|format(input.scale) }} },
{%- endfor %}
{%- endif %}
    ],
    answer: OutputKind::{{ "{:?}"|format(policy.output.answer()) }},
    values: &[
{%- for value in policy.output.values() %}
        Value { min: {{ "{:?}"|format(value.min) }}, max: {{ "{:?}"|format(value.max) }}, squash: Squash::{{ "{:?}"|format(value.squash) }}, exponent: {{ value.exponent }} },
{%- endfor %}
    ],
};

/// Words of scratch memory that a decision needs.
pub const SCRATCH: usize = {{ scratch }};

/// The network as the kernels read it: what lies in flash.
#[rustfmt::skip]
pub static MODEL: [u32; {{ words }}] = {
    let layers = [
{%- for layer in layers %}
        LayerRows {
            inputs: {{ layer.inputs }},
            kind: Kind::{{ "{:?}"|format(layer.kind) }},
            weights: Weights::I16(&[
{%- for row in layer.rows() %}
                {{ row|join(", ") }},
{%- endfor %}
            ]),
            bias: &[{{ layer.bias|join(", ") }}],
            rescale: &[
{%- for rescale in layer.rescales() %}
                Rescale { factor: {{ rescale.factor }}, shift: {{ rescale.shift }} },
{%- endfor %}
            ],
        },
{%- endfor %}
    ];
    let mut words = [0; {{ words }}];
    assert!(pack(&layers, &MEANING, &mut words), "no input may overflow an accumulator");
    words
};
