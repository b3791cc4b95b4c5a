//! `tpg-paper replay`: replays recorded episodes and compares them.

use super::actor::RecordedActor;
use super::chain::Chain;
use super::data::{self, ByRow, Task};
use super::episode::Rules;
use super::replay::{self, Comparison, Done};
use super::sac;
use crate::limits::{max_actions, max_actor_actions};
use clap::{Args, ValueEnum};
use serde::Serialize;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use tpg_arm::WIDOWX;
use tpg_codegen::emit::{Language, Options, Prefix};
use tpg_codegen::verify::Workshop;
use tpg_engine::single;
use tpg_graph::Graph;
use tpg_graph::command::{CommandError, Verdict};
use tpg_graph::engine::{Engine, Reference};
use tpg_graph::import;
use tpg_problems::arm::binding::Binding;
use tpg_problems::arm::targets::Start;

/// Replay recorded episodes and count exact matches
#[derive(Clone, Debug, Args)]
pub struct ReplayArgs {
    /// The policy: a graph.json or a GEGELATI .dot file; - for standard input
    #[arg(long, value_name = "FILE", required_unless_present = "actor", conflicts_with = "actor")]
    graph: Option<PathBuf>,
    /// The policy: a recorded actor's weights
    #[arg(long, value_name = "F32", requires = "layout")]
    actor: Option<PathBuf>,
    /// The layout of the actor's weights
    #[arg(long, value_name = "JSON", requires = "actor")]
    layout: Option<PathBuf>,
    /// Let an invalid action end an actor's episode
    #[arg(long, requires = "actor")]
    end_at_collision: bool,
    /// A built-in description that supplies what a .dot file lacks
    #[arg(long, value_name = "NAME", conflicts_with = "sidecar")]
    profile_of: Option<import::Profile>,
    /// A TOML file that supplies what a .dot file lacks
    #[arg(long, value_name = "FILE")]
    sidecar: Option<PathBuf>,
    /// The recorded problem; it determines the maximum number of actions
    #[arg(long, value_enum)]
    problem: Start,
    /// The hand has reached its target below this distance
    #[arg(long, value_name = "D", default_value_t = 3.0, value_parser = millimetres)]
    tolerance_mm: f64,
    /// Starts and targets: columns row, m0 to m3, tx, ty, tz
    #[arg(long, value_name = "CSV")]
    targets: PathBuf,
    /// Recorded end states: columns row, score_x1000, distance_um, success, collision, nb_actions
    #[arg(long, value_name = "CSV", required_unless_present = "trace")]
    ends: Option<PathBuf>,
    /// Recorded steps: columns row, step, m0 to m3; gzip allowed
    #[arg(long, value_name = "CSV.gz")]
    trace: Option<PathBuf>,
    /// The engine: the interpreter, or compiled generated code
    #[arg(long, value_enum, default_value_t = EngineArg::Interpreter)]
    engine: EngineArg,
    /// Print one JSON object
    #[arg(long)]
    json: bool,
}

/// Engine that decides.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum EngineArg {
    /// The interpreter of tpg-codegen.
    Interpreter,
    /// The trainer's own engine, one state at a time.
    Trainer,
    /// Generated C, compiled with the host's C compiler.
    C,
    /// Generated Rust, compiled with rustc.
    Rust,
}

impl EngineArg {
    /// Starts the engine for a graph read from `file`.
    ///
    /// # Errors
    /// If generated code cannot be built.
    pub fn start<'g>(self, file: &Path, graph: &'g Graph) -> Result<Box<dyn Engine + 'g>, CommandError> {
        let options = Options::new(Prefix::of_file(file));
        // The folder is deleted on return; the program started from it keeps running.
        let workshop = || Workshop::new().map_err(CommandError::other);
        Ok(match self {
            Self::Interpreter => Box::new(Reference::new(graph)),
            Self::Trainer => single(graph),
            Self::C => Box::new(workshop()?.run(Language::C, graph, &options).map_err(CommandError::other)?),
            Self::Rust => Box::new(workshop()?.run(Language::Rust, graph, &options).map_err(CommandError::other)?),
        })
    }
}

