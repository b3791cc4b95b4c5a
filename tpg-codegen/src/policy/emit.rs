//! A policy in integers as Rust constants for `tpg_runtime::sac::fixed`.

use super::QuantisedPolicy;
use crate::error::{InputError, Place};
use askama::Template;

#[derive(Template)]
#[template(path = "rust/network.rs", escape = "none")]
struct NetworkFile<'a> {
    tool: &'a str,
    source_sha256: &'a str,
    bytes: usize,
    multiplications: usize,
    actions: &'a str,
    actions_variant: &'a str,
    mask: &'a str,
    mask_variant: &'a str,
    may_rest: bool,
    layers: Vec<LayerText>,
}

struct LayerText {
    name: &'static str,
    outputs: usize,
    rows: Vec<String>,
    bias: String,
    rescale: Vec<(i16, u8)>,
}

fn list<T: ToString>(values: &[T]) -> String {
    values.iter().map(T::to_string).collect::<Vec<_>>().join(", ")
}

/// The text of a Rust module: the network, the decision behind it, and the assertion that nothing can overflow.
///
/// # Errors
/// If the network has not two hidden layers, which is what the runtime's `Network` has.
pub fn to_rust(policy: &QuantisedPolicy) -> Result<String, InputError> {
    if policy.layers.len() != 3 {
        let found = format!("{} layers", policy.layers.len());
        return Err(InputError::new("policy.q.json", Place::Path("$.layers".to_owned()), found, "3 layers"));
    }
    let texts = ["first", "second", "last"].into_iter().zip(&policy.layers).map(|(name, layer)| LayerText {
        name,
        outputs: layer.outputs,
        rows: layer.weights.chunks_exact(layer.inputs).map(list).collect(),
        bias: list(&layer.bias),
        rescale: layer.factor.iter().copied().zip(layer.shift.iter().copied()).collect(),
    });
    let file = NetworkFile {
        tool: concat!("tpg-codegen ", env!("CARGO_PKG_VERSION")),
        source_sha256: &policy.source_sha256,
        bytes: policy.bytes(),
        multiplications: policy.multiplications(),
        actions: &policy.actions,
        actions_variant: if policy.actions == "fine" { "Fine" } else { "Coarse" },
        mask: &policy.mask,
        mask_variant: if policy.mask == "none" { "None" } else { "JointLimits" },
        may_rest: policy.may_rest,
        layers: texts.collect(),
    };
    Ok(file.render().expect("a template of plain values") + "\n")
}
