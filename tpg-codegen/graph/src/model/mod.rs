//! The graph: a policy with everything that decides its behaviour.
//!
//! A [`Graph`] is validated once, when it is made from a [`Document`]; after that every id is an index that exists, every
//! register and input is in range, and the teams form an acyclic graph with one root. Passes and emitters never check again.

mod document;
mod effect;
mod name;
mod schema;
mod text;
mod validate;

pub use document::{
    ActionDocument, Document, EdgeDocument, FORMAT, LineDocument, MathsProvider, OperandDocument, ProgramDocument,
    Provenance, ScalarType, SourceDocument, TeamDocument, VERSION,
};

pub use effect::Effect;
pub use schema::schema;
pub use validate::MAX_NUMBERED;

use sha2::{Digest, Sha256};
use std::fmt::Write as _;
use tpg_runtime::ops::Instruction;
pub use tpg_runtime::policy::ActionId;

/// The place of a team in [`Graph::teams`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TeamId(pub(crate) u32);

/// The place of a program in [`Graph::programs`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ProgramId(pub(crate) u32);

/// A register of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Reg(pub(crate) u16);

/// An index into the flat state: the values of all sources, one source after another.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Input(pub u16);

impl TeamId {
    /// As an index.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

impl ProgramId {
    /// As an index.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

impl Reg {
    /// The register whose value after the program is its bid.
    pub const BID: Self = Self(0);

    /// As an index.
    pub fn index(self) -> usize {
        usize::from(self.0)
    }
}

impl Input {
    /// As an index.
    pub fn index(self) -> usize {
        usize::from(self.0)
    }
}

/// A data source: a named run of values that programs read.
#[derive(Clone, Debug, PartialEq)]
pub struct Source {
    /// A C and Rust identifier.
    pub name: String,
    /// The unit of its values, for people.
    pub unit: String,
    /// The declared range of each value, both ends included and finite.
    pub ranges: Vec<Range>,
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

/// Something a policy can do.
#[derive(Clone, Debug, PartialEq)]
pub struct Action {
    /// What it is called.
    pub name: String,
    /// The numbers it carries for its problem; of one length for all actions that have them.
    pub effect: Option<Effect>,
}

/// Where an instruction reads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Operand {
    /// A register.
    Register(Reg),
    /// A value of the state.
    Input(Input),
    /// A number, finite and exact in the graph's scalar type.
    Constant(f64),
}

/// One line of a program: `to = instruction(operands)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// Where the result goes.
    pub to: Reg,
    /// What is computed.
    pub instruction: Instruction,
    /// As many operands as the instruction's arity says; the second of a one-operand instruction repeats the first.
    pub operands: [Operand; 2],
}

/// A program: lines in order, registers zero before the first; its bid is register 0 after the last.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// Its id in the source file.
    pub label: u32,
    /// Its lines.
    pub lines: Vec<Line>,
}

/// Where an edge leads.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Destination {
    /// To another team: the walk goes on.
    Team(TeamId),
    /// To an action: the walk ends.
    Action(ActionId),
}

/// A program that bids for its destination.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Edge {
    /// Who bids.
    pub program: ProgramId,
    /// For what.
    pub to: Destination,
}

/// A team: its edges bid, the highest bid wins, of equal bids the last.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Team {
    /// Its id in the source file.
    pub label: u32,
    /// Its edges, at least one; the order decides ties.
    pub edges: Vec<Edge>,
}

/// A validated tangled program graph.
#[derive(Clone, Debug, PartialEq)]
pub struct Graph {
    scalar: ScalarType,
    maths: MathsProvider,
    registers: u16,
    sources: Vec<Source>,
    instructions: Vec<Instruction>,
    actions: Vec<Action>,
    root: TeamId,
    teams: Vec<Team>,
    programs: Vec<Program>,
    provenance: Provenance,
}

impl Graph {
    /// The type programs compute in.
    pub fn scalar(&self) -> ScalarType {
        self.scalar
    }

    /// Who computes sin, cos, ln and exp.
    pub fn maths(&self) -> MathsProvider {
        self.maths
    }

    /// Registers of a program.
    pub fn registers(&self) -> u16 {
        self.registers
    }

    /// The data sources, in the order of the state.
    pub fn sources(&self) -> &[Source] {
        &self.sources
    }

    /// The declared instruction set, in its order (which `.dot` files refer to by number).
    pub fn instructions(&self) -> &[Instruction] {
        &self.instructions
    }

    /// The actions, by id.
    pub fn actions(&self) -> &[Action] {
        &self.actions
    }

    /// Where the walk starts.
    pub fn root(&self) -> TeamId {
        self.root
    }

    /// The teams, by id.
    pub fn teams(&self) -> &[Team] {
        &self.teams
    }

    /// The programs, by id.
    pub fn programs(&self) -> &[Program] {
        &self.programs
    }

    /// A team.
    pub fn team(&self, id: TeamId) -> &Team {
        &self.teams[id.index()]
    }

    /// A program.
    pub fn program(&self, id: ProgramId) -> &Program {
        &self.programs[id.index()]
    }

    /// Where the graph comes from.
    pub fn provenance(&self) -> &Provenance {
        &self.provenance
    }

    /// How many values a state has: the lengths of all sources together.
    pub fn state_length(&self) -> usize {
        self.sources.iter().map(|source| source.ranges.len()).sum()
    }

    /// Every input of a state, in order.
    pub fn inputs(&self) -> impl Iterator<Item = Input> + use<> {
        (0..self.state_length()).map(|place| Input(place as u16))
    }

    /// The declared range of each value of the state.
    pub fn state_ranges(&self) -> impl Iterator<Item = Range> + '_ {
        self.sources.iter().flat_map(|source| source.ranges.iter().copied())
    }

    /// The source that an input belongs to, and its place there.
    pub fn source_of(&self, input: Input) -> (&Source, usize) {
        let mut place = input.index();
        for source in &self.sources {
            if place < source.ranges.len() {
                return (source, place);
            }
            place -= source.ranges.len();
        }
        unreachable!("inputs are validated against the sources")
    }

    /// An input as it is written: `target[0]`.
    pub fn input_name(&self, input: Input) -> String {
        let (source, place) = self.source_of(input);
        format!("{}[{place}]", source.name)
    }

    /// The canonical text of `graph.json`: the same graph always gives the same bytes.
    pub fn to_json(&self) -> String {
        text::write(&self.to_document())
    }

    /// SHA-256 of the [canonical text](Self::to_json), in hexadecimal.
    pub fn sha256(&self) -> String {
        Sha256::digest(self.to_json()).iter().fold(String::new(), |mut hex, byte| {
            let _ = write!(hex, "{byte:02x}");
            hex
        })
    }
}
