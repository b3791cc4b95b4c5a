//! Trials of a hybrid on a list of tasks.

use super::graph::GraphPolicy;
use super::narrowed::Narrowed;
use super::setting::{Detector, Setting};
use crate::sac::motors::MotorNetwork;
use serde::Serialize;
use tpg_arm::cycle::{Brent, CycleDetector, Visited};
use tpg_arm::hybrid::{CAUSES, Hybrid, HybridEpisode, HybridSummary};
use tpg_arm::observation::Observation;
use tpg_arm::{Arm, Move, Pose};
use tpg_graph::Graph;
use tpg_graph::error::InputError;
use tpg_graph::in_arithmetic_of;
use tpg_problems::arm::targets::Task;
use tpg_problems::arm::trial::{self, Trial};
use tpg_problems::arm::{ArmProblem, ArmScalar};
use tpg_runtime::ops::Maths;
use tpg_runtime::policy::Policy;

/// Results of many episodes of a hybrid.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct HybridTrial {
    /// Statistics as for any policy.
    #[serde(flatten)]
    pub trial: Trial,
    /// Fraction of all actions that the graph chose.
    pub tpg_action_ratio: f64,
    /// The same fraction for each episode, averaged over episodes: the paper's ratio.
    pub tpg_ratio_of_episodes: f64,
    /// Hand-overs per episode, by cause: guard, drift, stop, cycle.
    pub hand_overs: [f64; CAUSES],
    /// Number of times per episode that the network handed the arm back.
    pub hand_backs: f64,
}

/// Capacity of the exact set of poses: the action limit of random starts, plus the start.
const CAPACITY: usize = 4096;

/// Lets a graph and an actor do every task together, on the actor's arm.
///
/// # Errors
/// If the graph does not fit the arm; `file` is its name in errors.
pub fn run(
    file: &str,
    graph: &Graph,
    actor: &MotorNetwork,
    setting: &Setting,
    problem: impl Into<ArmProblem>,
    tasks: &[Task],
) -> Result<HybridTrial, InputError> {
    let problem = problem.into();
    in_arithmetic_of!(graph, of(file, graph, actor, setting, &problem, tasks))
}

fn of<S: ArmScalar, M: Maths<S>>(
    file: &str,
    graph: &Graph,
    actor: &MotorNetwork,
    setting: &Setting,
    problem: &ArmProblem,
    tasks: &[Task],
) -> Result<HybridTrial, InputError> {
    let description = actor.arm();
    let tpg = GraphPolicy::<S, M>::new(file, graph, &description)?;
    let sac = actor.policy();
    let arm = S::arm(&description);
    let hybrid = Hybrid { arm: &arm, tpg, sac: Narrowed::<S, _>::new(&sac), settings: setting.settings() };
    Ok(trial(&hybrid, setting.detector, problem, tasks))
}

/// Lets a graph do every task alone.
///
/// # Errors
/// If the graph does not fit the arm; `file` is its name in errors.
pub fn graph_alone(
    file: &str,
    graph: &Graph,
    arm: &Arm<f64>,
    problem: impl Into<ArmProblem>,
    tasks: &[Task],
) -> Result<Trial, InputError> {
    let problem = problem.into();
    in_arithmetic_of!(graph, alone(file, graph, arm, problem, tasks))
}

fn alone<S: ArmScalar, M: Maths<S>>(
    file: &str,
    graph: &Graph,
    arm: &Arm<f64>,
    problem: ArmProblem,
    tasks: &[Task],
) -> Result<Trial, InputError> {
    Ok(trial::run(&S::arm(arm), &GraphPolicy::<S, M>::new(file, graph, arm)?, problem, tasks))
}

/// Runs one episode of each task.
pub fn trial<S, T, P>(
    hybrid: &Hybrid<'_, S, T, P>,
    detector: Detector,
    problem: &ArmProblem,
    tasks: &[Task],
) -> HybridTrial
where
    S: ArmScalar,
    T: Policy<State = Observation<S>, Action = Move>,
    P: Policy<State = Observation<S>, Action = Move>,
{
    let summaries = match detector {
        Detector::Visited => episodes(hybrid, &Visited::<CAPACITY>::new(), problem, tasks),
        Detector::Brent => episodes(hybrid, &Brent::new(), problem, tasks),
    };
    summarise(problem, &summaries)
}

fn episodes<S, T, P, D>(
    hybrid: &Hybrid<'_, S, T, P>,
    detector: &D,
    problem: &ArmProblem,
    tasks: &[Task],
) -> Vec<HybridSummary<S>>
where
    S: ArmScalar,
    T: Policy<State = Observation<S>, Action = Move>,
    P: Policy<State = Observation<S>, Action = Move>,
    D: CycleDetector<Pose> + Clone,
{
    let episode = |task: &Task| {
        HybridEpisode::with_play(hybrid, problem.reach(task), detector.clone(), problem.play(task)).run(|_, _| ())
    };
    tasks.iter().map(episode).collect()
}

fn summarise<S: ArmScalar>(problem: &ArmProblem, summaries: &[HybridSummary<S>]) -> HybridTrial {
    let episodes = summaries.len().max(1) as f64;
    let (mut tpg, mut ratios, mut hand_backs, mut hand_overs) = (0.0, 0.0, 0.0, [0.0; CAUSES]);
    for HybridSummary { summary, counts } in summaries {
        tpg += f64::from(counts.tpg_actions);
        ratios += f64::from(counts.tpg_actions) / f64::from(summary.actions.max(1));
        hand_backs += f64::from(counts.hand_backs);
        hand_overs.iter_mut().zip(counts.hand_overs).for_each(|(sum, count)| *sum += f64::from(count));
    }
    let ended: Vec<_> = summaries.iter().map(|episode| episode.summary).collect();
    let trial = trial::summarise(problem.clone(), &ended);
    let all = (trial.mean_actions * episodes).max(1.0);
    HybridTrial {
        trial,
        tpg_action_ratio: tpg / all,
        tpg_ratio_of_episodes: ratios / episodes,
        hand_overs: hand_overs.map(|sum| sum / episodes),
        hand_backs: hand_backs / episodes,
    }
}
