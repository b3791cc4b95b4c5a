//! `tpg-train eval`: lets a policy act on test episodes and counts how they end.

mod report;

pub use report::Report;

use crate::engine::{Ending, Environment, Lanes, Options, Plan, Policy};
use crate::environments::{ArmDescription, ArmEnvironment, ArmProblem, ArmScalar, ArmTask, arm::OUTCOMES};
use crate::evolution::config::Config;
use crate::evolution::config::Shield;
use crate::hybrid::actor::Actor;
use crate::hybrid::graph::read_graph;
use crate::hybrid::setting::{Detector, HandBack, HybridFile, Setting};
use crate::hybrid::trial;
use crate::targets::{self, Set, Start};
use clap::Args;
use serde::Deserialize as _;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::time::Instant;
use tpg_arm::hybrid::Guard;
use tpg_arm::observation::shield::{SHIELDED, STEP, action as action_of};
use tpg_arm::{Arm, WIDOWX};
use tpg_graph::Graph;
use tpg_graph::error::{InputError, Place};
use tpg_graph::in_arithmetic_of;
use tpg_runtime::ops::Maths;

/// Let a policy act and count how its episodes end.
#[derive(Clone, Debug, Args)]
pub struct EvalArgs {
    /// The problem: fixed or random start
    #[arg(long, value_enum)]
    pub problem: Start,
    /// A graph; with --policy too, the two share the arm
    #[arg(long, value_name = "GRAPH", required_unless_present_any = ["policy", "hybrid"])]
    pub tpg: Option<PathBuf>,
    /// The arm, tolerance and action limit of this configuration. Default: the arm that the graph was trained for (the
    /// WidowX where it does not say), 3 mm, 1707 or 3414 actions
    #[arg(long, value_name = "FILE")]
    pub config: Option<PathBuf>,
    /// A policy.safetensors, a policy.q.json, or the classical `planner` or `nearest-goal`
    #[arg(long, value_name = "FILE")]
    pub policy: Option<String>,
    /// A hybrid.toml: graph, actor, and how they share the arm
    #[arg(long, value_name = "FILE", conflicts_with_all = ["tpg", "policy"])]
    pub hybrid: Option<PathBuf>,
    /// With --tpg and --policy: actions of the network before the graph is asked again, or `never`
    #[arg(long, value_name = "N", default_value = "100")]
    pub hand_back_after: HandBack,
    /// With --tpg and --policy: the network takes over when the hand is further away than its best by this; `inf`
    #[arg(long, value_name = "D", default_value_t = 20.0)]
    pub separation_mm: f64,
    /// With --tpg and --policy: none, joint-limits, collisions or both
    #[arg(long, value_name = "GUARD", default_value = "none", value_parser = crate::hybrid::command::guard)]
    pub guard: Guard,
    /// With --tpg and --policy: how cycles of the graph are noticed
    #[arg(long, value_enum, default_value_t = Detector::Visited)]
    pub cycle_detector: Detector,
    /// Episodes from a file
    #[arg(long, value_name = "CSV", conflicts_with = "episodes")]
    pub targets: Option<PathBuf>,
    /// So many episodes of the test set of --seed
    #[arg(long, value_name = "N", default_value_t = 1000)]
    pub episodes: usize,
    /// The seed of the test set
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,
    /// Add a shield to a graph that has none: actions that would be refused cannot be chosen
    #[arg(long, value_enum, default_value_t = Shield::None, conflicts_with_all = ["policy", "hybrid"])]
    pub shield: Shield,
    /// One JSON object instead of a table
    #[arg(long)]
    pub json: bool,
}

