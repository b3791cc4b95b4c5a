//! `tpg-train eval`: lets a policy act on test episodes and reports how they end.

mod law;
mod report;

use report::Against;
pub use report::EvaluationReport;

use crate::hybrid::rollout::{Acting, HybridResult, Policies};
use crate::hybrid::setting::{Hybrid, Setting};
use crate::hybrid::shared::{Episodes, Shared};
use crate::run_args::command_line;
use crate::sac::network::Network;
use clap::Args;
use std::path::{Path, PathBuf};
use std::slice::from_ref;
use tpg_engine::TaskSet;
use tpg_graph::Graph;
use tpg_graph::command::print;
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
    /// Episodes from a file, as generated/test-targets holds them for some problems
    #[arg(long, value_name = "CSV", conflicts_with = "episodes")]
    pub targets: Option<PathBuf>,
    /// The number of test episodes
    #[arg(long, value_name = "N", default_value_t = 1000)]
    pub episodes: usize,
    /// The seed of the test episodes
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,
    /// Also run another policy on the same episodes, and print the difference in score with its 95 % interval: a graph, a
    /// network, a hybrid.toml, a file of formulas, or a controller that comes with the problem
    #[arg(long, value_name = "POLICY")]
    pub against: Option<String>,
    /// Print one JSON object instead of a table
    #[arg(long)]
    pub json: bool,
}

/// A policy that is asked for, and its problem.
struct Evaluated {
    /// The name that the report shows.
    name: String,
    /// The policies; none for a controller that the problem brings.
    policies: Option<Policies>,
    problem: Problem,
}

