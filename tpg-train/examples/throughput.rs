//! Environment steps per CPU-second, and what each idea of the engine is worth.
//!
//! `cargo run --release -p tpg-train --example throughput [-- GRAPH...]`: random roots of the paper's problem, and the
//! graphs named, on 1,000 episodes of the random-start problem. One thread.

use std::time::Instant;
use tpg_codegen::graph::Graph;
use tpg_runtime::arm::WIDOWX;
use tpg_runtime::observation::Source;
use tpg_runtime::ops::Own;
use tpg_train::engine::{Environment, Lanes, Options, Plan, Policy};
use tpg_train::environments::{ArmEnvironment, ArmProblem, ArmTask};
use tpg_train::evolution::mutate_program::ProgramMutator;
use tpg_train::evolution::mutate_team::random_population;
use tpg_train::evolution::presets::Preset;
use tpg_train::evolution::vocabulary::Vocabulary;
use tpg_train::random::{Purpose, Stream};
use tpg_train::targets::{Set, Start, tasks};

const ROOTS: usize = 100;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let tasks: Vec<ArmTask> =
        tasks(&WIDOWX, 3, Set::Training, Start::Rs, 1000).into_iter().map(ArmTask::from).collect();
    let config = Preset::find("paper-rs").ok_or("no such preset")?.config()?;
    let environment = ArmEnvironment::<f32>::new(&WIDOWX, ArmProblem::new(Start::Rs, config.sources()));
    let sources = environment.sources();
    let vocabulary = Vocabulary::new(config.instructions(), 8, 0, &sources, false, config.language.scalar);
    let mutator = ProgramMutator { vocabulary: &vocabulary, parameters: &config.program, literals: &config.literals };
    let genome = random_population(&mutator, &config.tpg, 9, &mut Stream::new(1, 0, Purpose::Test, 0));
    let roots = genome.roots();
    let random: Vec<Policy> = roots.iter().take(ROOTS).map(|&root| genome.policy(root, &vocabulary)).collect();
    measure(&format!("{ROOTS} random roots, the paper's problem"), &environment, &random, &tasks[..100]);
    for path in std::env::args().skip(1) {
        let graph = Graph::from_json(&path, &std::fs::read_to_string(&path)?)?;
        let names = graph.sources().iter();
        let sources: Option<Vec<Source>> = names.map(|source| Source::from_name(&source.name)).collect();
        let problem = ArmProblem::new(Start::Rs, sources.ok_or("a source that the arm does not have")?);
        let moves: Option<Vec<_>> = graph.actions().iter().map(|action| action.moves).collect();
        let moves = moves.ok_or("an action that moves nothing")?;
        let environment = ArmEnvironment::<f32>::for_evaluation(&WIDOWX, problem, moves);
        measure(&path, &environment, &[Policy::from(&graph)], &tasks);
    }
    Ok(())
}

/// Prints a row for every set of options.
fn measure(name: &str, environment: &ArmEnvironment<f32>, policies: &[Policy], tasks: &[ArmTask]) {
    println!("{name}");
    let all = Options::default();
    for (what, options) in [
        ("everything on, 112 lanes", all),
        ("16 lanes", Options { lanes: 16, ..all }),
        ("1 lane", Options { lanes: 1, ..all }),
        ("no sharing of values", Options { share: false, ..all }),
        ("cycles noticed at the time-out only", Options { look_for_cycles: false, ..all }),
    ] {
        let mut lanes = Lanes::<f32, Own, _>::new(environment, options);
        let began = Instant::now();
        for policy in policies {
            let plan = Plan::new::<Own>(policy, &environment.sources(), options.share);
            lanes.run(&plan, tasks);
        }
        let seconds = began.elapsed().as_secs_f64();
        let steps = lanes.steps() as f64;
        println!("  {what:38} {:7.2} M steps/s, {:8.3} s", steps / seconds / 1e6, seconds);
    }
}
