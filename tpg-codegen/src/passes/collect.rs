//! Nodes and leaves that no walk needs any more.

use crate::ir::{Module, Node, NodeId, Successor, Values};
use Node::*;
use std::collections::BTreeSet;
use tpg_runtime::policy::ActionId;

/// Removes them.
pub(super) fn run(module: &mut Module<'_>) {
    let ends: BTreeSet<Successor> = module.teams.iter().flat_map(|team| &team.edges).map(|edge| edge.to).collect();
    for (number, leaf) in module.leaves.iter_mut().enumerate() {
        if !ends.contains(&Successor::Action(ActionId(number as u16))) {
            leaf.values.clear();
        }
    }
    let mut nodes = std::mem::take(&mut module.nodes);
    keep(&mut nodes, module.roots_mut().collect());
    module.nodes = nodes;
}

/// Keeps what `roots` need, and renumbers.
pub(super) fn keep(nodes: &mut Vec<Node>, roots: Vec<&mut NodeId>) {
    let mut needed = vec![false; nodes.len()];
    for root in &roots {
        needed[root.index()] = true;
    }
    // Operands come before operations: backwards, every user is seen before what it uses.
    for index in (0..nodes.len()).rev() {
        if needed[index] {
            nodes[index].operands().iter().for_each(|operand| needed[operand.index()] = true);
        }
    }
    let mut values = Values::default();
    let mut place: Vec<Option<NodeId>> = vec![None; nodes.len()];
    for (index, &node) in nodes.iter().enumerate().filter(|&(index, _)| needed[index]) {
        let at = |id: NodeId| place[id.index()].unwrap_or(id);
        let node = match node {
            // Of a one-operand instruction, the second repeats the first.
            Operation(instruction, operands) => Operation(instruction, operands.map(at)),
            Upper(instruction, value) => Upper(instruction, at(value)),
            Constant(_) | Input(_) => node,
        };
        place[index] = Some(values.intern(node));
    }
    for root in roots {
        *root = place[root.index()].unwrap_or(*root);
    }
    *nodes = values.into_nodes();
}

#[cfg(test)]
mod tests {
    use super::run;
    use crate::ir::{Bidder, Module, Node, NodeId};
    use tpg_graph::Input;
    use tpg_graph::sample::{self, Shape};
    use tpg_runtime::ops::Instruction;

    #[test]
    fn what_a_bid_needs_stays_in_order() {
        let operation = |a, b| Node::Operation(Instruction::Add, [NodeId(a), NodeId(b)]);
        let nodes =
            vec![Node::Input(Input(0)), Node::Input(Input(1)), operation(0, 1), operation(1, 1), operation(3, 1)];
        let graph = sample::graph(&Shape::default(), 0);
        let bidders = vec![Bidder { label: 0, value: NodeId(4) }];
        let mut module = Module { nodes, bidders, ..Module::empty(&graph) };
        run(&mut module);
        assert_eq!(module.nodes, [Node::Input(Input(1)), operation(0, 0), operation(1, 0)]);
        assert_eq!(module.bidders[0].value, NodeId(2));
    }
}
