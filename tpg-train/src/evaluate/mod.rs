//! `tpg-train eval`: lets a policy act on test episodes and reports how they end.

mod law;
mod linear;
mod report;

use report::Against;
pub use report::EvaluationReport;

use crate::hybrid::rollout::{Acting, HybridResult, Policies};
use crate::hybrid::setting::{Hybrid, Setting};
use crate::hybrid::shared::{Episodes, Shared};
use crate::run_args::{command_line, print};
use crate::sac::network::Network;
use clap::Args;
use std::path::{Path, PathBuf};
use tpg_engine::{EpisodeResult, TaskSet};
use tpg_graph::Graph;
use tpg_graph::error::{InputError, Place};
use tpg_graph::files::{read_graph, read_text};
use tpg_problems::{Problem, ProblemName};
use tpg_runtime::switch::Driver;

/// Let a policy act and count how its episodes end.
#[derive(Clone, Debug, Args)]
pub(crate) struct EvalArgs {
    /// The problem
    #[arg(long, value_enum)]
    pub problem: ProblemName,
    /// A graph; with --policy too, one that asks the network
    #[arg(long, value_name = "GRAPH", required_unless_present_any = ["policy", "hybrid"])]
    pub tpg: Option<PathBuf>,
    /// Use this configuration's problem settings [default: those that the policy was trained with]
    #[arg(long, value_name = "FILE")]
    pub config: Option<PathBuf>,
    /// A policy.safetensors or policy.q.json, or a controller that the problem brings: on the arm `planner`, `nearest-goal` or
    /// `closed-form`
    #[arg(long, value_name = "FILE")]
    pub policy: Option<String>,
    /// A hybrid.toml: graph, network, and when they take turns
    #[arg(long, value_name = "FILE", conflicts_with_all = ["tpg", "policy"])]
    pub hybrid: Option<PathBuf>,
    /// Episodes from a file, as `tpg-train targets` prints them for some problems
    #[arg(long, value_name = "CSV", conflicts_with = "episodes")]
    pub targets: Option<PathBuf>,
    /// The number of test episodes
    #[arg(long, value_name = "N", default_value_t = 1000)]
    pub episodes: usize,
    /// The seed of the test episodes
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,
    /// Also run another policy on the same episodes, and print the difference in score with its 95 % interval: a graph, a
    /// network, a hybrid.toml, a file of formulas, a controller that comes with the problem, or `linear`: weighted sums, trained
    /// as the run of --tpg was and kept in its folder
    #[arg(long, value_name = "POLICY")]
    pub against: Option<String>,
    /// Print one JSON object instead of a table
    #[arg(long)]
    pub json: bool,
}

/// A policy that is asked for, with the name that the report shows.
enum Evaluated {
    Policies(String, Policies),
    /// A controller that the problem brings.
    Controller(String),
}

/// Does what the arguments ask, and prints it.
///
/// # Errors
/// If the policy or the episodes cannot be read, or do not go with the problem.
pub(crate) fn eval(args: &EvalArgs) -> Result<(), InputError> {
    let (policy, problem) = asked(args)?;
    let (mut report, endings) = played(args, &policy, &problem)?;
    if let Some(other) = &args.against {
        let args = alone(args, other, &problem)?;
        let (policy, its) = asked(&args)?;
        if !problem.has_same_episodes(&its) {
            let accepted = "a policy for the same settings of the problem; --config FILE gives them to both";
            return Err(command_line(format!("--against {other}, which brings other settings"), accepted));
        }
        let (other, theirs) = played(&args, &policy, &its)?;
        report.against = Some(Box::new(Against::new(other, &endings, &theirs)));
    }
    let text = if args.json {
        serde_json::to_string(&report).expect("a report is plain data") + "\n"
    } else {
        report.to_table()
    };
    print(&text)
}

