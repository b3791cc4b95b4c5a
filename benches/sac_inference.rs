//! Time of one inference of an actor, batch 1, compared with PyTorch on the same core in the same run.
//!
//! `cargo bench -p tpg-benches --bench sac_inference`. See `pytorch/mod.rs` for how PyTorch is found. This project's
//! code and PyTorch take turns; a figure is the median of many bursts of about half a millisecond, which a busy machine
//! rarely interrupts.
//!
//! The network alone is timed, from its inputs to its preferences, and for the shipped one also the step before it: the
//! features of an observation.

mod pytorch;

use std::hint::black_box;
use std::time::Instant;
use tpg_arm::frame::Frame;
use tpg_arm::observation::Observation;
use tpg_arm::sac::fixed::{FixedDecision, quantise};
use tpg_arm::sac::packed::{Model, PackedPolicy};
use tpg_arm::sac::{FEATURES, features};
use tpg_arm::{Arm, JOINTS, Pose, WIDOWX};
use tpg_engine::random::{Purpose, Stream};
use tpg_generated::widowx_sac;
use tpg_nn::{Mlp, Shape, Tape};
use tpg_runtime::net::{self, Kind, LayerRows, Rescale, Weights};
use tpg_runtime::policy::Policy as _;

const ARM: Arm<f32> = WIDOWX.to_f32();
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

/// Packs a network of arbitrary numbers: its time does not depend on them.
fn model(units: usize) -> Vec<u32> {
    let meaning = FixedDecision::from_flags(0).meaning();
    let sizes = [(FEATURES, units), (units, units), (units, JOINTS)];
    let weights = [1i8, -77, 3, 120].repeat(units * units.max(FEATURES) / 4);
    let (bias, rescale) =
        (vec![100; units.max(JOINTS)], vec![Rescale { factor: 20_000, shift: 24 }; units.max(JOINTS)]);
    let rows = sizes.map(|(inputs, outputs)| LayerRows {
        inputs,
        kind: Kind::W8A16,
        weights: Weights::I8(&weights[..inputs * outputs]),
        bias: &bias[..outputs],
        rescale: &rescale[..outputs],
    });
    let mut words = vec![0; net::words(&sizes.map(|(inputs, outputs)| (inputs, outputs, Kind::W8A16)), &meaning)];
    assert!(net::pack(&rows, &meaning, &mut words), "no accumulator overflows");
    words
}

/// Times a network as stored in flash, with the kernels of this machine.
fn integers(words: &[u32]) -> f64 {
    let model = Model::parse(words).expect("what was packed");
    let mut scratch = vec![0; model.scratch()];
    let input: [i16; FEATURES] = std::array::from_fn(|i| i as i16 * 97 - 1500);
    nanoseconds(|| {
        black_box(model.preferences(black_box(&input), &mut scratch));
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
    let form = tpg_kernels::form();
    for units in [256, 16] {
        println!("integers, 38-{units}-{units}-4, {form}: {:.0}", integers(&model(units)));
    }
    println!("integers, 38-64-64-4 (widowx-sac), {form}: {:.0}", integers(&widowx_sac::MODEL));

    let seen = Observation::at(&ARM, Pose([1500, 2100, 1900, 2300]), [120.0, 260.0, 140.0]);
    let input = nanoseconds(|| {
        black_box(quantise(&features(&Frame::new(&ARM, black_box(&seen)))));
    });
    println!("the features of an observation, as integers: {input:.0}");
    let model = Model::parse(&widowx_sac::MODEL).expect("a committed model");
    let policy = PackedPolicy::<{ widowx_sac::SCRATCH }>::new(&ARM, model).expect("its own scratch memory");
    let decision = nanoseconds(|| {
        black_box(policy.decide(black_box(&seen)));
    });
    println!("widowx-sac from the observation to the move: {decision:.0}");
}
