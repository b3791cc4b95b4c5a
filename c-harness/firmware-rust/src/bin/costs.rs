//! Counts instructions: each profile's Rust on the same states, networks of each kind and size, and the work around them.

#![no_std]
#![no_main]

use core::hint::black_box;
use cortex_m::singleton;
use cortex_m_rt::entry;
use tpg_arm::binding;
use tpg_arm::cycle::Brent;
use tpg_arm::episode::{Episode, ReachTask};
use tpg_arm::frame::{Clearance, Frame};
use tpg_arm::observation::{Observation, Source, Straight, TargetMemo};
use tpg_arm::sac::packed::Model;
use tpg_arm::sac::{FEATURES, features, fixed};
use tpg_arm::{Arm, Move, Pose, WIDOWX};
use tpg_firmware::record::Hash;
use tpg_firmware::{Counter, Report, Tally, exit, run};
use tpg_generated::widowx_sac;
use tpg_runtime::policy::{ActionId, Policy};

include!(concat!(env!("TPG_GENERATED"), "/problems.rs"));
include!(concat!(env!("TPG_GENERATED"), "/profiles.rs"));
include!(concat!(env!("TPG_GENERATED"), "/models.rs"));

static ARM: Arm<f32> = WIDOWX.to_f32();

static WIDE: [u32; fixed::Network::<64, 64>::WIDE_WORDS] = widowx_sac::NETWORK.pack_wide(&widowx_sac::DECISION);

/// Prints the counts under a name.
fn tell(tally: &Tally, name: &str) {
    tally.costs(Report::new("cost ").word(name).unsigned("actions", tally.actions)).print();
}

/// Every profile of one graph along the states that it sees.
fn profiles<A, B, C, D, const N: usize>(
    counter: &mut Counter,
    names: [&str; 4],
    policies: (A, B, C, D),
    sources: &[Source],
    moves: &[Move],
    problems: &[ReachTask<f32>],
) where
    A: Policy<State = [f32; N], Action = ActionId>,
    B: Policy<State = [f32; N], Action = ActionId>,
    C: Policy<State = [f32; N], Action = ActionId>,
    D: Policy<State = [f32; N], Action = ActionId>,
{
    let mut tallies = [Tally::new(); 4];
    for &problem in problems.iter().take(PARTS) {
        let mut episode = Episode::new(&ARM, problem, Brent::new());
        let memo = TargetMemo::new();
        loop {
            let mut state = [0f32; N];
            Source::fill(sources, &ARM, episode.observation(), &memo, &mut state);
            let (ActionId(fast), a) = counter.measure(|| policies.0.decide(black_box(&state)));
            let (ActionId(balanced), b) = counter.measure(|| policies.1.decide(black_box(&state)));
            let (ActionId(small), c) = counter.measure(|| policies.2.decide(black_box(&state)));
            let (ActionId(constant), d) = counter.measure(|| policies.3.decide(black_box(&state)));
            if [balanced, small, constant] != [fast; 3] {
                exit(false);
            }
            for (tally, instructions) in tallies.iter_mut().zip([a, b, c, d]) {
                tally.add(instructions);
            }
            let wanted = moves.get(usize::from(fast)).copied().unwrap_or(Move::STOP);
            if episode.advance(wanted).is_some() {
                break;
            }
        }
    }
    for (tally, name) in tallies.iter().zip(names) {
        tell(&tally, name);
    }
}

/// The classical yardstick: straight to the target's stance.
fn straight(counter: &mut Counter, name: &str, problems: &[ReachTask<f32>]) {
    let policy = Straight::new(&ARM);
    let mut tally = Tally::new();
    for &problem in problems.iter().take(PARTS) {
        let mut episode = Episode::new(&ARM, problem, Brent::new());
        loop {
            let (wanted, instructions) = counter.measure(|| policy.decide(black_box(episode.observation())));
            tally.add(instructions);
            if episode.advance(wanted).is_some() {
                break;
            }
        }
    }
    tell(&tally, name);
}

/// A stream of numbers without a pattern.
struct Numbers(u32);

impl Numbers {
    fn next(&mut self) -> u32 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        self.0 >> 8
    }
}

/// A network in integers.
fn network(counter: &mut Counter, name: &str, words: &'static [u32], scratch: &mut [u32]) {
    let Ok(model) = Model::parse(words) else { exit(false) };
    let mut numbers = Numbers(1);
    let mut tally = Tally::new();
    for _ in 0..16 {
        let inputs: [i16; FEATURES] = core::array::from_fn(|_| (numbers.next() % 16_384) as i16 - 8192);
        let (_, instructions) = counter.measure(|| model.preferences(black_box(&inputs), scratch));
        tally.add(instructions);
    }
    tell(&tally, name);
}

/// A hash of the preferences for many inputs, extreme ones among them: the host's must be the same.
fn bits(name: &str, words: &'static [u32], scratch: &mut [u32]) {
    let Ok(model) = Model::parse(words) else { exit(false) };
    let mut state = 11u32;
    let mut hash = Hash::new();
    for _ in 0..INPUTS {
        let inputs: [i16; FEATURES] = core::array::from_fn(|_| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 16) as i16
        });
        for preference in model.preferences(&inputs, scratch) {
            hash.add(u64::from(preference as u32));
        }
    }
    Report::new("bits ").word(name).unsigned("actions", INPUTS).hexadecimal("hash", hash.0).print();
}

