//! From a graph of floats to a graph of whole numbers, which compiles to integers.
//!
//! Every value of the state gets a scale, such that the range that it has fills the bits that it comes in. A sum of inputs is then a sum
//! of counts with whole weights, `round(weight * scale * K)`: one K for all bids of a team, for they are compared, and one for each
//! output, the greatest power of two at which weights and sum fit. Nothing else needs rounding but products, quotients and outputs, which
//! the word `quotient` does.
//!
//! | module | subject |
//! | --- | --- |
//! | `build` | values times a scale, in whole numbers |
//! | `program` | whole numbers as lines of programs |
//! | `compare` | how far both graphs differ |

mod build;
mod compare;
mod program;

pub use compare::{Agreement, OutputDifference};

use crate::ir::{Module, Node, NodeId, Successor, reached};
use crate::passes;
use askama::Template;
use build::{Builder, memory_scale, power_below};
use program::Programs;
use serde::Serialize;
use serde_json::{Value, json};
use tpg_graph::error::InputError;
use tpg_graph::states::StateSet;
use tpg_graph::{
    Counts, Document, EdgeDocument, Graph, LeafDocument, MathsProvider, MemoryDocument, OutputDocument,
    ProgramDocument, Range, ScalarType, SourceDocument, TeamDocument,
};

/// Bits of an output.
const OUTPUT_BITS: u32 = 16;

/// The options.
#[derive(Clone, Debug)]
pub struct Request<'a> {
    /// Bits of the inputs.
    pub inputs: u32,
    /// Bits of the weights.
    pub weights: u32,
    /// The states on which both graphs are compared. The values of visited ones fill the bits, else the declared ranges do.
    pub states: &'a StateSet,
    /// The multiple of these ranges that fills the bits.
    pub margin: f64,
    /// Values by label, as in `target[0]`, that a sensor delivers in counts of its own.
    pub given: &'a [(String, Counts)],
}

impl<'a> Request<'a> {
    /// Inputs and weights of so many bits.
    pub fn of_bits(bits: u32, states: &'a StateSet) -> Self {
        Self { inputs: bits, weights: bits, states, margin: 1.0, given: &[] }
    }
}

/// The quantisation in figures; for people, their text.
#[derive(Clone, Debug, PartialEq, Serialize, Template)]
#[template(path = "quantised.txt", escape = "none")]
pub struct QuantiseReport {
    /// Bits of the inputs.
    pub inputs: u32,
    /// Bits of the weights.
    pub weights: u32,
    /// The greatest magnitude of each team's bids and each output's sum.
    pub bounds: Vec<(String, u64)>,
    /// Weights that became 0.
    pub vanished: usize,
    /// The comparison of both graphs.
    pub comparison: Agreement,
}

/// Makes the graph of whole numbers; `file` is the graph's name in messages.
///
/// # Errors
/// A value that cannot be put into integers: one whose range has no width or no end, an output without limits that mean something, an
/// instruction that integers do not have.
pub fn quantise(file: &str, graph: &Graph, request: &Request<'_>) -> Result<(Graph, QuantiseReport), InputError> {
    let refuse = |place: &str, found: &str, accepted: &str| Err(InputError::new(file, place, found, accepted));
    if graph.has_counts() {
        return refuse("$.sources[0].counts", "a graph of counts", "a graph that is not in integers yet");
    }
    let module = passes::optimise(graph);
    let counts = counts(file, graph, &module, request)?;
    let observed = graph.observed_length();
    let mut quantiser = Quantiser {
        graph,
        module: &module,
        builder: Builder::new(&module, counts.clone(), observed, request.weights),
        programs: Programs { registers: 1, ..Programs::default() },
        bounds: Vec::new(),
    };
    let document = match quantiser.document(&counts, request) {
        Ok(document) => document,
        Err(found) => {
            let accepted = "sums, products, quotients, minima, maxima, magnitudes and choices";
            return refuse("$.programs", &found, accepted);
        }
    };
    let Quantiser { builder, bounds, .. } = quantiser;
    let vanished = builder.vanished;
    let counted = Graph::from_document(file, document)?;
    let comparison = Agreement::new(graph, &counted, request.states);
    for (output, difference) in graph.outputs().iter().zip(&comparison.outputs) {
        // Even one count would be beyond what any actuator does.
        let is_too_coarse = output.range.max - output.range.min > 1e30;
        if !difference.mean.is_finite() || is_too_coarse {
            let found = format!("{:?} limited to {}", output.name, output.range);
            return refuse("$.outputs", &found, "limits that the actuator has");
        }
    }
    let report = QuantiseReport { inputs: request.inputs, weights: request.weights, bounds, vanished, comparison };
    Ok((counted, report))
}

