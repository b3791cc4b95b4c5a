//! Graphs, read by this crate's own reader, and their meaning as terms.

pub mod meaning;
mod read;

use crate::machine::Interface;
use crate::term::{Float, Terms};

/// The end of an edge. Teams and leaves by their places in the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Destination {
    /// Another team decides
    Team(usize),
    /// The number of the action that is answered
    Action(u32),
    /// The outputs are a leaf's
    Leaf(usize),
}

/// A vertex in or behind a circle, if there is one. Of each vertex, those after it are given.
pub(crate) fn circle(after: &[Vec<usize>]) -> Option<usize> {
    let mut before = vec![0_usize; after.len()];
    after.iter().flatten().for_each(|&to| before[to] += 1);
    let mut ready: Vec<usize> = (0..after.len()).filter(|&vertex| before[vertex] == 0).collect();
    while let Some(vertex) = ready.pop() {
        for &to in &after[vertex] {
            before[to] -= 1;
            if before[to] == 0 {
                ready.push(to);
            }
        }
    }
    before.iter().position(|&left| left > 0)
}

/// An operand of a line.
#[derive(Clone, Copy, Debug)]
enum GraphOperand {
    Register(usize),
    Source(u32),
    Constant(f64),
}

#[derive(Clone, Debug)]
struct GraphLine {
    to: usize,
    word: String,
    operands: Vec<GraphOperand>,
}

#[derive(Clone, Debug)]
struct GraphEdge {
    program: usize,
    to: Destination,
}

#[derive(Clone, Debug)]
struct GraphTeam {
    id: u64,
    edges: Vec<GraphEdge>,
}

/// The lowest and highest value of an output or of memory, and the one in place of NaN.
type ValueLimits = [f64; 3];

/// A graph as it is written. All numbers of programs, teams and leaves are places in the lists here.
#[derive(Clone, Debug)]
pub struct Graph {
    interface: Interface,
    /// The declared ranges of the sources, one for each value, and those of the memory after them
    pub(crate) ranges: Vec<[f64; 2]>,
    registers: usize,
    /// Sine and the like are this project's own, not the platform's
    own_maths: bool,
    programs: Vec<Vec<GraphLine>>,
    teams: Vec<GraphTeam>,
    /// For each leaf its programs: of outputs, then of memory
    pub(crate) leaves: Vec<Vec<usize>>,
    /// Of outputs, then of memory
    limits: Vec<ValueLimits>,
    /// The first team, or the only leaf
    pub(crate) start: Destination,
}

impl Graph {
    /// What the policy reads and answers.
    #[must_use]
    pub fn interface(&self) -> &Interface {
        &self.interface
    }

    /// Tests for a graph of counts, which are whole numbers.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        !self.interface.counts.is_empty()
    }

    /// A number that the graph names.
    pub(crate) fn constant(&self, terms: &Terms, value: f64) -> Float {
        if self.is_whole() { terms.whole(value as i128) } else { terms.constant(value as f32) }
    }

    /// The numbers that programs name.
    pub(crate) fn constants(&self) -> Vec<f64> {
        let operands = self.programs.iter().flatten().flat_map(|line| &line.operands);
        let constants = operands.filter_map(|operand| match operand {
            GraphOperand::Constant(value) => Some(*value),
            _ => None,
        });
        constants.collect()
    }

    /// A destination by its id in the file, for people.
    #[must_use]
    pub fn name(&self, destination: Destination) -> String {
        match destination {
            Destination::Team(team) => format!("team {}", self.teams[team].id),
            Destination::Action(action) => format!("action {action}"),
            Destination::Leaf(leaf) => format!("leaf {leaf} of {}", self.leaves.len()),
        }
    }
}
