//! Branch-free `no_std` Rust: every distinct operation once, then every team's choice by selects, then a bounded chase
//! from the root to an action. The time does not depend on the state.

use super::{File, Language, Options, banner, layout};
use crate::graph::{Graph, MathsProvider};
use crate::ir::{Module, Node, NodeId, Target};
use crate::passes;
use askama::Template;
use tpg_runtime::observation::Source as ArmSource;
use tpg_runtime::ops::Instruction;

#[derive(Template)]
#[template(path = "rust/policy.rs", escape = "none")]
struct Policy<'a> {
    banner: &'a [String],
    name: String,
    scalar: &'a str,
    /// `Own` or `System`, where a transcendental function is used.
    provider: Option<&'a str>,
    state_length: usize,
    sources: Vec<SourceView>,
    actions: Vec<String>,
    arm: Option<ArmView>,
    statements: Vec<String>,
    teams: Vec<TeamView>,
    /// The names of the teams' choices.
    next: Vec<String>,
    vertex: &'a str,
    depth: usize,
}

struct SourceView {
    name: String,
    unit: String,
    places: String,
    range: String,
}

/// The sources and moves of a policy that drives the arm.
struct ArmView {
    sources: Vec<String>,
    moves: Vec<String>,
}

struct TeamView {
    label: u32,
    first: EdgeView,
    others: Vec<EdgeView>,
}

struct EdgeView {
    bid: String,
    to: usize,
}

/// Emits the file.
pub(super) fn emit(graph: &Graph, options: &Options) -> Vec<File> {
    let module = &passes::optimise(graph, options.assumption).0;
    let printer = Printer { graph, module };
    let vertices = module.teams.len() + graph.actions().len();
    let policy = Policy {
        banner: &banner::lines(graph, module, options, Language::Rust),
        name: options.prefix.camel(),
        scalar: graph.scalar().name(),
        provider: printer.uses_maths().then_some(printer.provider()),
        state_length: graph.state_length(),
        sources: source_views(graph),
        actions: graph.actions().iter().map(|action| one_line(&action.name)).collect(),
        arm: arm_view(graph),
        statements: printer.statements(),
        teams: module.teams.iter().map(|team| printer.team(team)).collect(),
        next: (0..module.teams.len()).map(|team| format!("t{team}")).collect(),
        vertex: if vertices <= 1 << 16 { "u16" } else { "u32" },
        depth: module.depth,
    };
    let text = layout::tidy(&policy.render().expect("the template renders"));
    vec![File { name: format!("{}.rs", options.prefix), text }]
}

fn one_line(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}

fn source_views(graph: &Graph) -> Vec<SourceView> {
    let mut first = 0;
    (graph.sources().iter())
        .map(|source| {
            let end = first + source.ranges.len();
            let places = format!("{first}..{end}");
            first = end;
            SourceView {
                name: source.name.clone(),
                unit: one_line(&source.unit),
                places,
                range: source.envelope().to_string(),
            }
        })
        .collect()
}

/// `Some` where every source is one of the arm's and every action says what it moves.
fn arm_view(graph: &Graph) -> Option<ArmView> {
    let sources = (graph.sources().iter())
        .map(|source| ArmSource::from_name(&source.name).filter(|arm| arm.length() == source.ranges.len()))
        .map(|source| source.map(|source| format!("Source::{source:?}")))
        .collect::<Option<_>>()?;
    let moves = graph.actions().iter().map(|action| action.moves.map(|m| format!("Move({:?})", m.0)));
    Some(ArmView { sources, moves: moves.collect::<Option<_>>()? })
}

/// Writes nodes as Rust expressions.
struct Printer<'a> {
    graph: &'a Graph,
    module: &'a Module,
}

impl Printer<'_> {
    fn provider(&self) -> &'static str {
        match self.graph.maths() {
            MathsProvider::Own => "Own",
            MathsProvider::System => "System",
        }
    }

    fn uses_maths(&self) -> bool {
        let transcendental = |i| matches!(i, Instruction::Cos | Instruction::Sin | Instruction::Ln | Instruction::Exp);
        self.module.nodes.iter().any(|node| matches!(*node, Node::Operation(i, _) if transcendental(i)))
    }

    fn statements(&self) -> Vec<String> {
        (0u32..)
            .zip(&self.module.nodes)
            .filter(|(_, node)| matches!(node, Node::Operation(..)))
            .map(|(id, _)| format!("let v{id} = {};", self.operation(NodeId(id))))
            .collect()
    }

    fn team(&self, team: &crate::ir::Team) -> TeamView {
        let mut edges = team
            .edges
            .iter()
            .map(|edge| EdgeView { bid: self.value(self.module.bidders[edge.bidder].value), to: self.vertex(edge.to) });
        let first = edges.next().expect("a team has an edge");
        TeamView { label: team.label, first, others: edges.collect() }
    }

    fn vertex(&self, target: Target) -> usize {
        match target {
            Target::Team(team) => team,
            Target::Action(action) => self.module.teams.len() + usize::from(action.0),
        }
    }

    fn operation(&self, id: NodeId) -> String {
        let Node::Operation(instruction, operands) = self.module.node(id) else {
            return self.value(id);
        };
        let [a, b] = operands.map(|operand| self.value(operand));
        match instruction {
            Instruction::Sub => format!("{a} - {b}"),
            Instruction::Add => format!("{a} + {b}"),
            Instruction::Mul => format!("{a} * {b}"),
            Instruction::Div => format!("{a} / {b}"),
            Instruction::NegateIfLess | Instruction::Min | Instruction::Max => {
                format!("ops::{}({a}, {b})", instruction.name())
            }
            Instruction::Cos | Instruction::Sin | Instruction::Ln | Instruction::Exp => {
                format!("{}::{}({a})", self.provider(), instruction.name())
            }
            Instruction::Abs => format!("{}::abs({a})", self.graph.scalar().name()),
        }
    }

    fn value(&self, id: NodeId) -> String {
        match self.module.node(id) {
            Node::Constant(bits) => {
                let value = f64::from_bits(bits);
                match self.graph.scalar() {
                    crate::graph::ScalarType::F32 => format!("{:?}_f32", value as f32),
                    crate::graph::ScalarType::F64 => format!("{value:?}_f64"),
                }
            }
            Node::Input(input) => format!("s[{}]", input.index()),
            Node::Operation(..) | Node::Upper(..) => format!("v{}", id.0),
        }
    }
}
