//! Tests of runs: the trained policy on the test episodes.

use super::episode::{WEIGHED, Watched, watch};
use super::runs::{Kind, Run, Together};
use crate::evaluate::arm::endings_of;
use crate::evaluate::graph::endings;
use crate::evaluate::{hybrid, network};
use crate::hybrid::arm::setting::Hybrid as ArmHybrid;
use crate::hybrid::arm::trial;
use crate::hybrid::setting::Hybrid;
use crate::hybrid::shared::{Episodes, Shared};
use crate::hybrid::trial::Acting;
use crate::sac::motors::MotorNetwork;
use crate::sac::network::Network;
use crate::sac::tensors::place;
use tpg_arm::{Arm, Pose};
use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{
    Choices, Ending, EngineOptions, Environment, Lanes, Measure, Plan, PolicyGraph, Remembered, Remembering, Summary,
};
use tpg_graph::error::{InputError, Place};
use tpg_graph::{Graph, in_arithmetic_of};
use tpg_problems::arm::environment::{DISTANCE, OUTCOMES};
use tpg_problems::arm::targets::{self, Set, Start};
use tpg_problems::arm::{ArmEnvironment, ArmProblem, ArmScalar, ArmTask};
use tpg_problems::{ContinuousProblem, Number, Problem};
use tpg_runtime::ops::Maths;

/// Number of trajectories to keep: the first successful and the first failed episodes.
const KEPT: [usize; 2] = [3, 3];

/// Result of a run on the test episodes.
#[derive(Debug)]
pub(super) struct Tested {
    /// The episodes.
    pub(super) endings: Vec<Ending>,
    /// Quantity reported in addition to the score, if the problem has one.
    pub(super) measure: Option<Measure>,
    /// Results that only the arm has.
    pub(super) arm: Option<OnTheArm>,
    /// Some episodes on another problem, action by action.
    pub(super) watched: Option<Watched>,
}

/// The arm, and some of its episodes.
#[derive(Debug)]
pub(super) struct OnTheArm {
    /// The arm.
    pub(super) arm: Arm<f64>,
    /// Success is a final distance below this, mm.
    pub(super) tolerance: f64,
    /// Some episodes, pose by pose.
    pub(super) walks: Vec<Walk>,
}

/// One episode, pose by pose.
#[derive(Debug)]
pub(super) struct Walk {
    /// Index among the test episodes.
    pub(super) number: usize,
    /// Target of the hand, mm.
    pub(super) target: [f64; 3],
    /// Poses from start to end.
    pub(super) poses: Vec<Pose>,
    /// Outcome, one of [`OUTCOMES`].
    pub(super) outcome: &'static str,
    /// Final distance, mm.
    pub(super) distance: f64,
}

impl Tested {
    /// Returns the means.
    pub(super) fn summary(&self) -> Summary {
        Summary::of(&self.endings)
    }

    /// Returns the measure of each episode: on the arm, the final distance in mm.
    pub(super) fn measures(&self) -> Vec<f64> {
        self.endings.iter().map(|ending| ending.measure).collect()
    }
}

/// Returns the policies of a run's hall of fame, each with its name and result.
pub(super) fn hall<'r>(
    run: &'r Run,
    episodes: usize,
    seed: u64,
    own: Option<&dyn Shared>,
) -> Result<Vec<(String, &'r Run, Tested)>, InputError> {
    let mut tested = Vec::new();
    for one in &run.hall {
        if let Some(result) = test(one, episodes, seed, own)? {
            tested.push((format!("{}, {}", run.name, one.name), one, result));
        }
    }
    Ok(tested)
}

