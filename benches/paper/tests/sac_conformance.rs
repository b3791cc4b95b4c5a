//! The paper's trained actors, replayed with PyTorch's random numbers: every row and every step.

use crate::support;
use crate::support::sac::{max_actions, run};
use crate::support::torch_random::TorchRandom;
use crate::support::traces::{trace_difference, traces};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::fs;
use tpg_arm::observation::Observation;
use tpg_arm::{JOINTS, Pose, WIDOWX};
use tpg_paper::actor::{INPUTS, RecordedActor, STATE};
use tpg_paper::chain::Chain;
use tpg_paper::episode::Rules;
use tpg_paper::{data, replay};
use tpg_problems::arm::targets::Start;

const PROBLEMS: [(&str, Start); 2] = [("fs", Start::Fs), ("rs", Start::Rs)];
const SEEDS: u32 = 3;

#[test]
fn random_numbers_are_pytorchs() {
    let Some(file) = support::foreign_file("random_numbers_are_pytorchs", "rng_torch_normal4.json") else { return };
    let text = fs::read_to_string(file).expect("a recorded file");
    let recorded: BTreeMap<u64, Vec<[f64; 4]>> = serde_json::from_str(&text).expect("draws by seed");
    assert!(!recorded.is_empty());
    for (seed, draws) in recorded {
        let mut random = TorchRandom::new(seed);
        for (number, draw) in draws.into_iter().enumerate() {
            for wanted in draw {
                assert_eq!(random.normal(), wanted as f32, "seed {seed}, draw {number}");
            }
        }
    }
}

/// The outputs that PyTorch computed, in the description of an actor.
#[derive(Deserialize)]
struct Described {
    #[serde(default)]
    forward_checks: Vec<ForwardCheck>,
}

#[derive(Deserialize)]
struct ForwardCheck {
    /// Motor positions, ticks.
    motors: [i16; JOINTS],
    /// The target, mm.
    target: [f64; 3],
    /// Input of the actor.
    state: [f32; INPUTS],
    /// Means.
    mu: [f32; JOINTS],
    /// Spreads, clipped.
    sigma: [f32; JOINTS],
}

#[test]
fn actors_answer_what_was_recorded() {
    let Some(folder) = support::folder("actors_answer_what_was_recorded") else { return };
    let chain = Chain::new(WIDOWX);
    for (name, _) in PROBLEMS {
        for seed in 0..SEEDS {
            let file = |suffix: &str| folder.join(format!("sac/{name}_s{seed}.{suffix}"));
            let actor = RecordedActor::read(&file("actor.f32"), &file("json")).expect("a recorded actor");
            let described: Described =
                serde_json::from_str(&fs::read_to_string(file("json")).expect("a description")).expect("a description");
            if described.forward_checks.is_empty() {
                tpg_testing::skip("tpg-paper, actors_answer_what_was_recorded: no outputs by PyTorch");
                return;
            }
            assert_eq!(described.forward_checks.len(), 40);
            for check in described.forward_checks {
                let pose = Pose(check.motors);
                let seen = Observation::new(&WIDOWX, pose, chain.hand(pose), check.target);
                let state = actor.state(&seen);
                let mut recorded = [0.0; STATE];
                recorded[..INPUTS].copy_from_slice(&check.state);
                let (mean, spread) = actor.forward(&recorded);
                let pairs = (state.into_iter().take(INPUTS).chain(mean).chain(spread))
                    .zip(check.state.into_iter().chain(check.mu).chain(check.sigma));
                for (ours, recorded) in pairs {
                    assert!((ours - recorded).abs() < 1e-5, "{name} {seed}: {ours} {recorded}");
                }
            }
        }
    }
}

#[test]
fn stochastic_episodes_come_out_the_same() {
    let Some(folder) = support::folder("stochastic_episodes_come_out_the_same") else { return };
    let chain = Chain::new(WIDOWX);
    let (mut rows, mut steps) = (0, 0);
    for (name, problem) in PROBLEMS {
        let tasks = data::tasks(&folder.join(format!("targets_{name}.csv"))).expect("recorded targets");
        for seed in 0..SEEDS {
            for (mode, is_strict) in [("kill", true), ("nokill", false)] {
                let file = |suffix: &str| folder.join(format!("sac/{name}_s{seed}.{suffix}"));
                let actor = RecordedActor::read(&file("actor.f32"), &file("json")).expect("a recorded actor");
                let rules = Rules { max_actions: max_actions(problem), tolerance: 3.0 };
                let done = run(&chain, rules, is_strict, &tasks, &actor);
                let mut ends = data::ends(&file(&format!("{mode}.ends.csv"))).expect("recorded ends");
                for end in ends.values_mut() {
                    assert!(end.tpg_actions.is_none_or(|actions| actions == 0), "no action is a TPG's");
                    end.tpg_actions = None;
                }
                let traces = traces(&file(&format!("{mode}.trace.csv.gz")));
                let of_ends = replay::compare(&ends, &done, replay::end_difference);
                let of_traces = replay::compare(&traces, &done, trace_difference);
                for comparison in [&of_ends, &of_traces] {
                    assert!(comparison.is_exact(), "{name} {seed} {mode}: {comparison:?}");
                }
                rows += of_ends.rows;
                steps += traces.values().map(Vec::len).sum::<usize>();
            }
        }
    }
    assert_eq!((rows, steps), (720, 637_942), "all that was recorded");
}
