//! Networks in floating point beside PyTorch, on the same core in the same run: one inference of an actor, batch 1, and the CPU time
//! of one complete update of the soft actor-critic, batch 256.
//!
//! `cargo bench -p tpg-benches --bench networks`. See `pytorch/mod.rs` for how PyTorch is found. This project's code and
//! PyTorch take turns, so that other load on the machine affects both alike; a figure is the median of the turns, and an inference's
//! that of many bursts of about half a millisecond, which a busy machine rarely interrupts.
//!
//! `tpg-paper table2` times the shipped network in integers.

mod pytorch;

use std::hint::black_box;
use std::time::Instant;
use tpg_benches::cpu_seconds;
use tpg_engine::random::{Purpose, Stream};
use tpg_nn::{Agent, Experience, Gaussian, Mlp, Rates, Shape, Tape};

const BURSTS: usize = 401;
const TURNS: usize = 3;
/// The arm's: 38 features, four motors.
const INPUTS: usize = 38;
const ACTIONS: usize = 4;
const UPDATES: u32 = 300;

/// Returns the median time of one call over several bursts, in ns.
fn nanoseconds(mut call: impl FnMut()) -> f64 {
    let mut burst = |repeats: u32| {
        let began = Instant::now();
        for _ in 0..repeats {
            call();
        }
        began.elapsed().as_secs_f64() * 1e9 / f64::from(repeats)
    };
    let one = (0..9).map(|_| burst(100)).fold(f64::MAX, f64::min);
    let repeats = (5e5 / one).clamp(1.0, 1e6) as u32;
    pytorch::median((0..BURSTS).map(|_| burst(repeats)).collect())
}

/// Returns the time of one inference, from inputs to preferences, ns.
fn inference(inputs: usize, units: usize) -> f64 {
    let shape = Shape { inputs, hidden: vec![units; 2], outputs: 4 };
    let mut random = Stream::new(1, 0, Purpose::Test, 0);
    let network = Mlp::random(shape.clone(), || random.unit());
    let mut tape = Tape::new(&shape, 1);
    random.normals(tape.input_mut());
    nanoseconds(|| {
        black_box(tape.input_mut());
        network.forward(&mut tape);
        black_box(tape.output());
    })
}

/// Returns the CPU time of one update, ms.
fn update(actor: usize, critic: usize) -> f64 {
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
    let (noise, next_noise) = (draw(ACTIONS * batch), draw(ACTIONS * batch));
    let mut experience = Experience { states, actions, rewards, discounts, next, next_noise, noise };
    let rates = Rates { learning: 5e-4, temperature: 1.5e-3, follow: 0.005, target_entropy: -1.0 };
    let mut run = |updates: u32| {
        for _ in 0..updates {
            // Drawing noise is part of an update.
            random.normals(&mut experience.noise);
            random.normals(&mut experience.next_noise);
            agent.update(&mut space, &experience, &rates);
        }
    };
    run(UPDATES / 10);
    let began = cpu_seconds();
    run(UPDATES);
    (cpu_seconds() - began) * 1e3 / f64::from(UPDATES)
}

/// Measures in turns, and describes both: the medians of this project's and of what PyTorch's script prints, under these names.
fn compared(python: Option<&str>, script: &str, sizes: [usize; 2], names: &[&str], ours: impl Fn() -> f64) -> String {
    let (mut own, mut theirs) = (Vec::new(), Vec::new());
    for _ in 0..TURNS {
        own.push(ours());
        theirs.extend(python.map(|python| pytorch::numbers(python, script, &sizes.map(|size| size.to_string()))));
    }
    let own = pytorch::median(own);
    let other = |(place, name): (usize, &&str)| {
        let median = pytorch::median(theirs.iter().map(|numbers| numbers[place]).collect());
        format!("; {name} {median:.2}, {:.1} times", median / own)
    };
    let others = if theirs.is_empty() { &[][..] } else { names };
    format!("{own:.2}") + &others.iter().enumerate().map(other).collect::<String>()
}

fn main() {
    // `cargo test --benches` only needs to check that it runs.
    if std::env::args().any(|argument| argument == "--test") {
        return;
    }
    let python = pytorch::python();
    let python = python.as_deref();
    println!("one inference, batch 1; ns, median of {BURSTS} bursts");
    for (inputs, units) in [(13, 256), (38, 256), (38, 64), (38, 16)] {
        let names = ["PyTorch eager", "TorchScript"];
        let line = compared(python, "sac_inference.py", [inputs, units], &names, || inference(inputs, units));
        println!("f32, {inputs}-{units}-{units}-4: {line}");
    }
    println!("one update, batch 256, {INPUTS} inputs; ms of CPU time on one thread, median of {TURNS} turns");
    for (actor, critic) in [(256, 256), (64, 128), (64, 64), (16, 64)] {
        let line = compared(python, "sac_update.py", [actor, critic], &["PyTorch"], || update(actor, critic));
        println!("actor {actor}-{actor} critics {critic}-{critic}: {line}");
    }
}
