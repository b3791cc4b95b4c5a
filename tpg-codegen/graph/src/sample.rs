//! Random valid graphs, for tests and benchmarks: the same shape and seed always give the same graph.
//!
//! They deliberately contain what is rare in trained graphs and easy to get wrong: equal bids, programs shared by
//! several teams, programs without lines, constants of every kind, introns, unordered ids, a root that is not the first
//! team.
//!
//! ```
//! use tpg_graph::sample::{self, Shape};
//!
//! let graph = sample::graph(&Shape::default(), 7);
//! assert_eq!(graph, sample::graph(&Shape::default(), 7));
//! assert_ne!(graph, sample::graph(&Shape::default(), 8));
//! ```

use crate::Word;
use crate::model::{
    ActionDocument, Document, EdgeDocument, FORMAT, Graph, LeafDocument, LineDocument, MathsProvider, MemoryDocument,
    OperandDocument, OutputDocument, ProgramDocument, Provenance, ScalarType, SourceDocument, TeamDocument,
};
use SampledEnd::*;
use rand::seq::SliceRandom;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::collections::BTreeSet;
use std::ops::RangeInclusive;
use tpg_runtime::ops::Instruction;

/// Parameters of random graphs.
#[derive(Clone, Debug)]
pub struct Shape {
    /// Number of teams.
    pub teams: usize,
    /// Number of edges of a team, unless it needs more to reach other teams.
    pub edges: RangeInclusive<usize>,
    /// Number of lines of a program.
    pub lines: RangeInclusive<usize>,
    /// Number of registers.
    pub registers: u32,
    /// Length of each source.
    pub sources: Vec<u32>,
    /// Number of actions, or of leaves if there are outputs.
    pub actions: u32,
    /// Number of outputs; 0 for a policy that answers with an action.
    pub outputs: u32,
    /// Number of values that leaves compute for the next decision; 0 without outputs.
    pub memory: u32,
    /// The instruction set.
    pub instructions: Vec<Word>,
    /// The type programs compute in.
    pub scalar: ScalarType,
    /// Provider of sin, cos, tan, ln and exp.
    pub maths: MathsProvider,
    /// Kind of constants that programs read.
    pub constants: Constants,
    /// If true, the teams form one chain, the deepest possible graph.
    pub chain: bool,
}

/// Kind of constants that programs read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Constants {
    /// No constants.
    None,
    /// 32-bit integers.
    Integers,
    /// Any finite numbers, including whole ones, tiny ones and −0.
    Reals,
}

impl Default for Shape {
    /// Returns the shape of a graph about as large as the paper's, with every instruction but rare ones.
    fn default() -> Self {
        Self {
            teams: 20,
            edges: 2..=10,
            lines: 0..=8,
            registers: 8,
            sources: vec![3, 3, 4],
            actions: 9,
            outputs: 0,
            memory: 0,
            instructions: words().filter(|word| matches!(word, Word::Instruction(_))).collect(),
            scalar: ScalarType::F64,
            maths: MathsProvider::Own,
            constants: Constants::Reals,
            chain: false,
        }
    }
}

impl Shape {
    /// Returns a random shape of a policy with outputs: formulas without a team, one leaf, many leaves; most with memory.
    pub fn random_with_outputs(seed: u64) -> Self {
        let shape = Self::random(seed);
        let teams = if seed.is_multiple_of(5) { 0 } else { shape.teams };
        Self { teams, outputs: 1 + (seed % 3) as u32, memory: (seed / 3 % 4) as u32, ..shape }
    }

