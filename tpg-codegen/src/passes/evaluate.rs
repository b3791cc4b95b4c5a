//! The values of nodes for a state.

use super::estimate;
use crate::ir::Node;
use tpg_graph::ScalarType;
use tpg_runtime::ops::Maths;
use tpg_runtime::scalar::Scalar;

/// Computes every node, whether generated code would or not.
///
/// # Panics
/// If `state` or `values` is too short.
pub(crate) fn evaluate<S: Scalar, M: Maths<S>>(scalar: ScalarType, nodes: &[Node], state: &[f64], values: &mut [S]) {
    for (index, node) in nodes.iter().enumerate() {
        values[index] = match *node {
            Node::Constant(bits) => S::from_f64(f64::from_bits(bits)),
            Node::Input(input) => S::from_f64(state[input.index()]),
            Node::Operation(instruction, [a, b]) => instruction.apply::<S, M>(values[a.index()], values[b.index()]),
            Node::Upper(instruction, value) => {
                S::from_f64(estimate::upper(scalar, instruction, values[value.index()].to_f64()))
            }
        };
    }
}
