//! A module as tables, for the profile `small`.

use crate::ir::{Module, Node::*, NodeId};
use std::collections::{BTreeMap, BTreeSet};
use tpg_runtime::ops::Instruction;

/// The tables.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Bytecode {
    /// Instructions: from the lowest bits on, two operands and an operation.
    pub code: Vec<u64>,
    /// The start of each program in [`code`](Self::code), and the end of the last.
    pub programs: Vec<u64>,
    /// The program of each edge.
    pub bidders: Vec<u64>,
    /// The destination of each edge: teams from 0, then actions.
    pub targets: Vec<u64>,
    /// The start of each team's edges, and the end of the last team's.
    pub teams: Vec<u64>,
    /// The program of each output of each leaf, by the leaves' numbers; of a leaf that no walk ends at, any program.
    pub leaves: Vec<u64>,
    /// The constants, which follow the state in the frame.
    pub constants: Vec<f64>,
    /// The place of a program's first result in the frame.
    pub first_result: usize,
    /// Places in the frame.
    pub frame: usize,
    /// Bits of an operand.
    pub operand_bits: u32,
    /// The operations that occur, by number; `None` copies its first operand.
    pub used: Vec<Option<Instruction>>,
}

impl Bytecode {
    /// The lowest bits of an instruction, which are an operand.
    pub(crate) fn operand_mask(&self) -> u32 {
        (1 << self.operand_bits) - 1
    }
}

/// The smallest unsigned integer type for some values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Width(u32);

impl Width {
    /// The width of values up to `greatest`.
    pub(crate) fn up_to(greatest: u64) -> Self {
        Self(match greatest {
            0..=0xff => 8,
            0x100..=0xffff => 16,
            0x1_0000..=0xffff_ffff => 32,
            _ => 64,
        })
    }

    /// The number of bits: 8, 16, 32 or 64.
    pub(crate) fn bits(self) -> u32 {
        self.0
    }
}

