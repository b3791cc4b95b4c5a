//! A validated graph and its parts.

use super::counts::Counts;
use super::document::{ActionDocument, MathsProvider, Provenance, ScalarType, SourceDocument};
use super::text;
use crate::word::Word;
use sha2::{Digest, Sha256};
use std::fmt::Write as _;
use tpg_runtime::policy::ActionId;

/// Index of a team in [`Graph::teams`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TeamId(pub(crate) u32);

/// Index of a program in [`Graph::programs`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ProgramId(pub(crate) u32);

/// A register of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Reg(pub(crate) u16);

/// An index into the flat state, which concatenates the values of all sources.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Input(pub u16);

impl TeamId {
    /// Returns the id as an index.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

impl ProgramId {
    /// Returns the id as an index.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

impl Reg {
    /// The register whose final value is the program's result: a bid, or an output.
    pub const RESULT: Self = Self(0);

    /// Returns the register as an index.
    pub fn index(self) -> usize {
        usize::from(self.0)
    }
}

impl Input {
    /// Returns the input as an index.
    pub fn index(self) -> usize {
        usize::from(self.0)
    }
}

/// A closed, finite range of values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Lowest value.
    pub min: f64,
    /// Highest value.
    pub max: f64,
}

impl std::fmt::Display for Range {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} to {}", self.min, self.max)
    }
}

impl std::fmt::Display for ActionDocument {
    /// Writes the name, and what the action asks: `help (asks network)`.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match &self.ask {
            Some(asked) => write!(f, "{} (asks {asked})", self.name),
            None => f.write_str(&self.name),
        }
    }
}

/// A value that a policy answers.
#[derive(Clone, Debug, PartialEq)]
pub struct Output {
    /// A C and Rust identifier.
    pub name: String,
    /// Unit of the value, for human readers.
    pub unit: String,
    /// The range that the value is limited to; its ends are exact in the graph's scalar type.
    pub range: Range,
    /// The value in place of NaN, in the range; of a memory, also the first value.
    pub nan: f64,
    /// The integers that it is, if it is counts.
    pub counts: Option<Counts>,
}

/// A leaf: the action of a policy with outputs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Leaf {
    /// Id in the source file.
    pub label: u32,
    /// The program of each value, in the order of [`Graph::outputs`].
    pub programs: Vec<ProgramId>,
}

/// An operand of an instruction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Operand {
    /// A register.
    Register(Reg),
    /// A value of the state.
    Input(Input),
    /// A number, finite and exact in the graph's scalar type.
    Constant(f64),
}

/// One line of a program: `to = word(operands)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// Destination register.
    pub to: Reg,
    /// The instruction, or the few that the line stands for.
    pub instruction: Word,
    /// As many operands as the word's arity; a word with one operand repeats it.
    pub operands: [Operand; 2],
}

/// A program: lines run in order on registers that start at zero; the final value of register 0 is its bid, or an output.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// Id in the source file.
    pub label: u32,
    /// Lines of the program.
    pub lines: Vec<Line>,
}

/// Destination of an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Destination {
    /// To another team: the walk goes on.
    Team(TeamId),
    /// To an action: the walk ends. In a policy with outputs, the number is that of a leaf.
    Action(ActionId),
}

/// A program that bids for its destination.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Edge {
    /// The bidding program.
    pub program: ProgramId,
    /// The destination it bids for.
    pub to: Destination,
}

/// A team: its edges bid; the highest bid wins, and among equal bids the last.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Team {
    /// Id in the source file.
    pub label: u32,
    /// Edges, at least one; their order decides ties.
    pub edges: Vec<Edge>,
}

/// A validated tangled program graph.
#[derive(Clone, Debug, PartialEq)]
pub struct Graph {
    pub(super) scalar: ScalarType,
    pub(super) maths: MathsProvider,
    pub(super) registers: u16,
    pub(crate) sources: Vec<SourceDocument>,
    pub(super) instructions: Vec<Word>,
    pub(super) actions: Vec<ActionDocument>,
    pub(super) outputs: Vec<Output>,
    pub(super) memory: usize,
    pub(super) leaves: Vec<Leaf>,
    pub(super) root: TeamId,
    /// The only leaf was written without a team: the root stands for it.
    pub(super) is_formula: bool,
    pub(super) teams: Vec<Team>,
    pub(crate) programs: Vec<Program>,
    pub(super) provenance: Provenance,
}

impl Graph {
    /// Returns the type programs compute in.
    pub fn scalar(&self) -> ScalarType {
        self.scalar
    }

    /// Returns the provider of sin, cos, tan, ln and exp.
    pub fn maths(&self) -> MathsProvider {
        self.maths
    }

    /// Returns the number of registers of a program.
    pub fn registers(&self) -> u16 {
        self.registers
    }

    /// Returns the data sources, in the order of the state; the last ones are the memory, if there is any.
    pub fn sources(&self) -> &[SourceDocument] {
        &self.sources
    }

    /// Returns the declared instruction set in its order.
    pub fn instructions(&self) -> &[Word] {
        &self.instructions
    }

    /// Returns the actions, by id; empty for a policy with outputs.
    pub fn actions(&self) -> &[ActionDocument] {
        &self.actions
    }

    /// Returns the other policies that actions ask, by name; a graph that asks none acts alone.
    pub fn asks(&self) -> impl Iterator<Item = &str> {
        self.actions.iter().filter_map(|action| action.ask.as_deref())
    }

