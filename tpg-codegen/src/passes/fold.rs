//! Constant folding and identities that hold for every value, bit for bit.
//!
//! Rules: an operation on constants is a constant; `x − 0 = x` and `x + (−0) = x`, also for x = −0; `1·x = x`,
//! `x / 1 = x`; division by a power of two is multiplication by its reciprocal; `min(x, x)`, `max(x, x)` and
//! `negate_if_less(x, x)` are x, for NaN too, as the comparison is false; a minimum with an operand that was in it already is
//! that minimum, but `min(min(x, y), x) = min(y, x)`, and so for the maximum; with a NaN, an operation is NaN or one of its
//! operands; `||x|| = |x|`; sums and products commute (the
//! payload of a NaN aside, which no comparison sees), so their operands are sorted and equal ones meet.
//!
//! The rule for nested minima also avoids a miscompilation: LLVM 22 replaces `min(min(c, x), c)` with a constant c by
//! `min(c, x)`, which is wrong for a NaN.
//!
//! Not exact, and so not rules: `x + 0` (−0 becomes 0), `0·x` and `x − x` (NaN for an infinite x), any reassociation.

use super::arithmetic::Arithmetic;
use crate::ir::{Module, Node, NodeId, Successor, Values};
use Instruction::*;
use Node::*;
use std::collections::BTreeMap;
use tpg_runtime::ops::{Instruction, bid, clamp};
use tpg_runtime::policy::ActionId;

/// Folds every node, then every bid: a bid of NaN is a bid of −∞, and one of −0 a bid of 0. An output that is constant is
/// limited here, and of leaves with the same values one remains.
pub(super) fn run(module: &mut Module<'_>, arithmetic: Arithmetic) {
    let fold = |values: &mut Values, _, instruction, operands| operation(values, arithmetic, instruction, operands);
    let (mut values, folded) = rewritten(&module.nodes, fold);
    for bidder in &mut module.bidders {
        let value = folded[bidder.value.index()];
        bidder.value = match values.node(value).as_constant() {
            // Bids of 0 and −0 are equally high: they are one. (x + 0 is x, but for −0.)
            Some(constant) => values.intern(Node::constant(bid(constant) + 0.0)),
            None => value,
        };
    }
    for leaf in &mut module.leaves {
        for (value, output) in leaf.values.iter_mut().zip(module.graph.outputs()) {
            *value = folded[value.index()];
            if let Some(constant) = values.node(*value).as_constant() {
                let limited = clamp(constant, output.range.min, output.range.max, output.nan);
                *value = values.intern(Node::constant(limited));
            }
        }
    }
    module.nodes = values.into_nodes();
    merge_leaves(module);
}

/// Rewrites nodes, and says what each has become; `operation` makes the new node of the operation at a place, from its new operands.
pub(super) fn rewritten(
    nodes: &[Node],
    operation: impl Fn(&mut Values, usize, Instruction, [NodeId; 2]) -> NodeId,
) -> (Values, Vec<NodeId>) {
    let mut values = Values::default();
    let mut places: Vec<NodeId> = Vec::with_capacity(nodes.len());
    for (index, &node) in nodes.iter().enumerate() {
        let at = |id: NodeId| places[id.index()];
        places.push(match node {
            Operation(instruction, operands) => operation(&mut values, index, instruction, operands.map(at)),
            Upper(function, value) => values.intern(Upper(function, at(value))),
            Constant(_) | Input(_) => values.intern(node),
        });
    }
    (values, places)
}

/// Leads every edge to a leaf to the first leaf with the same values.
fn merge_leaves(module: &mut Module<'_>) {
    let mut first = BTreeMap::new();
    let same: Vec<usize> = (module.leaves.iter().enumerate())
        .map(|(number, leaf)| *first.entry(leaf.values.clone()).or_insert(number))
        .collect();
    for edge in module.teams.iter_mut().flat_map(|team| &mut team.edges) {
        if let (Successor::Action(leaf), false) = (edge.to, same.is_empty()) {
            edge.to = Successor::Action(ActionId(same[usize::from(leaf.0)] as u16));
        }
    }
}

