//! The nodes and edges that a file declares.

use super::fault::{Fault, refuse};
use crate::import::composed::OPERANDS;
use std::collections::BTreeMap;
use std::fmt;

/// Nodes of one kind, in file order and indexed by number.
#[derive(Debug)]
pub(super) struct Table<T> {
    items: Vec<T>,
    places: BTreeMap<u32, usize>,
}

impl<T> Default for Table<T> {
    fn default() -> Self {
        Self { items: Vec::new(), places: BTreeMap::new() }
    }
}

impl<T> Table<T> {
    /// Returns all nodes in file order.
    pub(super) fn items(&self) -> &[T] {
        &self.items
    }

    /// Returns the index in [`items`](Self::items) of the node with the given number.
    pub(super) fn place(&self, number: u32) -> Option<usize> {
        self.places.get(&number).copied()
    }

    /// Returns the node with the given number.
    pub(super) fn get(&self, number: u32) -> Option<&T> {
        self.place(number).map(|place| &self.items[place])
    }

    pub(super) fn get_mut(&mut self, number: u32) -> Option<&mut T> {
        self.place(number).map(|place| &mut self.items[place])
    }

    pub(super) fn insert(&mut self, node: Node, item: T) -> Result<(), Fault> {
        if self.places.insert(node.number, self.items.len()).is_some() {
            let accepted = format!("a number that no other {} has", node.kind.letter());
            return refuse(format!("{node} a second time"), accepted);
        }
        self.items.push(item);
        Ok(())
    }
}

/// Node of a team.
#[derive(Debug)]
pub(super) struct Team {
    pub(super) number: u32,
    pub(super) line: usize,
}

/// Node of a program.
#[derive(Debug)]
pub(super) struct Program {
    pub(super) number: u32,
    pub(super) line: usize,
    pub(super) constants: Vec<f64>,
}

/// Node that holds a program's lines; some files of GEGELATI 2 have its constants here.
#[derive(Debug)]
pub(super) struct Lines {
    pub(super) line: usize,
    pub(super) lines: Vec<ProgramLine>,
    pub(super) constants: Vec<f64>,
}

/// One line of a program, with the numbers of the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct ProgramLine {
    /// Index in the instruction set.
    pub(super) instruction: u32,
    /// Destination register.
    pub(super) to: u32,
    /// Number of operands in the file: as many as the widest instruction of the set reads.
    pub(super) written: usize,
    /// The leading operands, up to the maximum that an instruction here can read.
    pub(super) operands: [OperandText; OPERANDS.len()],
}

/// An operand, with the numbers of the file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct OperandText {
    /// 0 for the registers, then the constants if there are any, then the environment's sources.
    pub(super) source: u32,
    /// Location, taken modulo the size of the source.
    pub(super) location: u64,
}

/// Node of an action.
#[derive(Debug)]
pub(super) struct Action {
    pub(super) node: u32,
    pub(super) line: usize,
    /// The action, or what its programs compute: `0-2`.
    pub(super) labels: Vec<u32>,
    /// Its programs, in the order of the labels.
    pub(super) programs: Vec<u32>,
}

/// An edge of a team; without a destination, it is the one that another edge states for the same program.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    pub(super) line: usize,
    pub(super) team: u32,
    pub(super) program: u32,
    pub(super) to: Option<Node>,
}

/// The statement that names the roots.
#[derive(Debug)]
pub(super) struct Rank {
    pub(super) line: usize,
    pub(super) roots: Vec<Node>,
}

/// Everything that a file declares.
#[derive(Debug, Default)]
pub(super) struct Declared {
    /// The exporter named in the first comment: a tool and its version.
    pub(super) exporter: Option<(String, String)>,
    pub(super) teams: Table<Team>,
    pub(super) programs: Table<Program>,
    pub(super) lines: Table<Lines>,
    pub(super) actions: Table<Action>,
    /// Programs that links name, each with the line. Links are redundant, but the programs must exist.
    pub(super) links: Vec<(usize, u32)>,
    pub(super) edges: Vec<Edge>,
    pub(super) rank: Option<Rank>,
    /// Line of the closing brace.
    pub(super) close: usize,
}

/// A kind of node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Team,
    Program,
    Lines,
    Action,
}

impl Kind {
    pub(super) const ALL: [Self; 4] = [Self::Team, Self::Program, Self::Lines, Self::Action];

    pub(super) fn letter(self) -> char {
        match self {
            Self::Team => 'T',
            Self::Program => 'P',
            Self::Lines => 'I',
            Self::Action => 'A',
        }
    }
}

/// The name of a node: `T12`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Node {
    pub(super) kind: Kind,
    pub(super) number: u32,
}

impl fmt::Display for Node {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.kind.letter(), self.number)
    }
}
