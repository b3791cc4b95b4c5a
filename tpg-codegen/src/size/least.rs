//! A model of the flash of small graphs' code, by which the profile `small` takes the least of several shapes.
//!
//! The size of code is a sum over what it is made of, each with a weight for a language, a scalar type and a shape: fitted to what
//! `arm-none-eabi-gcc` 12.2 at `-Os` and rustc 1.95 at `opt-level` s made of random graphs for a Cortex-M4F, and for Rust then moved until
//! the choice among the shapes was best. What the compilers leave out because it cannot matter, the model does not know:
//! `tests/least.rs` holds how far it is off.

use crate::ir::{Module, Node, NodeId, reached};
use crate::options::Language;
use crate::passes::bytecode::{Bytecode, Width};
use crate::passes::cases::{Cases, Kind};
use crate::passes::functions;
use crate::passes::schedule::Schedule;
use crate::program::Shape;
use tpg_graph::{MathsProvider, ScalarType};
use tpg_runtime::ops::Instruction;

/// The number of what code is made of.
const PARTS: usize = 18;

/// The most edges of a graph that is not certain to be least as tables.
const FEW_EDGES: usize = 64;

/// Of several shapes of a module, the one whose code is least; the first is as tables.
pub(crate) fn least(module: &Module<'_>, language: Language, shapes: [Shape; 4]) -> Shape {
    let flash = |shape: &Shape| {
        let weights = weights(language, module.graph.scalar(), shape);
        weights.map_or(f64::INFINITY, |weights| weights.iter().zip(parts(module, shape)).map(|(w, n)| w * n).sum())
    };
    let sizes = shapes.each_ref().map(flash);
    let least = (0..shapes.len()).fold(0, |least, place| if sizes[place] < sizes[least] { place } else { least });
    let mut shapes = Vec::from(shapes);
    shapes.swap_remove(least)
}

/// Tests for a graph so small that other shapes than tables may be less.
pub(crate) fn is_small(module: &Module<'_>) -> bool {
    module.teams.iter().map(|team| team.edges.len()).sum::<usize>() <= FEW_EDGES
}

