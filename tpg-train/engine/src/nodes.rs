//! Programs as values: each distinct operation of a root exists once.
//!
//! A program's effective lines become nodes of a hash-consed arena; a program is represented by the node of its
//! register 0. Lines that do not reach that register (four of five in evolved graphs) never enter the arena, and values
//! shared by several programs are computed once. Nodes are in topological order, operands first.

use crate::policy::{Line, Operand};
use std::marker::PhantomData;
use tpg_graph::dataflow::{Assignment, effective};
use tpg_graph::hash_cons::HashCons;
use tpg_runtime::ops::{Instruction, Maths};
use tpg_runtime::scalar::Scalar;

/// Index of a node in its arena.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(pub(crate) u32);

impl NodeId {
    /// Returns the id as an index.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// A value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Node<S> {
    /// A value of the state.
    Input(u16),
    /// A number.
    Constant(S),
    /// The result of an instruction.
    Operation(Instruction, NodeId, NodeId),
}

/// Key under which equal nodes are merged. Constants compare by bits: 0 and −0 differ, and equal NaNs are the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Identity {
    Input(u16),
    Constant(u64),
    Operation(Instruction, NodeId, NodeId),
}

/// The distinct nodes of a set of programs.
#[derive(Clone, Debug)]
pub struct Arena<S, M> {
    nodes: HashCons<Node<S>, Identity>,
    maths: PhantomData<M>,
}

impl<S, M> Default for Arena<S, M> {
    fn default() -> Self {
        Self { nodes: HashCons::default(), maths: PhantomData }
    }
}

impl<S: Scalar, M: Maths<S>> Arena<S, M> {
    /// Returns the nodes; operands come before their users.
    pub fn nodes(&self) -> &[Node<S>] {
        self.nodes.nodes()
    }

    /// Returns the nodes; operands come before their users.
    pub(super) fn into_nodes(self) -> Vec<Node<S>> {
        self.nodes.into_nodes()
    }

    /// Adds a program and returns the node whose value is its bid.
    pub fn program(&mut self, registers: u16, lines: &[Line]) -> NodeId {
        let zero = self.constant(S::ZERO);
        let mut at = vec![zero; usize::from(registers)];
        for (line, _) in lines.iter().zip(effective(registers.into(), lines)).filter(|(_, effective)| *effective) {
            let operands = line.operands.map(|operand| match operand {
                Operand::Register(register) => at[usize::from(register)],
                Operand::Input(input) => self.node(Node::Input(input)),
                Operand::Constant(value) => self.constant(S::from_f64(value)),
            });
            let to = at[usize::from(line.to)];
            let apply = |instruction, operands| self.operation(instruction, operands);
            at[usize::from(line.to)] = line.instruction.compose(to, operands, apply);
        }
        at[0]
    }

    /// Adds a value of the state, whether or not a program reads it.
    pub(super) fn input(&mut self, input: u16) {
        self.node(Node::Input(input));
    }

    fn operation(&mut self, instruction: Instruction, [a, b]: [NodeId; 2]) -> NodeId {
        let b = if instruction.arity() == 1 { a } else { b };
        if let (Node::Constant(a), Node::Constant(b)) = (self.nodes()[a.index()], self.nodes()[b.index()]) {
            return self.constant(instruction.apply::<S, M>(a, b));
        }
        // a + b and b + a differ at most in which NaN they propagate, and all NaNs bid the same.
        let commutes = matches!(instruction, Instruction::Add | Instruction::Mul);
        let (a, b) = if commutes && b < a { (b, a) } else { (a, b) };
        self.node(Node::Operation(instruction, a, b))
    }

    fn constant(&mut self, value: S) -> NodeId {
        self.node(Node::Constant(value))
    }

    fn node(&mut self, node: Node<S>) -> NodeId {
        let identity = match node {
            Node::Input(input) => Identity::Input(input),
            Node::Constant(value) => Identity::Constant(value.to_f64().to_bits()),
            Node::Operation(instruction, a, b) => Identity::Operation(instruction, a, b),
        };
        NodeId(self.nodes.intern_by(identity, node))
    }
}

impl Assignment for Line {
    fn writes(&self) -> usize {
        self.to.into()
    }

    fn reads(&self) -> impl Iterator<Item = usize> {
        let operands = self.operands.iter().take(self.instruction.arity()).filter_map(|operand| match operand {
            Operand::Register(register) => Some(usize::from(*register)),
            Operand::Input(_) | Operand::Constant(_) => None,
        });
        operands.chain(self.instruction.reads_destination().then(|| usize::from(self.to)))
    }
}

#[cfg(test)]
mod tests {
    use super::{Arena, Node};
    use crate::policy::{Line, Operand};
    use tpg_graph::dataflow::effective;
    use tpg_runtime::ops::{Instruction, Own};

    fn line(to: u16, instruction: Instruction, a: Operand, b: Operand) -> Line {
        Line { to, instruction: instruction.into(), operands: [a, b] }
    }

    const R0: Operand = Operand::Register(0);
    const R1: Operand = Operand::Register(1);
    const X: Operand = Operand::Input(0);
    const Y: Operand = Operand::Input(1);

    #[test]
    fn lines_that_cannot_reach_the_bid_are_not_effective() {
        let program = [
            line(1, Instruction::Add, X, Y),
            line(0, Instruction::Add, X, X), // overwritten before it is read
            line(2, Instruction::Mul, R0, R0),
            line(0, Instruction::Abs, R1, Operand::Register(2)), // Abs ignores its second operand
        ];
        assert_eq!(effective(8, &program), [true, false, false, true]);
    }

    #[test]
    fn equal_values_are_one_node_and_constants_fold() {
        let mut arena = Arena::<f32, Own>::default();
        let a = arena.program(8, &[line(0, Instruction::Add, X, Y)]);
        let b = arena.program(8, &[line(3, Instruction::Sub, X, Y), line(0, Instruction::Add, Y, X)]);
        assert_eq!(a, b, "x + y and y + x are one value");
        let c = arena.program(8, &[line(0, Instruction::Sub, X, Y)]);
        let d = arena.program(8, &[line(0, Instruction::Sub, Y, X)]);
        assert_ne!(c, d, "x − y and y − x are not");
        let two = Operand::Constant(2.0);
        let folded = arena.program(8, &[line(1, Instruction::Mul, two, two), line(0, Instruction::Sub, R1, R0)]);
        assert_eq!(arena.nodes()[folded.index()], Node::Constant(4.0));
    }

    #[test]
    fn operands_come_before_what_they_enter() {
        let mut arena = Arena::<f32, Own>::default();
        arena.program(8, &[line(1, Instruction::Add, X, Y), line(0, Instruction::Mul, R1, X)]);
        for (place, node) in (0u32..).zip(arena.nodes()) {
            if let Node::Operation(_, a, b) = node {
                assert!(a.0 < place && b.0 < place);
            }
        }
    }
}