    /// Returns a random shape: small graphs of every kind.
    pub fn random(seed: u64) -> Self {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let mut instructions: Vec<Word> = words().collect();
        instructions.shuffle(&mut random);
        instructions.truncate(random.random_range(1..=instructions.len()));
        match seed % 4 {
            0 => instructions.push(RARE[0].into()),
            1 => instructions.extend(RARE[1..].iter().map(|&rare| Word::from(rare))),
            _ => {}
        }
        let constants = [Constants::None, Constants::Integers, Constants::Reals];
        Self {
            teams: random.random_range(1..=30),
            edges: 1..=random.random_range(1..=12),
            lines: 0..=random.random_range(0..=10),
            registers: random.random_range(1..=12),
            sources: (0..random.random_range(1..=4)).map(|_| random.random_range(1..=6)).collect(),
            actions: random.random_range(1..=9),
            outputs: 0,
            memory: 0,
            instructions,
            scalar: if random.random() { ScalarType::F32 } else { ScalarType::F64 },
            maths: if random.random() { MathsProvider::Own } else { MathsProvider::System },
            constants: constants[random.random_range(0..constants.len())],
            chain: random.random_ratio(1, 4),
        }
    }
}

/// Instructions that only some random graphs have.
const RARE: [Instruction; 4] = [Instruction::Quotient, Instruction::Sqrt, Instruction::Atan, Instruction::Tanh];

/// Every word but the rare instructions.
fn words() -> impl Iterator<Item = Word> {
    Word::ALL.into_iter().filter(|word| RARE.iter().all(|&rare| *word != rare.into()))
}

/// Returns a random graph of the given shape.
///
/// # Panics
/// If the shape admits no graph: no teams, edges, registers, values, actions or instructions.
pub fn graph(shape: &Shape, seed: u64) -> Graph {
    let document = Sampler { shape, random: ChaCha8Rng::seed_from_u64(seed), programs: Vec::new() }.document(seed);
    Graph::from_document("<sample>", document).unwrap_or_else(|error| panic!("{error}"))
}

/// Destination of a program: a team by index, or an action.
#[derive(Clone, Copy, Debug, PartialEq)]
enum SampledEnd {
    Team(usize),
    Action(u32),
}

/// Draws the graph. Teams are numbered from the root down while edges are drawn, so every edge leads to a higher
/// number.
struct Sampler<'s> {
    shape: &'s Shape,
    random: ChaCha8Rng,
    programs: Vec<(SampledEnd, Vec<LineDocument>)>,
}

