//! `tpg-train eval`: lets a policy act on test episodes and counts how they end.

use crate::engine::{Ending, Environment, Lanes, Options, Plan, Policy};
use crate::environments::{ArmDescription, ArmEnvironment, ArmProblem, ArmScalar, ArmTask, arm::OUTCOMES};
use crate::evolution::config::Config;
use crate::evolution::config::Shield;
use crate::hybrid::actor::Actor;
use crate::hybrid::graph::read_graph;
use crate::hybrid::setting::{Detector, HandBack, HybridFile, Setting};
use crate::hybrid::trial::{self, HybridTrial};
use crate::targets::{self, Set, Start};
use crate::trial::{Failures, Trial};
use clap::Args;
use serde::{Deserialize as _, Serialize};
use std::collections::BTreeMap;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::time::Instant;
use tpg_codegen::error::{InputError, Place};
use tpg_codegen::graph::Graph;
use tpg_codegen::in_arithmetic_of;
use tpg_runtime::arm::{Arm, WIDOWX};
use tpg_runtime::hybrid::{Cause, Guard};
use tpg_runtime::observation::shield::{SHIELDED, STEP, action as action_of};
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

/// What `eval --json` prints. Rates are between 0 and 1.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// `fs` or `rs`.
    pub problem: String,
    /// The policy's file.
    pub policy: String,
    /// `none`, `limits` or `limits-and-collision`: the actions that the policy cannot choose.
    pub shield: String,
    /// Episodes.
    pub episodes: usize,
    /// The seed of the test set; absent for a file of episodes.
    pub seed: Option<u64>,
    /// Part of the episodes that reached their target.
    pub success_rate: f64,
    /// Part of the episodes that an invalid action ended.
    pub collision_rate: f64,
    /// Mean distance at the end.
    pub mean_distance_mm: f64,
    /// Median distance at the end.
    pub median_distance_mm: f64,
    /// Mean number of actions.
    pub mean_actions: f64,
    /// Mean number of actions of the episodes that reached their target.
    pub mean_actions_on_success: f64,
    /// Part of the actions that the TPG chose: 1 but for a hybrid.
    pub tpg_action_ratio: f64,
    /// Time of one action on this machine, all lanes together: policy and environment.
    pub ns_per_action: f64,
    /// Episodes by how they failed.
    pub failures: BTreeMap<String, usize>,
    /// Hand-overs an episode to a hybrid's network, by cause; absent for other policies.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hand_overs: Option<BTreeMap<String, f64>>,
}

impl Report {
    /// Of the endings of some episodes; `seconds` is what they took.
    pub fn new(
        problem: Start,
        policy: &str,
        shield: Shield,
        seed: Option<u64>,
        endings: &[Ending],
        outcomes: &[&str],
        seconds: f64,
    ) -> Self {
        let share = |count: usize| count as f64 / endings.len().max(1) as f64;
        let of = |names: &[&str]| endings.iter().filter(|e| names.contains(&outcomes[usize::from(e.outcome)])).count();
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len().max(1) as f64;
        let mut distances: Vec<f64> = endings.iter().map(|ending| ending.error).collect();
        distances.sort_by(f64::total_cmp);
        let actions: Vec<f64> = endings.iter().map(|ending| f64::from(ending.actions)).collect();
        let on_success: Vec<f64> =
            (endings.iter().filter(|ending| ending.success)).map(|ending| f64::from(ending.actions)).collect();
        let failures = outcomes.iter().filter(|&&name| name != "reached").map(|&name| (name.to_owned(), of(&[name])));
        let middle = distances.len() / 2;
        let median = if distances.len() % 2 == 1 {
            distances[middle]
        } else if middle > 0 {
            0.5 * (distances[middle - 1] + distances[middle])
        } else {
            0.0
        };
        Self {
            problem: match problem {
                Start::Fs => "fs".to_owned(),
                Start::Rs => "rs".to_owned(),
            },
            policy: policy.to_owned(),
            shield: shield.name().to_owned(),
            episodes: endings.len(),
            seed,
            success_rate: share(endings.iter().filter(|ending| ending.success).count()),
            collision_rate: share(of(&["joint_limit", "table", "base"])),
            mean_distance_mm: mean(&distances),
            median_distance_mm: median,
            mean_actions: mean(&actions),
            mean_actions_on_success: mean(&on_success),
            tpg_action_ratio: 1.0,
            ns_per_action: seconds * 1e9 / actions.iter().sum::<f64>().max(1.0),
            failures: failures.collect(),
            hand_overs: None,
        }
    }

