//! `tpg-train eval`: lets a policy act on test episodes and reports how they end.
//!
//! | module | subject |
//! | --- | --- |
//! | [`arm`] | graphs, networks, hybrids and planners on the arm |
//! | [`graph`] | a graph on any environment |
//! | [`network`] | a network on any built-in problem |
//! | [`hybrid`] | a hybrid on any problem but the arm's |
//! | [`EvaluationReport`] | the figures |

pub mod arm;
pub mod graph;
pub mod hybrid;
pub mod network;
mod report;

pub(crate) use report::mean_with_confidence;
pub use report::{ArmFigures, Asks, EvaluationReport, HybridFigures, confidence};

use crate::files::{read_graph, read_text};
use crate::hybrid::command::setting_of;
use crate::hybrid::setting::{Detector, Hybrid};
use crate::hybrid::span::Span;
use crate::run_args::command_line;
use crate::sac::network::Network;
use clap::Args;
use std::path::{Path, PathBuf};
use tpg_arm::hybrid::Guard;
use tpg_graph::error::{InputError, Place};
use tpg_problems::arm::Shield;
use tpg_problems::{ContinuousProblem, Problem, ProblemName};

/// Let a policy act and count how its episodes end.
#[derive(Clone, Debug, Args)]
pub struct EvalArgs {
    /// The problem
    #[arg(long, value_enum)]
    pub problem: ProblemName,
    /// A graph; with --policy too, the graph hands over to the network, or asks it
    #[arg(long, value_name = "GRAPH", required_unless_present_any = ["policy", "hybrid"])]
    pub tpg: Option<PathBuf>,
    /// The problem's settings of this configuration. Default: those of the problem; for the arm, the arm that the policy was
    /// trained for (the WidowX where it does not say), and for a network its tests' settings
    #[arg(long, value_name = "FILE")]
    pub config: Option<PathBuf>,
    /// A policy.safetensors or policy.q.json; on the arm also the classical `planner`, `nearest-goal` or `closed-form`
    #[arg(long, value_name = "FILE")]
    pub policy: Option<String>,
    /// A hybrid.toml: graph, network, and when they take turns
    #[arg(long, value_name = "FILE", conflicts_with_all = ["tpg", "policy"])]
    pub hybrid: Option<PathBuf>,
    /// With --tpg and --policy: actions of the network before the graph takes over again, or `never`
    #[arg(long, value_name = "N", default_value = "100")]
    pub hand_back_after: Span,
    /// With --tpg and --policy, not on the arm: the network takes over when the distance to the goal exceeds its least by
    /// this, in the problem's own unit [default: inf]
    #[arg(long, value_name = "D")]
    pub separation: Option<f64>,
    /// With --tpg and --policy, not on the arm: the network takes over after that many actions without progress [default:
    /// never]
    #[arg(long, value_name = "N")]
    pub patience: Option<Span>,
    /// With --tpg and --policy, on the arm: the network takes over when the hand is further away than its best by this;
    /// `inf` [default: 20]
    #[arg(long, value_name = "D")]
    pub separation_mm: Option<f64>,
    /// With --tpg and --policy, on the arm: none, joint-limits, collisions or both [default: none]
    #[arg(long, value_name = "GUARD", value_parser = crate::hybrid::command::guard)]
    pub guard: Option<Guard>,
    /// With --tpg and --policy: method of detecting that the graph cycles [default: visited on the arm, else none]
    #[arg(long, value_enum)]
    pub cycle_detector: Option<Detector>,
    /// The arm's episodes from a file, as `tpg-train targets` prints them
    #[arg(long, value_name = "CSV", conflicts_with = "episodes")]
    pub targets: Option<PathBuf>,
    /// The number of test episodes
    #[arg(long, value_name = "N", default_value_t = 1000)]
    pub episodes: usize,
    /// The seed of the test episodes
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
/// If the policy or the episodes cannot be read, or do not go with the problem.
pub fn eval(args: &EvalArgs) -> Result<(), InputError> {
    let report = match args.problem.start() {
        Some(start) => arm::evaluate(args, start)?,
        None => on_a_problem(args)?,
    };
    let text = if args.json {
        serde_json::to_string(&report).expect("a report is plain data") + "\n"
    } else {
        report.to_table()
    };
    let written = tpg_graph::command::print(&text);
    written.map_err(|error| InputError::io("<stdout>".as_ref(), &error, "an open pipe"))
}

/// A graph, a network or a hybrid on a problem that is not the arm's.
fn on_a_problem(args: &EvalArgs) -> Result<EvaluationReport, InputError> {
    let name = args.problem.name();
    let of_the_arm = (args.targets.is_some() && args.problem != ProblemName::Dodge)
        || args.separation_mm.is_some()
        || args.guard.is_some();
    if of_the_arm || args.shield != Shield::None {
        let found = format!("an option of the arm's with --problem {name}");
        let accepted = "--tpg GRAPH, --policy FILE, both, or --hybrid FILE; --config, --episodes, --seed; with both --separation, \
                        --patience, --cycle-detector and --hand-back-after";
        return Err(command_line(found, accepted));
    }
    let config = args.config.as_deref();
    if args.targets.is_some() && (args.tpg.is_none() || args.policy.is_some()) {
        return Err(command_line("--targets without a graph alone", "--tpg GRAPH with --targets CSV"));
    }
    match (&args.hybrid, &args.tpg, &args.policy) {
        (Some(path), ..) => {
            let hybrid = Hybrid::read(path)?;
            same_problem(name, &hybrid.network.0, &hybrid.network.1)?;
            let problem = graph_problem(args.problem, config)?;
            hybrid::on_problem(&problem, &path.display().to_string(), &hybrid, args.episodes, args.seed)
        }
        (None, Some(graph), Some(actor)) => {
            let (separation, patience) =
                (args.separation.unwrap_or(f64::INFINITY), args.patience.unwrap_or(Span::NEVER));
            let detector = args.cycle_detector.unwrap_or_default();
            let (place, graph) = (graph.display().to_string(), read_graph(graph)?);
            let setting = setting_of(&graph, args.hand_back_after, separation, patience, detector)?;
            let file = format!("{place} with {actor}: {}", setting.sentence());
            let network = (actor.clone(), Network::read(Path::new(actor))?);
            let hybrid = Hybrid { problem: name.to_owned(), graph: (place, graph), network, setting };
            same_problem(name, actor, &hybrid.network.1)?;
            hybrid::on_problem(&graph_problem(args.problem, config)?, &file, &hybrid, args.episodes, args.seed)
        }
        (None, Some(path), None) => {
            let problem = graph_problem(args.problem, config)?;
            let (file, graph) = (path.display().to_string(), read_graph(path)?);
            match (&args.targets, &problem) {
                (Some(scenes), Problem::Dodge(config)) => graph::on_scenes(config, &file, &graph, scenes),
                _ => graph::on_problem(&problem, &file, &graph, args.episodes, args.seed),
            }
        }
        (None, None, Some(file)) => {
            let network = Network::read(Path::new(file))?;
            let problem = match (config, network.problem()) {
                (Some(path), _) => {
                    let text = read_text(path, "a configuration as `tpg-train config --sac` prints")?;
                    ContinuousProblem::from_toml(&path.display().to_string(), &text)?
                }
                (None, Some(table)) => ContinuousProblem::from_table(file, table)?,
                (None, None) => ContinuousProblem::usual(args.problem),
            };
            same_name(name, problem.name().name())?;
            network::on_problem(&problem, file, &network, args.episodes, args.seed)
        }
        (None, None, None) => Err(command_line("no policy", "--tpg GRAPH, --policy FILE or --hybrid FILE")),
    }
}

/// Returns a problem with the settings of a configuration, or its usual ones.
///
/// # Errors
/// If the configuration cannot be read, or is for another problem.
pub fn graph_problem(name: ProblemName, config: Option<&Path>) -> Result<Problem, InputError> {
    let Some(path) = config else { return Ok(Problem::usual(name)) };
    let text = read_text(path, "a configuration as `tpg-train config` prints")?;
    let problem = Problem::from_toml(&path.display().to_string(), &text)?;
    same_name(name.name(), problem.name().name())?;
    Ok(problem)
}

/// Refuses a network that names another problem than the one asked for; `file` is the network's.
///
/// # Errors
/// If it does.
pub fn same_problem(asked: &str, file: &str, network: &Network) -> Result<(), InputError> {
    let Some(table) = network.problem() else { return Ok(()) };
    match table.get("name").and_then(toml::Value::as_str) {
        Some(name) if name != asked => {
            let found = format!("a policy for {name}");
            Err(InputError::new(file, Place::Whole, found, format!("one for {asked}")))
        }
        _ => Ok(()),
    }
}

fn same_name(asked: &str, found: &str) -> Result<(), InputError> {
    if found == asked {
        return Ok(());
    }
    let found = format!("--problem {asked} with a configuration or a policy for {found}");
    Err(command_line(found, "the same problem twice"))
}