impl Sampler<'_> {
    fn document(mut self, seed: u64) -> Document {
        let shape = self.shape;
        let edges = self.edges();
        let team_ids = self.ids(shape.teams);
        let leaves = self.leaves();
        let program_ids = self.ids(self.programs.len());
        let edge = |&program: &usize| {
            let mut edge = EdgeDocument { program: program_ids[program], ..EdgeDocument::default() };
            match self.programs[program].0 {
                Team(team) => edge.team = Some(team_ids[team]),
                Action(action) if shape.outputs == 0 => edge.action = Some(action),
                Action(leaf) => edge.leaf = Some(leaf),
            }
            edge
        };
        let mut teams: Vec<TeamDocument> = (team_ids.iter().zip(&edges))
            .map(|(&id, edges)| TeamDocument { id, edges: edges.iter().map(edge).collect() })
            .collect();
        let mut programs: Vec<ProgramDocument> =
            (program_ids.iter().zip(self.programs)).map(|(&id, (_, lines))| ProgramDocument { id, lines }).collect();
        let leaves = (leaves.into_iter())
            .map(|(id, programs)| {
                let mut programs: Vec<u32> = programs.into_iter().map(|it| program_ids[it]).collect();
                let memory = programs.split_off(shape.outputs as usize);
                LeafDocument { id, programs, memory }
            })
            .collect();
        teams.shuffle(&mut self.random);
        programs.shuffle(&mut self.random);
        Document {
            format: FORMAT.to_owned(),
            version: if shape.outputs == 0 { 1 } else { 2 },
            scalar: shape.scalar,
            maths: shape.maths,
            registers: shape.registers,
            sources: (0..).zip(&shape.sources).map(|(index, &length)| source(index, length)).collect(),
            instructions: shape.instructions.iter().map(|instruction| instruction.name().to_owned()).collect(),
            actions: (0..if shape.outputs == 0 { shape.actions } else { 0 }).map(action).collect(),
            outputs: (0..shape.outputs).map(output).collect(),
            memory: (0..shape.memory).map(memory).collect(),
            root: team_ids.first().copied(),
            teams,
            leaves,
            programs,
            provenance: Provenance {
                tool: Some("tpg-codegen sample".to_owned()),
                seed: Some(seed),
                note: Some("Random: \"valid\", without meaning.\nNot trained.".to_owned()),
                ..Provenance::default()
            },
        }
    }

    /// Draws the programs of each team's edges, in order. Every team except the root gets an edge from an earlier team.
    fn edges(&mut self) -> Vec<Vec<usize>> {
        let mut edges: Vec<Vec<usize>> = vec![Vec::new(); self.shape.teams];
        for team in 1..self.shape.teams {
            let above = if self.shape.chain { team - 1 } else { self.random.random_range(0..team) };
            let program = self.program(Team(team));
            edges[above].push(program);
        }
        for (team, edges) in edges.iter_mut().enumerate() {
            let wanted = self.random.random_range(self.shape.edges.clone()).max(1);
            while edges.len() < wanted {
                edges.push(self.bidder(team));
            }
            edges.shuffle(&mut self.random);
        }
        edges
    }

    /// Draws the programs of the leaves that edges lead to; without teams there is one leaf.
    fn leaves(&mut self) -> Vec<(u32, Vec<usize>)> {
        if self.shape.outputs == 0 {
            return Vec::new();
        }
        let ends = self.programs.iter().filter_map(|&(to, _)| match to {
            Action(leaf) => Some(leaf),
            Team(_) => None,
        });
        let mut reached: BTreeSet<u32> = ends.collect();
        if self.shape.teams == 0 {
            reached.insert(0);
        }
        let values = 0..self.shape.outputs + self.shape.memory;
        reached.into_iter().map(|leaf| (leaf, values.clone().map(|_| self.computing(leaf)).collect())).collect()
    }

    /// Draws a program that computes an output of a leaf: one that exists already, or a new one.
    fn computing(&mut self, leaf: u32) -> usize {
        let other = self.random.random_range(0..=self.programs.len());
        if other < self.programs.len() && self.random.random_ratio(1, 4) { other } else { self.program(Action(leaf)) }
    }

    /// Draws a program that may bid in a team: one of another team, a copy of another's lines, or a new one.
    fn bidder(&mut self, team: usize) -> usize {
        let other = self.random.random_range(0..=self.programs.len());
        let destination = self.destination(team);
        match (self.programs.get(other).cloned(), self.random.random_range(0..4)) {
            (Some((to, _)), 0) if may_lead(team, to) => other,
            (Some((_, lines)), 1) => self.add(destination, lines),
            _ => self.program(destination),
        }
    }

    fn destination(&mut self, from: usize) -> SampledEnd {
        let below = from + 1..self.shape.teams;
        if !self.shape.chain && !below.is_empty() && self.random.random_ratio(1, 3) {
            Team(self.random.random_range(below))
        } else {
            Action(self.random.random_range(0..self.shape.actions))
        }
    }

    fn program(&mut self, to: SampledEnd) -> usize {
        let count = self.random.random_range(self.shape.lines.clone());
        let lines = (0..count).map(|_| self.line()).collect();
        self.add(to, lines)
    }

    fn add(&mut self, to: SampledEnd, lines: Vec<LineDocument>) -> usize {
        self.programs.push((to, lines));
        self.programs.len() - 1
    }

    fn line(&mut self) -> LineDocument {
        let instruction = self.shape.instructions[self.random.random_range(0..self.shape.instructions.len())];
        let args = (0..instruction.arity()).map(|_| self.operand()).collect();
        // Half of the lines compute the bid, so that bids usually depend on inputs.
        let to = if self.random.random() { 0 } else { self.random.random_range(0..self.shape.registers) };
        LineDocument { to, op: instruction.name().to_owned(), args }
    }

    fn operand(&mut self) -> OperandDocument {
        match (self.random.random_range(0..8), self.shape.constants) {
            (0, Constants::Integers | Constants::Reals) => OperandDocument::Constant(self.constant()),
            (1..=3, _) => OperandDocument::Place(format!("r{}", self.random.random_range(0..self.shape.registers))),
            _ => {
                let sources = self.shape.sources.len();
                let source = self.random.random_range(0..sources + self.shape.memory as usize);
                OperandDocument::Place(match source.checked_sub(sources) {
                    Some(memory) => format!("m{memory}[0]"),
                    None => format!("s{source}[{}]", self.random.random_range(0..self.shape.sources[source])),
                })
            }
        }
    }

    fn constant(&mut self) -> f64 {
        let kinds = if self.shape.constants == Constants::Reals { 6 } else { 2 };
        let value = match self.random.random_range(0..kinds) {
            0 => f64::from(self.random.random_range(-10..=10)),
            1 => f64::from(self.random.random::<i32>()),
            2 => -0.0,
            3 => 1e-40, // a denormal of f32
            4 => self.random.random_range(-3e38..3e38),
            _ => self.random.random_range(-1.0..1.0),
        };
        self.shape.scalar.round(value)
    }

    /// Draws distinct ids, unordered and with gaps.
    fn ids(&mut self, count: usize) -> Vec<u32> {
        let mut ids: Vec<u32> = (0..count as u32).map(|place| place * 3 + self.random.random_range(0..3)).collect();
        ids.shuffle(&mut self.random);
        ids
    }
}

