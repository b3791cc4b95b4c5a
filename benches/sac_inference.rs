//! Time of one inference of an actor, batch 1, compared with PyTorch on the same core in the same run.
//!
//! `cargo bench -p tpg-benches --bench sac_inference`. See `pytorch/mod.rs` for how PyTorch is found. This project's
//! code and PyTorch take turns; a figure is the median of many bursts of about half a millisecond, which a busy machine
//! rarely interrupts.
//!
//! The network in floating point is timed, from its inputs to its preferences; `tpg-paper table2` times the shipped one in integers.

mod pytorch;

use std::hint::black_box;
use std::time::Instant;
use tpg_engine::random::{Purpose, Stream};
use tpg_nn::{Mlp, Shape, Tape};

const BURSTS: usize = 401;
const TURNS: usize = 3;

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

fn float(inputs: usize, units: usize) -> f64 {
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

fn main() {
    // `cargo test --benches` only needs to check that it runs.
    if std::env::args().any(|argument| argument == "--test") {
        return;
    }
    println!("one inference, batch 1; ns, median of {BURSTS} bursts");
    let python = pytorch::python();
    for (inputs, units) in [(13, 256), (38, 256), (38, 64), (38, 16)] {
        let (mut ours, mut eager, mut script) = (Vec::new(), Vec::new(), Vec::new());
        for _ in 0..TURNS {
            ours.push(float(inputs, units));
            if let Some(python) = &python {
                let sizes = [inputs, units].map(|size| size.to_string());
                let numbers = pytorch::numbers(python, "sac_inference.py", &sizes);
                eager.push(numbers[0]);
                script.push(numbers[1]);
            }
        }
        let ours = pytorch::median(ours);
        print!("f32, {inputs}-{units}-{units}-4: {ours:.0}");
        if !eager.is_empty() {
            let [eager, script] = [eager, script].map(pytorch::median);
            let [by_eager, by_script] = [eager / ours, script / ours];
            print!("; PyTorch eager {eager:.0}, {by_eager:.1} times; TorchScript {script:.0}, {by_script:.1} times");
        }
        println!();
    }
}