/// Does what the arguments ask, and prints it.
///
/// # Errors
/// If the policy or the episodes cannot be read, or do not go with the problem.
pub(crate) fn eval(args: &EvalArgs) -> Result<(), InputError> {
    let policy = asked(args)?;
    let mut report = played(args, &policy)?;
    if let Some(other) = &args.against {
        let args = alone(args, other, &policy.problem)?;
        let its = asked(&args)?;
        if !policy.problem.has_same_episodes(&its.problem) {
            let accepted = "a policy for the same settings of the problem; --config FILE gives them to both";
            return Err(command_line(format!("--against {other}, which brings other settings"), accepted));
        }
        report.against = Some(Box::new(Against::new(&report.endings, played(&args, &its)?)));
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
    let is_controller = problem.controllers().contains(&other);
    if !is_controller && !Path::new(other).exists() {
        let mut accepted = "a graph.json, a TOML file with [law], a network, a hybrid.toml".to_owned();
        problem.controllers().iter().for_each(|controller| accepted += &format!(", {controller}"));
        return Err(command_line(format!("--against {other}: no such file"), accepted));
    }
    if is_controller || other.ends_with(".q.json") || other.ends_with(".safetensors") {
        alone.policy = Some(other.to_owned());
    } else if other.ends_with(".toml") && !law::is_law(other) {
        alone.hybrid = Some(other.into());
    } else {
        alone.tpg = Some(other.into());
    }
    Ok(alone)
}

/// Lets a policy do the episodes that the arguments ask for.
fn played(args: &EvalArgs, Evaluated { name, policies, problem }: &Evaluated) -> Result<EvaluationReport, InputError> {
    let episodes =
        Episodes { set: TaskSet::Test, count: args.episodes, seed: args.seed, file: args.targets.as_deref() };
    if let Some(policies) = policies {
        return evaluate(problem, name, policies.acting(), episodes);
    }
    let endings = problem.controlled(name, &episodes.in_problem(problem)?).unwrap_or_default();
    Ok(EvaluationReport::new(problem, name, episodes, HybridResult::alone(endings, Driver::Sac), None))
}

/// Reads the policies that the arguments name, and the problem that they are tested on.
fn asked(args: &EvalArgs) -> Result<Evaluated, InputError> {
    let problem = |graphs: &[(String, Graph)], networks: &[(String, Network)]| {
        problem_for(args.problem, args.config.as_deref(), graphs, networks)
    };
    if let Some(path) = &args.hybrid {
        let hybrid = Hybrid::read(path)?;
        let (asked, named) = (args.problem.name(), hybrid.problem.as_deref());
        if let Some(other) = named.filter(|name| *name != asked) {
            let found = format!("a hybrid for {other} with --problem {asked}");
            return Err(command_line(found, "the same problem twice"));
        }
        let problem = problem(from_ref(&hybrid.graph), from_ref(&hybrid.network))?;
        let policies = Some(Policies::Both(Box::new(hybrid)));
        return Ok(Evaluated { name: path.display().to_string(), policies, problem });
    }
    let bare = problem(&[], &[])?;
    let graph = |path: &PathBuf| {
        let is_law = path.extension().is_some_and(|extension| extension == "toml");
        let environment = bare.environment::<f32>();
        let law = || law::read(path, environment.sources(), environment.actions());
        Ok::<_, InputError>((path.display().to_string(), if is_law { law() } else { read_graph(path) }?))
    };
    let graph = args.tpg.as_ref().map(graph).transpose()?;
    if let (None, Some(name)) = (&graph, args.policy.clone().filter(|name| bare.controllers().contains(&name.as_str())))
    {
        return Ok(Evaluated { name, policies: None, problem: bare });
    }
    let network = |file: &String| Ok::<_, InputError>((file.clone(), Network::read(Path::new(file))?));
    let network = args.policy.as_ref().map(network).transpose()?;
    let problem = problem(graph.as_slice(), network.as_slice())?;
    let (name, policies) = match (graph, network) {
        (Some(graph), Some(network)) => {
            if graph.1.asks().next().is_none() {
                let found = format!("{} with --policy {}: it asks nobody", graph.0, network.0);
                let accepted = "a graph that asks, or --hybrid FILE, which says when the network takes over";
                return Err(command_line(found, accepted));
            }
            let setting = Setting::only_asks();
            let name = format!("{} with {}: {}", graph.0, network.0, setting.sentence());
            (name, Policies::Both(Box::new(Hybrid { problem: None, graph, network, setting })))
        }
        (Some(graph), None) => (graph.0.clone(), Policies::Graph(Box::new(graph))),
        (None, Some(network)) => (network.0.clone(), Policies::Network(network)),
        (None, None) => return Err(command_line("no policy", "--tpg GRAPH, --policy FILE or --hybrid FILE")),
    };
    Ok(Evaluated { name, policies: Some(policies), problem })
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
    let hybrid = match acting {
        Acting::Both((_, graph), _, setting) => {
            let facts = problem.facts();
            setting.check_on(&problem.name(), facts.guards, facts.has_key)?;
            Some(graph)
        }
        _ => None,
    };
    let done = problem.play(acting, episodes)?;
    Ok(EvaluationReport::new(problem, name, episodes, done, hybrid))
}

/// Returns the problem that policies are tested on: with the settings of a configuration, or those that they were trained with. Of
/// several networks, the first one's rules of tests hold for all.
///
/// # Errors
/// If the configuration cannot be read, or one of these is for another problem.
pub(crate) fn problem_for(
    name: ProblemName,
    config: Option<&Path>,
    graphs: &[(String, Graph)],
    networks: &[(String, Network)],
) -> Result<Problem, InputError> {
    let of_graph = |graph: Option<&(String, Graph)>| Problem::tested(name, graph.map(|(file, graph)| (&**file, graph)));
    let mut problem = match config {
        Some(path) => {
            let text = read_text(path, "a configuration as `tpg-train config` prints")?;
            let problem = Problem::from_toml(&path.display().to_string(), &text)?;
            if problem.name() != name {
                let found = format!("--problem {} with a configuration for {}", name.name(), problem.name().name());
                return Err(command_line(found, "the same problem twice"));
            }
            problem.for_tests()
        }
        None => of_graph(graphs.first())?,
    };
    for graph in graphs.iter().skip(1).filter(|_| config.is_none()) {
        if of_graph(Some(graph))? != problem {
            let accepted = "one as the first, or --config";
            return Err(InputError::new(&graph.0, Place::Whole, "a graph for another arm", accepted));
        }
    }
    for (place, (file, network)) in networks.iter().enumerate().rev() {
        let settings = network.settings();
        let trained_on = settings.get("name").and_then(toml::Value::as_str);
        if let Some(other) = trained_on.filter(|other| !Problem::share_policies(other, name.name())) {
            let found = format!("a policy for {other}");
            return Err(InputError::new(file, Place::Whole, found, format!("one for {}", name.name())));
        }
        problem = problem.joined(file, &settings, place == 0 && config.is_none(), !graphs.is_empty())?;
    }
    Ok(problem)
}