/// Bytes of flash for each part.
fn weights(language: Language, scalar: ScalarType, shape: &Shape) -> Option<[f64; PARTS]> {
    // Guards of expensive bids take so much that tables are less.
    let has_guards =
        matches!(shape, Shape::Fast { schedule, .. } if schedule.plans.iter().any(|plan| !plan.lazy.is_empty()));
    if has_guards {
        return None;
    }
    Some(match (language, scalar, shape) {
        (Language::C, ScalarType::F32, Shape::Fast { .. }) => [
            23.0, -58.0, 21.0, 22.0, 0.0, 32.0, 2.0, 19.0, 18.0, -5.0, 398.0, -30.0, -16.0, -30.0, -16.0, 7.0, 39.0,
            7.0,
        ],
        (Language::C, ScalarType::F32, Shape::Balanced(_)) => [
            17.0, 15.0, -5.0, 21.0, 41.0, 49.0, 4.0, 4.0, 5.0, 11.0, 383.0, 207.0, 297.0, 23.0, -46.0, 10.0, 30.0, 14.0,
        ],
        (Language::C, ScalarType::F32, Shape::Small(_)) => {
            [143.0, 3.0, 14.0, -5.0, 0.0, 0.0, -5.0, -5.0, 6.0, 10.0, 394.0, 241.0, 231.0, 0.0, 0.0, -1.0, 89.0, -2.0]
        }
        (Language::C, ScalarType::F32, Shape::ConstantTime(_)) => {
            [-3.0, 1.0, 1.0, 55.0, -13.0, -1.0, 14.0, 48.0, 43.0, -26.0, 397.0, 221.0, 108.0, 0.0, 0.0, 8.0, 25.0, 18.0]
        }
        (Language::C, ScalarType::F64, Shape::Fast { .. }) => {
            [-6.0, -97.0, 25.0, 33.0, 0.0, 69.0, 15.0, 53.0, 0.0, -37.0, 0.0, 0.0, 0.0, 0.0, 0.0, 20.0, -53.0, 42.0]
        }
        (Language::C, ScalarType::F64, Shape::Balanced(_)) => [
            21.0, 51.0, -18.0, 32.0, 99.0, -6.0, 10.0, 25.0, -27.0, -22.0, 1063.0, 707.0, 657.0, -93.0, 109.0, -7.0,
            31.0, 18.0,
        ],
        (Language::C, ScalarType::F64, Shape::Small(_)) => [
            165.0, 2.0, 25.0, -2.0, 0.0, 0.0, -4.0, -6.0, -9.0, 12.0, 1054.0, 612.0, 584.0, 0.0, 0.0, -1.0, 117.0, -1.0,
        ],
        (Language::C, ScalarType::F64, Shape::ConstantTime(_)) => [
            -69.0, -9.0, 51.0, 91.0, -12.0, 78.0, 23.0, 48.0, -4.0, 4.0, 1036.0, 632.0, 581.0, 0.0, 0.0, 40.0, 102.0,
            -49.0,
        ],
        (Language::Rust, ScalarType::F32, Shape::Fast { .. }) => {
            [6.0, -52.0, 19.0, 29.0, 0.0, 27.0, 9.0, 24.0, 90.0, -12.0, 0.0, 443.0, -91.0, 0.0, 0.0, 3.0, 24.0, 10.0]
        }
        (Language::Rust, ScalarType::F32, Shape::Balanced(_)) => {
            [107.0, 33.0, 0.0, 11.0, 15.0, 120.0, 5.0, 7.0, 62.0, 2.0, 555.0, 233.0, 200.0, 0.0, 0.0, 6.0, 46.0, 4.0]
        }
        (Language::Rust, ScalarType::F32, Shape::Small(_)) => {
            [185.0, 3.0, 67.0, 2.0, 0.0, 0.0, -10.0, -35.0, 16.0, 8.0, 420.0, 220.0, 175.0, 0.0, 0.0, 3.0, 84.0, -13.0]
        }
        (Language::Rust, ScalarType::F32, Shape::ConstantTime(_)) => [
            -32.0, 2.0, 27.0, 31.0, 17.0, 0.0, 10.0, 33.0, 39.0, -18.0, 513.0, 256.0, 229.0, 0.0, 0.0, 10.0, 71.0, 11.0,
        ],
        (Language::Rust, ScalarType::F64, Shape::Fast { .. }) => {
            [-15.0, -58.0, 36.0, 45.0, 0.0, 25.0, 8.0, 47.0, 136.0, -48.0, 155.0, 0.0, 0.0, 0.0, 0.0, 13.0, 95.0, 12.0]
        }
        (Language::Rust, ScalarType::F64, Shape::Balanced(_)) => {
            [218.0, 26.0, -6.0, 18.0, 46.0, 136.0, 19.0, 30.0, 15.0, 18.0, 13.0, -9.0, 70.0, 0.0, 0.0, 5.0, 72.0, 10.0]
        }
        (Language::Rust, ScalarType::F64, Shape::Small(_)) => {
            [162.0, 2.0, 88.0, 3.0, 0.0, 0.0, -7.0, -20.0, -36.0, 15.0, -12.0, 4.0, 38.0, 0.0, 0.0, -8.0, 92.0, 11.0]
        }
        (Language::Rust, ScalarType::F64, Shape::ConstantTime(_)) => [
            5.0, -60.0, 34.0, 94.0, 45.0, -10.0, 40.0, 116.0, 95.0, 28.0, -85.0, -17.0, 26.0, 0.0, 0.0, 11.0, 201.0,
            16.0,
        ],
        (_, _, Shape::Formula(_) | Shape::Gegelati) => return None,
    })
}