/// The counts of each value of the state; of memory, those that the graph keeps.
fn counts(file: &str, graph: &Graph, module: &Module<'_>, request: &Request<'_>) -> Result<Vec<Counts>, InputError> {
    let mut ranges: Vec<Range> = graph.state_ranges().collect();
    let observed = graph.observed_length();
    if request.states.is_visited {
        ranges.truncate(observed);
        ranges.fill(Range { min: f64::INFINITY, max: f64::NEG_INFINITY });
        ranges.extend(graph.state_ranges().skip(observed));
        for state in request.states.states.chunks_exact(graph.state_length()) {
            for (range, &value) in ranges[..observed].iter_mut().zip(state) {
                // NaN makes an end NaN, which is refused.
                range.min = if range.min.is_nan() || range.min <= value { range.min } else { value };
                range.max = if range.max.is_nan() || range.max >= value { range.max } else { value };
            }
        }
    }
    let labels: Vec<String> = graph.inputs().take(observed).map(|input| graph.input_label(input)).collect();
    // As CSV files do, `[0]` may name the only value of a source.
    let is = |label: &String, name: &str| label == name || name.strip_suffix("[0]") == Some(label);
    if let Some((name, _)) = request.given.iter().find(|(name, _)| !labels.iter().any(|label| is(label, name))) {
        return Err(InputError::new(file, "$.sources", format!("no value {name:?}"), labels.join(", ")));
    }
    let top = f64::from((1_u32 << (request.inputs - 1)) - 1);
    (graph.inputs().zip(&ranges))
        .map(|(input, range)| {
            let greatest = range.magnitude();
            let given =
                request.given.iter().rfind(|(name, _)| labels.get(input.index()).is_some_and(|label| is(label, name)));
            if let Some((_, counts)) = given {
                return Ok(*counts);
            }
            if let Some(limits) = graph.image_range(input) {
                // A value of an image is a count already.
                let counts = |bits| Counts { bits, scale: 1.0, offset: 0.0 };
                let holds =
                    |bits: &u32| counts(*bits).limits()[0] <= limits[0] && limits[1] <= counts(*bits).limits()[1];
                let found = || format!("{}: {} to {}", graph.input_label(input), limits[0], limits[1]);
                let refused = || InputError::new(file, "$.sources", found(), "windows whose sum fits 16 bits");
                return Counts::BITS.clone().find(holds).map(counts).ok_or_else(refused);
            }
            if input.index() >= observed {
                return Ok(Counts { bits: 16, scale: 1.0 / memory_scale(greatest), offset: 0.0 });
            }
            let is_read = module.nodes.contains(&Node::Input(input));
            let width = range.max - range.min;
            if is_read && !(width > 0.0 && width.is_finite()) {
                let what = if width == 0.0 { "a range of zero width" } else { "a range without end" };
                let found = format!("{}: {range}, {what}", graph.input_label(input));
                let accepted =
                    if request.states.is_visited { "states in which it varies, finite" } else { "a range that it has" };
                return Err(InputError::new(file, "$.sources", found, accepted));
            }
            let scale = greatest * request.margin / top;
            Ok(Counts {
                bits: request.inputs,
                scale: if scale > 0.0 && scale.is_finite() { scale } else { 1.0 },
                offset: 0.0,
            })
        })
        .collect()
}

/// The scale of an output: the greatest power of two at which its range fits.
fn output_scale(range: Range) -> f64 {
    let top = f64::from((1_u32 << (OUTPUT_BITS - 1)) - 1);
    let greatest = range.magnitude();
    // One bit is left: as many counts as a Q14 has.
    if greatest == 0.0 { 1.0 } else { power_below(top / greatest).min(16384.0) }
}

/// The count of a value; not −0.
fn scaled(value: f64, scale: f64) -> f64 {
    (value * scale).round() + 0.0
}

struct Quantiser<'a> {
    graph: &'a Graph,
    module: &'a Module<'a>,
    builder: Builder<'a>,
    programs: Programs,
    bounds: Vec<(String, u64)>,
}

