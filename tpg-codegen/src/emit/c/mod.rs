//! C99: one `.c` and one `.h`, in the shape of a profile or of GEGELATI's generated code.

mod balanced;
mod constant_time;
mod entry;
mod expression;
mod fast;
pub(crate) mod field;
mod formula;
mod gegelati;
mod helpers;
mod integers;
mod leaves;
mod small;

use super::file::{File, comment};
use super::interface::{OutputView, SourceView, actions, asks, outputs, sources};
use super::look::{self, LookView};
use super::syntax::Syntax;
use super::vectors::{Vectors, vectors};
use super::{banner, layout, moves::moves, team::compares_in_functions};
use crate::integers::{output_bits, source_bits};
use crate::program::Program;
use crate::shape::Shape;
use askama::Template;
use expression::CPrinter;
use tpg_graph::interpret::Answer;
use tpg_graph::{Graph, MathsProvider, ScalarType};

#[derive(Template)]
#[template(path = "c/header.h", escape = "none")]
struct CHeader<'a> {
    printer: &'a CPrinter<'a>,
    banner: &'a [String],
    sources: &'a [SourceView],
    /// The constant of each action, and its name where the constant does not say it.
    actions: Vec<(String, String)>,
    /// Name and number of each action that asks.
    asks: Vec<(String, usize)>,
    outputs: &'a [OutputView],
    memory: &'a [OutputView],
    arm: Option<CArmView>,
    look: Option<&'a LookView>,
    /// The quality of the self-test.
    quality: Option<String>,
}

/// The sources and moves of a policy that drives the arm, as initialisers.
struct CArmView {
    sources: Vec<String>,
    moves: Vec<String>,
}

#[derive(Template)]
#[template(path = "c/source.c", escape = "none")]
struct CSource<'a> {
    printer: &'a CPrinter<'a>,
    banner: &'a [String],
    needs_math: bool,
    needs_string: bool,
    /// The number of teams and the longest walk, where the body walks over tables.
    walk: Option<(usize, usize)>,
    helpers: String,
    body: String,
    sources: &'a [SourceView],
    /// The states of the self-test, and the answers to them.
    vectors: Vec<(String, String)>,
    /// The outputs, then the next values of the memory.
    outputs: &'a [OutputView],
    /// The values of an answer, and of the memory.
    parts: (&'a [OutputView], &'a [OutputView]),
    /// The statements that put a state into a view.
    observed: Vec<String>,
    /// The function that reads an image.
    look: String,
}

/// The two files.
pub(super) fn files(program: &Program<'_>) -> Vec<File> {
    let (graph, module) = (program.graph(), &program.module);
    let prefix = program.options.prefix.lower();
    let gegelati = program.shape == Shape::Gegelati;
    let integers = matches!(program.shape, Shape::Integers(_));
    let printer = CPrinter {
        graph,
        nodes: &module.nodes,
        prefix,
        gegelati,
        integers,
        short_cuts: false,
        branch_free: program.is_branch_free(),
        leads: false,
    };
    let kind = |bits: u32| if integers { format!("int{bits}_t") } else { printer.scalar().to_owned() };
    let sources = sources(graph, comment, |source| kind(source_bits(source)));
    let outputs = outputs(&printer, comment, |output| kind(output_bits(output)));
    let mut own_helpers = None;
    let (printer, body) = match &program.shape {
        Shape::Gegelati => (printer, gegelati::render(&printer, module)),
        Shape::Fast(schedule) => {
            let leads = compares_in_functions(module);
            let printer = CPrinter { nodes: &schedule.nodes, short_cuts: true, leads, ..printer };
            (printer, fast::render(&printer, module, schedule, &outputs))
        }
        Shape::Balanced(cases) => {
            let printer = CPrinter { nodes: &cases.nodes, ..printer };
            (printer, balanced::render(&printer, cases, &outputs))
        }
        Shape::Small(code) => (printer, small::render(&printer, code, &outputs)),
        Shape::ConstantTime => (printer, constant_time::render(&printer, module, &outputs)),
        Shape::Formula => (printer, formula::render(&printer, module, &outputs)),
        Shape::Integers(integers) => {
            let (helpers, body) = integers::render(&printer, program, integers, &outputs);
            own_helpers = Some(helpers);
            (printer, body)
        }
    };
    let helpers = own_helpers.unwrap_or_else(|| helpers::render(&printer, &body));
    let banner = banner::lines(program);
    let seen = &sources[..sources.len() - graph.memory()];
    let (answers, memory) = outputs.split_at(outputs.len() - graph.memory());
    let observed = if memory.is_empty() {
        Vec::new()
    } else {
        seen.iter().flat_map(|source| observed(source, integers)).collect()
    };
    let chosen = vectors(graph);
    let seen_image = LookView::new(graph, &sources).filter(|_| !gegelati);
    let header = CHeader {
        printer: &printer,
        banner: &banner,
        sources: seen,
        actions: actions(graph, &printer.upper()),
        asks: asks(graph),
        outputs: answers,
        memory,
        arm: arm_view(graph),
        look: seen_image.as_ref(),
        quality: chosen.quality(),
    };
    let vectors = views(&printer, &chosen);
    let shown = vectors.iter().flat_map(|(state, answer)| [state, answer]);
    let needs_math = [&helpers, &body].into_iter().chain(shown).any(|text| uses_maths(text)) && !integers;
    let needs_string = [&helpers, &body].into_iter().chain(&observed).any(|text| text.contains("memcpy"));
    let source = CSource {
        printer: &printer,
        banner: &banner,
        needs_math,
        needs_string,
        walk: body.contains("_TEAMS").then_some((module.teams.len(), module.depth)),
        helpers,
        body,
        sources: &sources,
        vectors,
        outputs: &outputs,
        parts: (answers, memory),
        observed,
        look: seen_image.as_ref().map_or_else(String::new, |view| look::c(view, prefix)),
    };
    let text = |text: askama::Result<String>| layout::wrap(&layout::tidy(&text.expect("the template renders")), false);
    vec![
        File { name: format!("{prefix}.h"), text: text(header.render()) },
        File { name: format!("{prefix}.c"), text: text(source.render()) },
    ]
}

