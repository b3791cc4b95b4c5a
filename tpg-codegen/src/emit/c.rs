//! C99: one `.c` and one `.h`, a function for each program and team, the walk a bounded switch, as GEGELATI shapes it.

use super::{File, Options, Style, banner, layout};
use crate::graph::{Graph, Input, MathsProvider, ScalarType};
use crate::interpret;
use crate::ir::{Bidder, Module, Node, NodeId, Target};
use crate::states;
use askama::Template;
use tpg_runtime::ops::Instruction;

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
    gegelati: bool,
    system_maths: bool,
}

#[derive(Template)]
#[template(path = "c/source.c", escape = "none")]
struct Source<'a> {
    banner: &'a [String],
    prefix: &'a str,
    upper: &'a str,
    scalar: &'a str,
    helpers: Helpers,
    // The kernels' templates ask for these by name.
    uses_sin: bool,
    uses_cos: bool,
    uses_ln: bool,
    uses_exp: bool,
    sources: &'a [SourceView],
    programs: Vec<ProgramView>,
    teams: Vec<TeamView>,
    vectors: Vec<VectorView>,
    vertex: &'a str,
    gegelati: bool,
    /// The parameter and the argument that carry the state.
    parameter: String,
    argument: &'a str,
}

/// Static helpers: an unused one would be a warning, so only those that programs call are emitted.
struct Helpers {
    own: bool,
    f64: bool,
    used: Vec<Instruction>,
}

impl Helpers {
    fn uses(&self, name: &str) -> bool {
        Instruction::from_name(name).is_some_and(|instruction| self.used.contains(&instruction))
    }

    fn own_maths(&self) -> bool {
        self.own && ["sin", "cos", "ln", "exp"].iter().any(|name| self.uses(name))
    }
}

struct SourceView {
    name: String,
    length: usize,
    unit: String,
    range: String,
}

struct ProgramView {
    label: u32,
    statements: Vec<String>,
    result: String,
    reads_state: bool,
}

struct TeamView {
    label: u32,
    programs: Vec<u32>,
    next: String,
}

struct VectorView {
    state: String,
    action: u16,
}

/// Emits the two files.
pub(super) fn emit(graph: &Graph, module: &Module, options: &Options) -> Vec<File> {
    let banner = banner::lines(graph, module, options, "c");
    let prefix = options.prefix.lower();
    let upper = options.prefix.upper();
    let gegelati = options.style == Style::Gegelati;
    let scalar = match graph.scalar() {
        ScalarType::F32 => "float",
        ScalarType::F64 => "double",
    };
    let printer = Printer { graph, module, prefix, gegelati };
    let sources: Vec<SourceView> = graph.sources().iter().map(source_view).collect();
    let teams = module.teams.len();
    let header = Header {
        banner: &banner,
        prefix,
        upper: &upper,
        scalar,
        sources: &sources,
        actions: graph.actions().iter().map(|action| comment(&action.name)).collect(),
        teams,
        depth: module.depth,
        gegelati,
        system_maths: graph.maths() == MathsProvider::System,
    };
    let vertices = teams + graph.actions().len();
    let helpers = printer.helpers();
    let source = Source {
        banner: &banner,
        prefix,
        upper: &upper,
        scalar,
        uses_sin: helpers.uses("sin"),
        uses_cos: helpers.uses("cos"),
        uses_ln: helpers.uses("ln"),
        uses_exp: helpers.uses("exp"),
        helpers,
        sources: &sources,
        programs: module.bidders.iter().map(|bidder| printer.program(bidder)).collect(),
        teams: (0..teams).map(|team| printer.team(team)).collect(),
        vectors: vectors(graph),
        vertex: if vertices <= 1 << 16 { "uint16_t" } else { "uint32_t" },
        gegelati,
        parameter: if gegelati { "void".to_owned() } else { format!("const {prefix}_state_t *state") },
        argument: if gegelati { "" } else { "state" },
    };
    vec![
        File { name: format!("{prefix}.h"), text: layout::tidy(&header.render().expect("the template renders")) },
        File { name: format!("{prefix}.c"), text: layout::tidy(&source.render().expect("the template renders")) },
    ]
}

/// Text that may stand in a C comment.
fn comment(text: &str) -> String {
    text.chars().map(|c| if c.is_control() || c == '*' || c == '/' { ' ' } else { c }).collect()
}

