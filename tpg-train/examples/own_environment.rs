//! A user-defined problem, from training to C: a cart on rails that must stop in the middle.
//!
//! `cargo run --release -p tpg-train --example own_environment -- RUN`, which takes seconds, writes `RUN/graph.json` and
//! `RUN/report.html`; `cargo run --release -p tpg-codegen -- RUN/graph.json --lang c --prefix cart -o RUN` writes the C.
use std::ops::ControlFlow;
use std::path::Path;
use tpg_engine::random::Stream;
use tpg_engine::{Act, ActionSpace, Choices, End, Environment, LocalThreads, SourceSet, Step, TaskSet};
use tpg_graph::{Graph, SourceDocument};
use tpg_runtime::ops::Own;
use tpg_train::{Acting, Config, Episodes, Goal, OwnProblem, ReportArgs, RunOptions, evaluate, report_with};

pub(crate) struct Cart;

impl Environment<f32> for Cart {
    type Task = f32; // starting position, m
    type Episode = [f32; 2]; // position and velocity

    fn sources(&self) -> Vec<SourceDocument> {
        vec![SourceDocument::new("cart", "m, m/s", vec![[-20.0, 20.0]; 2])]
    }
    fn actions(&self) -> ActionSpace {
        ActionSpace::discrete(["push", "pull"])
    }
    fn time_limit(&self) -> u32 {
        100
    }
    fn draw(&self, random: &mut Stream) -> f32 {
        (4.0 * random.unit() - 2.0) as f32
    }
    fn start(&self, &position: &f32) -> [f32; 2] {
        [position, 0.0]
    }
    fn observe(&self, cart: &mut [f32; 2], _wanted: SourceSet, state: &mut [f32]) {
        state.copy_from_slice(cart);
    }
    fn step(&self, [position, velocity]: &mut [f32; 2], act: Act<'_, f32>) -> Step {
        *velocity += if act.choice() == 0 { 0.1 } else { -0.1 };
        *position += 0.1 * *velocity;
        Step::reward(-f64::from(position.abs() + velocity.abs()))
    }
    fn timeout(&self, [position, velocity]: &[f32; 2]) -> End {
        End { success: Some(position.abs() + velocity.abs() < 0.2), ..End::new(1) }
    }
}

pub(crate) fn train(folder: &Path) -> Result<(), Box<dyn std::error::Error>> {
    let config = Config::default();
    let evaluator = LocalThreads::<f32, Own, Cart>::new(&Cart, 0)?;
    let goal = Goal { target: Some(-50.0), max_steps: None };
    let options = RunOptions { folder: folder.to_owned(), goal, ..RunOptions::default() };
    tpg_train::train(&config, 1, &Cart, &evaluator, &options, |_progress| ControlFlow::Continue(()))?;

    let file = folder.join("graph.json").display().to_string();
    let graph = (file.clone(), Graph::from_json(&file, &std::fs::read_to_string(&file)?)?);
    let problem = OwnProblem::<f32, Own, _>::new("cart", Choices::new(&Cart, None)?);
    let episodes = Episodes { set: TaskSet::Test, count: 1000, seed: 1, file: None };
    print!("{}", evaluate(&problem, &file, Acting::Graph(&graph), episodes)?.to_table());
    let args = ReportArgs { runs: vec![folder.to_owned()], out: folder.join("report.html"), episodes: 1000, seed: 1 };
    report_with(&args, Some(&problem))?;
    Ok(())
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    train(std::env::args_os().nth(1).ok_or("usage: own_environment RUN")?.as_ref())
}
