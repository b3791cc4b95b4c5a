//! A policy in the engine's form: plain data that a work unit can carry to any thread or machine.

use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use std::sync::Arc;
use tpg_graph::Graph;
use tpg_graph::Word;
use tpg_graph::dataflow::{depth_first, effective};

/// An operand of an instruction.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Operand {
    /// A register.
    Register(u16),
    /// A value of the flat state.
    Input(u16),
    /// A number, exact in the policy's scalar type.
    Constant(f64),
}

/// One line of a program.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Line {
    /// Destination register.
    pub to: u16,
    /// The instruction, or the few that the line stands for.
    #[serde(with = "by_name")]
    pub instruction: Word,
    /// Its operands; a word with one operand ignores the second.
    pub operands: [Operand; 2],
}

/// Destination of an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Destination {
    /// The team at this index of [`PolicyGraph::teams`].
    Team(u32),
    /// An action.
    Action(u16),
}

/// A program that bids for its destination.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Edge {
    /// Index of the bidder in [`PolicyGraph::programs`].
    pub program: u32,
    /// Destination it bids for.
    pub to: Destination,
}

/// A graph with a single root, reduced to what affects decisions: no labels, sources or provenance.
///
/// Team 0 is the root, and edges lead only to later teams: [`PolicyGraph::new`] ensures both.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PolicyGraph {
    /// Number of registers of a program.
    pub registers: u16,
    /// The teams; among equal bids the last edge wins.
    pub teams: Vec<Vec<Edge>>,
    /// The programs; roots of a population share most of theirs.
    pub programs: Vec<Arc<[Line]>>,
    /// The outputs; empty for a policy that chooses among actions.
    #[serde(default)]
    pub outputs: Vec<Limits>,
    /// The leaves, which edges lead to in place of actions: the program of each output.
    #[serde(default)]
    pub leaves: Vec<Vec<u32>>,
}

/// The limits of an output.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Limits {
    /// Lowest value, exact in the policy's scalar type.
    pub min: f64,
    /// Highest value, exact in the policy's scalar type.
    pub max: f64,
    /// The value in place of NaN.
    pub nan: f64,
}

impl PolicyGraph {
    /// Sorts teams topologically, root first, and drops teams that are not reachable from the root.
    ///
    /// # Panics
    /// If the teams have a cycle, which neither GEGELATI's mutations nor a validated graph can contain.
    pub fn new(registers: u16, root: u32, teams: Vec<Vec<Edge>>, programs: Vec<Vec<Line>>) -> Self {
        Self::with_programs(registers, root, teams, programs.into_iter().map(Arc::from).collect())
    }

    /// As [`new`](Self::new), of programs that other policies may share.
    ///
    /// # Panics
    /// As [`new`](Self::new).
    pub fn with_programs(registers: u16, root: u32, teams: Vec<Vec<Edge>>, programs: Vec<Arc<[Line]>>) -> Self {
        let order = topological(root, &teams);
        let mut place = vec![u32::MAX; teams.len()];
        for (new, &old) in (0u32..).zip(&order) {
            place[old] = new;
        }
        let renumbered = |edge: &Edge| match edge.to {
            Destination::Team(team) => Edge { to: Destination::Team(place[team as usize]), ..*edge },
            Destination::Action(_) => *edge,
        };
        let teams = order.iter().map(|&old| teams[old].iter().map(renumbered).collect()).collect();
        Self { registers, teams, programs, outputs: Vec::new(), leaves: Vec::new() }
    }

    /// Returns the same policy with outputs: its edges lead to leaves in place of actions.
    #[must_use]
    pub fn with_outputs(self, outputs: Vec<Limits>, leaves: Vec<Vec<u32>>) -> Self {
        Self { outputs, leaves, ..self }
    }
}

impl PolicyGraph {
    /// Returns the number of lines that a bid or an output depends on; each program counts once. A bid without a rival has
    /// none.
    pub fn lines(&self) -> usize {
        let has_rivals = !matches!(&self.teams[..], [team] if team.len() == 1);
        let bids = self.teams.iter().flatten().map(|edge| edge.program).filter(|_| has_rivals);
        let programs: BTreeSet<u32> = bids.chain(self.leaves.iter().flatten().copied()).collect();
        let count = |&program: &u32| {
            let effective = effective(self.registers.into(), &self.programs[program as usize]);
            effective.into_iter().filter(|&effective| effective).count()
        };
        programs.iter().map(count).sum()
    }

    /// Returns the size of the policy: its [lines](Self::lines), and the edges of teams that have a choice.
    ///
    /// ```
    /// use tpg_engine::{Destination, Edge, PolicyGraph};
    ///
    /// let edge = |action| Edge { program: 0, to: Destination::Action(action) };
    /// assert_eq!(PolicyGraph::new(1, 0, vec![vec![edge(0), edge(1)]], vec![vec![]]).size(), 2);
    /// assert_eq!(PolicyGraph::new(1, 0, vec![vec![edge(0)]], vec![vec![]]).size(), 0, "there is no choice");
    /// ```
    pub fn size(&self) -> usize {
        self.lines() + self.teams.iter().map(Vec::len).filter(|&edges| edges > 1).sum::<usize>()
    }
}

impl From<&Graph> for PolicyGraph {
    fn from(graph: &Graph) -> Self {
        let operand = |operand: tpg_graph::Operand| match operand {
            tpg_graph::Operand::Register(register) => Operand::Register(register.index() as u16),
            tpg_graph::Operand::Input(input) => Operand::Input(input.index() as u16),
            tpg_graph::Operand::Constant(value) => Operand::Constant(value),
        };
        let line = |line: &tpg_graph::Line| Line {
            to: line.to.index() as u16,
            instruction: line.instruction,
            operands: line.operands.map(operand),
        };
        let edge = |edge: &tpg_graph::Edge| Edge {
            program: edge.program.index() as u32,
            to: match edge.to {
                tpg_graph::Destination::Team(team) => Destination::Team(team.index() as u32),
                tpg_graph::Destination::Action(action) => Destination::Action(action.0),
            },
        };
        let teams = graph.teams().iter().map(|team| team.edges.iter().map(edge).collect()).collect();
        let programs = graph.programs().iter().map(|program| program.lines.iter().map(line).collect()).collect();
        let limits =
            |output: &tpg_graph::Output| Limits { min: output.range.min, max: output.range.max, nan: output.nan };
        let leaf = |leaf: &tpg_graph::Leaf| leaf.programs.iter().map(|program| program.index() as u32).collect();
        Self::new(graph.registers(), graph.root().index() as u32, teams, programs)
            .with_outputs(graph.outputs().iter().map(limits).collect(), graph.leaves().iter().map(leaf).collect())
    }
}

/// Returns the teams reachable from the root in topological order.
fn topological(root: u32, teams: &[Vec<Edge>]) -> Vec<usize> {
    let edge = |team: usize, place: usize| {
        teams[team].get(place).map(|edge| match edge.to {
            Destination::Team(to) => Some(to as usize),
            Destination::Action(_) => None,
        })
    };
    depth_first(teams.len(), [root as usize], edge).unwrap_or_else(|cycle| panic!("a cycle of teams: {cycle:?}"))
}

/// Serialises instructions by name, as in `graph.json`.
mod by_name {
    use serde::{Deserialize, Deserializer, Serializer, de::Error};
    use tpg_graph::Word;

    pub(super) fn serialize<S: Serializer>(word: &Word, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(word.name())
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Word, D::Error> {
        let name = String::deserialize(deserializer)?;
        Word::from_name(&name).ok_or_else(|| D::Error::custom(format!("unknown instruction {name:?}")))
    }
}