/// Returns the arguments that let another policy do the same episodes.
///
/// # Errors
/// If there is neither such a file nor such a controller.
fn alone(args: &EvalArgs, other: &str, problem: &Problem) -> Result<EvalArgs, InputError> {
    let mut alone = EvalArgs { tpg: None, policy: None, hybrid: None, against: None, ..args.clone() };
    match other {
        linear::LINEAR => alone.tpg = Some(linear::trained(args)?),
        _ if !Path::new(other).exists() && !problem.controllers().contains(&other) => {
            let mut accepted = "a graph.json, a TOML file with [law], a network, a hybrid.toml, linear".to_owned();
            problem.controllers().iter().for_each(|controller| accepted += &format!(", {controller}"));
            return Err(command_line(format!("--against {other}: no such file"), accepted));
        }
        _ if problem.controllers().contains(&other) => alone.policy = Some(other.to_owned()),
        _ if other.ends_with(".toml") && !law::is_law(other) => alone.hybrid = Some(other.into()),
        _ if other.ends_with(".q.json") || other.ends_with(".safetensors") => alone.policy = Some(other.to_owned()),
        _ => alone.tpg = Some(other.into()),
    }
    Ok(alone)
}

/// Lets a policy do the episodes that the arguments ask for.
fn played(
    args: &EvalArgs,
    policy: &Evaluated,
    problem: &Problem,
) -> Result<(EvaluationReport, Vec<EpisodeResult>), InputError> {
    let episodes =
        Episodes { set: TaskSet::Test, count: args.episodes, seed: args.seed, file: args.targets.as_deref() };
    match policy {
        Evaluated::Policies(name, policies) => play(problem, name, policies.acting(), episodes),
        Evaluated::Controller(name) => {
            let endings = problem.controlled(name, &episodes.in_problem(problem)?).unwrap_or_default();
            let done = HybridResult::alone(endings, Driver::Sac);
            let report = EvaluationReport::new(problem, name, episodes, &done, None);
            Ok((report, done.endings))
        }
    }
}

/// Reads the policies that the arguments name, and the problem that they are tested on.
fn asked(args: &EvalArgs) -> Result<(Evaluated, Problem), InputError> {
    let (config, from_file) = (args.config.as_deref(), args.config.is_none());
    let read = |path: &Path| match path.extension().is_some_and(|extension| extension == "toml") {
        true => {
            let environment = problem_for(args.problem, config, None)?.environment::<f32>();
            law::read(path, environment.sources(), environment.actions())
        }
        false => read_graph(path),
    };
    let problem_for = |graph: Option<&(String, Graph)>| {
        problem_for(args.problem, config, graph.map(|(file, graph)| (file.as_str(), graph)))
    };
    let joined = |graph: Option<&(String, Graph)>, (file, network): &(String, Network)| {
        let settings = network.settings();
        same_problem(args.problem.name(), file, network)?;
        problem_for(graph)?.joined(file, &settings, from_file, graph.is_some())
    };
    match (&args.hybrid, &args.tpg, &args.policy) {
        (Some(path), ..) => {
            let hybrid = Hybrid::read(path)?;
            let (asked, named) = (args.problem.name(), hybrid.problem.as_deref());
            if let Some(other) = named.filter(|name| *name != asked) {
                let found = format!("a hybrid for {other} with --problem {asked}");
                return Err(command_line(found, "the same problem twice"));
            }
            let problem = joined(Some(&hybrid.graph), &hybrid.network)?;
            Ok((Evaluated::Policies(path.display().to_string(), Policies::Both(Box::new(hybrid))), problem))
        }
        (None, Some(graph), Some(actor)) => {
            let graph = (graph.display().to_string(), read(graph)?);
            let network = (actor.clone(), Network::read(Path::new(actor))?);
            let problem = joined(Some(&graph), &network)?;
            if graph.1.asks().next().is_none() {
                let found = format!("{} with --policy {actor}: it asks nobody", graph.0);
                return Err(command_line(
                    found,
                    "a graph that asks, or --hybrid FILE, which says when the network takes over",
                ));
            }
            let setting = Setting::only_asks();
            let name = format!("{} with {actor}: {}", graph.0, setting.sentence());
            let hybrid = Hybrid { problem: None, graph, network, setting };
            Ok((Evaluated::Policies(name, Policies::Both(Box::new(hybrid))), problem))
        }
        (None, Some(path), None) => {
            let graph = (path.display().to_string(), read(path)?);
            let problem = problem_for(Some(&graph))?;
            Ok((Evaluated::Policies(graph.0.clone(), Policies::Graph(Box::new(graph))), problem))
        }
        (None, None, Some(file)) => {
            let problem = problem_for(None)?;
            if problem.controllers().contains(&file.as_str()) {
                return Ok((Evaluated::Controller(file.clone()), problem));
            }
            let network = (file.clone(), Network::read(Path::new(file))?);
            let problem = joined(None, &network)?;
            Ok((Evaluated::Policies(file.clone(), Policies::Network(network)), problem))
        }
        (None, None, None) => Err(command_line("no policy", "--tpg GRAPH, --policy FILE or --hybrid FILE")),
    }
}

