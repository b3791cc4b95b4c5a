//! Policies on the arm: graphs, networks, hybrids, and planners.

use super::EvalArgs;
use super::report::EvaluationReport;
use crate::arm_of;
use crate::files::read_graph;
use crate::hybrid::arm::setting::{Detector, Hybrid, Setting};
use crate::hybrid::arm::trial;
use crate::hybrid::setting::Detector as AnyDetector;
use crate::run_args::command_line;
use crate::sac::motors::MotorNetwork;
use std::path::Path;
use std::time::Instant;
use tpg_arm::observation::Straight;
use tpg_arm::observation::shield::{SHIELDED, STEP, action as action_of};
use tpg_arm::{Arm, WIDOWX};
use tpg_engine::{Ending, EngineOptions, Environment, Lanes, Plan, PolicyGraph};
use tpg_graph::error::{InputError, Place};
use tpg_graph::{Graph, in_arithmetic_of};
use tpg_problems::arm::planner::{Choice, Planner};
use tpg_problems::arm::targets::{self, Set, Start};
use tpg_problems::arm::trial::{Trial, run};
use tpg_problems::arm::{ArmEnvironment, ArmProblem, ArmScalar, ArmTask, Config, Shield};
use tpg_runtime::ops::Maths;

/// A policy that is asked for.
enum Asked {
    /// A graph alone.
    Graph(String, Graph),
    /// A network alone.
    Network(String, MotorNetwork),
    /// A graph and a network.
    Hybrid(String, Hybrid),
    /// A classical controller, by its name.
    Classical(String, Classical),
}

/// A controller that learns nothing.
#[derive(Clone, Copy)]
enum Classical {
    /// It chooses among all poses that solve the task.
    Planner(Choice),
    /// Straight to the stance: what fits a microcontroller.
    ClosedForm,
}

impl Classical {
    const ALL: [(&str, Self); 3] = [
        ("planner", Self::Planner(Choice::NearestFree)),
        ("nearest-goal", Self::Planner(Choice::Nearest)),
        ("closed-form", Self::ClosedForm),
    ];

    fn find(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|(known, _)| *known == name).map(|(_, classical)| classical)
    }

    fn trial(self, arm: &Arm<f64>, problem: &ArmProblem, tasks: &[targets::Task]) -> Trial {
        match self {
            Self::Planner(choice) => run(arm, &Planner::within(arm, choice, problem.tolerance), problem.clone(), tasks),
            Self::ClosedForm => run(arm, &Straight::new(arm), problem.clone(), tasks),
        }
    }
}

/// Evaluates what the arguments ask on the arm.
///
/// # Errors
/// If the policy or the episodes cannot be read, or the policy is not one for the arm.
pub fn evaluate(args: &EvalArgs, start: Start) -> Result<EvaluationReport, InputError> {
    if args.separation.is_some() || args.patience.is_some() {
        return Err(command_line(
            "--separation or --patience on the arm",
            "--separation-mm, --guard, --cycle-detector",
        ));
    }
    let config = args.config.as_deref().map(|path| arm_of::config(path, start)).transpose()?;
    let asked = asked(args, config.as_ref())?;
    let (arm, problem) = match &config {
        Some(config) => (config.arm(), config.problem(start)),
        None => asked.usual(start)?,
    };
    let (tasks, seed) = match &args.targets {
        Some(path) => (targets::read_csv(&arm, path)?, None),
        None => (targets::tasks(&arm, args.seed, Set::Test, start, args.episodes), Some(args.seed)),
    };
    let began = Instant::now();
    let seconds = || began.elapsed().as_secs_f64();
    match &asked {
        Asked::Graph(file, graph) => of_graph(file, graph, &arm, problem, args.shield, tasks, seed),
        Asked::Network(file, actor) => {
            let trial = actor.trial(problem, &tasks);
            Ok(EvaluationReport::of_trial(&trial, file, Shield::None, 0.0, seed, seconds()))
        }
        Asked::Hybrid(name, Hybrid { graph: (file, graph), actor, setting }) => {
            let done = trial::run(file, graph, actor, setting, problem, &tasks)?;
            Ok(EvaluationReport::of_hybrid(&done, name, seed, seconds()))
        }
        Asked::Classical(name, classical) => {
            let trial = classical.trial(&arm, &problem, &tasks);
            Ok(EvaluationReport::of_trial(&trial, name, Shield::None, 0.0, seed, seconds()))
        }
    }
}

/// Reads the policies that the arguments name.
fn asked(args: &EvalArgs, config: Option<&Config>) -> Result<Asked, InputError> {
    let arm = config.map(Config::arm);
    let named = |path: &Path| Ok::<_, InputError>((path.display().to_string(), read_graph(path)?));
    match (&args.hybrid, args.tpg.as_deref(), &args.policy) {
        (Some(path), ..) => {
            let (file, hybrid) = (path.display().to_string(), Hybrid::read(path)?);
            if arm.is_some_and(|arm| arm != hybrid.actor.arm()) {
                let accepted = "one for the arm of --config";
                return Err(InputError::new(file, Place::Whole, "a hybrid for another arm", accepted));
            }
            Ok(Asked::Hybrid(file, hybrid))
        }
        (None, Some(path), Some(actor)) => {
            let setting = setting(args)?;
            let graph = named(path)?;
            let arm = match arm {
                Some(arm) => arm,
                None => arm_of::graph(&graph.0, &graph.1)?,
            };
            let name = format!("{} with {actor}: {}", graph.0, setting.sentence());
            let actor = MotorNetwork::read(Path::new(actor), Some(&arm))?;
            Ok(Asked::Hybrid(name, Hybrid { graph, actor, setting }))
        }
        (None, Some(path), None) => named(path).map(|(file, graph)| Asked::Graph(file, graph)),
        (None, None, Some(policy)) => match Classical::find(policy) {
            Some(classical) => Ok(Asked::Classical(policy.clone(), classical)),
            None => Ok(Asked::Network(policy.clone(), MotorNetwork::read(Path::new(policy), arm.as_ref())?)),
        },
        (None, None, None) => Err(command_line("no policy", "--tpg GRAPH, --policy FILE or --hybrid FILE")),
    }
}

