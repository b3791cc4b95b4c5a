//! A module as tables: what the profile `small` runs.

use crate::graph::Graph;
use crate::ir::{Module, Node, NodeId, Target};
use std::collections::{BTreeMap, BTreeSet};
use tpg_runtime::ops::Instruction;

/// The tables.
#[derive(Clone, Debug, PartialEq)]
pub struct Bytecode {
    /// Instructions: from the lowest bits on, two operands and an operation.
    pub code: Vec<u64>,
    /// Where each program begins in [`code`](Self::code), and where the last ends.
    pub programs: Vec<u64>,
    /// The program of each edge.
    pub bidders: Vec<u64>,
    /// Where each edge leads: teams from 0, then actions.
    pub targets: Vec<u64>,
    /// Where each team's edges begin, and where the last team's end.
    pub teams: Vec<u64>,
    /// The constants, which follow the state in the frame.
    pub constants: Vec<f64>,
    /// The place of a program's first result in the frame.
    pub first_result: usize,
    /// Places in the frame.
    pub frame: usize,
    /// Bits of an operand.
    pub operand_bits: u32,
    /// The operations that occur, in order; `None` copies its first operand.
    pub used: Vec<Option<Instruction>>,
}

/// The number of an operation.
pub fn number(operation: Option<Instruction>) -> u32 {
    match operation {
        Some(instruction) => instruction as u32,
        None => Instruction::ALL.len() as u32,
    }
}

/// Encodes a module. Programs that bid the same value are one.
pub fn encode(graph: &Graph, module: &Module) -> Bytecode {
    let constants = constants(module);
    let first_result = graph.state_length() + constants.len();
    let mut values: Vec<NodeId> = Vec::new();
    let mut program_of = BTreeMap::new();
    let mut bidders = Vec::new();
    let mut targets = Vec::new();
    let mut teams = vec![0];
    for team in &module.teams {
        for edge in &team.edges {
            let value = module.bidders[edge.bidder].value;
            let program = *program_of.entry(value).or_insert_with(|| {
                values.push(value);
                values.len() - 1
            });
            bidders.push(program as u64);
            targets.push(match edge.to {
                Target::Team(team) => team as u64,
                Target::Action(action) => module.teams.len() as u64 + u64::from(action.0),
            });
        }
        teams.push(bidders.len() as u64);
    }
    let lists: Vec<Vec<NodeId>> = values.iter().map(|&value| module.operations_of(value)).collect();
    let longest = lists.iter().map(Vec::len).max().unwrap_or(0).max(1);
    let frame = first_result + longest;
    let operand_bits = usize::BITS - (frame - 1).leading_zeros();
    let mut used = BTreeSet::new();
    let mut code = Vec::new();
    let mut programs = vec![0];
    for (value, list) in values.iter().zip(&lists) {
        let place = |id: NodeId| match module.node(id) {
            Node::Input(input) => input.index(),
            Node::Constant(bits) => graph.state_length() + constants.binary_search(&bits).unwrap_or(0),
            Node::Operation(..) | Node::Upper(..) => first_result + list.binary_search(&id).unwrap_or(0),
        };
        let mut push = |operation: Option<Instruction>, [a, b]: [NodeId; 2]| {
            used.insert((number(operation), operation));
            let [a, b] = [a, b].map(|id| place(id) as u64);
            code.push(u64::from(number(operation)) << (2 * operand_bits) | b << operand_bits | a);
        };
        for &id in list {
            if let Node::Operation(instruction, operands) = module.node(id) {
                push(Some(instruction), operands);
            }
        }
        if list.is_empty() {
            push(None, [*value; 2]);
        }
        programs.push(code.len() as u64);
    }
    Bytecode {
        code,
        programs,
        bidders,
        targets,
        teams,
        constants: constants.into_iter().map(f64::from_bits).collect(),
        first_result,
        frame,
        operand_bits,
        used: used.into_iter().map(|(_, operation)| operation).collect(),
    }
}

/// The constants of a module by their bits, sorted.
fn constants(module: &Module) -> Vec<u64> {
    let constants: BTreeSet<u64> = (module.nodes.iter())
        .filter_map(|node| if let Node::Constant(bits) = *node { Some(bits) } else { None })
        .collect();
    constants.into_iter().collect()
}
