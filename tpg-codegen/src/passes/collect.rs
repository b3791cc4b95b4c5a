//! Nodes that no bid needs any more.

use crate::ir::{Module, Node, NodeId, Values};

/// Removes them.
pub(super) fn run(module: &mut Module) {
    let mut needed = vec![false; module.nodes.len()];
    for bidder in &module.bidders {
        needed[bidder.value.index()] = true;
    }
    // Operands come before operations: backwards, every user is seen before what it uses.
    for index in (0..module.nodes.len()).rev() {
        if needed[index] {
            module.nodes[index].operands().iter().for_each(|operand| needed[operand.index()] = true);
        }
    }
    let mut values = Values::default();
    let mut place: Vec<Option<NodeId>> = vec![None; module.nodes.len()];
    for (index, &node) in module.nodes.iter().enumerate().filter(|&(index, _)| needed[index]) {
        let node = match node {
            Node::Operation(instruction, operands) => {
                Node::Operation(instruction, operands.map(|operand| place[operand.index()].unwrap_or(operand)))
            }
            Node::Upper(function, value) => Node::Upper(function, place[value.index()].unwrap_or(value)),
            Node::Constant(_) | Node::Input(_) => node,
        };
        place[index] = Some(values.intern(node));
    }
    for bidder in &mut module.bidders {
        bidder.value = place[bidder.value.index()].unwrap_or(bidder.value);
    }
    module.nodes = values.into_nodes();
}

#[cfg(test)]
mod tests {
    use super::run;
    use crate::graph::Input;
    use crate::ir::{Bidder, Module, Node, NodeId};
    use tpg_runtime::ops::Instruction;

    #[test]
    fn what_a_bid_needs_stays_in_order() {
        let operation = |a, b| Node::Operation(Instruction::Add, [NodeId(a), NodeId(b)]);
        let nodes =
            vec![Node::Input(Input(0)), Node::Input(Input(1)), operation(0, 1), operation(1, 1), operation(3, 1)];
        let mut module =
            Module { nodes, bidders: vec![Bidder { label: 0, value: NodeId(4) }], teams: Vec::new(), depth: 0 };
        run(&mut module);
        assert_eq!(module.nodes, [Node::Input(Input(1)), operation(0, 0), operation(1, 0)]);
        assert_eq!(module.bidders[0].value, NodeId(2));
    }
}
