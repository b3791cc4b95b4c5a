//! The shipped policies, the states that they see on every core, and their answers on this machine: the interpreter's.

use crate::Failure;
use crate::record::Hash;
use askama::Template;
use std::fs;
use std::path::{Path, PathBuf};
use tpg_codegen::emit::{Code, File, Language, Options, Prefix};
use tpg_codegen::quantise::{Request, quantise};
use tpg_graph::image::Vision;
use tpg_graph::interpret::{self, Answer};
use tpg_graph::states::StateSet;
use tpg_graph::{Graph, ScalarType, import};
use tpg_runtime::policy::ActionId;
use tpg_testing::library;

/// States of each policy on most cores.
pub(super) const STATES: usize = 10_000;

/// States of each policy in integers, and of each on an AVR.
pub(super) const FEWER_STATES: usize = 2_000;

/// Values that `policies.h` has room for.
const MOST_VALUES: u32 = 24;

/// The bits of a third of the states.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Bits {
    /// Any.
    Any,
    /// Zeros, infinities, NaN, and magnitudes from 2⁻³¹ to 2³²: AVR's C library rounds a denormal quotient to a neighbour.
    NeitherTinyNorHuge,
}

impl Bits {
    /// States of each policy: fewer of those in integers, and on an AVR, whose emulator is slow.
    pub(super) const fn states(self, integers: bool) -> usize {
        match self {
            Self::Any if !integers => STATES,
            _ => FEWER_STATES,
        }
    }

    fn apply(self, bits: u32) -> u32 {
        match (self, bits >> 23 & 255) {
            (Self::Any, _) | (_, 255) => bits,
            (Self::NeitherTinyNorHuge, 0) => bits & 0x8000_0000,
            (Self::NeitherTinyNorHuge, exponent) => bits & 0x807f_ffff | (96 + (exponent & 63)) << 23,
        }
    }
}

/// A policy that is shipped: its name as a prefix, and its graph.
#[derive(Debug)]
pub(super) struct Shipped {
    pub(super) prefix: Prefix,
    graph: Graph,
    /// A hash of the interpreter's answers for any bits, and for neither tiny nor huge ones.
    hashes: [Hash; 2],
}

/// The bits of integers that each policy is put into.
pub(super) const WIDTHS: [u32; 2] = [16, 8];

/// The graphs of `generated/` that see no image, and one with memory, by name.
pub(super) fn all() -> Result<Vec<Shipped>, Failure> {
    let generated = library::top().join("generated");
    let entries = fs::read_dir(&generated).map_err(|error| Failure::at(&generated, error))?;
    let mut paths: Vec<PathBuf> =
        entries.flatten().map(|entry| entry.path().join("graph.json")).filter(|path| path.is_file()).collect();
    paths.push(library::top().join("c-harness/pendulum/recall.json"));
    paths.sort();
    paths.iter().filter_map(|path| Shipped::load(path).transpose()).collect()
}

/// The policies that have no memory in integers, each of every width, with the width behind its name.
pub(super) fn integers(shipped: &[Shipped]) -> Result<Vec<Shipped>, Failure> {
    let mut integers = Vec::new();
    for one in shipped.iter().filter(|one| one.graph.memory() == 0) {
        for bits in WIDTHS {
            let compared = StateSet::sampled(&one.graph, 1, 1);
            let request = Request::of_bits(bits, &compared);
            let (graph, _) = quantise(&one.prefix.to_string(), &one.graph, &request)?;
            let prefix = format!("{}_{bits}", one.prefix).parse().map_err(Failure::new::<String>)?;
            integers.push(Shipped::new(prefix, graph));
        }
    }
    Ok(integers)
}

/// The low end and a 16,777,216th of the range of each input.
fn ranges(graph: &Graph) -> (Vec<f32>, Vec<f32>) {
    graph.state_ranges().map(|range| (range.min as f32, ((range.max - range.min) / 16_777_216.0) as f32)).unzip()
}

/// The states that `states.c` draws.
fn states(graph: &Graph, kind: Bits) -> Vec<f64> {
    let (low, step) = ranges(graph);
    let most = |input| graph.counts_of(input).map(|counts| counts.limits()[1] as f32);
    let most: Vec<Option<f32>> = graph.inputs().map(most).collect();
    let mut bits = 1u32;
    let count = kind.states(graph.has_counts());
    let mut states = Vec::with_capacity(count * low.len());
    for index in 0..count {
        for ((low, step), most) in low.iter().zip(&step).zip(&most) {
            bits ^= bits << 13;
            bits ^= bits >> 17;
            bits ^= bits << 5;
            let value = if index % 3 == 0 { f32::from_bits(kind.apply(bits)) } else { low + (bits >> 8) as f32 * step };
            states.push(f64::from(most.map_or(value, |most| counted(value, most))));
        }
    }
    states
}

/// A value as the count that `policies_integers.c` makes of it: cut off, and clipped.
fn counted(value: f32, most: f32) -> f32 {
    if value.is_nan() { 0.0 } else { value.clamp(-most, most).trunc() + 0.0 }
}

