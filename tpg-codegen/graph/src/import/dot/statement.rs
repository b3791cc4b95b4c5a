//! Statements of a `.dot` file.

use crate::import::composed::OPERANDS;
use std::fmt;

/// A statement with its line number.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Located {
    /// Counted from 1.
    pub(super) line: usize,
    /// The statement.
    pub(super) statement: Statement,
}

/// The content of a line, as far as it matters to the graph.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Statement {
    /// The exporter named in the first comment: a tool and its version.
    Exporter { tool: String, version: String },
    /// A team.
    Team { team: u32 },
    /// A program, and its constants.
    Program { program: u32, constants: Vec<f64> },
    /// The lines of a program; some files of GEGELATI 2 have its constants here.
    Lines { program: u32, lines: Vec<ProgramLine>, constants: Vec<f64> },
    /// A link from a program to its lines.
    Link { program: u32 },
    /// An action node. Its label is the action, or what its programs compute: `0-2`.
    Action { node: u32, labels: Vec<u32> },
    /// A program of an action node.
    ActionProgram { node: u32, program: u32 },
    /// An edge.
    Edge { team: u32, program: u32, to: Target },
    /// The roots.
    Rank { roots: Vec<Node> },
    /// The closing brace.
    Close,
}

/// Destination of an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Target {
    /// To a team.
    Team(u32),
    /// To the action of this node.
    ActionNode(u32),
    /// The destination that another edge states for the same program.
    OfProgram,
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

/// A kind of node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Team,
    Program,
    Lines,
    Action,
}

/// The name of a node: `T12`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Node {
    pub(super) kind: Kind,
    pub(super) number: u32,
}

impl fmt::Display for Node {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let letter = match self.kind {
            Kind::Team => 'T',
            Kind::Program => 'P',
            Kind::Lines => 'I',
            Kind::Action => 'A',
        };
        write!(f, "{letter}{}", self.number)
    }
}