/// Tests whether C uses something of `<math.h>`, which a chip without a C library may not have.
fn uses_maths(text: &str) -> bool {
    const FUNCTIONS: [&str; 9] = ["atan", "cos", "exp", "fabs", "log", "sin", "sqrt", "tan", "tanh"];
    let word = |word: &str| {
        let function = word.strip_suffix('f').unwrap_or(word);
        ["INFINITY", "NAN", "isnan"].contains(&word) || FUNCTIONS.contains(&function)
    };
    text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').any(word)
}

/// `None` where the runtime's C interface cannot drive the arm with it: it computes in `f32`.
fn arm_view(graph: &Graph) -> Option<CArmView> {
    let moves = moves(graph).filter(|_| graph.scalar() == ScalarType::F32)?;
    let sources = graph.sources().iter().map(|source| format!("TPG_SOURCE_{}", source.name.to_ascii_uppercase()));
    let moves = moves.iter().map(|moves| {
        let ticks: Vec<String> = moves.iter().map(i8::to_string).collect();
        format!("{{ {{ {} }} }}", ticks.join(", "))
    });
    Some(CArmView { sources: sources.collect(), moves: moves.collect() })
}

/// The statements that copy a source from a state to a view.
fn observed(source: &SourceView, one_by_one: bool) -> Vec<String> {
    /// More values than this are copied as a block.
    const FEW: usize = 16;
    let SourceView { field: name, length, .. } = source;
    if *length > FEW && !one_by_one {
        return vec![format!("(void)memcpy(view.{name}, state->{name}, sizeof view.{name});")];
    }
    match length {
        1 => vec![format!("view.{name} = state->{name};")],
        _ => (0..*length).map(|place| format!("view.{name}[{place}] = state->{name}[{place}];")).collect(),
    }
}

fn views(printer: &CPrinter<'_>, Vectors { states, answers, .. }: &Vectors) -> Vec<(String, String)> {
    let (graph, constants) = (printer.graph, printer.constants());
    (states.chunks_exact(graph.state_length()).zip(answers))
        .map(|(state, answer)| {
            let mut values = state.iter();
            let members = graph.sources().iter().map(|source| {
                let values: Vec<String> =
                    values.by_ref().take(source.ranges.len()).map(|&value| printer.literal(value)).collect();
                match &values[..] {
                    [value] if !printer.gegelati => value.clone(),
                    _ => format!("{{ {} }}", values.join(", ")),
                }
            });
            let state = format!("{{ {} }}", members.collect::<Vec<_>>().join(", "));
            let answer = match answer {
                Answer::Action(action) if printer.gegelati => format!("{}U", action.0),
                Answer::Action(action) => constants[usize::from(action.0)].clone(),
                Answer::Values(values) => {
                    let values: Vec<String> = values.iter().map(|&value| printer.literal(value)).collect();
                    format!("{{ {} }}", values.join(", "))
                }
            };
            (state, answer)
        })
        .collect()
}
