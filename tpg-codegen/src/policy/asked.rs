//! A graph and the network that it asks as one C function.

use super::meaning::Output;
use super::network::QuantisedPolicy;
use super::plain::to_plain_c;
use crate::Options;
use crate::emit::c::field::member;
use crate::emit::{Code, File, Language, Prefix};
use askama::Template;
use tpg_graph::error::{InputError, Place};
use tpg_graph::{Counts, Graph, Input, ScalarType};

#[derive(Template)]
#[template(path = "c/decide.h", escape = "none")]
struct DecideHeader<'a> {
    prefix: &'a str,
    upper: String,
    network: &'a str,
    ask: String,
    /// What the network sees of the graph's state.
    inputs: Vec<String>,
}

/// The C of a graph, the [plain C](to_plain_c) of the network that it asks, and `PREFIX_decide.h`, whose function answers for
/// both.
///
/// # Errors
/// Where the network does not fit the graph: its inputs, its actions, or none that asks; and those of [`Code::of_graph`].
pub fn to_asking_c(graph: &Graph, options: &Options, policy: &QuantisedPolicy) -> Result<Vec<File>, InputError> {
    let last = graph.actions().split_last();
    let Some((ask, own)) = last.and_then(|(last, own)| Some((last.ask.as_ref()?, own))) else {
        return Err(InputError::new("the graph", "$.actions", "no action that asks, as the last", "one"));
    };
    let refuse = |path: &str, found: &[String], accepted: &[String]| {
        Err(InputError::new("the network", path, found.join(", "), accepted.join(", ")))
    };
    let name = |input| match graph.source_of(input).0 {
        source if source.ranges.len() == 1 => source.name.clone(),
        _ => graph.input_name(input),
    };
    let inputs: Vec<String> = graph.inputs().map(name).collect();
    let seen: Vec<String> = policy.inputs.iter().map(|input| input.name.clone()).collect();
    if inputs != seen {
        return refuse("$.observation", &seen, &inputs);
    }
    let own: Vec<String> = own.iter().map(|action| action.name.clone()).collect();
    let choices = if let Output::Argmax(names) = &policy.output { &names[..] } else { &[] };
    if choices != own {
        return refuse("$.output", choices, &own);
    }
    let prefix = options.prefix.lower();
    let name = format!("{prefix}_{ask}");
    let network: Prefix =
        name.parse().map_err(|_| InputError::new("the prefix", Place::Whole, &name, "a shorter name"))?;
    let mut files = Code::of_graph("the graph", graph, options, Language::C)?.files;
    files.extend(to_plain_c(policy, &network)?);
    let header = DecideHeader {
        prefix,
        upper: options.prefix.upper(),
        network: network.lower(),
        ask: ask.to_ascii_uppercase(),
        inputs: graph.inputs().map(|input| value(graph, input)).collect(),
    };
    let text = header.render().expect("a template of plain values") + "\n";
    files.push(File { name: format!("{prefix}_decide.h"), text });
    Ok(files)
}

/// Returns a value of the graph's state in C: of counts, what they are worth.
fn value(graph: &Graph, input: Input) -> String {
    let member = member(graph, input);
    match graph.counts_of(input) {
        Some(Counts { scale, offset: 0.0, .. }) => format!("(float){member} * {:?}f", scale as f32),
        Some(Counts { scale, offset, .. }) => format!("((float){member} - {:?}f) * {:?}f", offset as f32, scale as f32),
        None if graph.scalar() == ScalarType::F64 => format!("(float){member}"),
        None => member,
    }
}
