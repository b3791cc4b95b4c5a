//! GEGELATI's `.dot` format.
//!
//! Together with its [sidecar](super::sidecar) the text reads back as the same graph: nodes keep their numbers and the
//! graph's order. Programs therefore come before the edges, whereas GEGELATI's own exporter mixes the two; its reader
//! accepts both.

use crate::model::{ActionId, Destination, Graph, Input, Line, Operand, Program, Team};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::{self, Write as _};

/// Returns the text of the `.dot` file. Outputs are GEGELATI 2's continuous actions: an action node for each leaf, and a
/// program for each value that its label names.
///
/// # Errors
/// The part of the graph that the format cannot express: counts, an image, or memory.
pub fn text(graph: &Graph) -> Result<String, Inexpressible> {
    if graph.has_counts() {
        return Err(Inexpressible::Counts);
    }
    if graph.sees() {
        return Err(Inexpressible::Image);
    }
    match graph.memory() {
        0 => Ok(Writer::new(graph).text()),
        _ => {
            let (_, memory) = graph.split_outputs();
            Err(Inexpressible::Memory(memory.iter().map(|value| value.name.clone()).collect()))
        }
    }
}

/// The part of a graph that GEGELATI's format cannot express.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Inexpressible {
    /// The worth of counts.
    Counts,
    /// Features of an image.
    Image,
    /// Memory, by its names.
    Memory(Vec<String>),
}

impl fmt::Display for Inexpressible {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Counts => f.write_str("a policy of counts: GEGELATI's format does not say what a count is worth"),
            Self::Image => f.write_str("a policy that sees an image: GEGELATI's format has no features of one"),
            Self::Memory(memory) => write!(
                f,
                "a policy with memory ({}): in GEGELATI's format a decision depends on the state alone",
                memory.join(", ")
            ),
        }
    }
}

struct Writer<'g> {
    graph: &'g Graph,
    constants: Vec<DotConstants>,
    /// True for what GEGELATI 1 cannot say: constants that are no 32-bit integers, and outputs.
    second: bool,
    /// The programs that compute outputs.
    computing: BTreeSet<usize>,
    /// Constants per program: the number needed by the program with the most constants.
    count: usize,
    /// Operands per line: the number read by the widest instruction of the set.
    operands: usize,
    /// Source and location of every input.
    inputs: Vec<(usize, usize)>,
    out: String,
}

impl<'g> Writer<'g> {
    fn new(graph: &'g Graph) -> Self {
        let constants: Vec<DotConstants> = graph.programs().iter().map(DotConstants::new).collect();
        let count = constants.iter().map(|constants| constants.values.len()).max().unwrap_or(0);
        let first_source = if count == 0 { 1 } else { 2 };
        Self {
            graph,
            second: !graph.leaves().is_empty()
                || !constants.iter().flat_map(|constants| &constants.values).all(|&value| is_integer(value)),
            computing: (graph.leaves().iter()).flat_map(|leaf| leaf.programs.iter().map(|id| id.index())).collect(),
            constants,
            count,
            operands: graph.instructions().iter().map(|instruction| instruction.arity()).max().unwrap_or(1),
            inputs: (first_source..)
                .zip(graph.sources())
                .flat_map(|(number, source)| (0..source.ranges.len()).map(move |location| (number, location)))
                .collect(),
            out: String::new(),
        }
    }

    fn text(mut self) -> String {
        let graph = self.graph;
        self.put(format_args!("// File exported with tpg-codegen v{}\n", env!("CARGO_PKG_VERSION")));
        self.put(format_args!("digraph{{\n"));
        self.put(format_args!("\tgraph[pad = \"0.212, 0.055\" bgcolor = lightgray]\n"));
        self.put(format_args!("\tnode[shape=circle style = filled label = \"\"]\n"));
        let teams = if graph.is_formula() { &[] } else { graph.teams() };
        let root = match teams {
            [] => format!("A{}", graph.leaves()[0].label),
            _ => format!("T{}", graph.team(graph.root()).label),
        };
        for team in teams {
            let name = format!("T{}", team.label);
            let colour = if name == root { "#1199bb" } else { "#66ddff" };
            self.put(format_args!("\t\t{name} [fillcolor=\"{colour}\"]\n"));
        }
        for (index, program) in graph.programs().iter().enumerate() {
            self.program(index, program);
        }
        self.leaves();
        self.edges(teams);
        self.put(format_args!("\t\t{{ rank= same {root} }}\n}}\n"));
        self.out
    }

    fn put(&mut self, text: std::fmt::Arguments<'_>) {
        self.out.write_fmt(text).expect("writing to a string never fails");
    }

