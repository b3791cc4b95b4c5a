//! Signs of zeros that nobody sees.
//!
//! `x + 0` is x, but for x = −0, which it makes 0. Registers begin at 0, so the first sum of a program is often such a one. A
//! team compares bids, and no comparison tells −0 from 0; neither does a later sum with a constant. Where the sign of a zero
//! can reach no output, these additions go.
//!
//! An analysis backwards: the sign of a value's zero is *seen* if that of a value that uses it is, and passes through there.

use super::arithmetic::Arithmetic;
use super::fold;
use crate::ir::{Module, Node};
use Instruction::*;
use Node::*;
use tpg_runtime::ops::Instruction;

/// Removes additions and subtractions of a zero that change nothing but an unseen sign.
pub(super) fn run(module: &mut Module<'_>, arithmetic: Arithmetic) {
    let seen = seen(module);
    let (values, place) = fold::rewritten(&module.nodes, |values, index, instruction, [a, b]| {
        let [zero_a, zero_b] = [a, b].map(|id| values.node(id).as_constant() == Some(0.0));
        match instruction {
            Add | Sub if zero_b && !seen[index] => a,
            Add if zero_a && !seen[index] => b,
            _ => fold::operation(values, arithmetic, instruction, [a, b]),
        }
    });
    for value in module.roots_mut() {
        *value = place[value.index()];
    }
    module.nodes = values.into_nodes();
}

/// For each node, whether the sign of its zero may reach an output.
fn seen(module: &Module<'_>) -> Vec<bool> {
    let mut seen = vec![false; module.nodes.len()];
    for value in module.leaves.iter().flat_map(|leaf| &leaf.values) {
        seen[value.index()] = true;
    }
    // Operands come before operations: backwards, every user is there before what it uses.
    for index in (0..module.nodes.len()).rev() {
        match module.nodes[index] {
            Operation(instruction, operands) => {
                let constants = operands.map(|operand| module.node(operand).as_constant());
                let passes = passes(instruction, constants, seen[index]);
                for (operand, passes) in operands.iter().zip(passes).take(instruction.arity()) {
                    seen[operand.index()] |= passes;
                }
            }
            Upper(_, value) => seen[value.index()] = true,
            Constant(_) | Input(_) => {}
        }
    }
    seen
}

/// Tests for each operand whether the sign of its zero can be seen, where that of the result's can or cannot.
fn passes(instruction: Instruction, constants: [Option<f64>; 2], seen: bool) -> [bool; 2] {
    // A constant that decides the result's sign: with it, a sum of −0 and one of 0 are the same.
    let decides = |place: usize, neutral: f64| constants[place].is_some_and(|c| c.to_bits() != neutral.to_bits());
    match instruction {
        Add => [seen && !decides(1, -0.0), seen && !decides(0, -0.0)],
        Sub => [seen && !decides(1, 0.0), seen && !decides(0, -0.0)],
        // A quotient by 0 is infinite, and has its sign.
        Div => [seen, true],
        Mul | Min | Max => [seen, seen],
        Sin | Tan | Sqrt | Atan | Tanh => [seen, seen],
        // The second operand is compared, or is a divisor whose remainder has the sign of the first.
        NegateIfLess | Fmod | Gate => [seen, false],
        // Of either zero they are 0, 1, 1 and −∞; a quotient is never −0, and by either zero the same.
        Abs | Cos | Exp | Ln | Quotient => [false, false],
    }
}

#[cfg(test)]
mod tests {
    use super::{passes, run};
    use crate::ir::{Bidder, Leaf, Module, Node, NodeId};
    use crate::passes::arithmetic::Arithmetic;
    use tpg_graph::sample::{self, Shape};
    use tpg_graph::{Input, MathsProvider, ScalarType};
    use tpg_runtime::ops::Instruction;

