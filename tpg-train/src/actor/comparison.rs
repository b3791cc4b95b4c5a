//! An actor of the arm in integers beside the same in floating point, as `tpg-train quantise --report` writes it.

use super::file::FloatActor;
use super::fixed::FixedActor;
use super::policy::ActorPolicy;
use serde::Serialize;
use std::cell::Cell;
use std::fmt;
use tpg_arm::observation::Observation;
use tpg_arm::{JOINTS, Move};
use tpg_codegen::policy::QuantisedPolicy;
use tpg_graph::error::InputError;
use tpg_problems::arm::targets::{Set, Start, tasks};
use tpg_problems::arm::trial::{self, Trial};
use tpg_runtime::policy::Policy;

/// Episodes of each start: validation tasks, which neither training nor tests see.
const EPISODES: usize = 1000;
const SEED: u64 = 1_000;

/// Size, cost and quality.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Comparison {
    /// The widths of weights and activations.
    pub kind: String,
    /// Bytes of its constants.
    pub bytes: usize,
    /// Multiplications of a weight that one decision costs.
    pub multiplications: usize,
    /// The episodes of each start.
    pub starts: Vec<OnStart>,
}

/// The result of the episodes of one start.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OnStart {
    /// Observations on the way of the policy in floating point.
    pub observations: u64,
    /// The fraction of them for which both make the same move of all motors.
    pub same_move: f64,
    /// The fraction of them, motor by motor, where the motor does the same.
    pub same_motor: f64,
    /// In floating point.
    pub float: Trial,
    /// In integers.
    pub fixed: Trial,
}

/// A policy in floating point, compared with one in integers at every step.
struct Watched<'a> {
    float: &'a ActorPolicy<'a>,
    fixed: &'a FixedActor,
    /// Observations, same moves, same motors.
    counts: Cell<[u64; 3]>,
}

impl Policy for Watched<'_> {
    type State = Observation<f32>;
    type Action = Move;

    fn decide(&self, seen: &Observation<f32>) -> Move {
        let (chosen, other) = (self.float.decide(seen), self.fixed.decide(seen));
        let motors = chosen.0.iter().zip(&other.0).filter(|(chosen, other)| chosen == other).count() as u64;
        let [observations, moves, same] = self.counts.get();
        self.counts.set([observations + 1, moves + u64::from(chosen == other), same + motors]);
        chosen
    }
}

impl Comparison {
    /// The comparison of an actor and its integers.
    ///
    /// # Errors
    /// As [`FixedActor::new`].
    pub fn new(actor: &FloatActor, policy: &QuantisedPolicy) -> Result<Self, InputError> {
        let (float, fixed) = (actor.policy(), FixedActor::new(policy.clone(), &actor.motors.arm())?);
        let (arm, single) = (actor.motors.arm(), actor.motors.arm().to_f32());
        let starts = [Start::Fs, Start::Rs].map(|start| {
            let rules = actor.motors.tests(start);
            let tasks = tasks(&arm, SEED, Set::Validation, start, EPISODES);
            let watched = Watched { float: &float, fixed: &fixed, counts: Cell::default() };
            let by_float = trial::run(&single, &watched, rules.clone(), &tasks);
            let [observations, moves, motors] = watched.counts.get();
            OnStart {
                observations,
                same_move: moves as f64 / observations as f64,
                same_motor: motors as f64 / (observations * JOINTS as u64) as f64,
                float: by_float,
                fixed: trial::run(&single, &fixed, rules, &tasks),
            }
        });
        Ok(Self {
            kind: policy.kind.clone(),
            bytes: policy.bytes(),
            multiplications: policy.multiplications(),
            starts: starts.into(),
        })
    }
}

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let percent = |fraction: f64| 100.0 * fraction;
        let lines = self.starts.iter().map(|on| {
            format!(
                "{:?}: success {:.1} % in floating point, {:.1} % in integers; the same move {:.1} %, motor {:.1} %",
                on.float.problem,
                percent(on.float.success_rate),
                percent(on.fixed.success_rate),
                percent(on.same_move),
                percent(on.same_motor)
            )
        });
        f.write_str(&lines.collect::<Vec<_>>().join("\n"))
    }
}
