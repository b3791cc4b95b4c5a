//! A model of the flash of small graphs' code, by which the profile `small` takes the smallest of several shapes.
//!
//! The size of code is a sum over its parts, each with a weight for a language, a scalar type and a shape: fitted to what
//! `arm-none-eabi-gcc` 12.2 at `-Os` and rustc 1.95 at `opt-level` s made of random graphs for a Cortex-M4F, and for Rust then moved until
//! the choice among the shapes was best. The model does not know what the compilers leave out because it cannot matter:
//! `tests/least.rs` limits how far it is off.

use crate::ir::{Module, Node, NodeId, reached};
use crate::options::Language;
use crate::passes::cases::{Cases, Kind};
use crate::passes::functions;
use crate::passes::schedule::{FEW_EDGES, Schedule};
use crate::shape::Shape;
use tpg_graph::{MathsProvider, ScalarType};
use tpg_runtime::ops::Instruction;

/// The number of parts.
const PARTS: usize = 16;

/// Bytes of flash for each part, by language, scalar type and shape: fast, balanced, small, constant-time.
#[rustfmt::skip]
const WEIGHTS: [[[[i64; PARTS]; 4]; 2]; 2] = [
    // C
    [
        [
            [23, -58, 21, 22, 0, 32, 2, 19, 18, -5, 398, -30, -16, 7, 39, 7],
            [17, 15, -5, 21, 41, 49, 4, 4, 5, 11, 383, 207, 297, 10, 30, 14],
            [143, 3, 14, -5, 0, 0, -5, -5, 6, 10, 394, 241, 231, -1, 89, -2],
            [-3, 1, 1, 55, -13, -1, 14, 48, 43, -26, 397, 221, 108, 8, 25, 18],
        ],
        [
            [-6, -97, 25, 33, 0, 69, 15, 53, 0, -37, 0, 0, 0, 20, -53, 42],
            [21, 51, -18, 32, 99, -6, 10, 25, -27, -22, 1063, 707, 657, -7, 31, 18],
            [165, 2, 25, -2, 0, 0, -4, -6, -9, 12, 1054, 612, 584, -1, 117, -1],
            [-69, -9, 51, 91, -12, 78, 23, 48, -4, 4, 1036, 632, 581, 40, 102, -49],
        ],
    ],
    // Rust
    [
        [
            [6, -52, 19, 29, 0, 27, 9, 24, 90, -12, 0, 443, -91, 3, 24, 10],
            [107, 33, 0, 11, 15, 120, 5, 7, 62, 2, 555, 233, 200, 6, 46, 4],
            [185, 3, 67, 2, 0, 0, -10, -35, 16, 8, 420, 220, 175, 3, 84, -13],
            [-32, 2, 27, 31, 17, 0, 10, 33, 39, -18, 513, 256, 229, 10, 71, 11],
        ],
        [
            [-15, -58, 36, 45, 0, 25, 8, 47, 136, -48, 155, 0, 0, 13, 95, 12],
            [218, 26, -6, 18, 46, 136, 19, 30, 15, 18, 13, -9, 70, 5, 72, 10],
            [162, 2, 88, 3, 0, 0, -7, -20, -36, 15, -12, 4, 38, -8, 92, 11],
            [5, -60, 34, 94, 45, -10, 40, 116, 95, 28, -85, -17, 26, 11, 201, 16],
        ],
    ],
];

/// Returns the shape of a module whose code is smallest; the first is as tables.
pub(crate) fn smallest(module: &Module<'_>, language: Language, shapes: [Shape; 4]) -> Shape {
    let flash = |shape: &Shape| {
        let weights = weights(language, module.graph.scalar(), shape);
        weights.map_or(i64::MAX, |weights| weights.iter().zip(parts(module, shape)).map(|(w, n)| w * n).sum())
    };
    let sizes = shapes.each_ref().map(flash);
    let first = (0..shapes.len()).min_by_key(|&place| sizes[place]).unwrap_or(0);
    Vec::from(shapes).swap_remove(first)
}

/// Tests for a graph so small that other shapes than tables may be smaller.
pub(crate) fn is_small(module: &Module<'_>) -> bool {
    module.edges() <= FEW_EDGES
}