    const F64: Arithmetic = Arithmetic { scalar: ScalarType::F64, maths: MathsProvider::Own };
    const VALUES: [f64; 9] = [0.0, -0.0, 1.5, -3.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, 1e-310];

    /// Tests whether two numbers are the same, or both NaN; where signs are not seen, zeros are the same.
    fn same(a: f64, b: f64, seen: bool) -> bool {
        a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan()) || (!seen && a == b)
    }

    #[test]
    fn an_unseen_sign_changes_no_result() {
        let evaluate = |instruction, [a, b]: [f64; 2]| F64.evaluate(instruction, a, b).expect("own maths");
        for instruction in Instruction::ALL {
            for (seen, place) in [(false, 0), (false, 1), (true, 0), (true, 1)] {
                let with = |zero: f64, other: f64| if place == 0 { [zero, other] } else { [other, zero] };
                let differs = |other| {
                    let [plus, minus] = [0.0, -0.0].map(|zero| evaluate(instruction, with(zero, other)));
                    !same(plus, minus, seen)
                };
                // What is said of any operand beside it, and of a constant one.
                let says = |other: Option<f64>| {
                    passes(instruction, if place == 0 { [None, other] } else { [other, None] }, seen)[place]
                };
                for other in VALUES {
                    assert!(says(None) || !differs(other), "{instruction:?}, place {place}, beside {other}");
                    assert!(says(Some(other)) || !differs(other), "{instruction:?}, place {place}, beside {other}");
                }
                // Nothing is kept without need, for some value beside it.
                if place < instruction.arity() {
                    assert_eq!(says(None), VALUES.into_iter().any(differs), "{instruction:?}, place {place}, {seen}");
                }
            }
        }
    }

    /// A module of an input, zeros and a product, a sum with 0 of it, and what is made of that.
    fn module(graph: &tpg_graph::Graph, last: impl Fn(&mut Vec<Node>, NodeId) -> NodeId) -> (Module<'_>, NodeId) {
        let product = Node::Operation(Instruction::Mul, [NodeId(0), NodeId(0)]);
        let sum = Node::Operation(Instruction::Add, [NodeId(1), NodeId(2)]);
        let mut nodes = vec![Node::Input(Input(0)), Node::constant(0.0), product, sum];
        let value = last(&mut nodes, NodeId(3));
        (Module { nodes, ..Module::empty(graph) }, value)
    }

    fn sums(module: &Module<'_>) -> usize {
        module.nodes.iter().filter(|node| matches!(node, Node::Operation(Instruction::Add, _))).count()
    }

    #[test]
    fn a_sum_with_zero_goes_where_a_team_compares_it_and_stays_where_an_output_shows_it() {
        let graph = sample::graph(&Shape::default(), 0);
        let (mut compared, value) = module(&graph, |_, sum| sum);
        compared.bidders = vec![Bidder { label: 0, value }];
        run(&mut compared, F64);
        assert_eq!(sums(&compared), 0);
        assert_eq!(compared.node(compared.bidders[0].value), compared.nodes[2]);
        // An output that the same value is as well shows its sign.
        let (mut shown, value) = module(&graph, |_, sum| sum);
        shown.bidders = vec![Bidder { label: 0, value }];
        shown.leaves = vec![Leaf { label: 0, values: vec![value] }];
        run(&mut shown, F64);
        assert_eq!(sums(&shown), 1);
    }

    #[test]
    fn a_sum_with_zero_goes_where_a_constant_is_added_later() {
        let graph = sample::graph(&Shape::default(), 0);
        for constant in [2.5, -0.25, 0.0] {
            let (mut module, value) = module(&graph, |nodes, sum| {
                nodes.extend([Node::constant(constant), Node::Operation(Instruction::Add, [sum, NodeId(4)])]);
                NodeId(5)
            });
            module.leaves = vec![Leaf { label: 0, values: vec![value] }];
            run(&mut module, F64);
            assert_eq!(sums(&module), 1, "{constant}");
        }
    }
}
