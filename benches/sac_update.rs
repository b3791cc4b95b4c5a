//! CPU time of one complete update of the soft actor-critic, batch 256, compared with PyTorch on the same core in the
//! same run.
//!
//! `cargo bench -p tpg-benches --bench sac_update`. See `pytorch/mod.rs` for how PyTorch is found. This project's code
//! and PyTorch take turns, so that other load on the machine affects both alike; a figure is the median of the rounds.

mod pytorch;

use tpg_benches::cpu_seconds;
use tpg_engine::random::{Purpose, Stream};
use tpg_nn::{Agent, Experience, Gaussian, Rates};

/// The arm's: 38 features, four motors.
const INPUTS: usize = 38;
const ACTIONS: usize = 4;
const SIZES: [(usize, usize); 4] = [(256, 256), (64, 128), (64, 64), (16, 64)];
const UPDATES: u32 = 300;
const ROUNDS: usize = 3;

fn milliseconds(actor: usize, critic: usize) -> f64 {
    let (inputs, batch) = (INPUTS, 256);
    let mut random = Stream::new(1, 0, Purpose::Test, 0);
    let gaussian = Gaussian { actions: ACTIONS };
    let hidden = [&[actor; 2][..], &[critic; 2]];
    let mut agent = Agent::random(inputs, hidden, gaussian, -3.0, || random.unit());
    let mut space = agent.workspace(batch);
    let mut draw = |count: usize| {
        let mut numbers = vec![0.0; count];
        random.normals(&mut numbers);
        numbers
    };
    let (states, next) = (draw(inputs * batch), draw(inputs * batch));
    let actions: Vec<f32> = draw(ACTIONS * batch).into_iter().map(f32::tanh).collect();
    let (rewards, discounts) = (draw(batch), vec![0.95; batch]);
    let (mut noise, mut next_noise) = (draw(ACTIONS * batch), draw(ACTIONS * batch));
    let rates = Rates { learning: 5e-4, temperature: 1.5e-3, follow: 0.005, target_entropy: -1.0 };
    let mut run = |updates: u32| {
        for _ in 0..updates {
            // Drawing noise is part of an update.
            random.normals(&mut noise);
            random.normals(&mut next_noise);
            let experience = Experience {
                states: &states,
                actions: &actions,
                rewards: &rewards,
                discounts: &discounts,
                next: &next,
                next_noise: &next_noise,
                noise: &noise,
            };
            agent.update(&mut space, experience, &rates);
        }
    };
    run(UPDATES / 10);
    let seconds = cpu_seconds;
    let began = seconds();
    run(UPDATES);
    (seconds() - began) * 1e3 / f64::from(UPDATES)
}

fn main() {
    // `cargo test --benches` only needs to check that it runs.
    if std::env::args().any(|argument| argument == "--test") {
        return;
    }
    println!("one update, batch 256, 38 inputs; ms of CPU time on one thread, median of {ROUNDS} rounds");
    let python = pytorch::python();
    for (actor, critic) in SIZES {
        let (mut ours, mut theirs) = (Vec::new(), Vec::new());
        for _ in 0..ROUNDS {
            ours.push(milliseconds(actor, critic));
            if let Some(python) = &python {
                let widths = [actor, critic].map(|width| width.to_string());
                theirs.extend(pytorch::numbers(python, "sac_update.py", &widths));
            }
        }
        let ours = pytorch::median(ours);
        print!("actor {actor}-{actor} critics {critic}-{critic}: {ours:.2}");
        match theirs.is_empty() {
            true => println!(),
            false => println!(
                ", PyTorch {0:.2}, {1:.1} times",
                pytorch::median(theirs.clone()),
                pytorch::median(theirs) / ours
            ),
        }
    }
}
