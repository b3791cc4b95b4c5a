//! Values and operations as expressions: what is the same in every language, and what each spells its own way.

use crate::ir::{Node, NodeId, needed};
use crate::passes::bytecode::{Bytecode, Width};
use Instruction::*;
use tpg_graph::{Graph, Input};
use tpg_runtime::ops::Instruction;

/// A table of unsigned integers: the least type that holds them, and the values as a language writes them.
pub(super) struct Table {
    pub(super) kind: String,
    pub(super) values: Vec<String>,
}

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
    /// The suffix of a number of such a type.
    fn suffix(&self, _width: Width) -> &'static str {
        ""
    }
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
    /// The statement that names an expression.
    fn declaration(&self, name: &str, expression: &str) -> String;
    /// The lowest finite number.
    fn lowest(&self) -> String;
    /// Words that cannot name a variable of generated code.
    fn is_taken(&self, name: &str) -> bool;
    /// A whole number.
    fn index(&self, number: usize) -> String;

    /// Functions compare bids with a team's best bid, which is in the structure `lead`; otherwise expressions do.
    fn leads(&self) -> bool;
    /// The condition under which a bid that is not above a bound can win: of an edge, or of one after all others.
    fn can_win(&self, bound: &str, edge: Option<&str>) -> String;

    /// A bid that is always computed has braces around it, too.
    const BRACES: bool;

    /// A variable that is called after something of the graph.
    fn local(&self, name: &str) -> String {
        let ours = name.starts_with("to_") || name.contains("term") || name.starts_with("bid_");
        if ours || self.is_taken(name) { format!("{name}_") } else { name.to_owned() }
    }

    /// Tests for a graph in which clang and rustc may take a bid of 0 for another one: `(v > 0) ? v : 0` of a `v = max(0, x)` for v, which
    /// it is not where x is NaN. Where they do not know the 0, they do not.
    fn hides_zeros(&self) -> bool {
        let may_compare = |node: &Node| match node {
            Node::Operation(instruction, _) => !matches!(instruction, Add | Sub | Mul | Div),
            Node::Upper(..) => true,
            Node::Constant(_) | Node::Input(_) => false,
        };
        self.nodes().iter().any(may_compare)
    }

    /// Tests whether a value is made of an input.
    fn reads_state<'i>(&self, values: impl IntoIterator<Item = &'i NodeId>) -> bool {
        let is_input = |id: &NodeId| matches!(self.nodes()[id.index()], Node::Input(_));
        let reads = |&id: &NodeId| {
            let operations = needed(self.nodes(), id, |_| true);
            is_input(&id) || operations.iter().flat_map(|id| self.nodes()[id.index()].operands()).any(is_input)
        };
        values.into_iter().any(reads)
    }

    /// An instruction on operands; one-operand instructions ignore the second.
    fn instruction(&self, instruction: Instruction, operands: &[String]) -> String {
        let operands = &operands[..instruction.arity()];
        match instruction {
            Sub => operands.join(" - "),
            Add => operands.join(" + "),
            Mul => operands.join(" * "),
            Div => operands.join(" / "),
            _ => self.call(instruction, &operands.join(", ")),
        }
    }

    /// A table of whole numbers.
    fn table(&self, values: &[u64]) -> Table {
        let width = Width::up_to(values.iter().copied().max().unwrap_or(0));
        let value = |value: &u64| format!("{value}{}", self.suffix(width));
        Table { kind: self.unsigned(width), values: values.iter().map(value).collect() }
    }

    /// The operations of tables, by number: expressions of `a` and `b`.
    fn cases(&self, code: &Bytecode) -> Vec<(u32, String)> {
        let operands = ["a".to_owned(), "b".to_owned()];
        let expression = |operation: Option<_>| match operation {
            Some(instruction) => self.instruction(instruction, &operands),
            None => "a".to_owned(),
        };
        (0..).zip(&code.used).map(|(number, &operation)| (number, expression(operation))).collect()
    }

    /// The least type that numbers a module's vertices.
    fn vertex_type(&self, vertices: usize) -> String {
        self.unsigned(Width::up_to(vertices as u64 - 1))
    }
}