/// Encodes a module. Programs that bid the same value share one entry.
pub(crate) fn encode(module: &Module<'_>) -> Bytecode {
    let constants = constants(module);
    let state_length = module.graph.state_length();
    let first_result = state_length + constants.len();
    let mut values: Vec<NodeId> = Vec::new();
    let mut numbers = BTreeMap::new();
    let mut number_of = |value: NodeId| {
        *numbers.entry(value).or_insert_with(|| {
            values.push(value);
            values.len() as u64 - 1
        })
    };
    let mut bidders = Vec::new();
    let mut targets = Vec::new();
    let mut teams = vec![0];
    for team in &module.teams {
        for edge in &team.edges {
            let value = module.bidders[edge.bidder].value;
            bidders.push(number_of(value));
            targets.push(module.vertex(edge.to) as u64);
        }
        teams.push(bidders.len() as u64);
    }
    let outputs = module.graph.outputs().len();
    let places = module.leaves.iter().flat_map(|leaf| (0..outputs).map(|output| leaf.values.get(output)));
    let leaves = places.map(|value| value.map_or(0, |&value| number_of(value))).collect();
    let lists: Vec<Vec<NodeId>> = values.iter().map(|&value| module.operations_of(value)).collect();
    let longest = lists.iter().map(Vec::len).max().unwrap_or(0).max(1);
    let frame = first_result + longest;
    let operand_bits = usize::BITS - (frame - 1).leading_zeros();
    let operations = lists.iter().flatten().map(|&id| match module.node(id) {
        Operation(instruction, _) => Some(instruction),
        _ => None,
    });
    let copies = lists.iter().any(Vec::is_empty).then_some(None);
    let used: Vec<Option<Instruction>> = operations.chain(copies).collect::<BTreeSet<_>>().into_iter().collect();
    let mut code = Vec::new();
    let mut programs = vec![0];
    for (value, list) in values.iter().zip(&lists) {
        let place = |id: NodeId| match module.node(id) {
            Input(input) => input.index(),
            Constant(bits) => state_length + constants.binary_search(&bits).unwrap_or(0),
            Operation(..) | Upper(..) => first_result + list.binary_search(&id).unwrap_or(0),
        };
        let mut push = |operation: Option<Instruction>, [a, b]: [NodeId; 2]| {
            let number = used.binary_search(&operation).unwrap_or(0) as u64;
            let [a, b] = [a, b].map(|id| place(id) as u64);
            code.push(number << (2 * operand_bits) | b << operand_bits | a);
        };
        for &id in list {
            if let Operation(instruction, operands) = module.node(id) {
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
        leaves,
        constants: constants.into_iter().map(f64::from_bits).collect(),
        first_result,
        frame,
        operand_bits,
        used,
    }
}

/// The constants of a module by their bits, sorted.
fn constants(module: &Module<'_>) -> Vec<u64> {
    let constants: BTreeSet<u64> =
        (module.nodes.iter()).filter_map(|node| if let Constant(bits) = *node { Some(bits) } else { None }).collect();
    constants.into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::{Bytecode, encode};
    use crate::passes::arithmetic::Arithmetic;
    use crate::passes::optimise;
    use tpg_graph::sample::{self, Shape};
    use tpg_graph::{Graph, MathsProvider, ScalarType};
    use tpg_graph::{interpret, states};
    use tpg_runtime::ops::{Instruction, bid};

    /// Runs the tables as their fields say, knowing nothing of the module.
    fn run(code: &Bytecode, arithmetic: Arithmetic, actions: usize, state: &[f64]) -> usize {
        let teams = code.teams.len() - 1;
        let mut vertex = 0;
        while vertex < teams {
            let mut best: Option<(f64, usize)> = None;
            for edge in code.teams[vertex] as usize..code.teams[vertex + 1] as usize {
                let bid = bid(program(code, arithmetic, code.bidders[edge] as usize, state));
                if best.is_none_or(|(highest, _)| bid >= highest) {
                    best = Some((bid, code.targets[edge] as usize));
                }
            }
            vertex = best.expect("a team has an edge").1;
        }
        assert!(vertex < teams + actions);
        vertex - teams
    }

    fn program(code: &Bytecode, arithmetic: Arithmetic, program: usize, state: &[f64]) -> f64 {
        let mut frame: Vec<f64> = state.iter().chain(&code.constants).copied().collect();
        assert_eq!(frame.len(), code.first_result);
        for place in code.programs[program] as usize..code.programs[program + 1] as usize {
            let word = code.code[place];
            let mask = (1 << code.operand_bits) - 1;
            let [a, b] = [word & mask, word >> code.operand_bits & mask].map(|operand| frame[operand as usize]);
            frame.push(match code.used[(word >> (2 * code.operand_bits)) as usize] {
                Some(instruction) => arithmetic.evaluate(instruction, a, b).expect("own maths"),
                None => a,
            });
        }
        assert!(frame.len() <= code.frame);
        frame[frame.len() - 1]
    }

    fn graphs() -> impl Iterator<Item = Graph> {
        (0..150).map(|seed| sample::graph(&Shape { maths: MathsProvider::Own, ..Shape::random(seed) }, seed))
    }

    #[test]
    fn the_tables_alone_act_like_the_interpreter() {
        let mut copies = 0;
        for (graph, seed) in graphs().zip(0..) {
            let arithmetic = Arithmetic::new(&graph);
            let code = encode(&optimise(&graph));
            copies += usize::from(code.used.contains(&None));
            let states = states::sample(&graph, 100, seed);
            let expected = interpret::actions(&graph, &states);
            for (state, expected) in states.chunks_exact(graph.state_length()).zip(expected) {
                let found = run(&code, arithmetic, graph.actions().len(), state);
                assert_eq!(found, usize::from(expected.0), "graph {seed}, {state:?}");
            }
        }
        assert!(copies > 10, "bids that are inputs or constants occur");
    }

    #[test]
    fn programs_that_bid_the_same_are_one_and_nothing_is_wider_than_it_must_be() {
        let text = include_str!("../../tests/fixtures/all_instructions.json");
        let graph = Graph::from_json("fixture", text).expect("a valid graph");
        assert_eq!(graph.scalar(), ScalarType::F64);
        let code = encode(&optimise(&graph));
        // Program 3, which teams 7 and 9 share, bids 0, and no other program does: twelve programs for thirteen edges.
        assert_eq!((code.bidders.len(), code.programs.len() - 1, code.teams), (13, 12, vec![0, 5, 8, 13]));
        assert_eq!(code.bidders[2], code.bidders[7]);
        // Ten values of the state, then the constants, then the longest program's results, of three lines.
        assert_eq!(code.first_result, 10 + code.constants.len());
        assert_eq!(code.frame, code.first_result + 3);
        assert!(code.frame <= 1 << code.operand_bits && code.frame > 1 << (code.operand_bits - 1));
        assert_eq!(code.used.len(), Instruction::ALL.len(), "each but the quotient once, and the copy");
    }
}
