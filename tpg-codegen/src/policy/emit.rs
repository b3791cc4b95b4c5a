//! A policy in integers as Rust constants for `tpg_arm::sac`.

use super::{QuantisedLayer, QuantisedPolicy, to_words};
use askama::Template;
use tpg_arm::sac::packed::{Kind, Model};
use tpg_graph::error::{InputError, Place};

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

/// A network of another kind than `w8a16`: packed when it is compiled, which proves that nothing can overflow.
#[derive(Template)]
#[template(path = "rust/model.rs", escape = "none")]
struct ModelFile<'a> {
    tool: &'a str,
    source_sha256: &'a str,
    bytes: usize,
    multiplications: usize,
    kind: &'a str,
    actions: &'a str,
    actions_variant: &'a str,
    mask: &'a str,
    mask_variant: &'a str,
    may_rest: bool,
    scratch: usize,
    words: usize,
    layers: Vec<LayerText>,
}

struct LayerText {
    name: &'static str,
    inputs: usize,
    outputs: usize,
    kind: &'static str,
    rows: Vec<String>,
    bias: String,
    rescale: Vec<(i16, u8)>,
}

fn list<T: ToString>(values: &[T]) -> String {
    values.iter().map(T::to_string).collect::<Vec<_>>().join(", ")
}

/// The text of a Rust module: the network, the decision behind it, and the assertion that nothing can overflow.
///
/// A network of the kind `w8a16` is there twice: as the runtime's `Network`, and packed as what lies in flash. One of
/// another kind is there packed.
///
/// # Errors
/// If a network of the kind `w8a16` has not two hidden layers, which is what the runtime's `Network` has, or one of
/// another kind cannot be packed.
pub fn to_rust(policy: &QuantisedPolicy) -> Result<String, InputError> {
    if policy.kind() == Kind::W8A16 {
        return network(policy);
    }
    let words = to_words(policy, false)?;
    let file = ModelFile {
        tool: TOOL,
        source_sha256: &policy.source_sha256,
        bytes: policy.bytes(),
        multiplications: policy.multiplications(),
        kind: &policy.kind,
        actions: &policy.actions,
        actions_variant: actions_variant(policy),
        mask: &policy.mask,
        mask_variant: mask_variant(policy),
        may_rest: policy.may_rest,
        scratch: Model::parse(&words).map_or(0, |model| model.scratch()),
        words: words.len(),
        layers: texts(policy),
    };
    Ok(file.render().expect("a template of plain values") + "\n")
}

const TOOL: &str = concat!("tpg-codegen ", env!("CARGO_PKG_VERSION"));

fn actions_variant(policy: &QuantisedPolicy) -> &'static str {
    if policy.actions == "fine" { "Fine" } else { "Coarse" }
}

fn mask_variant(policy: &QuantisedPolicy) -> &'static str {
    if policy.mask == "none" { "None" } else { "JointLimits" }
}

fn texts(policy: &QuantisedPolicy) -> Vec<LayerText> {
    let names = ["first", "second", "last"].into_iter().chain(std::iter::repeat("further"));
    let text = |((name, layer), kind): ((&'static str, &QuantisedLayer), Kind)| LayerText {
        name,
        inputs: layer.inputs,
        outputs: layer.outputs,
        kind: match kind {
            Kind::W8A16 => "W8A16",
            Kind::W16A16 => "W16A16",
            Kind::W8A8 => "W8A8",
        },
        rows: layer.weights.chunks_exact(layer.inputs).map(list).collect(),
        bias: list(&layer.bias),
        rescale: layer.factor.iter().copied().zip(layer.shift.iter().copied()).collect(),
    };
    names.zip(&policy.layers).zip(policy.layer_kinds()).map(text).collect()
}

fn network(policy: &QuantisedPolicy) -> Result<String, InputError> {
    if policy.layers.len() != 3 {
        let found = format!("{} layers", policy.layers.len());
        return Err(InputError::new("policy.q.json", Place::Path("$.layers".to_owned()), found, "3 layers"));
    }
    let file = NetworkFile {
        tool: TOOL,
        source_sha256: &policy.source_sha256,
        bytes: policy.bytes(),
        multiplications: policy.multiplications(),
        actions: &policy.actions,
        actions_variant: actions_variant(policy),
        mask: &policy.mask,
        mask_variant: mask_variant(policy),
        may_rest: policy.may_rest,
        layers: texts(policy),
    };
    Ok(file.render().expect("a template of plain values") + "\n")
}