/// A layer in `f32`, sums in the order of the columns.
fn float_layer(weights: &[f32], bias: &[f32], inputs: &[f32], outputs: &mut [f32], hidden: bool) {
    for ((row, &bias), output) in weights.chunks_exact(inputs.len().max(1)).zip(bias).zip(outputs) {
        let sum = row.iter().zip(inputs).fold(bias, |sum, (&w, &x)| sum + w * x);
        *output = if hidden && sum < 0.0 { 0.0 } else { sum };
    }
}

/// A network in `f32`: inputs, width of both hidden layers.
fn float_network(counter: &mut Counter, name: &str, weights: &[f32], inputs: usize, width: usize) {
    let (mut first, mut second, mut out) = ([0f32; 256], [0f32; 256], [0f32; 4]);
    let Some((first_weights, rest)) = weights.split_at_checked(inputs * width) else { exit(false) };
    let Some((second_weights, rest)) = rest.split_at_checked(width * width) else { exit(false) };
    let Some(last_weights) = rest.get(..4 * width) else { exit(false) };
    let (Some(first), Some(second)) = (first.get_mut(..width), second.get_mut(..width)) else { exit(false) };
    let mut numbers = Numbers(1);
    let mut tally = Tally::new();
    for _ in 0..4 {
        let mut values = [0f32; FEATURES];
        values.iter_mut().for_each(|value| *value = (numbers.next() % 4096) as f32 / 2048.0 - 1.0);
        let Some(values) = values.get(..inputs) else { exit(false) };
        let ((), instructions) = counter.measure(|| {
            float_layer(first_weights, first_weights, black_box(values), first, true);
            float_layer(second_weights, second_weights, first, second, true);
            float_layer(last_weights, last_weights, second, &mut out, false);
            black_box(&out);
        });
        tally.add(instructions);
    }
    tell(&tally, name);
}

/// The parts of a decision of the network.
fn parts(counter: &mut Counter, problems: &[ReachTask<f32>]) {
    let [mut frames, mut made, mut clearances, mut rounded, mut decided] = [Tally::new(); 5];
    let mut numbers = Numbers(3);
    for problem in problems {
        let seen = Observation::at(&ARM, problem.start, problem.target);
        let (frame, instructions) = counter.measure(|| Frame::new(&ARM, black_box(&seen)));
        frames.add(instructions);
        let (values, instructions) = counter.measure(|| features(black_box(&frame)));
        made.add(instructions);
        let (_, instructions) = counter.measure(|| Clearance::new(black_box(frame.plane()), &ARM.shapes));
        clearances.add(instructions);
        let (_, instructions) = counter.measure(|| fixed::quantise(black_box(&values)));
        rounded.add(instructions);
        let preferences = [0; 4].map(|_: i32| (numbers.next() % 8192) as i32 - 4096);
        let Pose(ticks) = seen.pose;
        let (_, instructions) =
            counter.measure(|| widowx_sac::DECISION.decide(black_box(preferences), Pose(ticks), &ARM.ranges));
        decided.add(instructions);
    }
    frames.print("cost network: frame");
    made.print("cost network: features");
    clearances.print("cost network: clearance, a part of the features");
    rounded.print("cost network: features to integers");
    decided.print("cost network: decision");
}

#[entry]
fn main() -> ! {
    run(|counter| {
        profiles(
            counter,
            ["fs fast", "fs balanced", "fs small", "fs constant-time"],
            (fs_fast::FsFast, fs_balanced::FsBalanced, fs_small::FsSmall, fs_constant::FsConstant),
            &const { binding::sources(fs_fast::FsFast::SOURCES) },
            &const { binding::moves(fs_fast::FsFast::MOVES) },
            &FS_PROBLEMS,
        );
        profiles(
            counter,
            ["rs fast", "rs balanced", "rs small", "rs constant-time"],
            (rs_fast::RsFast, rs_balanced::RsBalanced, rs_small::RsSmall, rs_constant::RsConstant),
            &const { binding::sources(rs_fast::RsFast::SOURCES) },
            &const { binding::moves(rs_fast::RsFast::MOVES) },
            &RS_PROBLEMS,
        );
        straight(counter, "fs straight", &FS_PROBLEMS);
        straight(counter, "rs straight", &RS_PROBLEMS);
        parts(counter, &RS_PROBLEMS);
        let Some(scratch) = singleton!(: [u32; 512] = [0; 512]) else { return None };
        network(counter, "layers shipped (i8, i16 activations)", &widowx_sac::MODEL, scratch);
        network(counter, "layers shipped, wide (i8 as i16)", &WIDE, scratch);
        for (name, words) in MODELS {
            network(counter, name, words, scratch);
            bits(name, words, scratch);
        }
        const WEIGHTS: usize = 256 * (13 + 256 + 4);
        let Some(weights) = singleton!(: [f32; WEIGHTS] = [0.0; WEIGHTS]) else { return None };
        let mut numbers = Numbers(5);
        weights.iter_mut().for_each(|weight| *weight = (numbers.next() % 4096) as f32 / 16_384.0 - 0.125);
        float_network(counter, "layers 38-64-64-4 f32", weights, FEATURES, 64);
        float_network(counter, "layers 13-256-256-4 f32", weights, 13, 256);
        Some(())
    })
}