    /// Of a policy that is no graph; `seconds` is what its episodes took.
    pub fn of_trial(trial: &Trial, policy: &str, seed: Option<u64>, seconds: f64) -> Self {
        let Failures { cycle, stop, joint_limit, table, base, timeout } = trial.failures;
        let failures = [
            ("base", base),
            ("cycle", cycle),
            ("joint_limit", joint_limit),
            ("stop", stop),
            ("table", table),
            ("timeout", timeout),
        ];
        Self {
            problem: match trial.problem {
                Start::Fs => "fs".to_owned(),
                Start::Rs => "rs".to_owned(),
            },
            policy: policy.to_owned(),
            shield: Shield::None.name().to_owned(),
            episodes: trial.episodes,
            seed,
            success_rate: trial.success_rate,
            collision_rate: trial.collision_rate,
            mean_distance_mm: trial.mean_distance_mm,
            median_distance_mm: trial.median_distance_mm,
            mean_actions: trial.mean_actions,
            mean_actions_on_success: trial.mean_actions_on_success,
            tpg_action_ratio: 0.0,
            ns_per_action: seconds * 1e9 / (trial.mean_actions * trial.episodes as f64).max(1.0),
            failures: failures.map(|(name, count)| (name.to_owned(), count)).into(),
            hand_overs: None,
        }
    }

    /// Of a graph and a network that share the arm; `seconds` is what their episodes took.
    pub fn of_hybrid(done: &HybridTrial, policy: &str, seed: Option<u64>, seconds: f64) -> Self {
        let causes = Cause::ALL.map(|cause| cause.name().to_owned());
        Self {
            tpg_action_ratio: done.tpg_action_ratio,
            hand_overs: Some(causes.into_iter().zip(done.hand_overs).collect()),
            ..Self::of_trial(&done.trial, policy, seed, seconds)
        }
    }

    /// The report as a table for people.
    pub fn to_table(&self) -> String {
        let failures: Vec<String> = self
            .failures
            .iter()
            .filter(|(_, count)| **count > 0)
            .map(|(name, count)| format!("{name} {count}"))
            .collect();
        format!(
            "{} on {}, {} episodes\n\
             shield         {}\n\
             success        {:.1} %\n\
             collision      {:.1} %\n\
             distance       {:.2} mm mean, {:.2} mm median\n\
             actions        {:.0} mean, {:.0} mean on success\n\
             failures       {}\n\
             {}\
             time           {:.1} ns per action, all lanes together\n",
            self.policy,
            self.problem,
            self.episodes,
            self.shield,
            100.0 * self.success_rate,
            100.0 * self.collision_rate,
            self.mean_distance_mm,
            self.median_distance_mm,
            self.mean_actions,
            self.mean_actions_on_success,
            failures.join(", "),
            self.hand_overs.as_ref().map_or(String::new(), |causes| {
                let causes: Vec<String> = causes.iter().map(|(name, count)| format!("{name} {count:.2}")).collect();
                let ratio = 100.0 * self.tpg_action_ratio;
                format!("by the graph   {ratio:.1} % of the actions; hand-overs an episode: {}\n", causes.join(", "))
            }),
            self.ns_per_action
        )
    }
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
