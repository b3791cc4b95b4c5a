//! The order in which roots stand side by side.

use crate::nodes::{Node, NodeId, NodeSet};
use crate::plan::Plan;

/// How much longer a transcendental function takes than any other operation.
const TRANSCENDENTAL: usize = 8;

/// Returns the indices of a plan's roots in an order in which neighbours need much of the same, beginning with the first. What
/// several roots need in the same part of a block is computed once.
pub(super) fn kindred<S: Copy>(plan: &Plan<S>) -> Vec<usize> {
    let needs: Vec<&[NodeId]> = plan.roots.iter().map(|&root| &plan.teams[root as usize].needs[..]).collect();
    let time = |node: &NodeId| match plan.nodes[node.index()] {
        Node::Operation(instruction, ..) if instruction.is_transcendental() => TRANSCENDENTAL,
        _ => 1,
    };
    let mut left: Vec<usize> = (1..plan.roots.len()).collect();
    let mut order = vec![0];
    let mut newest = 0;
    while !left.is_empty() {
        let mut set = NodeSet::empty(plan.nodes.len());
        for &node in needs[newest] {
            set.insert(node);
        }
        let common = |root: usize| needs[root].iter().filter(|node| set.contains(**node)).map(time).sum::<usize>();
        // Of equals the first: `max_by_key` returns the last.
        let next = (0..left.len()).rev().max_by_key(|&place| common(left[place])).unwrap_or(0);
        newest = left.remove(next);
        order.push(newest);
    }
    order
}

#[cfg(test)]
mod tests {
    use super::kindred;
    use crate::{Destination, Edge, Line, Operand, Plan, PolicyGraph, SourceDocument};
    use tpg_runtime::ops::{Instruction, Own};

    #[test]
    fn roots_stand_beside_those_that_need_the_same() {
        let line = |instruction: Instruction, input| Line {
            to: 0,
            instruction: instruction.into(),
            operands: [Operand::Input(input), Operand::Input(0)],
        };
        let root = |lines: &[Line]| {
            let edge = |program| Edge { program, to: Destination::Action(program as u16) };
            let programs = [vec![]].into_iter().chain(lines.iter().map(|&line| vec![line]));
            let programs: Vec<Vec<Line>> = programs.collect();
            PolicyGraph::new(1, 0, vec![(0..programs.len() as u32).map(edge).collect()], programs)
        };
        let [sine, sum, product] = [(Instruction::Sin, 1), (Instruction::Add, 1), (Instruction::Mul, 1)]
            .map(|(instruction, input)| line(instruction, input));
        let other = line(Instruction::Sub, 1);
        let roots = [root(&[sine, sum, product]), root(&[other]), root(&[sum, product]), root(&[sine])];
        let source = SourceDocument::new("x", "1", vec![[0.0, 1.0]; 2]);
        let policies: Vec<&PolicyGraph> = roots.iter().collect();
        let plan = Plan::<f32>::of_roots::<Own>(&policies, &[source]);
        // The last root has the sine in common with the first, which outweighs two other operations.
        assert_eq!(kindred(&plan), [0, 3, 1, 2]);
    }
}