fn may_lead(from: usize, to: SampledEnd) -> bool {
    match to {
        Team(to) => to > from,
        Action(_) => true,
    }
}

fn source(index: usize, length: u32) -> SourceDocument {
    // Ranges of different kinds: symmetric, from zero, and a single value.
    let ranges = (0..length).map(|place| match (index + place as usize) % 4 {
        0 | 1 => [-600.0, 600.0],
        2 => [0.0, 4095.0],
        _ => [512.0, 512.0],
    });
    SourceDocument::new(format!("s{index}"), "mm", ranges.collect())
}

/// Ranges of different kinds, and NaN as their lowest, highest, or a value between.
fn output(index: u32) -> OutputDocument {
    let (min, max, nan) = match index % 4 {
        0 => (-2.0, 2.0, 0.0),
        1 => (0.0, 1000.0, 0.0),
        2 => (-1.0, 0.5, 0.5),
        _ => (-3e38, 3e38, -1.5),
    };
    let [min, max] = [min, max].map(|end: f64| f64::from(end as f32));
    OutputDocument { name: format!("out{index}"), unit: "N*m".to_owned(), min, max, nan, counts: None }
}

fn memory(index: u32) -> MemoryDocument {
    let OutputDocument { min, max, nan, .. } = output(index);
    MemoryDocument { name: format!("m{index}"), min, max, initial: nan }
}

fn action(id: u32) -> ActionDocument {
    ActionDocument { id, name: format!("action {id}"), effect: None, ask: None }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Operand;

    #[test]
    fn every_shape_gives_a_graph() {
        for seed in 0..500 {
            let shape = Shape::random(seed);
            assert_eq!(graph(&shape, seed).teams().len(), shape.teams);
        }
    }

    #[test]
    fn a_default_graph_has_what_is_easily_got_wrong() {
        let graph = graph(&Shape::default(), 1);
        let edges = || graph.teams().iter().flat_map(|team| &team.edges);
        let programs = graph.programs();
        assert!(edges().count() > programs.len(), "a program that several teams share");
        assert!(programs.iter().any(|program| program.lines.is_empty()), "a program without lines");
        let twin = |index: usize| programs[..index].iter().any(|program| program.lines == programs[index].lines);
        assert!((0..programs.len()).any(|index| !programs[index].lines.is_empty() && twin(index)), "equal bids");
        let operands = || programs.iter().flat_map(|program| &program.lines).flat_map(|line| line.operands);
        assert!(operands().any(|operand| matches!(operand, Operand::Constant(_))), "constants");
        assert_ne!(graph.root().index(), 0);
    }

    #[test]
    fn a_large_chain_is_no_trouble() {
        let shape = Shape { teams: 10_000, edges: 2..=4, chain: true, ..Shape::default() };
        assert_eq!(graph(&shape, 1).teams().len(), 10_000);
    }
}
