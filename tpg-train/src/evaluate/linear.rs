//! The linear rival of a run: weighted sums, found by the run's own search in as many steps.

use super::EvalArgs;
use crate::evolution::command::{TpgArgs, execute};
use crate::evolution::record::Row;
use crate::run_args::{RunArgs, command_line};
use std::path::{Path, PathBuf};
use tpg_graph::error::InputError;
use tpg_graph::files::read_graph;

/// The name of the rival, and of its folder in the run's.
pub(super) const LINEAR: &str = "linear";

/// Trains the rival of a graph in the folder of the graph's run, unless it is there, and returns its graph's path.
///
/// # Errors
/// If the graph is not that of a run, or the rival cannot be trained.
pub(super) fn trained(args: &EvalArgs) -> Result<PathBuf, InputError> {
    let refuse = || command_line("--against linear", "--tpg RUN/graph.json beside it, a run with its log");
    let graph = args.tpg.as_deref().ok_or_else(refuse)?;
    let folder = graph.parent().unwrap_or(Path::new("."));
    let (config, out) = (folder.join("config.toml"), folder.join(LINEAR));
    let log = std::fs::read_to_string(folder.join("generations.jsonl")).map_err(|_| refuse())?;
    let last = log.lines().last().and_then(|line| serde_json::from_str::<Row>(line).ok()).ok_or_else(refuse)?;
    let settings = ["start.share=1", "start.random=1", "learning.nb_generations=0"];
    let run = RunArgs {
        problem: Some(args.problem),
        preset: None,
        config: Some(config),
        set: settings.map(str::to_owned).into(),
        out: Some(out.clone()),
        seed: read_graph(graph)?.provenance().seed.unwrap_or(1),
        target: None,
        max_steps: Some(last.steps),
        resume: true,
        checkpoint_seconds: None,
    };
    let args = TpgArgs { run, seeds: None, threads: 0, generations: None };
    execute(&args, None).map_err(|error| command_line(format!("--against linear: {error}"), "the run's settings"))?;
    Ok(out.join("graph.json"))
}
