//! Environment steps per CPU-second, and the effect of each optimisation of the engine.
//!
//! `cargo bench -p tpg-benches --bench throughput -- [--quick] [--once] [--fs] [GRAPH]...`
//!
//! Without arguments: the first generation of the paper's problem. A graph (`graph.json`, or a `.dot` of the paper's artifact):
//! 1,000 episodes, random start, or fixed start after `--fs`. Times are CPU times of this process, the minimum of three passes;
//! `--once` makes one pass, `--quick` measures only the first row.

use std::ops::ControlFlow;
use std::path::Path;
use tpg_arm::WIDOWX;
use tpg_benches::cpu_seconds;
use tpg_engine::{EngineOptions, Evaluator, LocalThreads, PolicyGraph, Work};
use tpg_graph::import::{self, Profile};
use tpg_graph::{Graph, MathsProvider, ScalarType};
use tpg_problems::arm::targets::{Set, Start, tasks};
use tpg_problems::arm::{ArmEnvironment, ArmProblem, ArmScalar, ArmTask};
use tpg_problems::{Problem, ProblemSettings};
use tpg_runtime::ops::{Maths, Own, System};
use tpg_train::{Config, Configuration as _, RunOptions, train};

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
        population(extent)?;
    }
    for name in &names {
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
    Ok(())
}

/// Measures the first generation of a run.
fn population(extent: Extent) -> Result<(), Box<dyn std::error::Error>> {
    let mut config = Config::preset("paper-fs")?;
    config.learning.nb_generations = 1;
    config.selection.validation_episodes = 1;
    let problem = Problem::from_toml("paper-fs", &config.to_toml())?;
    let ProblemSettings::Arm(arm) = problem.settings else { return Err("another problem than the arm".into()) };
    let environment = arm.environment::<f32>(Start::Fs);
    println!("paper-fs, the first generation");
    table(&environment, extent, |evaluator: &LocalThreads<'_, f32, Own, _>, environment| {
        let folder = tempfile::tempdir()?;
        let options = RunOptions { folder: folder.path().to_owned(), ..RunOptions::default() };
        train::<f32, _, _>(&config, 1, environment, evaluator, &options, |_| ControlFlow::Continue(()))?;
        Ok(())
    })
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
    let work = Work { tasks, policies: vec![PolicyGraph::from(graph)] };
    println!("{name}: {} episodes", work.tasks.len());
    table(&environment, extent, |evaluator: &LocalThreads<'_, S, M, _>, _| {
        evaluator.evaluate(&work)?;
        Ok(())
    })
}

/// Prints a row for every set of options.
fn table<S: ArmScalar, M: Maths<S>>(
    environment: &ArmEnvironment<S>,
    extent: Extent,
    job: impl Fn(&LocalThreads<'_, S, M, ArmEnvironment<S>>, &ArmEnvironment<S>) -> Result<(), Box<dyn std::error::Error>>,
) -> Result<(), Box<dyn std::error::Error>> {
    println!("  {:44} {:>9} {:>9} {:>12} {:>8}", "", "CPU s", "wall s", "M steps/CPU s", "");
    let all = EngineOptions::default();
    let rows = [
        ("everything on, 112 lanes, 1 thread", environment, all, 1),
        ("2 threads", environment, all, 2),
        ("64 lanes", environment, EngineOptions { lanes: 64, ..all }, 1),
        ("16 lanes", environment, EngineOptions { lanes: 16, ..all }, 1),
        ("1 lane", environment, EngineOptions { lanes: 1, ..all }, 1),
        ("every bid computed", environment, EngineOptions { lazy: false, ..all }, 1),
    ];
    let mut first = None;
    for (name, environment, options, threads) in rows.into_iter().take(extent.rows) {
        let (mut least, mut wall, mut steps) = (f64::INFINITY, f64::INFINITY, 0);
        for _ in 0..extent.passes {
            let evaluator = LocalThreads::<S, M, _>::new(environment, options, threads)?;
            let (began, before) = (std::time::Instant::now(), cpu_seconds());
            job(&evaluator, environment)?;
            least = least.min(cpu_seconds() - before);
            wall = wall.min(began.elapsed().as_secs_f64());
            steps = evaluator.steps();
        }
        let all = *first.get_or_insert(least);
        let rate = steps as f64 / least.max(0.01) / 1e6;
        println!("  {name:44} {least:9.2} {wall:9.2} {rate:12.2} {:7.2}×", least / all.max(0.01));
    }
    Ok(())
}
