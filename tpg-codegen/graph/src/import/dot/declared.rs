//! The nodes and edges that a file declares.

use super::fault::{Fault, refuse};
use crate::import::composed::OPERANDS;
use indexmap::IndexMap;
use std::fmt;

/// Nodes of one kind by number, in file order.
pub(super) type Table<T> = IndexMap<u32, T>;

/// Adds a node, whose number no other may have.
pub(super) fn add<T>(table: &mut Table<T>, node: DotNode, item: T) -> Result<(), Fault> {
    if table.insert(node.number, item).is_some() {
        let accepted = format!("a number that no other {} has", node.kind.letter());
        return refuse(format!("{node} a second time"), accepted);
    }
    Ok(())
}

/// DotNode of a program.
#[derive(Debug)]
pub(super) struct DeclaredProgram {
    pub(super) line: usize,
    pub(super) constants: Vec<f64>,
}

/// DotNode that holds a program's lines; some files of GEGELATI 2 have its constants here.
#[derive(Debug)]
pub(super) struct DeclaredLines {
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

/// DotNode of an action.
#[derive(Debug)]
pub(super) struct DeclaredAction {
    pub(super) line: usize,
    /// The action, or what its programs compute: `0-2`.
    pub(super) labels: Vec<u32>,
    /// Its programs, in the order of the labels.
    pub(super) programs: Vec<u32>,
}

/// An edge of a team; without a destination, it is the one that another edge states for the same program.
#[derive(Clone, Copy, Debug)]
pub(super) struct DeclaredEdge {
    pub(super) line: usize,
    pub(super) team: u32,
    pub(super) program: u32,
    pub(super) to: Option<DotNode>,
}

/// The statement that names the roots.
#[derive(Debug)]
pub(super) struct Rank {
    pub(super) line: usize,
    pub(super) roots: Vec<DotNode>,
}

/// Everything that a file declares.
#[derive(Debug, Default)]
pub(super) struct Declared {
    /// The exporter named in the first comment: a tool and its version.
    pub(super) exporter: Option<(String, String)>,
    /// The line of each team.
    pub(super) teams: Table<usize>,
    pub(super) programs: Table<DeclaredProgram>,
    pub(super) lines: Table<DeclaredLines>,
    pub(super) actions: Table<DeclaredAction>,
    /// Programs that links name, each with the line. Links are redundant, but the programs must exist.
    pub(super) links: Vec<(usize, u32)>,
    pub(super) edges: Vec<DeclaredEdge>,
    pub(super) rank: Option<Rank>,
    /// Line of the closing brace.
    pub(super) close: usize,
}

/// A kind of node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NodeKind {
    Team,
    Program,
    Lines,
    Action,
}

impl NodeKind {
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
pub(super) struct DotNode {
    pub(super) kind: NodeKind,
    pub(super) number: u32,
}

impl fmt::Display for DotNode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.kind.letter(), self.number)
    }
}
