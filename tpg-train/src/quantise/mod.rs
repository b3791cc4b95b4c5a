//! `tpg-train quantise`: puts a trained network or graph into integers.

mod bits;
mod visiting;

pub use bits::{InIntegers, Visit};

use crate::evaluate::problem_for;
use crate::folder::frame::checksum;
use crate::hybrid::rollout::{Acting, run};
use crate::hybrid::shared::{Episodes, opened};
use crate::run_args::command_line;
use crate::sac::integers::quantised;
use crate::sac::weights;
use clap::Args;
use serde::Deserialize as _;
use std::fs::{self, File};
use std::io::Read as _;
use std::path::{Path, PathBuf};
use std::slice::from_ref;
use tpg_codegen::policy::Preferences;
use tpg_engine::{Choices, Environment as _, TaskSet, places};
use tpg_graph::command::{note, print};
use tpg_graph::error::{InputError, Place};
use tpg_graph::files::{read_graph, write_atomically};
use tpg_graph::states::StateSet;
use tpg_graph::{Graph, in_arithmetic_of};
use tpg_problems::{Number, PolicyKind, Problem, ProblemName};
use tpg_runtime::net::Kind;
use tpg_runtime::ops::Maths;
use visiting::Visiting;

/// Put a policy into integers.
#[derive(Clone, Debug, Args)]
pub struct QuantiseArgs {
    /// The policy.safetensors or graph.json
    pub policy: PathBuf,
    /// The policy.q.json or graph.json to write
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// Bits of a network's weights and activations: w8a16 or w16a16 [default: w8a16]
    #[arg(long, value_parser = kind)]
    pub kind: Option<Kind>,
    /// The seed of the episodes that calibrate a network or choose the bits of a graph; no test episodes
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,
    /// Options for graphs alone.
    #[command(flatten)]
    pub graph: GraphArgs,
}

/// Options for graphs.
#[derive(Clone, Debug, Default, PartialEq, Args)]
#[command(next_help_heading = "Options for graphs")]
pub struct GraphArgs {
    /// The problem [default: the one that the graph was trained on]
    #[arg(long, value_enum)]
    pub problem: Option<ProblemName>,
    /// Use this configuration's problem settings
    #[arg(long, value_name = "FILE")]
    pub config: Option<PathBuf>,
    /// Bits of inputs and weights [default: the fewest of 8, 10, 12, 14, 16 with which the mean return is at most one standard
    /// error lower]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(2..=16))]
    pub bits: Option<u32>,
    /// The number of episodes that both play [default: 100]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(2..))]
    pub episodes: Option<u32>,
}

fn kind(name: &str) -> Result<Kind, String> {
    Kind::from_name(name).ok_or_else(|| format!("accepted: {}", Kind::ALL.map(Kind::name).join(", ")))
}

/// Writes the integers and says what they cost.
///
/// # Errors
/// If the policy cannot be read or put into integers, or the file cannot be written.
pub fn quantise(args: &QuantiseArgs) -> Result<(), InputError> {
    if args.out == args.policy {
        let file = args.policy.display().to_string();
        return Err(InputError::new(file, Place::Whole, "the policy itself as --out", "another file"));
    }
    match (is_network(&args.policy)?, args.kind) {
        (true, kind) if args.graph == GraphArgs::default() => quantise_network(args, kind.unwrap_or(Kind::W8A16)),
        (true, _) => Err(command_line("a network with options for graphs", "--kind, --seed")),
        (false, None) => quantise_graph(args),
        (false, Some(_)) => Err(command_line("a graph with --kind", "--bits")),
    }
}

/// True for a safetensors file: it begins with its header's length in eight bytes, and no text has a 0 there.
fn is_network(path: &Path) -> Result<bool, InputError> {
    let mut start = Vec::new();
    let read = File::open(path).and_then(|file| file.take(8).read_to_end(&mut start));
    read.map_err(|error| InputError::io(path, &error, "a policy.safetensors or a graph.json"))?;
    Ok(start.contains(&0))
}

