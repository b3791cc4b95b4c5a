//! Environment steps per CPU-second, and the effect of each optimisation of the engine.
//!
//! `cargo run --release -p tpg-train --example throughput -- [--quick] [--once] [--fs] [RUN|GRAPH]...`
//!
//! Without arguments: generation 0 of the paper's problem. A run's folder: the generation after its checkpoint, exactly
//! as training would evaluate it. A graph (`graph.json`, or a `.dot` of the paper's artifact): 1,000 episodes, random
//! start, or fixed start after `--fs`. Times are CPU times of this process (Linux), the minimum of three passes;
//! `--once` makes one pass, `--quick` measures only the first row.

use std::path::Path;
use tpg_arm::WIDOWX;
use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{EngineOptions, Environment, Evaluator, LocalThreads, PolicyGraph, UnitKey, Work, WorkUnit};
use tpg_graph::import::{self, Profile};
use tpg_graph::{Graph, MathsProvider, ScalarType};
use tpg_problems::Problem;
use tpg_problems::arm::targets::{Set, Start, tasks};
use tpg_problems::arm::{ArmEnvironment, ArmProblem, ArmScalar, ArmTask};
use tpg_runtime::ops::{Maths, Own, System};
use tpg_train::evolution::checkpoint;
use tpg_train::evolution::config::EvolutionConfig;
use tpg_train::evolution::generation::{Evolution, Goal};
use tpg_train::evolution::logs::cpu_seconds;
use tpg_train::evolution::presets::Preset;
use tpg_train::evolution::stage::{Moment, Stage as _};
use tpg_train::evolution::state::State;

/// Extent of the measurement.
#[derive(Clone, Copy)]
struct Extent {
    rows: usize,
    /// Number of passes; the minimum excludes interference from other work on the machine.
    passes: usize,
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (flags, names): (Vec<String>, Vec<String>) = std::env::args().skip(1).partition(|name| name.starts_with("--"));
    let given = |name: &str| flags.iter().any(|flag| flag == name);
    let start = if given("--fs") { Start::Fs } else { Start::Rs };
    let extent =
        Extent { rows: if given("--quick") { 1 } else { usize::MAX }, passes: if given("--once") { 1 } else { 3 } };
    if names.is_empty() {
        let config = Preset::find("paper-fs").ok_or("no such preset")?.config()?;
        population("paper-fs, generation 0", &config, State::new(1, 1, 0), extent)?;
    }
    for name in &names {
        if Path::new(name).is_dir() {
            let (config, state) = checkpoint::open(Path::new(name))?;
            let title = format!("{name}, generation {}", state.generation);
            match config.language.scalar {
                ScalarType::F32 => population(&title, &config, state, extent)?,
                ScalarType::F64 => return Err("only runs in f32".into()),
            }
        } else {
            let path = Path::new(name);
            let profile = path.extension().is_some_and(|extension| extension == "dot").then_some(Profile::Ecta24);
            let graph = import::load(path, profile, None)?;
            match (graph.scalar(), graph.maths()) {
                (ScalarType::F32, MathsProvider::Own) => one::<f32, Own>(name, &graph, start, extent)?,
                (ScalarType::F32, MathsProvider::System) => one::<f32, System>(name, &graph, start, extent)?,
                (ScalarType::F64, MathsProvider::Own) => one::<f64, Own>(name, &graph, start, extent)?,
                (ScalarType::F64, MathsProvider::System) => one::<f64, System>(name, &graph, start, extent)?,
            }
        }
    }
    Ok(())
}

