//! Policies on the arm: graphs, networks, hybrids, and planners.

use super::EvalArgs;
use super::report::EvaluationReport;
use crate::actor::file::Actor;
use crate::files::read_graph;
use crate::hybrid::arm::setting::{Detector, Hybrid, Setting};
use crate::hybrid::arm::trial;
use crate::hybrid::setting::Detector as AnyDetector;
use crate::run_args::command_line;
use serde::Deserialize as _;
use std::path::Path;
use std::time::Instant;
use tpg_arm::observation::shield::{SHIELDED, STEP, action as action_of};
use tpg_arm::{Arm, WIDOWX};
use tpg_engine::{Ending, EngineOptions, Environment, Lanes, Plan, PolicyGraph};
use tpg_graph::error::{Finding, InputError, Place};
use tpg_graph::{Graph, in_arithmetic_of};
use tpg_problems::arm::planner::{Choice, Planner};
use tpg_problems::arm::targets::{self, Set, Start};
use tpg_problems::arm::trial::{Trial, run};
use tpg_problems::arm::{ArmDescription, ArmEnvironment, ArmProblem, ArmScalar, ArmTask, Config, Shield};
use tpg_problems::{Problem, ProblemName};
use tpg_runtime::ops::Maths;

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
    let config = args.config.as_deref().map(|path| arm_config(path, start)).transpose()?;
    let arm = arm_for(args, config.as_ref())?;
    let (tasks, seed) = match &args.targets {
        Some(path) => (targets::read_csv(&arm, path)?, None),
        None => (targets::tasks(&arm, args.seed, Set::Test, start, args.episodes), Some(args.seed)),
    };
    match (&args.hybrid, &args.tpg, &args.policy) {
        (Some(path), ..) => of_hybrid(&path.display().to_string(), &Hybrid::read(path)?, start, &tasks, seed),
        (None, Some(graph), Some(actor)) => {
            let setting = setting(args)?;
            let name = format!("{} with {actor}: {}", graph.display(), setting.sentence());
            let graph = (graph.display().to_string(), read_graph(graph)?);
            let hybrid = Hybrid { graph, actor: Actor::read(Path::new(actor))?, setting };
            of_hybrid(&name, &hybrid, start, &tasks, seed)
        }
        (None, Some(path), None) => {
            let problem = problem_of(start, config.as_ref());
            of_graph(&path.display().to_string(), &read_graph(path)?, &arm, problem, args.shield, tasks, seed)
        }
        (None, None, policy) => {
            let policy = policy.as_deref().unwrap_or("planner");
            let began = Instant::now();
            let trial = trial_of(policy, start, &tasks)?;
            Ok(EvaluationReport::of_trial(&trial, policy, Shield::None, 0.0, seed, began.elapsed().as_secs_f64()))
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

/// Lets a policy do tasks: a `policy.safetensors`, a `policy.q.json`, or the classical `planner` or `nearest-goal`.
///
/// # Errors
/// If there is no such policy.
pub fn trial_of(policy: &str, start: Start, tasks: &[targets::Task]) -> Result<Trial, InputError> {
    let choice = match policy {
        "planner" => Some(Choice::NearestFree),
        "nearest-goal" => Some(Choice::Nearest),
        _ => None,
    };
    match choice {
        Some(choice) => Ok(run(&WIDOWX, &Planner::new(&WIDOWX, choice), start, tasks)),
        None => Ok(Actor::read(Path::new(policy))?.trial(start, tasks)),
    }
}

/// Reads the arm's section of a configuration.
///
/// # Errors
/// If it cannot be read, or is for another problem.
pub fn arm_config(path: &Path, start: Start) -> Result<Config, InputError> {
    let text = crate::files::read_text(path, "a configuration as `tpg-train config` prints")?;
    match Problem::from_toml(&path.display().to_string(), &text)? {
        Problem::Arm(of, config) if of == start => Ok(config),
        other => {
            let (asked, found) = (ProblemName::from(start).name(), other.name().name());
            Err(command_line(format!("--problem {asked} with a configuration for {found}"), "the same problem twice"))
        }
    }
}

fn of_hybrid(
    name: &str,
    hybrid: &Hybrid,
    start: Start,
    tasks: &[targets::Task],
    seed: Option<u64>,
) -> Result<EvaluationReport, InputError> {
    let Hybrid { graph: (file, graph), actor, setting } = hybrid;
    let began = Instant::now();
    let done = trial::run(file, graph, actor, setting, start, tasks)?;
    Ok(EvaluationReport::of_hybrid(&done, name, seed, began.elapsed().as_secs_f64()))
}

/// The configuration's arm, or the graph's. Only graphs are for other arms than the WidowX.
fn arm_for(args: &EvalArgs, config: Option<&Config>) -> Result<Arm<f64>, InputError> {
    let of_graph = |path: &Path| arm_of(&path.display().to_string(), &read_graph(path)?);
    let arm = match (config, &args.tpg) {
        (Some(config), _) => config.arm(),
        (None, Some(path)) => of_graph(path)?,
        (None, None) => WIDOWX,
    };
    let graph_alone = args.hybrid.is_none() && args.policy.is_none();
    if !graph_alone && (config.is_some() || arm != WIDOWX) {
        let accepted = "--tpg alone: a network, a hybrid and a planner are for the WidowX";
        return Err(command_line("another arm or --config", accepted));
    }
    Ok(arm)
}

/// The arm that a graph was trained for, as its provenance says; the WidowX where that says nothing.
///
/// # Errors
/// If what it says is no arm.
pub fn arm_of(file: &str, graph: &Graph) -> Result<Arm<f64>, InputError> {
    let Some(text) =
        graph.provenance().config.as_ref().and_then(|config| config.get("problem")?.get("arm").or(config.get("arm")))
    else {
        return Ok(WIDOWX);
    };
    let refuse = |found: String| {
        let place = Place::Path("$.provenance.config.problem.arm".to_owned());
        InputError::new(file, place, found, "an arm as `tpg-train config widowx` prints, or none")
    };
    let arm = ArmDescription::deserialize(text).map_err(|error| refuse(error.to_string()))?;
    arm.check().map_err(|Finding { key, found, .. }| refuse(format!("{key} = {found}")))?;
    Ok(Arm::from(&arm))
}

/// The problem without its sources: a configuration's tolerance and action limit, or the paper's.
fn problem_of(start: Start, config: Option<&Config>) -> ArmProblem {
    let usual = ArmProblem::new(start, Vec::new());
    config.map_or(usual, |config| ArmProblem { sources: Vec::new(), ..config.problem(start) })
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
