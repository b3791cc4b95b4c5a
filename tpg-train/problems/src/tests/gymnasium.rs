//! Comparison of the built-in problems with Gymnasium, step by step.
//!
//! `gymnasium/record.py` records episodes; each step here begins in Gymnasium's own state. Endings must be equal, and
//! rewards but for the last bits of a square. Numbers may differ only by what separates two good libraries for sines: a few
//! units in the last place.

use crate::{Acrobot, CartPole, MountainCar, MountainCarContinuous, Pendulum, ProblemName};
use flate2::read::GzDecoder;
use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::process::{Command, Stdio};
use tpg_engine::{Act, Environment, SourceSet};
use tpg_runtime::policy::ActionId;

/// Largest accepted difference of a number of the state, in `f64`, after one step: sines of two libraries differ in their
/// last bits, and a step multiplies that.
const BOUND: f64 = 1e-13;

/// An episode that can begin in any of Gymnasium's states.
trait Recorded: Environment<f32> {
    /// Largest accepted difference of a reward, beside two units in the last place.
    const REWARD: f64 = 0.0;

    fn episode(state: &[f64], is_first: bool) -> Self::Episode;
    fn state(episode: &Self::Episode) -> Vec<f64>;
}

impl Recorded for CartPole {
    fn episode(state: &[f64], _: bool) -> [f64; 4] {
        state.try_into().expect("four numbers")
    }
    fn state(state: &[f64; 4]) -> Vec<f64> {
        state.to_vec()
    }
}

impl Recorded for Acrobot {
    fn episode(state: &[f64], _: bool) -> [f64; 8] {
        Environment::<f64>::start(&Acrobot, &state.try_into().expect("four numbers"))
    }
    fn state(links: &[f64; 8]) -> Vec<f64> {
        links[..4].to_vec()
    }
}

impl Recorded for MountainCar {
    fn episode(state: &[f64], _: bool) -> [f64; 2] {
        state.try_into().expect("two numbers")
    }
    fn state(state: &[f64; 2]) -> Vec<f64> {
        state.to_vec()
    }
}

impl Recorded for Pendulum {
    /// NumPy squares the torque by `powf` in `f32`, which is now and then off by a unit in the last place: of at most 4,
    /// times 0.001.
    const REWARD: f64 = 5e-10;

    fn episode(state: &[f64], _: bool) -> [f64; 4] {
        Environment::<f64>::start(&Pendulum, &state.try_into().expect("two numbers"))
    }
    fn state(swing: &[f64; 4]) -> Vec<f64> {
        swing[..2].to_vec()
    }
}

impl Recorded for MountainCarContinuous {
    fn episode(state: &[f64], is_first: bool) -> [f64; 3] {
        [state[0], state[1], f64::from(!is_first)]
    }
    fn state(drive: &[f64; 3]) -> Vec<f64> {
        drive[..2].to_vec()
    }
}

/// Counts of what agreed with Gymnasium and of what did not.
#[derive(Debug, Default)]
struct GymnasiumTally {
    episodes: usize,
    steps: usize,
    /// Numbers of observations, and those whose bits differ.
    numbers: usize,
    different: usize,
    /// Largest difference of a number of the state.
    largest: f64,
}

