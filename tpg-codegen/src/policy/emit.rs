//! A network in integers as Rust constants: for `tpg_runtime::net`, and for `tpg_arm::sac` where it is the arm's.

use super::meaning::{Output, Preferences};
use super::model::{self, to_words};
use super::network::{Layer, QuantisedLayer, QuantisedPolicy};
use askama::Template;
use tpg_graph::error::InputError;
use tpg_runtime::net::Kind;

#[derive(Template)]
#[template(path = "rust/network.rs", escape = "none")]
struct NetworkFile<'a> {
    tool: &'a str,
    policy: &'a QuantisedPolicy,
    preferences: &'a Preferences,
    layers: Vec<(&'a str, &'a QuantisedLayer)>,
}

/// Any other network: packed when it is compiled, which proves that nothing can overflow.
#[derive(Template)]
#[template(path = "rust/model.rs", escape = "none")]
struct ModelFile<'a> {
    tool: &'a str,
    policy: &'a QuantisedPolicy,
    outputs: Vec<String>,
    layers: Vec<Layer<'a>>,
    words: usize,
    scratch: usize,
}

const TOOL: &str = concat!("tpg-codegen ", env!("CARGO_PKG_VERSION"));

/// The text of a Rust module: the network, its meaning, and the proof that nothing can overflow.
///
/// The arm's network of kind `w8a16` with two hidden layers is there twice: as `tpg_arm`'s `Network`, and packed as what
/// lies in flash. Any other one is there packed.
///
/// # Errors
/// If it cannot be packed.
pub fn to_rust(policy: &QuantisedPolicy) -> Result<String, InputError> {
    let text = match &policy.output {
        Output::Preferences(preferences) if policy.kind() == Kind::W8A16 && policy.layers.len() == 3 => {
            let layers = ["first", "second", "last"].into_iter().zip(&policy.layers).collect();
            NetworkFile { tool: TOOL, policy, preferences, layers }.render()
        }
        output => {
            let words = to_words(policy, false)?;
            let outputs = match output {
                Output::Preferences(Preferences { actions, mask, may_rest }) => {
                    vec![format!("preferences; actions: {actions}; mask: {mask}; may rest: {may_rest}")]
                }
                Output::Values(_) => output.described(),
                Output::Argmax(_) => (output.described().iter().enumerate())
                    .map(|(place, name)| format!("action {place}: {name}"))
                    .collect(),
            };
            let scratch = model::scratch(&words);
            ModelFile { tool: TOOL, policy, outputs, layers: policy.described(), words: words.len(), scratch }.render()
        }
    };
    Ok(text.expect("a template of plain values") + "\n")
}