/// Measures the next generation of a run: its survivors' children on its episodes.
fn population(
    title: &str,
    config: &EvolutionConfig,
    mut state: State<ArmTask>,
    extent: Extent,
) -> Result<(), Box<dyn std::error::Error>> {
    let Problem::Arm(start, arm) = Problem::from_toml(title, &config.to_toml())? else {
        return Err("only runs on the arm".into());
    };
    let environment = arm.environment::<f32>(start);
    if state.generation > 0 {
        state.check(config, &environment)?;
    }
    let evaluator = LocalThreads::<f32, Own, _>::new(&environment, EngineOptions::default(), 1)?;
    let evolution = Evolution::new(config, &environment, &evaluator, state.scales.clone(), Goal::default());
    let context = evolution.context(&state);
    let moment = Moment { seed: state.seed, generation: state.generation, deme: 0 };
    let units = state.population.ask(&context, moment).into_iter().map(|candidate| WorkUnit {
        key: UnitKey { seed: state.seed, generation: state.generation, root: candidate.number },
        policy: candidate.policy,
    });
    let units = units.collect();
    let draw = |index| environment.draw(&mut Stream::new(state.seed, state.generation, Purpose::Episode, index));
    let tasks = (0..config.learning.nb_iterations_per_policy_evaluation as u64).map(draw).collect();
    table::<f32, Own>(title, &environment, &Work { tasks, units }, extent)
}

/// Measures a graph on 1,000 episodes.
fn one<S: ArmScalar, M: Maths<S>>(
    name: &str,
    graph: &Graph,
    start: Start,
    extent: Extent,
) -> Result<(), Box<dyn std::error::Error>> {
    let problem = ArmProblem::new(start, Vec::new());
    let environment = ArmEnvironment::<S>::for_graph(name, graph, &WIDOWX, problem)?;
    let tasks = tasks(&WIDOWX, 3, Set::Training, start, 1000).into_iter().map(ArmTask::from).collect();
    let unit = WorkUnit { key: UnitKey { seed: 0, generation: 0, root: 0 }, policy: PolicyGraph::from(graph) };
    table::<S, M>(name, &environment, &Work { tasks, units: vec![unit] }, extent)
}

/// Prints a row for every set of options.
fn table<S: ArmScalar, M: Maths<S>>(
    title: &str,
    environment: &ArmEnvironment<S>,
    work: &Work<ArmTask>,
    extent: Extent,
) -> Result<(), Box<dyn std::error::Error>> {
    println!("{title}: {} roots, {} episodes each", work.units.len(), work.tasks.len());
    println!("  {:44} {:>9} {:>9} {:>12} {:>8}", "", "CPU s", "wall s", "M steps/CPU s", "");
    let all = EngineOptions::default();
    let no_tables = environment.clone().without_tables();
    let no_vectors = environment.clone().without_vectors();
    let rows = [
        ("everything on, 112 lanes, 1 thread", environment, all, 1),
        ("2 threads", environment, all, 2),
        ("64 lanes", environment, EngineOptions { lanes: 64, ..all }, 1),
        ("16 lanes", environment, EngineOptions { lanes: 16, ..all }, 1),
        ("1 lane", environment, EngineOptions { lanes: 1, ..all }, 1),
        ("every bid computed", environment, EngineOptions { lazy: false, ..all }, 1),
        ("no sharing of values", environment, EngineOptions { share: false, ..all }, 1),
        ("the arm one lane at a time", &no_vectors, all, 1),
        ("sines by libm instead of tables", &no_tables, all, 1),
        ("cycles detected only at the timeout", environment, EngineOptions { look_for_cycles: false, ..all }, 1),
    ];
    let mut first = None;
    for (name, environment, options, threads) in rows.into_iter().take(extent.rows) {
        let (mut least, mut wall, mut steps) = (f64::INFINITY, f64::INFINITY, 0);
        for _ in 0..extent.passes {
            let evaluator = LocalThreads::<S, M, _>::new(environment, options, threads)?;
            let (began, before) =
                (std::time::Instant::now(), cpu_seconds().ok_or("this system does not report CPU times")?);
            evaluator.evaluate(work)?;
            least = least.min(cpu_seconds().unwrap_or(before) - before);
            wall = wall.min(began.elapsed().as_secs_f64());
            steps = evaluator.steps();
        }
        let all = *first.get_or_insert(least);
        let rate = steps as f64 / least.max(0.01) / 1e6;
        println!("  {name:44} {least:9.2} {wall:9.2} {rate:12.2} {:7.2}×", least / all.max(0.01));
    }
    Ok(())
}
