//! An estimate of generated C's flash on a Cortex-M4F, for machines without its compiler.

use crate::cost::Costs;
use crate::emit::team::compares_in_functions;
use crate::ir::Node;
use crate::program::Program;
use crate::shape::Shape;
use std::collections::BTreeSet;
use tpg_graph::{MathsProvider, ScalarType};
use tpg_runtime::ops::Instruction;

/// Bytes for each of what code is made of, fitted to what `arm-none-eabi-gcc` 12.2 made of random graphs.
struct Weights {
    always: u64,
    team: u64,
    edge: u64,
    /// For each occurrence of an operation in the text.
    operation: u64,
    /// Own sine, cosine and tangent.
    circular: u64,
    /// Own logarithm and exponential.
    exponential: u64,
}

const fn weights([always, team, edge, operation, circular, exponential]: [u64; 6]) -> Weights {
    Weights { always, team, edge, operation, circular, exponential }
}

/// Bytes of flash of a program in C. Of policies of eight teams or more, the compiler's number lies within a factor of 1.6.
pub fn flash(program: &Program<'_>) -> u64 {
    let (module, graph) = (&program.module, program.graph());
    let used: BTreeSet<Instruction> = (module.nodes.iter())
        .filter_map(|node| if let Node::Operation(instruction, _) = *node { Some(instruction) } else { None })
        .collect();
    let Weights { always, team, edge, operation, circular, exponential } = match (graph.scalar(), &program.shape) {
        (ScalarType::F32, Shape::Gegelati) => weights([0, 31, 4, 10, 651, 0]),
        (ScalarType::F64, Shape::Gegelati) => weights([4, 11, 10, 12, 1122, 803]),
        (ScalarType::F32, Shape::Fast { .. } | Shape::Formula(_)) | (_, Shape::Integers(_)) => {
            weights([0, 80, 2, 32, 873, 0])
        }
        (ScalarType::F64, Shape::Fast { .. }) if compares_in_functions(module) => weights([500, 10, 18, 20, 965, 638]),
        (ScalarType::F64, Shape::Fast { .. } | Shape::Formula(_)) => weights([0, 31, 66, 19, 965, 638]),
        (ScalarType::F32, Shape::Balanced(_)) => weights([150, 2, 3, 16, 650, 400]),
        (ScalarType::F64, Shape::Balanced(_)) => weights([200, 2, 3, 12, 1068, 831]),
        (ScalarType::F32, Shape::Small(_)) => weights([113, 0, 0, 23, 445, 359]),
        (ScalarType::F64, Shape::Small(_)) => weights([194, 0, 0, 23, 1068, 831]),
        (ScalarType::F32, Shape::ConstantTime(_)) => weights([21, 28, 7, 33, 136, 224]),
        (ScalarType::F64, Shape::ConstantTime(_)) => weights([283, 27, 14, 28, 942, 846]),
    };
    let own = |any: &[Instruction]| {
        u64::from(graph.maths() == MathsProvider::Own && any.iter().any(|instruction| used.contains(instruction)))
    };
    let remainder = match (graph.scalar(), &program.shape) {
        (ScalarType::F32, Shape::ConstantTime(_)) => 290,
        (ScalarType::F32, _) => 150,
        (ScalarType::F64, _) => 250,
    };
    let (operations, tables) = match &program.shape {
        // Each operation occurs once in the text; the tables come on top.
        Shape::Small(code) => (used.len() as u64, code.bytes(graph.scalar())),
        Shape::Balanced(cases) => {
            (cases.bids.iter().map(|&case| cases.operations(case).concat().len() as u64).sum(), 0)
        }
        _ => (Costs::of(program).written(), 0),
    };
    always
        + team * module.teams.len() as u64
        + edge * module.edges() as u64
        + operation * operations
        + circular * own(&[Instruction::Sin, Instruction::Cos, Instruction::Tan])
        + exponential * own(&[Instruction::Ln, Instruction::Exp, Instruction::Atan, Instruction::Tanh])
        + remainder * u64::from(used.contains(&Instruction::Fmod))
        + tables
}

#[cfg(test)]
mod tests {
    use super::flash;
    use crate::emit::Code;
    use crate::options::{Language, Options, Profile, Style};
    use crate::program::compile;
    use crate::size::{Target, build_c, measure};
    use tpg_graph::sample::{self, Shape};
    use tpg_graph::{MathsProvider, ScalarType};

    #[test]
    fn an_estimate_is_near_what_the_compiler_makes() {
        if !tpg_testing::tool("arm-none-eabi-gcc", "gcc-arm-none-eabi", "estimates of flash against real sizes") {
            return;
        }
        let options = Options::new("arm".parse().expect("a prefix"));
        let gegelati = Options { style: Style::Gegelati, ..options.clone() };
        let profiles = Profile::ALL.map(|profile| Options { profile: Some(profile), ..options.clone() });
        let mut compared = 0;
        for seed in 1000..1012_u64 {
            let scalar = if seed % 2 == 0 { ScalarType::F32 } else { ScalarType::F64 };
            let maths = if seed % 4 < 2 { MathsProvider::Own } else { MathsProvider::System };
            let teams = 10 + (seed % 40) as usize;
            let graph = sample::graph(&Shape { scalar, maths, teams, ..Shape::default() }, seed);
            for options in profiles.iter().chain([&gegelati]) {
                let code = Code::of(compile(&graph, options, Language::C));
                if code.program.module.teams.len() < 8 {
                    continue; // most of it was found to be idle
                }
                compared += 1;
                let built = build_c(&code, Target::M4f).expect("it compiles");
                let real = measure(&built.object).expect("an object file").flash() as f64;
                let ratio = flash(&code.program) as f64 / real;
                assert!((0.625..1.6).contains(&ratio), "graph {seed}: {ratio} of {real} bytes, {options:?}");
            }
        }
        assert!(compared >= 30, "{compared} comparisons");
    }
}
