//! A network in integers: {{ bytes }} bytes of constants, {{ multiplications }} multiplications a decision.
//!
//! Made by {{ tool }} from weights with SHA-256 {{ source_sha256 }}.
//! Numbers: {{ kind }}. Do not edit: make it again.
//!
//! Inputs:
{%- for input in inputs %}
//! - {{ loop.index0 }}: {{ input.0 }}
{%- endfor %}
//!
//! Outputs:
{%- for output in outputs %}
//! - {{ output }}
{%- endfor %}

use tpg_runtime::net::{Kind, LayerRows, Meaning, OutputKind, Rescale, {% if scaled %}Scaling, {% endif %}{% if values.len() > 0 %}Squash, Value, {% endif %}Weights, pack};

/// Everything about the network but its layers.
#[rustfmt::skip]
pub const MEANING: Meaning<'static> = Meaning {
    contract: {{ contract }},
    inputs: &[
{%- if scaled %}
{%- for input in inputs %}
        {{ input.1 }},
{%- endfor %}
{%- endif %}
    ],
    answer: OutputKind::{{ answer }},
    values: &[
{%- for value in values %}
        {{ value }},
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
    assert!(pack(&layers, &MEANING, &mut words), "no input may overflow an accumulator");
    words
};