/// An operation, or what it always equals.
pub(super) fn operation(
    values: &mut Values,
    arithmetic: Arithmetic,
    instruction: Instruction,
    operands: [NodeId; 2],
) -> NodeId {
    let [a, b] = operands;
    let constants = operands.map(|operand| values.node(operand).as_constant());
    let is = |constant: Option<f64>, value: f64| constant.is_some_and(|c| c.to_bits() == value.to_bits());
    if let [Some(x), Some(y)] = constants
        && let Some(result) = arithmetic.evaluate(instruction, x, y)
    {
        return values.intern(Node::constant(result));
    }
    if constants[..instruction.arity()].iter().any(|constant| constant.is_some_and(f64::is_nan)) {
        // No comparison with a NaN holds; everything else that reads one is one.
        return match instruction {
            Min | Max => b,
            NegateIfLess => a,
            // A gate with a NaN in front of it can still be shut.
            Gate if constants[1].is_some_and(f64::is_nan) => a,
            Gate => values.intern(Operation(instruction, operands)),
            // By 0, it is a number.
            Quotient if !constants[1].is_some_and(f64::is_nan) => values.intern(Operation(instruction, operands)),
            _ => values.intern(Node::constant(f64::NAN)),
        };
    }
    match instruction {
        Sub if is(constants[1], 0.0) => a,
        Add if is(constants[1], -0.0) => a,
        Add if is(constants[0], -0.0) => b,
        Mul if is(constants[1], 1.0) => a,
        Mul if is(constants[0], 1.0) => b,
        Div if is(constants[1], 1.0) => a,
        Div => match constants[1].and_then(|divisor| arithmetic.reciprocal(divisor)) {
            Some(factor) => {
                let factor = values.intern(Node::constant(factor));
                commutative(values, Mul, a, factor)
            }
            None => values.intern(Operation(instruction, operands)),
        },
        Min | Max | NegateIfLess if a == b => a,
        Min | Max => {
            let same = |operand| match values.node(operand) {
                Operation(inner, operands) if inner == instruction => Some(operands),
                _ => None,
            };
            match (same(a), same(b)) {
                (Some([_, y]), _) if b == y => a,
                (Some([x, y]), _) if b == x => operation(values, arithmetic, instruction, [y, x]),
                (_, Some(inner)) if inner.contains(&a) => b,
                _ => values.intern(Operation(instruction, operands)),
            }
        }
        Gate if is(constants[0], -0.0) => a,
        Gate if constants[1] == Some(0.0) => values.intern(Node::constant(-0.0)),
        Gate if constants[1].is_some() => a,
        Abs if matches!(values.node(a), Operation(Abs, _)) => a,
        Add | Mul => commutative(values, instruction, a, b),
        _ => values.intern(Operation(instruction, operands)),
    }
}

fn commutative(values: &mut Values, instruction: Instruction, a: NodeId, b: NodeId) -> NodeId {
    values.intern(Operation(instruction, [a.min(b), a.max(b)]))
}

#[cfg(test)]
mod tests {
    use super::{operation, run};
    use crate::ir::{Bidder, Module, Node, NodeId, Values};
    use crate::passes::arithmetic::Arithmetic;
    use tpg_graph::sample::{self, Shape};
    use tpg_graph::{Input, MathsProvider, ScalarType};
    use tpg_runtime::ops::Instruction;

    const F64: Arithmetic = Arithmetic { scalar: ScalarType::F64, maths: MathsProvider::Own };
    const VALUES: [f64; 9] =
        [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, -0.0, 1.5, -3.0, f64::MAX, f64::MIN_POSITIVE / 8.0];

    /// The value of a node for an input.
    fn value(values: &Values, id: NodeId, input: f64) -> f64 {
        match values.node(id) {
            Node::Constant(bits) => f64::from_bits(bits),
            Node::Input(_) => input,
            Node::Upper(..) => unreachable!("folding makes no bounds"),
            Node::Operation(instruction, operands) => {
                let [a, b] = operands.map(|operand| value(values, operand, input));
                F64.evaluate(instruction, a, b).expect("own maths")
            }
        }
    }

    #[test]
    fn whatever_is_folded_keeps_its_bits_for_every_value() {
        for instruction in Instruction::ALL {
            for constant in VALUES.into_iter().chain([1.0, 4.0, -0.25]) {
                for swapped in [false, true] {
                    let mut values = Values::default();
                    let x = values.intern(Node::Input(Input(0)));
                    let c = values.intern(Node::constant(constant));
                    let operands = if swapped { [c, x] } else { [x, c] };
                    let id = operation(&mut values, F64, instruction, operands);
                    for input in VALUES {
                        let [a, b] = if swapped { [constant, input] } else { [input, constant] };
                        let expected = F64.evaluate(instruction, a, b).expect("own maths");
                        let found = value(&values, id, input);
                        let equal = expected.to_bits() == found.to_bits() || (expected.is_nan() && found.is_nan());
                        assert!(equal, "{instruction:?} {a} {b}: {expected} but {found}");
                    }
                }
            }
        }
    }