/// Steps the problem from each recorded state.
fn compare<E: Recorded>(environment: &E, rows: impl Read) -> GymnasiumTally {
    let inputs = environment.sources().len();
    let mut tally = GymnasiumTally::default();
    let mut before: Vec<f64> = Vec::new();
    let mut steps = 0;
    for row in BufReader::new(rows).lines() {
        let row = row.expect("text");
        let fields: Vec<&str> = row.split(',').collect();
        let number = |text: &&str| text.parse::<f64>().unwrap_or_else(|_| panic!("{row}"));
        let numbers: Vec<f64> = fields[3..].iter().map(number).collect();
        let (state, observation) = numbers.split_at(numbers.len() - inputs);
        let mut seen = vec![0f32; inputs];
        if fields[0].is_empty() {
            environment.observe(&mut E::episode(state, true), SourceSet::ALL, &mut seen);
            (tally.episodes, steps) = (tally.episodes + 1, 0);
        } else {
            let mut episode = E::episode(&before, steps == 0);
            let action = number(&fields[0]);
            let step = if environment.actions().outputs().is_empty() {
                environment.step(&mut episode, Act::Choice(ActionId(action as u16)))
            } else {
                environment.step(&mut episode, Act::Values(&[action as f32]))
            };
            (tally.steps, steps) = (tally.steps + 1, steps + 1);
            let reward = number(&fields[1]);
            assert!(
                (step.reward - reward).abs() <= E::REWARD + 2.0 * f64::EPSILON * reward.abs(),
                "{} after {before:?}: {row}",
                step.reward
            );
            assert_eq!(step.end.is_some(), fields[2] == "1", "an ending after {before:?}: {row}");
            assert_eq!(step.end.is_none() && steps == environment.time_limit(), fields[2] == "2", "{row}");
            for (found, recorded) in E::state(&episode).iter().zip(state) {
                let difference = (found - recorded).abs();
                tally.largest = tally.largest.max(difference);
                assert!(difference <= BOUND, "{found} instead of {recorded} after {before:?}: {row}");
            }
            environment.observe(&mut episode, SourceSet::ALL, &mut seen);
        }
        for (found, recorded) in seen.iter().zip(observation) {
            let recorded = *recorded as f32;
            tally.numbers += 1;
            if found.to_bits() != recorded.to_bits() && *found != recorded {
                tally.different += 1;
                let unit = (recorded.next_up() - recorded).max(recorded - recorded.next_down());
                let bound = f64::from(unit).max(BOUND);
                assert!(f64::from((found - recorded).abs()) <= bound, "{found} instead of {recorded}: {row}");
            }
        }
        before = state.to_vec();
    }
    tally
}

/// Compares with the committed vectors.
fn committed<E: Recorded>(environment: &E, name: ProblemName) {
    let path = format!("{}/gymnasium/{}.csv.gz", env!("CARGO_MANIFEST_DIR"), name.name());
    let tally = compare(environment, GzDecoder::new(File::open(&path).expect("it is committed")));
    assert!(tally.episodes >= 4 && tally.steps > 1000, "{tally:?}");
    assert!(tally.different * 1000 <= tally.numbers, "{}: more than 1 of 1,000 numbers: {tally:?}", name.name());
}

#[test]
fn every_problem_steps_as_gymnasium_did() {
    committed(&CartPole, ProblemName::Cartpole);
    committed(&Acrobot, ProblemName::Acrobot);
    committed(&MountainCar, ProblemName::MountainCar);
    committed(&Pendulum, ProblemName::Pendulum);
    committed(&MountainCarContinuous, ProblemName::MountainCarContinuous);
}

/// Compares 10,000 episodes with Gymnasium itself, if the variable `TPG_GYMNASIUM_PYTHON` names a Python that has it; minutes.
fn live<E: Recorded>(environment: &E, name: ProblemName) {
    let Ok(python) = std::env::var("TPG_GYMNASIUM_PYTHON") else {
        tpg_testing::skip(&format!("{}: TPG_GYMNASIUM_PYTHON names no Python with Gymnasium", name.name()));
        return;
    };
    let episodes = tpg_testing::amount(100, 10_000);
    let script = format!("{}/gymnasium/record.py", env!("CARGO_MANIFEST_DIR"));
    let mut child = Command::new(python)
        .args([&script, name.name(), "--episodes", &episodes.to_string()])
        .stdout(Stdio::piped())
        .spawn()
        .expect("TPG_GYMNASIUM_PYTHON names a Python");
    let tally = compare(environment, child.stdout.take().expect("a pipe"));
    assert!(child.wait().expect("it ends").success());
    assert_eq!(tally.episodes, episodes);
    assert!(tally.different * 1000 <= tally.numbers, "{}: more than 1 of 1,000 numbers: {tally:?}", name.name());
    println!("{}: {tally:?}", name.name());
}

#[test]
fn cartpole_steps_as_gymnasium_does() {
    live(&CartPole, ProblemName::Cartpole);
}

#[test]
fn acrobot_steps_as_gymnasium_does() {
    live(&Acrobot, ProblemName::Acrobot);
}

#[test]
fn mountain_car_steps_as_gymnasium_does() {
    live(&MountainCar, ProblemName::MountainCar);
}

#[test]
fn pendulum_steps_as_gymnasium_does() {
    live(&Pendulum, ProblemName::Pendulum);
}

#[test]
fn mountain_car_continuous_steps_as_gymnasium_does() {
    live(&MountainCarContinuous, ProblemName::MountainCarContinuous);
}