fn source_view(source: &crate::graph::Source) -> SourceView {
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

/// A number so that the compiler reads the very same one.
fn literal(scalar: ScalarType, value: f64) -> String {
    match scalar {
        ScalarType::F32 => format!("{:?}F", value as f32),
        ScalarType::F64 => format!("{value:?}"),
    }
}

/// Writes nodes as C expressions.
struct Printer<'a> {
    graph: &'a Graph,
    module: &'a Module,
    prefix: &'a str,
    gegelati: bool,
}

impl Printer<'_> {
    fn helpers(&self) -> Helpers {
        let mut used: Vec<Instruction> = (self.module.nodes.iter())
            .filter_map(|node| if let Node::Operation(instruction, _) = node { Some(*instruction) } else { None })
            .collect();
        used.sort_unstable();
        used.dedup();
        Helpers { own: self.graph.maths() == MathsProvider::Own, f64: self.graph.scalar() == ScalarType::F64, used }
    }

    fn program(&self, bidder: &Bidder) -> ProgramView {
        let operations = self.module.operations_of(bidder.value);
        let scalar = if self.graph.scalar() == ScalarType::F32 { "float" } else { "double" };
        let reads = |id: &NodeId| matches!(self.module.node(*id), Node::Input(_));
        let reads_state = reads(&bidder.value)
            || operations.iter().any(|&id| match self.module.node(id) {
                Node::Operation(_, operands) => operands.iter().any(reads),
                Node::Constant(_) | Node::Input(_) => false,
            });
        ProgramView {
            label: bidder.label,
            statements: (operations.iter())
                .map(|&id| format!("const {scalar} v{} = {};", id.0, self.operation(id)))
                .collect(),
            result: self.value(bidder.value),
            reads_state,
        }
    }

    fn team(&self, index: usize) -> TeamView {
        let team = &self.module.teams[index];
        let next = team.edges.iter().map(|edge| format!("{}U", self.vertex(edge.to)));
        TeamView {
            label: team.label,
            programs: team.edges.iter().map(|edge| self.module.bidders[edge.bidder].label).collect(),
            next: next.collect::<Vec<_>>().join(", "),
        }
    }

    /// Teams are numbered from 0, the actions after them.
    fn vertex(&self, target: Target) -> usize {
        match target {
            Target::Team(team) => team,
            Target::Action(action) => self.module.teams.len() + usize::from(action.0),
        }
    }

    /// An operation's expression.
    fn operation(&self, id: NodeId) -> String {
        let Node::Operation(instruction, operands) = self.module.node(id) else {
            return self.value(id);
        };
        let [a, b] = operands.map(|operand| self.value(operand));
        let prefix = self.prefix;
        match instruction {
            Instruction::Sub => format!("{a} - {b}"),
            Instruction::Add => format!("{a} + {b}"),
            Instruction::Mul => format!("{a} * {b}"),
            Instruction::Div => format!("{a} / {b}"),
            Instruction::NegateIfLess | Instruction::Min | Instruction::Max => {
                format!("{prefix}_{}({a}, {b})", instruction.name())
            }
            Instruction::Cos => format!("{}({a})", self.maths("cos", "cos")),
            Instruction::Sin => format!("{}({a})", self.maths("sin", "sin")),
            Instruction::Ln => format!("{}({a})", self.maths("ln", "log")),
            Instruction::Exp => format!("{}({a})", self.maths("exp", "exp")),
            Instruction::Abs => format!("{}({a})", self.of_scalar("fabs")),
        }
    }

    fn maths(&self, own: &str, system: &str) -> String {
        match self.graph.maths() {
            MathsProvider::Own => format!("{}_{own}", self.prefix),
            MathsProvider::System => self.of_scalar(system),
        }
    }

    /// The name of a function of `<math.h>` in the graph's scalar type.
    fn of_scalar(&self, name: &str) -> String {
        match self.graph.scalar() {
            ScalarType::F32 => format!("{name}f"),
            ScalarType::F64 => name.to_owned(),
        }
    }

    fn value(&self, id: NodeId) -> String {
        match self.module.node(id) {
            Node::Constant(bits) => {
                let text = literal(self.graph.scalar(), f64::from_bits(bits));
                if text.starts_with('-') { format!("({text})") } else { text }
            }
            Node::Input(input) => self.input(input),
            Node::Operation(..) => format!("v{}", id.0),
        }
    }

    fn input(&self, input: Input) -> String {
        let (source, place) = self.graph.source_of(input);
        if self.gegelati {
            let number = self.graph.sources().iter().position(|s| s.name == source.name).unwrap_or(0) + 1;
            format!("in{number}[{place}]")
        } else {
            format!("state->{}[{place}]", source.name)
        }
    }
}