/// Does what the arguments ask, and prints it.
///
/// # Errors
/// If the graph or the episodes cannot be read, or the graph is not one for the arm.
pub fn eval(args: &EvalArgs) -> Result<(), InputError> {
    let config = args.config.as_deref().map(Config::read).transpose()?;
    let arm = arm_for(args, config.as_ref())?;
    let (tasks, seed) = match &args.targets {
        Some(path) => (read_tasks(&arm, path)?, None),
        None => (targets::tasks(&arm, args.seed, Set::Test, args.problem, args.episodes), Some(args.seed)),
    };
    let report = match (&args.hybrid, &args.tpg, &args.policy) {
        (Some(path), ..) => {
            let file = HybridFile::read(path)?;
            let beside = |name: &str| path.parent().unwrap_or(Path::new("")).join(name);
            let setting = file.setting().map_err(|(key, found, accepted)| {
                InputError::new(path.display().to_string(), Place::Path(key), found, accepted)
            })?;
            let (graph, actor) = (beside(&file.graph), beside(&file.actor));
            of_hybrid(&path.display().to_string(), &graph, &actor, &setting, args.problem, &tasks, seed)?
        }
        (None, Some(graph), Some(actor)) => {
            let setting = Setting {
                hand_back_after: args.hand_back_after,
                separation_mm: args.separation_mm,
                guard: args.guard,
                detector: args.cycle_detector,
            };
            let name = format!("{} with {actor}: {}", graph.display(), setting.sentence());
            of_hybrid(&name, graph, Path::new(actor), &setting, args.problem, &tasks, seed)?
        }
        (None, Some(path), None) => {
            let problem = problem_of(args.problem, config.as_ref());
            of_graph(&path.display().to_string(), &read_graph(path)?, &arm, problem, args.shield, tasks, seed)?
        }
        (None, None, policy) => {
            let policy = policy.as_deref().unwrap_or("planner");
            let began = Instant::now();
            let trial = crate::sac::evaluate::trial_of(policy, args.problem, &tasks)?;
            Report::of_trial(&trial, policy, seed, began.elapsed().as_secs_f64())
        }
    };
    let text = if args.json {
        serde_json::to_string(&report).expect("a report is plain data") + "\n"
    } else {
        report.to_table()
    };
    let written = std::io::stdout().lock().write_all(text.as_bytes());
    written.map_err(|error| InputError::io("<stdout>".as_ref(), &error, "an open pipe"))
}

fn of_hybrid(
    name: &str,
    graph: &Path,
    actor: &Path,
    setting: &Setting,
    start: Start,
    tasks: &[targets::Task],
    seed: Option<u64>,
) -> Result<Report, InputError> {
    let (file, graph, actor) = (graph.display().to_string(), read_graph(graph)?, Actor::read(actor)?);
    let began = Instant::now();
    let done = trial::run(&file, &graph, &actor, setting, start, tasks)?;
    Ok(Report::of_hybrid(&done, name, seed, began.elapsed().as_secs_f64()))
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
        return Err(InputError::new("<command line>", Place::Whole, "another arm or --config", accepted));
    }
    Ok(arm)
}

/// The arm that a graph was trained for, as its provenance says; the WidowX where that says nothing.
///
/// # Errors
/// If what it says is no arm.
pub fn arm_of(file: &str, graph: &Graph) -> Result<Arm<f64>, InputError> {
    let Some(text) = graph.provenance().config.as_ref().and_then(|config| config.get("arm")) else { return Ok(WIDOWX) };
    let refuse = |found: String| {
        let place = Place::Path("$.provenance.config.arm".to_owned());
        InputError::new(file, place, found, "an arm as `tpg-train config widowx` prints, or none")
    };
    let arm = ArmDescription::deserialize(text).map_err(|error| refuse(error.to_string()))?;
    arm.check().map_err(|(key, found, _)| refuse(format!("{key} = {found}")))?;
    Ok(Arm::from(&arm))
}

/// What a graph is asked for, but for its sources: a configuration's tolerance and action limit, or the paper's.
fn problem_of(start: Start, config: Option<&Config>) -> ArmProblem {
    let usual = ArmProblem::new(start, Vec::new());
    config.map_or(usual.clone(), |config| ArmProblem { start, sources: Vec::new(), ..config.arm_problem() })
}

fn of_graph(
    file: &str,
    graph: &Graph,
    arm: &Arm<f64>,
    problem: ArmProblem,
    added: Shield,
    tasks: Vec<targets::Task>,
    seed: Option<u64>,
) -> Result<Report, InputError> {
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
    Ok(Report::new(start, file, shield, seed, &endings, &OUTCOMES, seconds))
}

/// How a graph's episodes end, in its own scalar and maths; `problem`'s sources are the graph's.
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

fn read_tasks(arm: &Arm<f64>, path: &Path) -> Result<Vec<targets::Task>, InputError> {
    targets::read_csv(arm, path).map_err(input_error)
}

/// What is wrong with a file of episodes, as this program says it.
pub fn input_error(error: targets::Error) -> InputError {
    match error {
        targets::Error::Io { path, source } => InputError::io(&path, &source, "a file of episodes"),
        targets::Error::Content { path, line, found, accepted } => {
            InputError::new(path.display().to_string(), Place::Line(line as usize), found, accepted)
        }
    }
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
    let mut policy = Policy::from(graph);
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
    let plan = Plan::new::<M>(&policy, &environment.sources(), Options::default());
    Ok(Lanes::<S, M, _>::new(&environment, Options::default()).run(&plan, tasks))
}