/// Counts of the parts of code.
fn parts(module: &Module<'_>, shape: &Shape) -> [f64; PARTS] {
    let nodes = match shape {
        Shape::Fast { schedule, .. } => &schedule.nodes,
        Shape::Balanced(cases) => &cases.nodes,
        _ => &module.nodes,
    };
    let count = |of: &dyn Fn(&Node) -> bool| nodes.iter().filter(|node| of(node)).count() as f64;
    let operations = |of: &'static [Instruction]| {
        count(&move |node: &Node| matches!(node, Node::Operation(instruction, _) if of.contains(instruction)))
    };
    let uses = |of: &'static [Instruction]| operations(of).min(1.0);
    let own = |of: &'static [Instruction]| if module.graph.maths() == MathsProvider::Own { uses(of) } else { 0.0 };
    let leaf_values = reached(&module.leaves).map(|(_, leaf)| leaf.values.len()).sum::<usize>();
    let [choices, ways, eager, lazy, more] = deciding(module, shape);
    [
        1.0,
        choices,
        ways,
        eager,
        lazy,
        more,
        operations(&[Instruction::Sub, Instruction::Add, Instruction::Mul, Instruction::Div, Instruction::Abs]),
        operations(&[Instruction::NegateIfLess, Instruction::Min, Instruction::Max, Instruction::Gate]),
        operations(&[
            Instruction::Sin,
            Instruction::Cos,
            Instruction::Tan,
            Instruction::Ln,
            Instruction::Exp,
            Instruction::Fmod,
        ]),
        uses(&[Instruction::NegateIfLess]) + uses(&[Instruction::Min]) + uses(&[Instruction::Max]),
        own(&[Instruction::Sin, Instruction::Cos]),
        own(&[Instruction::Ln]),
        own(&[Instruction::Exp]),
        count(&|node| matches!(node, Node::Upper(Instruction::Ln, _))).min(1.0),
        count(&|node| matches!(node, Node::Upper(Instruction::Exp, _))).min(1.0),
        count(&|node| node.as_constant().is_some()),
        module.graph.outputs().len() as f64,
        leaf_values as f64,
    ]
}

/// The parts that decide, in the terms of each shape: of native teams their number, their ways, their cheap bids, the others, and the bids
/// of 0.
fn deciding(module: &Module<'_>, shape: &Shape) -> [f64; 5] {
    let edges = module.teams.iter().map(|team| team.edges.len()).sum::<usize>();
    let counts = match shape {
        Shape::Fast { schedule: Schedule { plans, nodes, .. }, .. } => {
            let deciding = || plans.iter().filter(|plan| plan.destinations().len() > 1);
            let is_zero = |id: NodeId| nodes[id.index()].as_constant() == Some(0.0);
            let is_constant = |id: NodeId| nodes[id.index()].as_constant().is_some();
            [
                deciding().count(),
                deciding().map(|plan| plan.destinations().len()).sum(),
                deciding()
                    .flat_map(|plan| plan.eager.iter().chain(&plan.eager_before))
                    .filter(|bid| !is_constant(bid.value))
                    .count(),
                deciding().map(|plan| plan.lazy.len()).sum(),
                deciding().flat_map(|plan| plan.eager.iter()).filter(|bid| is_zero(bid.value)).count(),
            ]
        }
        Shape::Balanced(Cases { bids, places, .. }) => {
            let plain = bids.iter().filter(|case| case.kind == Kind::Plain).count();
            [module.teams.len(), edges, plain, bids.len() - plain, usize::from(!places.is_empty())]
        }
        Shape::Small(code) => {
            [table_bytes(code, module.graph.scalar()), code.used.len(), code.programs.len() - 1, 0, 0]
        }
        Shape::ConstantTime(functions) => {
            let challenges = edges - module.teams.len();
            let distinct = functions.iter().map(|function| function.bids.len()).sum();
            let missing = functions::of_leaves(module, functions).len();
            [module.teams.len(), usize::from(module.teams.len() == 1), challenges, distinct, missing]
        }
        Shape::Formula(_) | Shape::Gegelati => [0; 5],
    };
    counts.map(|count| count as f64)
}

fn table_bytes(code: &Bytecode, scalar: ScalarType) -> usize {
    let tables = [&code.code, &code.programs, &code.bidders, &code.targets, &code.teams, &code.leaves];
    let bytes = |table: &Vec<u64>| (Width::of(table).bits() / 8) as usize * table.len();
    let scalar = if scalar == ScalarType::F32 { 4 } else { 8 };
    tables.into_iter().map(bytes).sum::<usize>() + scalar * code.constants.len()
}
