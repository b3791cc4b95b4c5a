//! Values and operations as expressions: what is the same in every language, and what each spells its own way.

use crate::ir::{Node, NodeId};
use crate::passes::bytecode::Width;
use tpg_graph::{Graph, Input, MathsProvider};
use tpg_runtime::ops::Instruction;

/// A language's spelling.
pub(super) trait Syntax {
    /// The graph.
    fn graph(&self) -> &Graph;
    /// The nodes that expressions name.
    fn nodes(&self) -> &[Node];
    /// The name of the graph's scalar type.
    fn scalar(&self) -> &'static str;
    /// The name of a type of unsigned integers.
    fn unsigned(&self, width: Width) -> String;
    /// A number, so that the compiler reads the very same one.
    fn literal(&self, value: f64) -> String;
    /// A value of the state.
    fn input(&self, input: Input) -> String;
    /// A call of an estimate.
    fn upper(&self, instruction: Instruction, argument: &str) -> String;
    /// A call of an instruction that is no operator.
    fn call(&self, instruction: Instruction, arguments: &str) -> String;

    /// A number that the compiler must not know.
    fn hidden(&self, number: &str) -> String;
    /// The statements that make `zero` a 0 that the compiler does not know.
    fn hidden_zero(&self, zero: &str) -> Vec<String>;
    /// The statement that computes a node.
    fn statement(&self, id: NodeId) -> String;
    /// A whole number.
    fn index(&self, number: usize) -> String;

    /// The prefix of the functions that compare bids with a team's best bid, which is in the structure `lead`. Without it,
    /// expressions compare them.
    fn lead_prefix(&self) -> Option<&str> {
        None
    }

    /// A bid that is always computed has braces around it, too.
    const BRACES: bool;

    /// A number as an operand.
    fn number(&self, value: f64) -> String {
        self.literal(value)
    }

    /// A node as an operand: a number, an input, or the name of what was computed.
    fn value(&self, id: NodeId) -> String {
        match self.nodes()[id.index()] {
            Node::Constant(bits) => self.number(f64::from_bits(bits)),
            Node::Input(input) => self.input(input),
            Node::Operation(..) | Node::Upper(..) => format!("v{}", id.0),
        }
    }

    /// The expression that computes a node.
    fn operation(&self, id: NodeId) -> String {
        let node = self.nodes()[id.index()];
        let platforms = node.is_transcendental() && self.graph().maths() == MathsProvider::System;
        let operand = |&id: &NodeId| match self.nodes()[id.index()].as_constant() {
            // A compiler that knew it would compute the function itself, and round another way than the platform does.
            Some(number) if platforms => self.hidden(&self.literal(number)),
            _ => self.value(id),
        };
        let operands: Vec<String> = node.operands().iter().map(operand).collect();
        match node {
            Node::Constant(_) | Node::Input(_) => self.value(id),
            Node::Upper(instruction, _) => self.upper(instruction, &operands.concat()),
            Node::Operation(instruction, _) => self.instruction(instruction, &operands),
        }
    }

    /// Tests whether a value is an input, or an operation has one as an operand.
    fn reads_state<'i>(&self, ids: impl IntoIterator<Item = &'i NodeId>) -> bool {
        let is_input = |id: &NodeId| matches!(self.nodes()[id.index()], Node::Input(_));
        ids.into_iter().any(|id| is_input(id) || self.nodes()[id.index()].operands().iter().any(is_input))
    }

    /// An instruction on operands; one-operand instructions ignore the second.
    fn instruction(&self, instruction: Instruction, operands: &[String]) -> String {
        let operands = &operands[..instruction.arity()];
        match instruction {
            Instruction::Sub => operands.join(" - "),
            Instruction::Add => operands.join(" + "),
            Instruction::Mul => operands.join(" * "),
            Instruction::Div => operands.join(" / "),
            _ => self.call(instruction, &operands.join(", ")),
        }
    }

    /// The least type that numbers a module's vertices.
    fn vertex_type(&self, vertices: usize) -> String {
        self.unsigned(Width::up_to(vertices as u64 - 1))
    }
}
