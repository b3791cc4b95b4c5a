//! A network in integers as Rust constants: for `tpg_runtime::net`, and for `tpg_arm::sac` where it is the arm's.

use super::{Output, Preferences, QuantisedLayer, QuantisedPolicy, meaning, to_words};
use askama::Template;
use tpg_graph::error::InputError;
use tpg_runtime::net::{Kind, Model};

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

/// Any other network: packed when it is compiled, which proves that nothing can overflow.
#[derive(Template)]
#[template(path = "rust/model.rs", escape = "none")]
struct ModelFile<'a> {
    tool: &'a str,
    source_sha256: &'a str,
    bytes: usize,
    multiplications: usize,
    kind: &'a str,
    contract: u32,
    inputs: Vec<(&'a str, String)>,
    scaled: bool,
    answer: String,
    outputs: Vec<String>,
    values: Vec<String>,
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

/// The text of a Rust module: the network, its meaning, and the proof that nothing can overflow.
///
/// The arm's network of kind `w8a16` with two hidden layers is there twice: as `tpg_arm`'s `Network`, and packed as what
/// lies in flash. Any other one is there packed.
///
/// # Errors
/// If it cannot be packed.
pub fn to_rust(policy: &QuantisedPolicy) -> Result<String, InputError> {
    if let Output::Preferences(preferences) = &policy.output
        && policy.kind() == Kind::W8A16
        && policy.layers.len() == 3
    {
        return Ok(network(policy, preferences));
    }
    let words = to_words(policy, false)?;
    let file = ModelFile {
        tool: TOOL,
        source_sha256: &policy.source_sha256,
        bytes: policy.bytes(),
        multiplications: policy.multiplications(),
        kind: &policy.kind,
        contract: meaning::contract_of(&policy.inputs),
        inputs: policy.inputs.iter().map(|input| (input.name.as_str(), scaling(input))).collect(),
        scaled: !meaning::scales(&policy.inputs).is_empty(),
        answer: format!("{:?}", policy.output.answer()),
        outputs: outputs(&policy.output),
        values: policy.output.values().iter().map(value).collect(),
        scratch: Model::parse(&words).map_or(0, |model| model.scratch()),
        words: words.len(),
        layers: texts(policy),
    };
    Ok(file.render().expect("a template of plain values") + "\n")
}

const TOOL: &str = concat!("tpg-codegen ", env!("CARGO_PKG_VERSION"));

fn scaling(input: &super::Input) -> String {
    format!("Scaling {{ offset: {:?}, scale: {:?} }}", input.offset, input.scale)
}

fn value(value: &tpg_runtime::net::Value) -> String {
    let tpg_runtime::net::Value { min, max, squash, exponent } = value;
    format!("Value {{ min: {min:?}, max: {max:?}, squash: Squash::{squash:?}, exponent: {exponent} }}")
}

/// The outputs, a line each.
fn outputs(output: &Output) -> Vec<String> {
    match output {
        Output::Preferences(Preferences { actions, mask, may_rest }) => {
            vec![format!("preferences; actions: {actions}; mask: {mask}; may rest: {may_rest}")]
        }
        Output::Values(values) => {
            values.iter().map(|value| format!("{}: {} to {}", value.name, value.min, value.max)).collect()
        }
        Output::Argmax(names) => {
            names.iter().enumerate().map(|(place, name)| format!("action {place}: {name}")).collect()
        }
    }
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

fn network(policy: &QuantisedPolicy, preferences: &Preferences) -> String {
    let file = NetworkFile {
        tool: TOOL,
        source_sha256: &policy.source_sha256,
        bytes: policy.bytes(),
        multiplications: policy.multiplications(),
        actions: &preferences.actions,
        actions_variant: if preferences.actions == "fine" { "Fine" } else { "Coarse" },
        mask: &preferences.mask,
        mask_variant: if preferences.mask == "none" { "None" } else { "JointLimits" },
        may_rest: preferences.may_rest,
        layers: texts(policy),
    };
    file.render().expect("a template of plain values") + "\n"
}