/// A hash of the interpreter's answers.
fn hash(graph: &Graph, states: &[f64]) -> Hash {
    let mut hash = Hash::new();
    for answer in interpret::answers(graph, states) {
        match answer {
            Answer::Action(ActionId(action)) => hash.add_bits(u32::from(action)),
            Answer::Values(values) if graph.has_counts() => {
                values.iter().for_each(|&count| hash.add_bits((count as i32).cast_unsigned()));
            }
            Answer::Values(values) => values.iter().for_each(|&value| hash.add_bits((value as f32).to_bits())),
        }
    }
    hash
}

impl Shipped {
    /// Reads a graph, unless it sees an image.
    fn load(path: &Path) -> Result<Option<Self>, Failure> {
        let graph = import::load(path, None, None)?;
        if Vision::new(graph.sources()).is_some() {
            return Ok(None);
        }
        if graph.scalar() != ScalarType::F32 {
            return Err(Failure::at(path, "it computes in f64, which an AVR does not have"));
        }
        if graph.state_length() as u32 > MOST_VALUES {
            return Err(Failure::at(path, format!("a state of more than {MOST_VALUES} values: see policies.h")));
        }
        Ok(Some(Self::new(Prefix::of_file(path), graph)))
    }

    fn new(prefix: Prefix, graph: Graph) -> Self {
        let hashes = [Bits::Any, Bits::NeitherTinyNorHuge].map(|bits| hash(&graph, &states(&graph, bits)));
        Self { prefix, graph, hashes }
    }

    /// The hash of its answers to states with such bits.
    pub(super) fn expected(&self, bits: Bits) -> &Hash {
        let [any, neither] = &self.hashes;
        if bits == Bits::Any { any } else { neither }
    }

    /// The number of its states with such bits.
    pub(super) fn states(&self, bits: Bits) -> usize {
        bits.states(self.graph.has_counts())
    }

    /// The generated C.
    ///
    /// # Errors
    /// A graph of counts that is no graph of whole numbers.
    pub(super) fn c(&self) -> Result<Vec<File>, Failure> {
        let options = Options::new(self.prefix.clone());
        let code = Code::of_graph(&self.prefix.to_string(), &self.graph, &options, Language::C);
        code.map(|code| code.files).map_err(Failure::new)
    }

    /// True where `tpg-generated` has it in Rust.
    pub(super) fn in_rust(&self) -> bool {
        self.graph.memory() == 0
    }

    /// What the template knows about it; `index` is its place among the others.
    fn view(&self, index: usize) -> PolicyView {
        let graph = &self.graph;
        let memory = graph.memory();
        let (low, step) = ranges(graph);
        let mut fields = Vec::new();
        for source in graph.sources() {
            let most = source.counts.iter().map(|counts| counts.limits()[1]).fold(0.0, f64::max);
            let length = source.ranges.len();
            for at in 0..length {
                let element = if length == 1 { String::new() } else { format!("[{at}]") };
                fields.push((format!("{}{element}", source.name), fields.len(), most));
            }
        }
        let outputs = graph.outputs();
        PolicyView {
            name: self.prefix.to_string(),
            bit: 1 << index,
            low,
            step,
            inputs: graph.state_length(),
            answers: outputs.len().max(1),
            memory: (memory > 0).then(|| graph.state_length() - memory),
            fields,
            outputs: outputs[..outputs.len() - memory].iter().map(|output| output.name.clone()).collect(),
        }
    }
}

/// A policy in [`PoliciesC`].
struct PolicyView {
    name: String,
    /// Its bit in `IN_IMAGE`.
    bit: u32,
    low: Vec<f32>,
    step: Vec<f32>,
    inputs: usize,
    answers: usize,
    /// The place of its memory in a state, if it has one.
    memory: Option<usize>,
    /// Each value of a state in integers, its place, and the greatest count.
    fields: Vec<(String, usize, f64)>,
    /// The outputs, memory aside.
    outputs: Vec<String>,
}

#[derive(Template)]
#[template(path = "policies.c", escape = "none")]
struct PoliciesC {
    policies: Vec<PolicyView>,
    integers: bool,
    rust: bool,
}

/// The code whose policies a file asks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ImageKind {
    C,
    Integers,
    Rust,
}

impl ImageKind {
    /// The name of the file.
    pub(super) const fn file(self) -> &'static str {
        match self {
            Self::C => "policies.c",
            Self::Integers => "policies_integers.c",
            Self::Rust => "policies_rust.c",
        }
    }
}

/// `policies.c`, of generated C, in floats or integers, or of generated Rust.
pub(super) fn policies_c(shipped: &[Shipped], kind: ImageKind) -> Result<File, Failure> {
    let asked = shipped.iter().filter(|one| kind != ImageKind::Rust || one.in_rust());
    let policies = asked.zip(0..).map(|(one, index)| one.view(index)).collect();
    let file = PoliciesC { policies, integers: kind == ImageKind::Integers, rust: kind == ImageKind::Rust };
    Ok(File { name: kind.file().to_owned(), text: file.render()? })
}
