//! A problem of one's own, from training to C: a cart on rails that must stop at the middle.
//!
//! `cargo run --release -p tpg-train --example own_environment -- RUN`, which takes seconds, and then
//! `cargo run --release -p tpg-codegen -- RUN/graph.json --lang c --prefix cart -o RUN`.
use tpg_graph::{ActionDocument, SourceDocument};
use tpg_runtime::{ops::Own, policy::ActionId};
use tpg_train::engine::{Ending, Environment, LocalThreads, Options, SourceSet};
use tpg_train::evolution::{config::EnvironmentName, presets::Preset, run::RunOptions, run::run};
use tpg_train::random::Stream;

pub(crate) struct Cart;

impl Environment<f32> for Cart {
    type Task = f32; // where the cart starts
    type Episode = [f32; 3]; // position, velocity, actions

    fn sources(&self) -> Vec<SourceDocument> {
        vec![SourceDocument { name: "cart".into(), length: 2, unit: "m, m/s".into(), ranges: vec![[-20.0, 20.0]; 2] }]
    }
    fn actions(&self) -> Vec<ActionDocument> {
        (0..).zip(["push", "pull"]).map(|(id, name)| ActionDocument { id, name: name.into(), effect: None }).collect()
    }
    fn outcomes(&self) -> &'static [&'static str] {
        &["stopped", "missed"]
    }
    fn time_limit(&self) -> u32 {
        100
    }
    fn draw(&self, stream: &mut Stream) -> f32 {
        (4.0 * stream.unit() - 2.0) as f32
    }
    fn start(&self, &position: &f32) -> [f32; 3] {
        [position, 0.0, 0.0]
    }
    fn observe(&self, cart: &mut [f32; 3], _wanted: SourceSet, state: &mut [f32]) {
        state.copy_from_slice(&cart[..2]);
    }
    fn step(&self, [position, velocity, actions]: &mut [f32; 3], action: ActionId) -> Option<Ending> {
        *velocity += if action == ActionId(0) { 0.1 } else { -0.1 };
        *position += 0.1 * *velocity;
        *actions += 1.0;
        let error = f64::from(position.abs() + velocity.abs());
        let (success, outcome) = (error < 0.2, u8::from(error >= 0.2));
        (*actions == 100.0).then_some(Ending { outcome, success, score: -error, error, actions: 100 })
    }
}

pub(crate) fn train(folder: std::path::PathBuf) -> Result<(), Box<dyn std::error::Error>> {
    let mut config = Preset::find("kelly").ok_or("no such preset")?.config()?;
    config.problem.environment = EnvironmentName::Own;
    (config.tpg.max_init_outgoing_edges, config.learning.nb_generations) = (2, 60);
    let evaluator = LocalThreads::<f32, Own, Cart>::new(&Cart, Options::default(), 0)?;
    let options = RunOptions { folder, ..RunOptions::default() };
    run::<f32, Own, _, _>(&config, 1, &Cart, &evaluator, &options, &false.into()).map(|_| ()).map_err(Into::into)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    train(std::env::args_os().nth(1).ok_or("usage: own_environment RUN")?.into())
}