/// Content of the `--json` output.
#[derive(Clone, Debug, Serialize)]
struct ReplayReport {
    graph: String,
    problem: Start,
    engine: String,
    comparisons: Vec<Comparison>,
}

impl ReplayArgs {
    /// Runs the command.
    ///
    /// # Errors
    /// Bad input, or an engine failure.
    pub fn run(&self) -> Result<Verdict, CommandError> {
        let tasks = data::tasks(&self.targets)?;
        let mut ends = self.ends.as_deref().map(|path| data::ends(path, &tasks)).transpose()?;
        let traces = self.trace.as_deref().map(|path| data::traces(path, &tasks)).transpose()?;

        let (policy, engine, done) = match (&self.graph, &self.actor, &self.layout) {
            (Some(graph), ..) => self.of_graph(graph, &tasks)?,
            (None, Some(actor), Some(layout)) => {
                // No action of an actor's episode is chosen by a TPG.
                ends.iter_mut().flat_map(|ends| ends.values_mut()).for_each(|end| end.tpg_actions = None);
                self.of_actor(actor, layout, &tasks)?
            }
            _ => return Err(CommandError::other("neither --graph nor --actor with --layout")),
        };
        let comparisons: Vec<Comparison> = (ends.iter().map(|ends| replay::compare_ends(ends, &done)))
            .chain(traces.iter().map(|traces| replay::compare_traces(traces, &done)))
            .collect();

        for comparison in &comparisons {
            if comparison.rows < tasks.len() {
                eprintln!("{}: {} of {} targets are recorded", comparison.kind, comparison.rows, tasks.len());
            }
        }
        let exact = comparisons.iter().all(Comparison::is_exact);
        let report = ReplayReport { graph: policy, problem: self.problem, engine, comparisons };
        report.print(self.json).map_err(CommandError::other)?;
        Ok(if exact { Verdict::Good } else { Verdict::Failed })
    }

    /// Returns the policy's name, the engine's name, and the episodes.
    fn of_graph(&self, path: &Path, tasks: &ByRow<Task>) -> Result<(String, String, ByRow<Done>), CommandError> {
        let graph = import::load(path, self.profile_of, self.sidecar.as_deref())?;
        let name = path.display().to_string();
        let binding = Binding::of_graph(&name, &graph)?;
        let rules = Rules { max_actions: max_actions(self.problem), tolerance: self.tolerance_mm };
        let mut engine = self.engine.start(path, &graph)?;
        let chain = Chain::new(WIDOWX);
        let done = replay::run(&chain, rules, tasks, &binding, engine.as_mut()).map_err(CommandError::other)?;
        Ok((name, engine.name().to_owned(), done))
    }

    fn of_actor(
        &self,
        weights: &Path,
        layout: &Path,
        tasks: &ByRow<Task>,
    ) -> Result<(String, String, ByRow<Done>), CommandError> {
        let actor = RecordedActor::read(weights, layout)?;
        let rules = Rules { max_actions: max_actor_actions(self.problem), tolerance: self.tolerance_mm };
        let done = sac::run(&Chain::new(WIDOWX), rules, self.end_at_collision, tasks, &actor);
        Ok((weights.display().to_string(), "actor".to_owned(), done))
    }
}

impl ReplayReport {
    fn print(&self, json: bool) -> io::Result<()> {
        let mut out = io::stdout().lock();
        if json {
            writeln!(out, "{}", serde_json::to_string(self)?)?;
            return out.flush();
        }
        for Comparison { kind, rows, exact_rows, steps, exact_steps, first_difference } in &self.comparisons {
            writeln!(out, "{kind}: rows {rows}, exact_rows {exact_rows}, steps {steps}, exact_steps {exact_steps}")?;
            if let Some(difference) = first_difference {
                writeln!(out, "{kind}: the first difference: {difference}")?;
            }
        }
        out.flush()
    }
}

fn millimetres(text: &str) -> Result<f64, String> {
    let value: f64 = text.parse().map_err(|_| "not a number".to_owned())?;
    if value.is_finite() && value > 0.0 { Ok(value) } else { Err("not a positive length".to_owned()) }
}
