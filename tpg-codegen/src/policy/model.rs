//! A policy in integers as one array of words, and C that holds it.

use super::{QuantisedLayer, QuantisedPolicy};
use crate::emit::{File, Prefix};
use crate::error::{InputError, Place};
use askama::Template;
use tpg_kernels::Kind;
use tpg_runtime::sac::fixed::{FixedDecision, Rescale};
use tpg_runtime::sac::packed::{self, LayerRows, Model, Weights};
use tpg_runtime::sac::{Actions, Mask};

#[derive(Template)]
#[template(path = "c/model.c", escape = "none")]
struct Source<'a> {
    banner: &'a [String],
    prefix: &'a str,
    upper: &'a str,
    lines: Vec<String>,
}

#[derive(Template)]
#[template(path = "c/model.h", escape = "none")]
struct Header<'a> {
    banner: &'a [String],
    prefix: &'a str,
    upper: &'a str,
    words: usize,
    scratch: usize,
}

/// The policy as `tpg_runtime::sac::packed` reads it.
///
/// # Errors
/// If it has more or wider layers than the runtime takes, or a rescale that is no multiplier of 32 bits.
pub fn to_words(policy: &QuantisedPolicy) -> Result<Vec<u32>, InputError> {
    let refuse = |found: String, accepted: &str| {
        InputError::new("policy.q.json", Place::Path("$.layers".to_owned()), found, accepted)
    };
    let actions = Actions::from_name(&policy.actions).unwrap_or(Actions::Fine);
    let mask = Mask::from_name(&policy.mask).unwrap_or(Mask::None);
    let decision = FixedDecision::new(actions, mask, policy.may_rest);
    let rescales: Vec<Vec<Rescale>> = policy.layers.iter().map(rescales).collect();
    let mut sizes = Vec::new();
    let mut rows = Vec::new();
    for (layer, rescale) in policy.layers.iter().zip(&rescales) {
        if let Some(at) = rescale.iter().find(|rescale| rescale.multiplier().is_none()) {
            return Err(refuse(format!("{at:?}"), "factor / 2^shift below 1/2, and exact in 32 bits"));
        }
        let weights = Weights::I8(&layer.weights);
        sizes.push((layer.inputs, layer.outputs, Kind::W8A16));
        rows.push(LayerRows { inputs: layer.inputs, kind: Kind::W8A16, weights, bias: &layer.bias, rescale });
    }
    let mut words = vec![0; packed::words(&sizes)];
    if !packed::pack(&rows, &decision, &mut words) {
        let found = format!("layers of {sizes:?}");
        let accepted = format!("1 to {} layers of at most {} values", packed::LAYERS, packed::WIDTH);
        return Err(refuse(found, &accepted));
    }
    Ok(words)
}

fn rescales(layer: &QuantisedLayer) -> Vec<Rescale> {
    layer.factor.iter().zip(&layer.shift).map(|(&factor, &shift)| Rescale { factor, shift }).collect()
}

/// `PREFIX.h` and `PREFIX.c`: the words as a constant array, for `tpg_sac_init`.
///
/// # Errors
/// As [`to_words`].
pub fn to_c(policy: &QuantisedPolicy, prefix: &Prefix) -> Result<Vec<File>, InputError> {
    let words = to_words(policy)?;
    let scratch = Model::parse(&words).map_or(0, |model| model.scratch());
    let upper = prefix.upper();
    let banner = [
        format!("Made by tpg-codegen {} from a network in integers; do not edit.", env!("CARGO_PKG_VERSION")),
        format!("Weights' SHA-256: {}", policy.source_sha256),
        format!(
            "{} layers, {} multiplications a decision, {} bytes.",
            policy.layers.len(),
            policy.multiplications(),
            4 * words.len()
        ),
        format!("Actions: {}; mask: {}.", policy.actions, policy.mask),
    ];
    let hexadecimal = |words: &[u32]| words.iter().map(|word| format!("0x{word:08x}U")).collect::<Vec<_>>().join(", ");
    let source = Source {
        banner: &banner,
        prefix: prefix.lower(),
        upper: &upper,
        lines: words.chunks(8).map(hexadecimal).collect(),
    };
    let header = Header { banner: &banner, prefix: prefix.lower(), upper: &upper, words: words.len(), scratch };
    let file = |extension: &str, text: String| File { name: format!("{prefix}.{extension}"), text: text + "\n" };
    Ok(vec![
        file("h", header.render().expect("a template of plain values")),
        file("c", source.render().expect("a template of plain values")),
    ])
}