fn quantise_graph(args: &QuantiseArgs) -> Result<(), InputError> {
    let GraphArgs { problem, config, bits, episodes } = &args.graph;
    let graph = (args.policy.display().to_string(), read_graph(&args.policy)?);
    let name = problem.map_or_else(|| trained_on(&graph), Ok)?;
    let problem = problem_for(name, config.as_deref(), from_ref(&graph), &[])?;
    let whole = in_integers(&problem, &graph, *bits, None, episodes.unwrap_or(100) as usize, args.seed)?;
    write_atomically(&args.out, whole.graph.to_json().as_bytes())?;
    print(whole.to_string())
}

/// Returns the problem that a graph was trained on.
fn trained_on((file, graph): &(String, Graph)) -> Result<ProblemName, InputError> {
    let config = graph.provenance().config.as_ref();
    let name = config.and_then(|config| config.get("problem")?.get("name")?.as_str());
    name.and_then(ProblemName::from_name).ok_or_else(|| {
        let found = name.map_or_else(|| "a graph that names no problem".to_owned(), |name| format!("{name:?}"));
        let accepted = format!("one of {}, or --problem", ProblemName::names());
        InputError::new(file, "$.provenance.config.problem.name", found, accepted)
    })
}

/// Puts a graph into integers that keep its return on a built-in problem, in `count` episodes that are no test episodes: see
/// [`InIntegers::keeping_return`].
///
/// # Errors
/// If the graph is not one for the problem, or cannot be put into integers.
pub fn in_integers(
    problem: &Problem,
    graph: &(String, Graph),
    bits: Option<u32>,
    given: Option<StateSet>,
    count: usize,
    seed: u64,
) -> Result<InIntegers, InputError> {
    let episodes = Episodes { set: TaskSet::Study, count, seed, file: None };
    InIntegers::keeping_return(&graph.0, &graph.1, bits, given, |played| {
        let acting = (graph.0.clone(), played.clone());
        in_arithmetic_of!(acting.1, visit(problem, &graph.1, &acting, episodes))
    })
}

/// Lets a graph, or what was made of it, play.
fn visit<S: Number, M: Maths<S>>(
    problem: &Problem,
    graph: &Graph,
    acting: &(String, Graph),
    episodes: Episodes<'_>,
) -> Result<Visit, InputError> {
    let tasks = episodes.in_problem(problem)?;
    opened::<S, _>(problem, graph, |choices| {
        let visiting = Visiting::new::<S>(choices, places(&acting.0, graph.observed(), &choices.sources())?);
        let visiting = Choices::new(visiting, None).expect("as they are");
        let done = run::<S, M, _>(&visiting, Acting::Graph(acting), &tasks)?;
        let returns = done.endings.iter().map(|ending| ending.score).collect();
        Ok(Visit { returns, states: visiting.inner().states() })
    })
}

fn quantise_network(args: &QuantiseArgs, kind: Kind) -> Result<(), InputError> {
    let file = args.policy.display().to_string();
    let (network, contract) = weights::read(&args.policy)?;
    let bytes = fs::read(&args.policy).map_err(|error| InputError::io(&args.policy, &error, "a policy.safetensors"))?;
    let hash = checksum(&bytes);
    let problem = Problem::from_table(&file, &contract.problem, PolicyKind::Network)?;
    let preferences = problem.kept_settings().map(Preferences::deserialize).transpose().map_err(|error| {
        InputError::new(&file, Place::Whole, error.message(), "settings of a network whose outputs are preferences")
    })?;
    let (environment, actor) = (problem.network_environment(args.seed), (&network, &contract));
    let policy = quantised(&file, actor, preferences, &&*environment, hash, kind, args.seed)?;
    write_atomically(&args.out, policy.to_json().as_bytes())?;
    note(format_args!(
        "{} bytes of constants, {} multiplications a decision",
        policy.bytes(),
        policy.multiplications()
    ));
    Ok(())
}