    fn program(&mut self, index: usize, program: &Program) {
        let label = program.label;
        let values = self.constants[index].values.iter().copied().chain(std::iter::repeat(0.0)).take(self.count);
        let list: String = match self.second {
            false => values.map(|value| format!("{value}|")).collect(),
            true => values.map(|value| format!("{value:?}|")).collect(),
        };
        let of_action = match (self.second, self.computing.contains(&index)) {
            (false, _) => "",
            (true, false) => " label=\"0\"",
            (true, true) => " label=\"1\"",
        };
        self.put(format_args!("\t\tP{label} [fillcolor=\"#cccccc\" shape=point{of_action}] //{list}\n"));
        self.put(format_args!("\t\tI{label} [shape=box style=invis label=\""));
        for line in &program.lines {
            self.line(index, line);
        }
        self.put(format_args!("\"]\n"));
        self.put(format_args!("\t\tP{label} -> I{label}[style=invis]\n"));
    }

    fn line(&mut self, program: usize, line: &Line) {
        let number = self.graph.instructions().iter().position(|&instruction| instruction == line.instruction);
        let number = number.expect("a validated graph declares its instructions");
        self.put(format_args!("{number}|{}", line.to.index()));
        let read = line.operands.iter().take(line.instruction.arity()).map(|&operand| match operand {
            Operand::Register(register) => (0, register.index()),
            Operand::Constant(value) => (1, self.constants[program].places[&value.to_bits()]),
            Operand::Input(Input(place)) => self.inputs[usize::from(place)],
        });
        let operands: Vec<(usize, usize)> = read.chain(std::iter::repeat((0, 0))).take(self.operands).collect();
        for (place, (source, location)) in operands.into_iter().enumerate() {
            let mark = if place == 0 { '&' } else { '#' };
            self.put(format_args!("{mark}{source}|{location}"));
        }
        self.put(format_args!("&#92;n"));
    }

    /// Writes the leaves and their programs, in the order of the outputs.
    fn leaves(&mut self) {
        let graph = self.graph;
        for leaf in graph.leaves() {
            let values: Vec<String> = (0..leaf.programs.len()).map(|value| value.to_string()).collect();
            self.action(leaf.label, &values.join("-"));
            for &program in &leaf.programs {
                self.put(format_args!("\t\tA{} -> P{}\n", leaf.label, graph.program(program).label));
            }
        }
    }

    fn action(&mut self, node: u32, label: &str) {
        self.put(format_args!(
            "\t\tA{node} [fillcolor=\"#ff3366\" shape=box margin=0.03 width=0 height=0 label=\"{label}\"]\n"
        ));
    }

    /// Writes the edges. Only the first edge of a program states its destination.
    fn edges(&mut self, teams: &[Team]) {
        let graph = self.graph;
        let mut led = vec![false; graph.programs().len()];
        let mut action_nodes = 0;
        for team in teams {
            for edge in &team.edges {
                let program = graph.program(edge.program).label;
                if std::mem::replace(&mut led[edge.program.index()], true) {
                    self.put(format_args!("\t\tT{} -> P{program}\n", team.label));
                    continue;
                }
                match edge.to {
                    Destination::Team(to) => {
                        let to = graph.team(to).label;
                        self.put(format_args!("\t\tT{} -> P{program} -> T{to}\n", team.label));
                    }
                    Destination::Action(ActionId(leaf)) if !graph.leaves().is_empty() => {
                        let node = graph.leaves()[usize::from(leaf)].label;
                        self.put(format_args!("\t\tT{} -> P{program} -> A{node}\n", team.label));
                    }
                    Destination::Action(action) => {
                        self.action(action_nodes, &action.0.to_string());
                        self.put(format_args!("\t\tT{} -> P{program} -> A{action_nodes}\n", team.label));
                        action_nodes += 1;
                    }
                }
            }
        }
    }
}

/// The constants of one program: each once, in the order in which the lines read them.
struct DotConstants {
    values: Vec<f64>,
    /// Keyed by bits because −0 and 0 are different constants.
    places: BTreeMap<u64, usize>,
}

impl DotConstants {
    fn new(program: &Program) -> Self {
        let mut constants = Self { values: Vec::new(), places: BTreeMap::new() };
        let read = program.lines.iter().flat_map(|line| &line.operands[..line.instruction.arity()]);
        for operand in read {
            if let Operand::Constant(value) = *operand {
                constants.places.entry(value.to_bits()).or_insert_with(|| {
                    constants.values.push(value);
                    constants.values.len() - 1
                });
            }
        }
        constants
    }
}

/// True if `value` is a 32-bit integer; −0 is not.
fn is_integer(value: f64) -> bool {
    f64::from(value as i32).to_bits() == value.to_bits()
}

#[cfg(test)]
mod tests {
    use super::is_integer;

    #[test]
    fn integers_of_32_bits() {
        for value in [0.0, -1.0, 2147483647.0, -2147483648.0] {
            assert!(is_integer(value), "{value}");
        }
        for value in [-0.0, 0.5, 2147483648.0, -2147483649.0, 1e300] {
            assert!(!is_integer(value), "{value}");
        }
    }
}
