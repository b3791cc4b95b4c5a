//! What a run trained, put to the test episodes.

use super::runs::{Kind, Run};
use crate::engine::{Ending, Environment, Lanes, Options, Plan, Policy};
use crate::environments::arm::{OUTCOMES, outcome_number};
use crate::environments::{ArmEnvironment, ArmProblem, ArmScalar, ArmTask};
use crate::evaluate::endings_of;
use crate::sac::policy::ActorPolicy;
use crate::targets::{self, Set, TOLERANCE};
use tpg_arm::{Arm, Pose, WIDOWX};
use tpg_graph::Graph;
use tpg_graph::error::InputError;
use tpg_graph::in_arithmetic_of;
use tpg_runtime::ops::Maths;

/// Trajectories that are kept: the first episodes that succeed, and the first that fail.
const KEPT: [usize; 2] = [3, 3];

/// How a run did on the test episodes.
#[derive(Debug)]
pub(super) struct Tested {
    /// The arm.
    pub(super) arm: Arm<f64>,
    /// Success is nearer than this, mm.
    pub(super) tolerance: f64,
    /// Final distance of each episode, mm.
    pub(super) distances: Vec<f64>,
    /// Whether it succeeded.
    pub(super) successes: usize,
    /// Actions of all episodes.
    pub(super) actions: u64,
    /// A few of them, pose by pose.
    pub(super) walks: Vec<Walk>,
}

/// One episode, pose by pose.
#[derive(Debug)]
pub(super) struct Walk {
    /// Its place among the test episodes.
    pub(super) number: usize,
    /// Where the hand was to go, mm.
    pub(super) target: [f64; 3],
    /// From the start to the end.
    pub(super) poses: Vec<Pose>,
    /// How it ended, of [`OUTCOMES`].
    pub(super) outcome: &'static str,
    /// Final distance, mm.
    pub(super) distance: f64,
}

impl Tested {
    /// Part of the episodes that succeeded.
    pub(super) fn success(&self) -> f64 {
        self.successes as f64 / self.distances.len().max(1) as f64
    }

    /// Mean final distance, mm.
    pub(super) fn mean_distance(&self) -> f64 {
        self.distances.iter().sum::<f64>() / self.distances.len().max(1) as f64
    }

    fn new(arm: Arm<f64>, tolerance: f64, endings: &[Ending], walks: Vec<Walk>) -> Self {
        Self {
            arm,
            tolerance,
            distances: endings.iter().map(|ending| ending.error).collect(),
            successes: endings.iter().filter(|ending| ending.success).count(),
            actions: endings.iter().map(|ending| u64::from(ending.actions)).sum(),
            walks,
        }
    }
}

/// Tests a run; `None` where there is no arm.
pub(super) fn test(run: &Run, episodes: usize, seed: u64) -> Result<Option<Tested>, InputError> {
    if !run.kind.has_arm() {
        return Ok(None);
    }
    match &run.kind {
        Kind::Tpg { config, graph } => {
            let (arm, problem) = (config.arm(), config.arm_problem());
            let tasks = targets::tasks(&arm, seed, Set::Test, problem.start, episodes);
            let tasks: Vec<ArmTask> = tasks.into_iter().map(ArmTask::from).collect();
            let endings = endings_of(&run.name, graph, &arm, problem.clone(), &tasks)?;
            let chosen = chosen(&endings);
            let chosen: Vec<(usize, ArmTask, Ending)> =
                chosen.into_iter().map(|place| (place, tasks[place], endings[place])).collect();
            let walks = in_arithmetic_of!(graph, walks(run, graph, &arm, &problem, &chosen))?;
            Ok(Some(Tested::new(arm, problem.tolerance, &endings, walks)))
        }
        Kind::Sac { start, network, contract } => {
            let tasks = targets::tasks(&WIDOWX, seed, Set::Test, *start, episodes);
            let policy = ActorPolicy::new(network, &contract.actor);
            let watch = |place: usize| {
                let mut poses = vec![tasks[place].start];
                let summary = policy.watch(*start, place, &tasks[place], |pose| poses.push(pose));
                let outcome = outcome_number(summary.outcome);
                let (actions, error) = (summary.actions, f64::from(summary.distance));
                (Ending { outcome, success: outcome == 0, score: -error, error, actions }, poses)
            };
            let endings: Vec<Ending> = (0..tasks.len()).map(|place| watch(place).0).collect();
            let walks = (chosen(&endings).into_iter())
                .map(|place| walk(place, tasks[place].target, watch(place).1, endings[place]))
                .collect();
            Ok(Some(Tested::new(WIDOWX, TOLERANCE, &endings, walks)))
        }
    }
}

/// The places of the episodes that are drawn.
fn chosen(endings: &[Ending]) -> Vec<usize> {
    let of = |success: bool, count: usize| {
        (0..endings.len()).filter(move |&place| endings[place].success == success).take(count)
    };
    of(true, KEPT[0]).chain(of(false, KEPT[1])).collect()
}

fn walk(number: usize, target: [f64; 3], poses: Vec<Pose>, ending: Ending) -> Walk {
    Walk { number, target, poses, outcome: OUTCOMES[usize::from(ending.outcome)], distance: ending.error }
}

/// The engine says the actions, the arm where they lead.
fn walks<S: ArmScalar, M: Maths<S>>(
    run: &Run,
    graph: &Graph,
    arm: &Arm<f64>,
    problem: &ArmProblem,
    chosen: &[(usize, ArmTask, Ending)],
) -> Result<Vec<Walk>, InputError> {
    let environment = ArmEnvironment::<S>::for_graph(&run.name, graph, arm, problem.clone())?;
    let plan = Plan::new::<M>(&Policy::from(graph), &environment.sources(), Options::default());
    let mut lanes = Lanes::<S, M, _>::new(&environment, Options { lanes: 1, ..Options::default() });
    let one = |&(number, task, ending): &(usize, ArmTask, Ending)| {
        let mut poses = vec![Pose(task.start)];
        lanes.run_watched(&plan, &[task], |_, action| {
            let moves = environment.moves()[usize::from(action.0)];
            let last = poses[poses.len() - 1];
            poses.push(environment.arm().step(last, moves).pose);
        });
        // The engine notices a cycle late; the episode ended at its first repeat.
        poses.truncate(ending.actions as usize + 1);
        walk(number, task.target, poses, ending)
    };
    Ok(chosen.iter().map(one).collect())
}