/// Lets policies do episodes of a problem, such as [an environment of your own](crate::hybrid::shared::OwnProblem), and reports
/// how they end; `name` is the policy's in the report.
///
/// ```
/// use tpg_engine::{Choices, TaskSet};
/// use tpg_graph::Graph;
/// use tpg_problems::CartPole;
/// use tpg_runtime::ops::Own;
/// use tpg_train::{Acting, Episodes, OwnProblem, evaluate};
///
/// // Pushes to the side to which the pole is falling: `right` is bid theta + omega, `left` is bid 0.
/// let text = r#"{
///     "format": "tpg-graph", "version": 1, "scalar": "f32", "maths": "own", "registers": 1,
///     "sources": [
///         { "name": "theta", "length": 1, "unit": "rad", "ranges": [[-1, 1]] },
///         { "name": "omega", "length": 1, "unit": "rad/s", "ranges": [[-9, 9]] }
///     ],
///     "instructions": ["add"],
///     "actions": [{ "id": 0, "name": "left" }, { "id": 1, "name": "right" }],
///     "root": 0,
///     "teams": [{ "id": 0, "edges": [{ "program": 0, "action": 0 }, { "program": 1, "action": 1 }] }],
///     "programs": [
///         { "id": 0, "lines": [] },
///         { "id": 1, "lines": [{ "to": 0, "op": "add", "args": ["theta[0]", "omega[0]"] }] }
///     ]
/// }"#;
/// let graph = ("falling.json".to_owned(), Graph::from_json("falling.json", text)?);
/// let pole = OwnProblem::<f32, Own, _>::new("pole", Choices::new(CartPole, None).expect("two actions"));
/// let episodes = Episodes { set: TaskSet::Test, count: 10, seed: 1, file: None };
/// let report = evaluate(&pole, &graph.0, Acting::Graph(&graph), episodes)?;
/// assert!(report.mean_score > 100.0, "{}", report.mean_score);
/// # Ok::<(), tpg_graph::error::InputError>(())
/// ```
///
/// # Errors
/// If a policy or its setting does not fit the problem.
pub fn evaluate(
    problem: &dyn Shared,
    name: &str,
    acting: Acting<'_>,
    episodes: Episodes<'_>,
) -> Result<EvaluationReport, InputError> {
    play(problem, name, acting, episodes).map(|(report, _)| report)
}

fn play(
    problem: &dyn Shared,
    name: &str,
    acting: Acting<'_>,
    episodes: Episodes<'_>,
) -> Result<(EvaluationReport, Vec<EpisodeResult>), InputError> {
    let hybrid = match acting {
        Acting::Both((_, graph), _, setting) => {
            let facts = problem.facts();
            setting.check_on(&problem.name(), facts.guards, facts.has_key)?;
            Some(graph)
        }
        _ => None,
    };
    let done = problem.play(acting, episodes)?;
    Ok((EvaluationReport::new(problem, name, episodes, &done, hybrid), done.endings))
}

/// Returns a problem with the settings of a configuration, or the one that a graph is tested on without.
///
/// # Errors
/// If the configuration cannot be read, or is for another problem.
pub(crate) fn problem_for(
    name: ProblemName,
    config: Option<&Path>,
    graph: Option<(&str, &Graph)>,
) -> Result<Problem, InputError> {
    let Some(path) = config else { return Problem::tested(name, graph) };
    let text = read_text(path, "a configuration as `tpg-train config` prints")?;
    let problem = Problem::from_toml(&path.display().to_string(), &text)?;
    if problem.name() == name {
        return Ok(problem.for_tests());
    }
    let found = format!("--problem {} with a configuration for {}", name.name(), problem.name().name());
    Err(command_line(found, "the same problem twice"))
}

/// Refuses a network that names another problem than the one asked for; `file` is the network's.
///
/// # Errors
/// If it does.
pub(crate) fn same_problem(asked: &str, file: &str, network: &Network) -> Result<(), InputError> {
    match network.settings().get("name").and_then(toml::Value::as_str) {
        Some(name) if !Problem::share_policies(name, asked) => {
            let found = format!("a policy for {name}");
            Err(InputError::new(file, Place::Whole, found, format!("one for {asked}")))
        }
        _ => Ok(()),
    }
}
