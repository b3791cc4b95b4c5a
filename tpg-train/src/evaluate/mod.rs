//! `tpg-train eval`: lets a policy act on test episodes and reports how they end.
//!
//! | module | subject |
//! | --- | --- |
//! | [`arm`] | graphs, networks, hybrids and planners on the arm |
//! | [`graph`] | a graph on any environment |
//! | [`network`] | a network on any built-in problem |
//! | [`Report`] | the figures |

pub mod arm;
pub mod graph;
pub mod network;
mod report;

pub use report::{ArmFigures, Report, confidence};

use crate::hybrid::graph::read_graph;
use crate::hybrid::setting::{Detector, HandBack};
use crate::run_args::command_line;
use crate::sac::network::Network;
use clap::Args;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use tpg_arm::hybrid::Guard;
use tpg_graph::error::InputError;
use tpg_problems::arm::Shield;
use tpg_problems::{ContinuousProblem, Problem, ProblemName};

/// Let a policy act and count how its episodes end.
#[derive(Clone, Debug, Args)]
pub struct EvalArgs {
    /// The problem
    #[arg(long, value_enum)]
    pub problem: ProblemName,
    /// A graph; with --policy too, the two share the arm
    #[arg(long, value_name = "GRAPH", required_unless_present_any = ["policy", "hybrid"])]
    pub tpg: Option<PathBuf>,
    /// The problem's settings of this configuration. Default: those of the problem; for the arm, the arm that the graph was
    /// trained for (the WidowX where it does not say)
    #[arg(long, value_name = "FILE")]
    pub config: Option<PathBuf>,
    /// A policy.safetensors or policy.q.json; on the arm also the classical `planner` or `nearest-goal`
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
    /// The arm's episodes from a file
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
    let written = std::io::stdout().lock().write_all(text.as_bytes());
    written.map_err(|error| InputError::io("<stdout>".as_ref(), &error, "an open pipe"))
}

/// A graph or a network on a problem that is not the arm's.
fn on_a_problem(args: &EvalArgs) -> Result<Report, InputError> {
    let name = args.problem.name();
    if args.hybrid.is_some() || args.targets.is_some() || args.shield != Shield::None {
        let found = format!("an option of the arm's with --problem {name}");
        return Err(command_line(found, "--tpg GRAPH or --policy FILE, --config, --episodes and --seed"));
    }
    match (&args.tpg, &args.policy) {
        (Some(path), None) => {
            let problem = match &args.config {
                None => Problem::usual(args.problem),
                Some(path) => {
                    let text = crate::files::read_text(path, "a configuration as `tpg-train config` prints")?;
                    Problem::from_toml(&path.display().to_string(), &text)?
                }
            };
            same_problem(args, problem.name())?;
            graph::on_problem(&problem, &path.display().to_string(), &read_graph(path)?, args.episodes, args.seed)
        }
        (None, Some(file)) => {
            let network = Network::read(Path::new(file))?;
            let problem = match (&args.config, network.problem()) {
                (Some(path), _) => {
                    let text = crate::files::read_text(path, "a configuration as `tpg-train config --sac` prints")?;
                    ContinuousProblem::from_toml(&path.display().to_string(), &text)?
                }
                (None, Some(table)) => ContinuousProblem::from_table(file, table)?,
                (None, None) => ContinuousProblem::usual(args.problem),
            };
            same_problem(args, problem.name())?;
            network::on_problem(&problem, file, &network, args.episodes, args.seed)
        }
        _ => Err(command_line(
            format!("a graph and a network with --problem {name}"),
            "one of them: the arm alone is shared",
        )),
    }
}

fn same_problem(args: &EvalArgs, found: ProblemName) -> Result<(), InputError> {
    if found == args.problem {
        return Ok(());
    }
    let found = format!("--problem {} with a configuration or a policy for {}", args.problem.name(), found.name());
    Err(command_line(found, "the same problem twice"))
}