fn weights(language: Language, scalar: ScalarType, shape: &Shape) -> Option<[i64; PARTS]> {
    let row = match shape {
        // Guards of expensive bids take so much that tables are smaller.
        Shape::Fast { schedule, .. } if schedule.plans.iter().any(|plan| !plan.lazy.is_empty()) => return None,
        Shape::Fast { .. } => 0,
        Shape::Balanced(_) => 1,
        Shape::Small(_) => 2,
        Shape::ConstantTime(_) => 3,
        Shape::Formula(_) | Shape::Gegelati | Shape::Integers(_) => return None,
    };
    Some(WEIGHTS[language as usize][scalar as usize][row])
}

/// Counts of the parts of code.
fn parts(module: &Module<'_>, shape: &Shape) -> [i64; PARTS] {
    let nodes = match shape {
        Shape::Fast { schedule, .. } => &schedule.nodes,
        Shape::Balanced(cases) => &cases.nodes,
        _ => &module.nodes,
    };
    let operations = |any: &[Instruction]| {
        let is_one = |node: &&Node| matches!(node, Node::Operation(instruction, _) if any.contains(instruction));
        nodes.iter().filter(is_one).count()
    };
    let uses = |any: &[Instruction]| operations(any).min(1);
    let own = |any: &[Instruction]| if module.graph.maths() == MathsProvider::Own { uses(any) } else { 0 };
    let [choices, ways, eager, lazy, more] = deciding(module, shape);
    [
        1,
        choices,
        ways,
        eager,
        lazy,
        more,
        operations(&[Instruction::Sub, Instruction::Add, Instruction::Mul, Instruction::Div, Instruction::Abs]),
        operations(&[
            Instruction::NegateIfLess,
            Instruction::Min,
            Instruction::Max,
            Instruction::Gate,
            Instruction::Quotient,
        ]),
        operations(&[Instruction::Fmod, Instruction::Sqrt])
            + nodes.iter().filter(|node| node.is_transcendental()).count(),
        uses(&[Instruction::NegateIfLess]) + uses(&[Instruction::Min]) + uses(&[Instruction::Max]),
        own(&[Instruction::Sin, Instruction::Cos]),
        own(&[Instruction::Ln, Instruction::Atan]),
        own(&[Instruction::Exp, Instruction::Tanh]),
        nodes.iter().filter(|node| node.as_constant().is_some()).count(),
        module.graph.outputs().len(),
        reached(&module.leaves).map(|(_, leaf)| leaf.values.len()).sum(),
    ]
    .map(|count| count as i64)
}

/// The parts that decide, in the terms of each shape: of native teams their number, their ways, their cheap bids, the others, and the bids
/// of 0.
fn deciding(module: &Module<'_>, shape: &Shape) -> [usize; 5] {
    let edges = module.teams.iter().map(|team| team.edges.len()).sum::<usize>();
    match shape {
        Shape::Fast { schedule: Schedule { plans, nodes, .. }, .. } => {
            let deciding = || plans.iter().filter(|plan| plan.destinations().len() > 1);
            let constant = |id: NodeId| nodes[id.index()].as_constant();
            let bids = || deciding().flat_map(|plan| &plan.eager).map(|bid| constant(bid.value));
            [
                deciding().count(),
                deciding().map(|plan| plan.destinations().len()).sum(),
                bids().filter(Option::is_none).count(),
                0,
                bids().filter(|&constant| constant == Some(0.0)).count(),
            ]
        }
        Shape::Balanced(Cases { bids, places, .. }) => {
            let plain = bids.iter().filter(|case| case.kind == Kind::Plain).count();
            [module.teams.len(), edges, plain, bids.len() - plain, usize::from(!places.is_empty())]
        }
        Shape::Small(code) => {
            [code.bytes(module.graph.scalar()) as usize, code.used.len(), code.programs.len() - 1, 0, 0]
        }
        Shape::ConstantTime(functions) => {
            let challenges = edges - module.teams.len();
            let distinct = functions.iter().map(|function| function.bids.len()).sum();
            let missing = functions::leaf_operations(module, functions).len();
            [module.teams.len(), usize::from(module.teams.len() == 1), challenges, distinct, missing]
        }
        Shape::Formula(_) | Shape::Gegelati | Shape::Integers(_) => [0; 5],
    }
}
