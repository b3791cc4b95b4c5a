//! Nodes as Rust expressions.

use crate::emit::questions::Words;
use crate::ir::{Node, NodeId};
use tpg_graph::{Graph, MathsProvider, ScalarType};
use tpg_runtime::ops::Instruction;

/// Writes nodes.
#[derive(Clone, Copy)]
pub(super) struct Printer<'a> {
    pub(super) graph: &'a Graph,
    pub(super) nodes: &'a [Node],
    /// Whether sines, cosines, logarithms and exponentials go through helpers that are not inlined; those answer the simple
    /// cases of the platform's themselves.
    pub(super) short_cuts: bool,
    /// Whether nothing may be a condition: what has one in it goes through `ct`, a `ConstantTime`.
    pub(super) branch_free: bool,
}

impl Words for Printer<'_> {
    fn value(&self, id: NodeId) -> String {
        Printer::value(self, id)
    }

    fn number(&self, value: f64) -> String {
        literal(self.graph.scalar(), value)
    }
}

impl Printer<'_> {
    /// The type that implements the transcendental functions.
    pub(super) fn provider(&self) -> &'static str {
        match self.graph.maths() {
            MathsProvider::Own => "Own",
            MathsProvider::System => "System",
        }
    }

    /// The statement that computes a node.
    pub(super) fn statement(&self, id: NodeId) -> String {
        format!("let v{} = {};", id.0, self.operation(id))
    }

    /// A node where it is used: a number, an input, or the name of what was computed.
    pub(super) fn value(&self, id: NodeId) -> String {
        match self.nodes[id.index()] {
            Node::Constant(bits) => literal(self.graph.scalar(), f64::from_bits(bits)),
            Node::Input(input) => format!("s[{}]", input.index()),
            Node::Operation(..) | Node::Upper(..) => format!("v{}", id.0),
        }
    }

    /// Whether `ct` has the maths.
    fn masked_maths(&self) -> bool {
        self.branch_free && self.graph.maths() == MathsProvider::Own && self.graph.scalar() == ScalarType::F32
    }

    fn operation(&self, id: NodeId) -> String {
        let node = self.nodes[id.index()];
        let operands: Vec<String> = node.operands().iter().map(|&operand| self.value(operand)).collect();
        match node {
            Node::Constant(_) | Node::Input(_) => self.value(id),
            Node::Upper(instruction, _) => format!("{}_upper({})", instruction.name(), operands.join("")),
            Node::Operation(instruction, _) => self.instruction(instruction, &operands),
        }
    }

    /// An instruction on operands; one-operand instructions ignore the second.
    pub(super) fn instruction(&self, instruction: Instruction, operands: &[String]) -> String {
        let operands = &operands[..instruction.arity()];
        let infix = |operator: &str| operands.join(operator);
        let arguments = operands.join(", ");
        match instruction {
            Instruction::Sub => infix(" - "),
            Instruction::Add => infix(" + "),
            Instruction::Mul => infix(" * "),
            Instruction::Div => infix(" / "),
            Instruction::NegateIfLess | Instruction::Min | Instruction::Max => {
                format!("{}{}({arguments})", if self.branch_free { "ct." } else { "ops::" }, instruction.name())
            }
            Instruction::Cos | Instruction::Sin | Instruction::Ln | Instruction::Exp if self.masked_maths() => {
                format!("ct.{}({arguments})", instruction.name())
            }
            Instruction::Cos | Instruction::Sin | Instruction::Ln | Instruction::Exp if self.short_cuts => {
                format!("{}({arguments})", instruction.name())
            }
            Instruction::Cos | Instruction::Sin | Instruction::Ln | Instruction::Exp => {
                format!("{}::{}({arguments})", self.provider(), instruction.name())
            }
            Instruction::Abs => format!("{}::abs({arguments})", self.graph.scalar().name()),
        }
    }
}

/// A number as a Rust literal.
pub(super) fn literal(scalar: ScalarType, value: f64) -> String {
    let name = scalar.name();
    if value.is_infinite() {
        return format!("{name}::{}", if value < 0.0 { "NEG_INFINITY" } else { "INFINITY" });
    }
    match scalar {
        ScalarType::F32 => format!("{:?}_f32", value as f32),
        ScalarType::F64 => format!("{value:?}_f64"),
    }
}