    #[test]
    fn an_operation_on_one_value_twice_keeps_its_bits() {
        for instruction in Instruction::ALL {
            let mut values = Values::default();
            let x = values.intern(Node::Input(Input(0)));
            let id = operation(&mut values, F64, instruction, [x, x]);
            for input in VALUES {
                let expected = F64.evaluate(instruction, input, input).expect("own maths");
                let found = value(&values, id, input);
                let equal = expected.to_bits() == found.to_bits() || (expected.is_nan() && found.is_nan());
                assert!(equal, "{instruction:?} {input}: {expected} but {found}");
            }
        }
    }

    #[test]
    fn a_minimum_of_a_minimum_and_its_operand_is_one_minimum_bit_for_bit() {
        for instruction in [Instruction::Min, Instruction::Max] {
            for constant in VALUES {
                // Inner and outer operands either way round, the outer one the input or the constant.
                for way in 0..8 {
                    let [inner_swapped, outer_swapped, of_constant] = [1, 2, 4].map(|bit| way & bit != 0);
                    let mut values = Values::default();
                    let x = values.intern(Node::Input(Input(0)));
                    let c = values.intern(Node::constant(constant));
                    let order = |swapped: bool, [a, b]: [NodeId; 2]| if swapped { [b, a] } else { [a, b] };
                    let inner = operation(&mut values, F64, instruction, order(inner_swapped, [x, c]));
                    let other = if of_constant { c } else { x };
                    let id = operation(&mut values, F64, instruction, order(outer_swapped, [inner, other]));
                    let depth = |id| match values.node(id) {
                        Node::Operation(_, operands) => Some(operands),
                        _ => None,
                    };
                    assert!(depth(id).into_iter().flatten().all(|operand| depth(operand).is_none()), "one is enough");
                    for input in VALUES {
                        let applied = |[a, b]: [f64; 2]| F64.evaluate(instruction, a, b).expect("own maths");
                        let order = |swapped: bool, [a, b]: [f64; 2]| if swapped { [b, a] } else { [a, b] };
                        let inner = applied(order(inner_swapped, [input, constant]));
                        let other = if of_constant { constant } else { input };
                        let expected = applied(order(outer_swapped, [inner, other]));
                        let found = value(&values, id, input);
                        let equal = expected.to_bits() == found.to_bits() || (expected.is_nan() && found.is_nan());
                        assert!(equal, "{instruction:?} of {input} and {constant}, way {way}: {expected} but {found}");
                    }
                }
            }
        }
    }

    #[test]
    fn identities_leave_no_operation() {
        let identities: [(Instruction, f64); 5] = [
            (Instruction::Sub, 0.0),
            (Instruction::Add, -0.0),
            (Instruction::Mul, 1.0),
            (Instruction::Div, 1.0),
            (Instruction::Div, 8.0),
        ];
        for (instruction, constant) in identities {
            let mut values = Values::default();
            let x = values.intern(Node::Input(Input(0)));
            let c = values.intern(Node::constant(constant));
            let id = operation(&mut values, F64, instruction, [x, c]);
            assert!(!matches!(values.node(id), Node::Operation(found, _) if found == instruction), "{instruction:?}");
        }
        let mut values = Values::default();
        let x = values.intern(Node::Input(Input(0)));
        let zero = values.intern(Node::constant(0.0));
        let sum = operation(&mut values, F64, Instruction::Add, [x, zero]);
        assert!(matches!(values.node(sum), Node::Operation(..)), "−0 + 0 is 0: not an identity");
    }

    #[test]
    fn a_constant_nan_is_no_operand() {
        for instruction in Instruction::ALL {
            for swapped in [false, true] {
                let mut values = Values::default();
                let x = values.intern(Node::Input(Input(0)));
                let nan = values.intern(Node::constant(f64::NAN));
                let id = operation(&mut values, F64, instruction, if swapped { [nan, x] } else { [x, nan] });
                let single = instruction.arity() == 1 && !swapped;
                let may_be_a_number = matches!(instruction, Instruction::Gate | Instruction::Quotient) && swapped;
                assert!(single || may_be_a_number || id == x || id == nan, "{instruction:?}");
            }
        }
    }

    #[test]
    fn a_bid_that_is_always_nan_is_minus_infinity() {
        let mut values = Values::default();
        let zero = values.intern(Node::constant(0.0));
        let quotient = values.intern(Node::Operation(Instruction::Div, [zero, zero]));
        let bidders = vec![Bidder { label: 1, value: quotient }];
        let graph = sample::graph(&Shape::default(), 0);
        let mut module = Module { nodes: values.into_nodes(), bidders, ..Module::empty(&graph) };
        run(&mut module, F64);
        assert_eq!(module.node(module.bidders[0].value), Node::constant(f64::NEG_INFINITY));
    }
}