impl Quantiser<'_> {
    fn document(&mut self, counts: &[Counts], request: &Request<'_>) -> Result<Document, String> {
        let module = self.module;
        let is_formula = module.only_leaf().is_some();
        let teams = if is_formula {
            Vec::new()
        } else {
            (module.teams.iter()).map(|team| self.team(team)).collect::<Result<_, _>>()?
        };
        let leaves: Vec<LeafDocument> =
            reached(&module.leaves).map(|(_, leaf)| self.leaf(leaf, counts)).collect::<Result<_, _>>()?;
        let programs = std::mem::take(&mut self.programs);
        let programs_written = (0..).zip(programs.all).map(|(id, (_, lines))| ProgramDocument { id, lines }).collect();
        let original = self.graph.to_document();
        let mut provenance = original.provenance.clone();
        let said = json!({ "inputs": request.inputs, "weights": request.weights, "graph_sha256": self.graph.sha256() });
        match &mut provenance.config {
            Some(Value::Object(config)) => {
                config.insert("quantised".to_owned(), said);
            }
            config => *config = Some(json!({ "quantised": said })),
        }
        let words = programs.words;
        Ok(Document {
            version: 2,
            scalar: ScalarType::F64,
            maths: MathsProvider::Own,
            registers: programs.registers,
            sources: self.sources(counts),
            instructions: if words.is_empty() { vec!["copy".to_owned()] } else { words.into_iter().collect() },
            outputs: self.graph.split_outputs().0.iter().map(output).collect(),
            memory: original.memory.iter().map(memory).collect(),
            root: (!is_formula).then(|| module.teams[0].label),
            teams,
            leaves,
            programs: programs_written,
            provenance,
            ..original
        })
    }

    fn sources(&self, counts: &[Counts]) -> Vec<SourceDocument> {
        let mut counts = counts.iter();
        (self.graph.observed().iter())
            .map(|source| {
                let counts: Vec<Counts> = counts.by_ref().take(source.length as usize).copied().collect();
                let ranges = source.ranges.iter().zip(&counts);
                let ranges = ranges.map(|(range, counts)| range.map(|end| counts.count(end))).collect();
                SourceDocument { ranges, counts, ..source.clone() }
            })
            .collect()
    }

    /// The bids of a team, all with one scale.
    fn team(&mut self, team: &crate::ir::Team) -> Result<TeamDocument, String> {
        let bids: Vec<NodeId> = team.edges.iter().map(|edge| self.module.bidders[edge.bidder].value).collect();
        let room = bids.iter().map(|&bid| self.builder.room(bid)).fold(f64::INFINITY, f64::min);
        let scale = power_below(room);
        let mut bound = 0;
        let mut edges = Vec::new();
        for (&bid, edge) in bids.iter().zip(&team.edges) {
            let value = self.builder.at(bid, scale, 0.0)?;
            bound = bound.max(self.builder.whole(value).magnitude());
            let mut written =
                EdgeDocument { program: self.program(value, format!("{:?}", edge.to)), ..EdgeDocument::default() };
            match edge.to {
                Successor::Team(to) => written.team = Some(self.module.teams[to].label),
                Successor::Action(end) => match self.module.leaves.get(usize::from(end.0)) {
                    Some(leaf) => written.leaf = Some(leaf.label),
                    None => written.action = Some(u32::from(end.0)),
                },
            }
            edges.push(written);
        }
        self.bounds.push((format!("team {}", team.label), bound));
        Ok(TeamDocument { id: team.label, edges })
    }

    fn leaf(&mut self, leaf: &crate::ir::Leaf, counts: &[Counts]) -> Result<LeafDocument, String> {
        let (observed, answered) = (self.graph.observed_length(), self.graph.split_outputs().0.len());
        let (mut programs, mut memory) = (Vec::new(), Vec::new());
        for (place, (output, &value)) in self.graph.outputs().iter().zip(&leaf.values).enumerate() {
            let whole = match place.checked_sub(answered) {
                Some(place) => self.builder.at(value, 1.0 / counts[observed + place].scale, 0.0)?,
                None => self.builder.rounded(value, output_scale(output.range))?,
            };
            let inner = match self.builder.values.node(whole) {
                Node::Operation(tpg_runtime::ops::Instruction::Quotient, [sum, _]) => sum,
                _ => whole,
            };
            self.bounds.push((format!("leaf {}, {}", leaf.label, output.name), self.builder.whole(inner).magnitude()));
            let program = self.program(whole, String::new());
            if place < answered { programs.push(program) } else { memory.push(program) }
        }
        Ok(LeafDocument { id: leaf.label, programs, memory })
    }

    fn program(&mut self, value: NodeId, to: String) -> u32 {
        self.programs.add(self.graph, &self.builder.values, value, to)
    }
}

fn output(output: &tpg_graph::Output) -> OutputDocument {
    let scale = output_scale(output.range);
    OutputDocument {
        name: output.name.clone(),
        unit: output.unit.clone(),
        min: scaled(output.range.min, scale),
        max: scaled(output.range.max, scale),
        nan: scaled(output.nan, scale),
        counts: Some(Counts { bits: OUTPUT_BITS, scale: 1.0 / scale, offset: 0.0 }),
    }
}

fn memory(memory: &MemoryDocument) -> MemoryDocument {
    let scale = memory_scale(Range { min: memory.min, max: memory.max }.magnitude());
    let [min, max, initial] = [memory.min, memory.max, memory.initial].map(|value| scaled(value, scale));
    MemoryDocument { name: memory.name.clone(), min, max, initial }
}
