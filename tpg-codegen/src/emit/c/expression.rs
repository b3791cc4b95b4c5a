//! Nodes as C expressions.

use crate::emit::questions::Words;
use crate::ir::{Node, NodeId};
use tpg_graph::{Graph, Input, MathsProvider, ScalarType};
use tpg_runtime::ops::Instruction;

/// Writes nodes.
#[derive(Clone, Copy)]
pub(super) struct Printer<'a> {
    pub(super) graph: &'a Graph,
    pub(super) nodes: &'a [Node],
    pub(super) prefix: &'a str,
    /// Whether inputs are GEGELATI's globals.
    pub(super) gegelati: bool,
    /// Whether logarithms and exponentials of the platform go through helpers that answer the simple cases themselves.
    pub(super) short_cuts: bool,
}

impl Words for Printer<'_> {
    fn value(&self, id: NodeId) -> String {
        Printer::value(self, id)
    }

    fn number(&self, value: f64) -> String {
        self.constant(value)
    }
}

impl Printer<'_> {
    /// The graph's scalar type.
    pub(super) fn scalar(&self) -> &'static str {
        match self.graph.scalar() {
            ScalarType::F32 => "float",
            ScalarType::F64 => "double",
        }
    }

    /// The statement that computes a node.
    pub(super) fn statement(&self, id: NodeId) -> String {
        format!("const {} v{} = {};", self.scalar(), id.0, self.operation(id))
    }

    /// The same, where a variable stands for it in several teams.
    pub(super) fn assignment(&self, id: NodeId) -> String {
        format!("v{} = {};", id.0, self.operation(id))
    }

    /// A node where it is used: a number, an input, or the name of what was computed.
    pub(super) fn value(&self, id: NodeId) -> String {
        match self.nodes[id.index()] {
            Node::Constant(bits) => self.constant(f64::from_bits(bits)),
            Node::Input(input) => self.input(input),
            Node::Operation(..) | Node::Upper(..) => format!("v{}", id.0),
        }
    }

    /// A number so that the compiler reads the very same one.
    pub(super) fn constant(&self, value: f64) -> String {
        let text = literal(self.graph.scalar(), value);
        if text.starts_with('-') { format!("({text})") } else { text }
    }

    fn operation(&self, id: NodeId) -> String {
        let node = self.nodes[id.index()];
        let operands: Vec<String> = node.operands().iter().map(|&operand| self.value(operand)).collect();
        match node {
            Node::Constant(_) | Node::Input(_) => self.value(id),
            Node::Upper(instruction, _) => {
                format!("{}_{}_upper({})", self.prefix, instruction.name(), operands.join(""))
            }
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
                format!("{}_{}({arguments})", self.prefix, instruction.name())
            }
            Instruction::Cos => format!("{}({arguments})", self.maths("cos", "cos", false)),
            Instruction::Sin => format!("{}({arguments})", self.maths("sin", "sin", false)),
            Instruction::Ln => format!("{}({arguments})", self.maths("ln", "log", true)),
            Instruction::Exp => format!("{}({arguments})", self.maths("exp", "exp", true)),
            Instruction::Abs => format!("{}({arguments})", self.of_scalar("fabs")),
        }
    }

    fn maths(&self, own: &str, system: &str, has_short_cut: bool) -> String {
        match self.graph.maths() {
            MathsProvider::System if !(self.short_cuts && has_short_cut) => self.of_scalar(system),
            MathsProvider::System | MathsProvider::Own => format!("{}_{own}", self.prefix),
        }
    }

    /// The name of a function of `<math.h>` in the graph's scalar type.
    pub(super) fn of_scalar(&self, name: &str) -> String {
        match self.graph.scalar() {
            ScalarType::F32 => format!("{name}f"),
            ScalarType::F64 => name.to_owned(),
        }
    }

    fn input(&self, input: Input) -> String {
        let (source, place) = self.graph.source_of(input);
        if self.gegelati {
            let number = self.graph.sources().iter().position(|s| s.name == source.name).unwrap_or(0) + 1;
            format!("in{number}[{place}]")
        } else {
            format!("state->{}[{place}]", source.name)
        }
    }
}

/// A number as a C literal.
pub(super) fn literal(scalar: ScalarType, value: f64) -> String {
    if value.is_infinite() {
        let sign = if value < 0.0 { "-" } else { "" };
        return match scalar {
            ScalarType::F32 => format!("{sign}INFINITY"),
            ScalarType::F64 => format!("{sign}(double)INFINITY"),
        };
    }
    match scalar {
        ScalarType::F32 => format!("{:?}F", value as f32),
        ScalarType::F64 => format!("{value:?}"),
    }
}
