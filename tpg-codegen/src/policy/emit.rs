//! A network in integers as Rust constants, for `tpg_runtime::net`.

use super::meaning::{Output, Preferences};
use super::model::{self, to_words};
use super::network::{Layer, QuantisedPolicy};
use askama::Template;
use tpg_graph::error::InputError;

/// A network, packed when it is compiled, which proves that nothing can overflow.
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

/// The text of a Rust module: the network, packed, its meaning, and the proof that nothing can overflow.
///
/// # Errors
/// If it cannot be packed.
pub fn to_rust(policy: &QuantisedPolicy) -> Result<String, InputError> {
    let words = to_words(policy)?;
    let outputs = match &policy.output {
        Output::Preferences(Preferences { actions, mask, may_rest }) => {
            vec![format!("preferences; actions: {actions}; mask: {mask}; may rest: {may_rest}")]
        }
        Output::Values(_) => policy.output.described(),
        Output::Argmax(_) => (policy.output.described().iter().enumerate())
            .map(|(place, name)| format!("action {place}: {name}"))
            .collect(),
    };
    let file = ModelFile {
        tool: concat!("tpg-codegen ", env!("CARGO_PKG_VERSION")),
        policy,
        outputs,
        layers: policy.described(),
        words: words.len(),
        scratch: model::scratch(&words),
    };
    Ok(file.render().expect("a template of plain values") + "\n")
}