/// Tests a run; `None` if its environment is not available.
pub(super) fn test(
    run: &Run,
    episodes: usize,
    seed: u64,
    own: Option<&dyn Shared>,
) -> Result<Option<Tested>, InputError> {
    match &run.kind {
        Kind::Tpg { problem: None, graph, .. } => {
            let Some(own) = own else { return Ok(None) };
            let graph = (run.name.clone(), (**graph).clone());
            let episodes = Episodes { purpose: Purpose::Evaluation, count: episodes, seed };
            let endings = own.trial(Acting::Graph(&graph), episodes)?.endings;
            Ok(Some(Tested { endings, measure: own.facts().measure, arm: None, watched: None }))
        }
        Kind::Tpg { problem: Some(problem), graph, .. } => match &**problem {
            Problem::Arm(start, config) => {
                let (arm, problem) = (config.arm(), config.problem(*start));
                let tasks = targets::tasks(&arm, seed, Set::Test, problem.start, episodes);
                let tasks: Vec<ArmTask> = tasks.into_iter().map(ArmTask::from).collect();
                let endings = endings_of(&run.name, graph, &arm, problem.clone(), &tasks)?;
                let chosen: Vec<(usize, ArmTask, Ending)> =
                    chosen(&endings).into_iter().map(|place| (place, tasks[place], endings[place])).collect();
                let walks = in_arithmetic_of!(graph, walks(run, graph, &arm, &problem, &chosen))?;
                let arm = OnTheArm { arm, tolerance: problem.tolerance, walks };
                Ok(Some(Tested { endings, measure: Some(DISTANCE), arm: Some(arm), watched: None }))
            }
            problem => {
                let test = OnAProblem { problem, file: &run.name, graph, episodes, seed };
                in_arithmetic_of!(graph, test.run()).map(Some)
            }
        },
        Kind::Sac { problem, network, contract } => match &**problem {
            ContinuousProblem::Motors(start, _) => {
                let network = Network::Float(Box::new(((**network).clone(), (**contract).clone())));
                let network = MotorNetwork::new(network, None).map_err(|finding| place(run.name.as_ref(), finding))?;
                Ok(Some(of_motors(&network, *start, episodes, seed)))
            }
            problem => {
                let network = Network::Float(Box::new(((**network).clone(), (**contract).clone())));
                let network::Tested { endings, measure, .. } =
                    network::test(problem, &run.name, &network, episodes, seed)?;
                Ok(Some(Tested { endings, measure, arm: None, watched: None }))
            }
        },
        Kind::Hybrid(Together::Arm(rules, hybrid)) => Ok(Some(of_an_arms_hybrid(hybrid, rules, episodes, seed)?)),
        Kind::Hybrid(Together::Other(problem, hybrid)) => Ok(Some(of_a_hybrid(&**problem, hybrid, episodes, seed)?)),
        Kind::Hybrid(Together::Own(hybrid)) => {
            let Some(own) = own else { return Ok(None) };
            Ok(Some(of_a_hybrid(own, hybrid, episodes, seed)?))
        }
    }
}

/// A hybrid on its test episodes.
fn of_a_hybrid(problem: &dyn Shared, hybrid: &Hybrid, episodes: usize, seed: u64) -> Result<Tested, InputError> {
    let endings = hybrid::test(problem, hybrid, episodes, seed)?.endings;
    Ok(Tested { endings, measure: problem.facts().measure, arm: None, watched: None })
}

/// A hybrid of the arm on its test episodes.
fn of_an_arms_hybrid(hybrid: &ArmHybrid, rules: &ArmProblem, episodes: usize, seed: u64) -> Result<Tested, InputError> {
    let ArmHybrid { graph: (file, graph), actor, setting } = hybrid;
    let tasks = targets::tasks(&actor.arm(), seed, Set::Test, rules.start, episodes);
    let endings = trial::run(file, graph, actor, setting, rules.clone(), &tasks)?.trial.endings;
    let arm = OnTheArm { arm: actor.arm(), tolerance: rules.tolerance, walks: Vec::new() };
    Ok(Tested { endings, measure: Some(DISTANCE), arm: Some(arm), watched: None })
}