    /// Returns the number of values that leaves compute for the next decision: the last of the [outputs](Self::outputs),
    /// and, under the same names, the last of the [sources](Self::sources), each of one value.
    ///
    /// A decision therefore stays a function: of the observed values and the memory, to the answer and the next memory.
    /// Whoever asks feeds the memory back; it begins with each one's [`Output::nan`].
    pub fn memory(&self) -> usize {
        self.memory
    }

    /// Returns the values that leaves compute, in order: the outputs, then the next values of the memory. Empty for a
    /// policy that answers with an action.
    pub fn outputs(&self) -> &[Output] {
        &self.outputs
    }

    /// Returns the leaves, by number; empty for a policy that answers with an action.
    pub fn leaves(&self) -> &[Leaf] {
        &self.leaves
    }

    /// Returns the number of ends of a walk: actions, or leaves.
    pub fn ends(&self) -> usize {
        self.actions.len() + self.leaves.len()
    }

    /// Tests for a policy without a decision: a single leaf, and no team in the file. The root then has one edge, to it.
    pub fn is_formula(&self) -> bool {
        self.is_formula
    }

    /// Names the end of a walk: "action 3 left", or "leaf 7" by the leaf's id in the file.
    pub fn end_name(&self, end: ActionId) -> String {
        let number = usize::from(end.0);
        match self.leaves.get(number) {
            Some(leaf) => format!("leaf {}", leaf.label),
            None => format!("action {number} {}", self.actions[number]),
        }
    }

    /// Returns the team where the walk starts.
    pub fn root(&self) -> TeamId {
        self.root
    }

    /// Returns the teams, by id.
    pub fn teams(&self) -> &[Team] {
        &self.teams
    }

    /// Returns the programs, by id.
    pub fn programs(&self) -> &[Program] {
        &self.programs
    }

    /// Returns a team.
    pub fn team(&self, id: TeamId) -> &Team {
        &self.teams[id.index()]
    }

    /// Returns a program.
    pub fn program(&self, id: ProgramId) -> &Program {
        &self.programs[id.index()]
    }

    /// Returns the origin of the graph.
    pub fn provenance(&self) -> &Provenance {
        &self.provenance
    }

    /// Returns the number of values in a state: the total length of all sources.
    pub fn state_length(&self) -> usize {
        self.sources.iter().map(|source| source.ranges.len()).sum()
    }

    /// Iterates over the inputs of a state, in order.
    pub fn inputs(&self) -> impl Iterator<Item = Input> + use<> {
        (0..self.state_length()).map(|place| Input(place as u16))
    }

    /// Iterates over the declared range of each value of the state.
    pub fn state_ranges(&self) -> impl Iterator<Item = Range> + '_ {
        self.sources.iter().flat_map(|source| &source.ranges).map(|&[min, max]| Range { min, max })
    }

    /// Tests for a graph that sees and answers counts.
    pub fn has_counts(&self) -> bool {
        self.sources.iter().any(|source| !source.counts.is_empty())
    }

    /// Returns the lowest and highest value that an input can have if it comes from an image.
    pub fn image_range(&self, input: Input) -> Option<[f64; 2]> {
        let (source, place) = self.source_of(input);
        let image = source.image.as_ref()?;
        Some(image.features[place].range(image.shape, u8::MAX))
    }

    /// Returns the lowest and highest count that an input can have: all that a type of so many bits holds, or all that its image can give.
    pub fn count_range(&self, input: Input, bits: u32) -> [f64; 2] {
        let held = Counts { bits, scale: 1.0, offset: 0.0 };
        self.image_range(input).unwrap_or_else(|| held.limits())
    }

    /// Tests for a graph that sees an image.
    pub fn sees(&self) -> bool {
        self.sources.iter().any(|source| source.image.is_some())
    }

    /// Returns the integers that an input comes in; `None` for memory, and where programs see the values themselves.
    pub fn counts_of(&self, input: Input) -> Option<Counts> {
        let (source, place) = self.source_of(input);
        source.counts.get(place).copied()
    }

    /// Returns the source that an input belongs to, and the input's index in it.
    pub fn source_of(&self, input: Input) -> (&SourceDocument, usize) {
        let mut place = input.index();
        for source in &self.sources {
            if place < source.ranges.len() {
                return (source, place);
            }
            place -= source.ranges.len();
        }
        unreachable!("inputs are validated against the sources")
    }

    /// Returns the written form of an input: `target[0]`.
    pub fn input_name(&self, input: Input) -> String {
        let (source, place) = self.source_of(input);
        format!("{}[{place}]", source.name)
    }

    /// Returns an input as formulas for people spell it: `target[0]`, or `theta` where that is a source's only value.
    pub fn input_label(&self, input: Input) -> String {
        let (source, _) = self.source_of(input);
        if source.ranges.len() == 1 { source.name.clone() } else { self.input_name(input) }
    }

    /// Returns the canonical text of `graph.json`: the same graph always gives the same bytes.
    pub fn to_json(&self) -> String {
        text::write(&self.to_document())
    }

    /// Returns the SHA-256 of the [canonical text](Self::to_json) in hexadecimal.
    pub fn sha256(&self) -> String {
        Sha256::digest(self.to_json()).iter().fold(String::new(), |mut hex, byte| {
            let _ = write!(hex, "{byte:02x}");
            hex
        })
    }
}