impl Asked {
    /// The arm and the rules of episodes without a configuration: those that the policy was made for, as far as it says.
    fn usual(&self, start: Start) -> Result<(Arm<f64>, ArmProblem), InputError> {
        match self {
            Self::Graph(file, graph) => Ok((arm_of::graph(file, graph)?, start.into())),
            Self::Network(_, actor) | Self::Hybrid(_, Hybrid { actor, .. }) => Ok((actor.arm(), actor.tests(start))),
            Self::Classical(..) => Ok((WIDOWX, start.into())),
        }
    }
}

/// The setting that the arguments ask for; the paper's of fixed starts where they do not.
fn setting(args: &EvalArgs) -> Result<Setting, InputError> {
    let detector = match args.cycle_detector {
        Some(AnyDetector::None) => {
            return Err(command_line("--cycle-detector none on the arm", "visited, brent"));
        }
        Some(AnyDetector::Brent) => Detector::Brent,
        Some(AnyDetector::Visited) | None => Detector::Visited,
    };
    let usual = Setting::PAPER_FS;
    Ok(Setting {
        hand_back_after: args.hand_back_after,
        separation_mm: args.separation_mm.unwrap_or(usual.separation_mm),
        guard: args.guard.unwrap_or(usual.guard),
        detector,
    })
}

fn of_graph(
    file: &str,
    graph: &Graph,
    arm: &Arm<f64>,
    problem: ArmProblem,
    added: Shield,
    tasks: Vec<targets::Task>,
    seed: Option<u64>,
) -> Result<EvaluationReport, InputError> {
    let start = problem.start;
    let problem = ArmProblem { sources: Vec::new(), ..problem };
    let shield = match (Shield::of(graph.sources().iter().map(|source| source.name.as_str())), added) {
        (own, Shield::None) => own,
        (Shield::None, added) => added,
        (own, _) => {
            let found = format!("--shield for a graph that has the shield {:?}", own.name());
            return Err(InputError::new(file, Place::Whole, found, "a graph without a shield"));
        }
    };
    let tasks: Vec<ArmTask> = tasks.into_iter().map(ArmTask::from).collect();
    let began = Instant::now();
    let endings = shielded_endings_of(file, graph, arm, problem, added, &tasks)?;
    let seconds = began.elapsed().as_secs_f64();
    Ok(EvaluationReport::of_trial(&Trial::of(start, endings), file, shield, 1.0, seed, seconds))
}

/// The endings of a graph's episodes, in its own scalar and maths; `problem`'s sources are the graph's.
///
/// # Errors
/// If the graph reads sources that the arm does not have, or has actions that do not say what they move.
pub fn endings_of(
    file: &str,
    graph: &Graph,
    arm: &Arm<f64>,
    problem: ArmProblem,
    tasks: &[ArmTask],
) -> Result<Vec<Ending>, InputError> {
    shielded_endings_of(file, graph, arm, problem, Shield::None, tasks)
}

/// [`endings_of`] under a shield that the graph has not.
///
/// # Errors
/// As [`endings_of`].
pub fn shielded_endings_of(
    file: &str,
    graph: &Graph,
    arm: &Arm<f64>,
    problem: ArmProblem,
    shield: Shield,
    tasks: &[ArmTask],
) -> Result<Vec<Ending>, InputError> {
    in_arithmetic_of!(graph, endings(file, graph, arm, problem, shield, tasks))
}

fn endings<S: ArmScalar, M: Maths<S>>(
    file: &str,
    graph: &Graph,
    arm: &Arm<f64>,
    problem: ArmProblem,
    shield: Shield,
    tasks: &[ArmTask],
) -> Result<Vec<Ending>, InputError> {
    let mut environment = ArmEnvironment::<S>::for_graph(file, graph, arm, problem)?;
    let mut policy = PolicyGraph::from(graph);
    if let Some(source) = shield.source() {
        let moves = environment.moves().to_vec();
        let first = graph.state_length() as u16;
        let place = |action: u16| {
            (0..SHIELDED as u8).find(|&place| moves.get(usize::from(action)) == Some(&action_of(place, STEP)))
        };
        policy = policy.shielded(|action| place(action).map(|place| first + u16::from(place)));
        let mut problem = environment.problem().clone();
        problem.sources.push(source);
        environment = ArmEnvironment::for_evaluation(arm, problem, moves);
    }
    let plan = Plan::new::<M>(&policy, &environment.sources(), EngineOptions::default());
    Lanes::<S, M, _>::new(&environment, EngineOptions::default())
        .run(&plan, tasks)
        .map_err(|error| InputError::new(file, Place::Whole, error.to_string(), "episodes that can be run"))
}
