//! `no_std` Rust in integers, without a way to panic.

use super::body::body;
use super::comment::{worth, worth_from};
use super::spelling::{Function, IntegerHelpers, IntegerSpelling, answer_bits, state_bits};
use crate::emit::file::{File, one_line};
use crate::emit::look::{self, LookView};
use crate::emit::{banner, interface, layout};
use crate::integers::Integers;
use crate::program::Program;
use askama::Template;
use tpg_graph::{Graph, Input, Output};

#[derive(Template)]
#[template(path = "integers/policy.rs", escape = "none")]
struct IntegerPolicy<'a> {
    banner: &'a [String],
    name: String,
    sources: Vec<String>,
    answers: Vec<String>,
    outputs: &'a [Output],
    memory: usize,
    state_length: usize,
    /// The type of a value of the state.
    kind: String,
    /// The type of an answer.
    action: String,
    initial: String,
    seen: String,
    remembered: String,
    answered: String,
    body: String,
    look: String,
    helpers: [IntegerHelpers; 2],
}

/// The file.
pub(super) fn files(program: &Program<'_>, integers: &Integers) -> Vec<File> {
    let (graph, prefix) = (program.graph(), &program.options.prefix);
    let spelling = IntegerSpelling::new(program);
    let (body, called) = body(&program.module, integers, &spelling);
    let memory = graph.memory();
    let (observed, answers) = (graph.state_length() - memory, graph.outputs().len() - memory);
    let list = |name: &str, places: std::ops::Range<usize>| -> Vec<String> {
        places.map(|place| format!("{name}[{place}]")).collect()
    };
    let action = match graph.outputs() {
        [] => "ActionId".to_owned(),
        outputs => format!("[i{}; {}]", answer_bits(graph), outputs.len()),
    };
    let kind = format!("i{}", state_bits(graph));
    let policy = IntegerPolicy {
        banner: &banner::lines(program),
        name: prefix.camel(),
        sources: sources(graph),
        answers: self::answers(graph),
        outputs: graph.outputs(),
        memory,
        state_length: graph.state_length(),
        action,
        initial: layout::array(
            &graph.outputs()[answers..].iter().map(|value| (value.nan as i64).to_string()).collect::<Vec<_>>(),
            4,
        ),
        seen: layout::array(&[list("state", 0..observed), list("memory", 0..memory)].concat(), 8),
        remembered: layout::array(&list("out", answers..answers + memory), 8),
        answered: layout::array(&list("out", 0..answers), 8),
        body: body.trim_end().to_owned(),
        look: LookView::new(graph, &interface::sources(graph, one_line), &|_| kind.clone())
            .map_or_else(String::new, |view| look::rust(&view, &prefix.camel(), &kind, observed)),
        kind,
        helpers: spelling.helpers(&called),
    };
    let text = layout::tidy(&policy.render().expect("the template renders"));
    vec![File { name: format!("{prefix}.rs"), text }]
}

fn sources(graph: &Graph) -> Vec<String> {
    let input = |input: Input| {
        let (source, place) = graph.source_of(input);
        let counts = graph.counts_of(input);
        let worth = counts.map_or_else(String::new, |counts| worth_from(&counts, &one_line(&source.unit)) + ", ");
        format!("`s[{}]`: {}, {worth}{}", input.index(), graph.input_label(input), source.ranges[place])
    };
    graph.inputs().map(input).collect()
}

fn answers(graph: &Graph) -> Vec<String> {
    let actions =
        graph.actions().iter().enumerate().map(|(id, action)| format!("{id}: {}", one_line(&action.to_string())));
    let output = |(place, output): (usize, &Output)| {
        let worth =
            output.counts.map_or_else(String::new, |counts| worth(counts.scale, &one_line(&output.unit)) + ", ");
        format!("`[{place}]`: {}, {worth}{}", output.name, output.range)
    };
    actions.chain(graph.outputs().iter().enumerate().map(output)).collect()
}