/// A network of the arm's motors on its test episodes.
fn of_motors(network: &MotorNetwork, start: Start, episodes: usize, seed: u64) -> Tested {
    let (arm, rules) = (network.arm(), network.tests(start));
    let tasks = targets::tasks(&arm, seed, Set::Test, start, episodes);
    let policy = network.policy();
    let watch = |place: usize| {
        let mut poses = vec![tasks[place].start];
        let summary = policy.watch(&rules, place, &tasks[place], |pose| poses.push(pose));
        (rules.ending(summary.outcome, summary.actions, f64::from(summary.distance)), poses)
    };
    let endings: Vec<Ending> = (0..tasks.len()).map(|place| watch(place).0).collect();
    let walks = (chosen(&endings).into_iter())
        .map(|place| walk(place, tasks[place].target, watch(place).1, endings[place]))
        .collect();
    Tested {
        endings,
        measure: Some(DISTANCE),
        arm: Some(OnTheArm { arm, tolerance: rules.tolerance, walks }),
        watched: None,
    }
}

/// A graph and a built-in problem that is not the arm's.
struct OnAProblem<'a> {
    problem: &'a Problem,
    file: &'a str,
    graph: &'a Graph,
    episodes: usize,
    seed: u64,
}

impl OnAProblem<'_> {
    fn run<S: Number, M: Maths<S>>(&self) -> Result<Tested, InputError> {
        let Self { problem, file, graph, episodes, seed } = *self;
        let environment = problem.environment::<S>();
        let choices = Choices::new(&*environment, problem.levels_for(graph))
            .map_err(|error| InputError::new(file, Place::Whole, error.to_string(), "fewer problem.levels"))?;
        let draw = |index| choices.draw(&mut Stream::new(seed, 0, Purpose::Evaluation, index));
        let tasks: Vec<_> = (0..WEIGHED.min(episodes) as u64).map(draw).collect();
        let watched = watch::<S, M, _>(graph, &choices, &tasks);
        let remembering = Remembering::new(choices, Remembered::of(graph));
        let endings = endings::<S, M>(file, graph, &remembering, episodes, seed)?;
        Ok(Tested { endings, measure: environment.measure(), arm: None, watched })
    }
}

/// Returns the indices of the episodes to draw.
fn chosen(endings: &[Ending]) -> Vec<usize> {
    let of = |success: bool, count: usize| {
        (0..endings.len()).filter(move |&place| endings[place].success == Some(success)).take(count)
    };
    of(true, KEPT[0]).chain(of(false, KEPT[1])).collect()
}

fn walk(number: usize, target: [f64; 3], poses: Vec<Pose>, ending: Ending) -> Walk {
    Walk { number, target, poses, outcome: OUTCOMES[usize::from(ending.outcome)], distance: ending.measure }
}

/// Returns trajectories: actions come from the engine, the resulting poses from the arm.
fn walks<S: ArmScalar, M: Maths<S>>(
    run: &Run,
    graph: &Graph,
    arm: &Arm<f64>,
    problem: &ArmProblem,
    chosen: &[(usize, ArmTask, Ending)],
) -> Result<Vec<Walk>, InputError> {
    let environment = ArmEnvironment::<S>::for_graph(&run.name, graph, arm, problem.clone())?;
    let plan = Plan::new::<M>(&PolicyGraph::from(graph), &environment.sources(), EngineOptions::default());
    let mut lanes = Lanes::<S, M, _>::new(&environment, EngineOptions { lanes: 1, ..EngineOptions::default() });
    let one = |&(number, task, ending): &(usize, ArmTask, Ending)| {
        let mut poses = vec![Pose(task.start)];
        lanes
            .run_watched(&plan, &[task], |_, action| {
                let moves = environment.moves()[usize::from(action.0)];
                let last = poses[poses.len() - 1];
                poses.push(environment.arm().step(last, moves).pose);
            })
            .map_err(|error| InputError::new(&run.name, Place::Whole, error.to_string(), "episodes that can be run"))?;
        // The engine detects a cycle late; the episode ended at its first repeat.
        poses.truncate(ending.actions as usize + 1);
        Ok(walk(number, task.target, poses, ending))
    };
    chosen.iter().map(one).collect()
}
