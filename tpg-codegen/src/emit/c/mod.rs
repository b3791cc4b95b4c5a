//! C99: one `.c` and one `.h`, in the shape of a profile or of GEGELATI's generated code.

mod constant_time;
mod expression;
mod fast;
mod gegelati;
mod helpers;
mod small;
mod walk;

use super::{File, Language, Options, Profile, Style, banner, layout, moves::moves};
use crate::cost::{Cost, Costs};
use crate::ir::{Module, Target};
use crate::passes::{self, schedule};
use askama::Template;
use expression::{Printer, literal};
use tpg_graph::interpret;
use tpg_graph::states;
use tpg_graph::{Graph, MathsProvider, ScalarType};

/// States in the self-test.
const VECTORS: usize = 16;
/// The seed they are drawn with.
const VECTOR_SEED: u64 = 1;

#[derive(Template)]
#[template(path = "c/header.h", escape = "none")]
struct Header<'a> {
    banner: &'a [String],
    prefix: &'a str,
    upper: &'a str,
    scalar: &'a str,
    sources: &'a [SourceView],
    actions: Vec<String>,
    teams: usize,
    depth: usize,
    worst: Cost<u64>,
    gegelati: bool,
    system_maths: bool,
    arm: Option<ArmView>,
}

/// The sources and moves of a policy that drives the arm, as initialisers.
struct ArmView {
    sources: Vec<String>,
    moves: Vec<String>,
}

#[derive(Template)]
#[template(path = "c/source.c", escape = "none")]
struct Source<'a> {
    banner: &'a [String],
    prefix: &'a str,
    upper: &'a str,
    scalar: &'a str,
    f64: bool,
    needs_string: bool,
    helpers: String,
    body: String,
    sources: &'a [SourceView],
    vectors: Vec<VectorView>,
    gegelati: bool,
}

struct SourceView {
    name: String,
    length: usize,
    unit: String,
    range: String,
}

struct VectorView {
    state: String,
    action: u16,
}

/// Emits the two files.
pub(super) fn emit(graph: &Graph, options: &Options) -> Vec<File> {
    let prefix = options.prefix.lower();
    let upper = options.prefix.upper();
    let gegelati = options.style == Style::Gegelati;
    let module = if gegelati { Module::lower(graph) } else { passes::optimise(graph, options.assumption).0 };
    let printer = Printer { graph, nodes: &module.nodes, prefix, gegelati, short_cuts: false };
    let (helpers, body, costs) = if gegelati {
        let costs = Costs::bid_by_bid(module.clone());
        (helpers::render(&printer, false), gegelati::render(&printer, &module, &upper), costs)
    } else {
        match options.shape(Language::C, &module) {
            Profile::Fast => {
                let schedule = schedule::schedule(graph, &module, options.recorded());
                let printer = Printer { nodes: &schedule.nodes, short_cuts: true, ..printer };
                let costs = Costs::scheduled(module.clone(), &schedule, Language::C);
                (helpers::render(&printer, false), fast::render(&printer, &module, &schedule, &upper), costs)
            }
            Profile::Small => {
                let costs = Costs::bid_by_bid(module.clone());
                (helpers::render(&printer, false), small::render(&printer, &module, &upper), costs)
            }
            Profile::ConstantTime => {
                let costs = Costs::everything(module.clone());
                (helpers::render(&printer, true), constant_time::render(&printer, &module, &upper), costs)
            }
        }
    };
    let banner = banner::lines(graph, &module, options, Language::C);
    let sources: Vec<SourceView> = graph.sources().iter().map(source_view).collect();
    let header = Header {
        banner: &banner,
        prefix,
        upper: &upper,
        scalar: printer.scalar(),
        sources: &sources,
        actions: graph.actions().iter().map(|action| comment(&action.name)).collect(),
        teams: module.teams.len(),
        depth: module.depth,
        worst: costs.worst(),
        gegelati,
        system_maths: graph.maths() == MathsProvider::System,
        arm: arm_view(graph),
    };
    let source = Source {
        banner: &banner,
        prefix,
        upper: &upper,
        scalar: printer.scalar(),
        f64: graph.scalar() == ScalarType::F64,
        needs_string: helpers.contains("memcpy") || body.contains("memcpy"),
        helpers,
        body,
        sources: &sources,
        vectors: vectors(graph),
        gegelati,
    };
    vec![
        File { name: format!("{prefix}.h"), text: layout::tidy(&header.render().expect("the template renders")) },
        File { name: format!("{prefix}.c"), text: layout::tidy(&source.render().expect("the template renders")) },
    ]
}

/// `None` where the runtime's C interface cannot drive the arm with it: it computes in `f32`.
fn arm_view(graph: &Graph) -> Option<ArmView> {
    let moves = moves(graph).filter(|_| graph.scalar() == ScalarType::F32)?;
    let sources = graph.sources().iter().map(|source| format!("TPG_SOURCE_{}", source.name.to_ascii_uppercase()));
    let moves = moves.iter().map(|moves| {
        let ticks: Vec<String> = moves.iter().map(i8::to_string).collect();
        format!("{{ {{ {} }} }}", ticks.join(", "))
    });
    Some(ArmView { sources: sources.collect(), moves: moves.collect() })
}

/// Teams are numbered from 0, the actions after them.
fn vertex(module: &Module, target: Target) -> String {
    let number = match target {
        Target::Team(team) => team,
        Target::Action(action) => module.teams.len() + usize::from(action.0),
    };
    format!("{number}U")
}

/// The least type that numbers them.
fn vertex_type(graph: &Graph, module: &Module) -> &'static str {
    match module.teams.len() + graph.actions().len() {
        0..=0x100 => "uint8_t",
        0x101..=0x1_0000 => "uint16_t",
        _ => "uint32_t",
    }
}

/// Text that may stand in a C comment.
fn comment(text: &str) -> String {
    text.chars().map(|c| if c.is_control() || c == '*' || c == '/' { ' ' } else { c }).collect()
}

fn source_view(source: &tpg_graph::Source) -> SourceView {
    SourceView {
        name: source.name.clone(),
        length: source.ranges.len(),
        unit: comment(&source.unit),
        range: source.envelope().to_string(),
    }
}

fn vectors(graph: &Graph) -> Vec<VectorView> {
    let states = states::sample_in_range(graph, VECTORS, VECTOR_SEED);
    let actions = interpret::actions(graph, &states);
    (states.chunks_exact(graph.state_length()).zip(actions))
        .map(|(state, action)| {
            let mut values = state.iter();
            let members = graph.sources().iter().map(|source| {
                let values: Vec<String> =
                    values.by_ref().take(source.ranges.len()).map(|&v| literal(graph.scalar(), v)).collect();
                format!("{{ {} }}", values.join(", "))
            });
            let state = format!("{{ {} }}", members.collect::<Vec<_>>().join(", "));
            VectorView { state, action: action.0 }
        })
        .collect()
}
