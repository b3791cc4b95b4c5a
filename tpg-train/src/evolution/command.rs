//! `tpg-train tpg`: evolves a tangled program graph.

use super::config::EvolutionConfig;
use super::generation::Goal;
use super::run::{Progress, RunEnd, RunError, RunOptions, train};
use crate::configuration::{Chosen, Configuration as _};
use crate::folder::RunFolder;
use crate::hybrid::asking::{self, Asking};
use crate::interrupt;
use crate::ranks::Ranks;
use crate::run_args::RunArgs;
use crate::sac::integers::decided;
use clap::Args;
use std::ops::{ControlFlow, Range};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use tpg_codegen::policy::QuantisedPolicy;
use tpg_engine::{
    AnyEpisode, AnyTask, Choices, Environment, Evaluator, LocalThreads, Measure, Remembering, Summary, erase,
};
use tpg_graph::ScalarType;
use tpg_graph::command::Verdict;
use tpg_graph::files::{read_text, write_atomically};
use tpg_graph::progress::Bar;
use tpg_problems::{DEFAULT_LEVELS, Number, Problem};
use tpg_runtime::ops::{Maths, Own};

/// Seconds between checkpoints.
const CHECKPOINT_SECONDS: u64 = 30;

/// Evolve a tangled program graph.
#[derive(Clone, Debug, Args)]
pub struct TpgArgs {
    /// The arguments of every run.
    #[command(flatten)]
    pub run: RunArgs,
    /// Train with seeds A to B - 1, and keep the best on the validation episodes
    #[arg(long, value_name = "A..B", value_parser = seeds, conflicts_with = "seed")]
    pub seeds: Option<Range<u64>>,
    /// Threads; 0 for all. Results do not depend on it
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub threads: usize,
    /// Generations instead of the configuration's; with --resume, a run can go further than before
    #[arg(long, value_name = "G", value_parser = clap::value_parser!(u64).range(1..))]
    pub generations: Option<u64>,
}

fn seeds(text: &str) -> Result<Range<u64>, String> {
    let parse = || {
        let (first, end) = text.split_once("..")?;
        Some(first.parse().ok()?..end.parse().ok()?)
    };
    let seeds = parse().filter(|seeds: &Range<u64>| !seeds.is_empty());
    seeds.ok_or_else(|| "two seeds A..B with A below B, such as 1..9".to_owned())
}

/// Runs the training, alone or on one of several ranks.
///
/// # Errors
/// An invalid configuration, a folder with another run, files that cannot be written.
pub(crate) fn execute(args: &TpgArgs, ranks: Option<&Ranks<'_>>) -> Result<Verdict, RunError> {
    let Chosen { mut config, problem, settings, .. } = Chosen::<EvolutionConfig>::by(&args.run)?;
    let is_set = settings.get("learning").is_some_and(|learning| learning.get("nb_generations").is_some());
    // A budget of steps needs no other: a preset's number of generations is for runs without one.
    let default = (args.run.max_steps.is_some() && !is_set).then_some(0);
    if let Some(generations) = args.generations.or(default) {
        config.learning.nb_generations = generations;
    }
    let network = config.ask.as_mut().map(|ask| asking::read(ask, &problem)).transpose()?;
    let stop = interrupt::watch();
    // Actions must be named to have one more.
    let levels = problem.levels().or(config.ask.as_ref().map(|_| DEFAULT_LEVELS));
    let training =
        TpgRun { args, config: &config, problem: &problem, levels, network: network.as_ref(), stop: &stop, ranks };
    let out = args.run.folder(problem.name(), args.seeds.as_ref().map_or(args.run.seed, |seeds| seeds.start));
    match config.language.scalar {
        ScalarType::F32 => training.run_in::<f32>(&out),
        ScalarType::F64 => training.run_in::<f64>(&out),
    }
}

/// A run on a built-in problem.
struct TpgRun<'a> {
    args: &'a TpgArgs,
    config: &'a EvolutionConfig,
    problem: &'a Problem,
    /// The levels of outputs, where they are actions.
    levels: Option<u16>,
    /// The network that policies can ask.
    network: Option<&'a QuantisedPolicy>,
    stop: &'a AtomicBool,
    ranks: Option<&'a Ranks<'a>>,
}

impl TpgRun<'_> {
    /// Trains in a folder, with one seed or with several, of which the best one's `graph.json` is the folder's.
    fn run_in<S: Number>(&self, out: &Path) -> Result<Verdict, RunError>
    where
        Own: Maths<S>,
    {
        let environment = self.problem.environment::<S>();
        let choices = Choices::new(&*environment, self.levels)?;
        let asking = self.config.ask.as_ref().zip(self.network).map(|(ask, network)| {
            let decide = |state: &[f32]| decided(network, state);
            erase(Asking::new::<S>(&choices, decide, ask.price))
        });
        let acting: &dyn Environment<S, Task = AnyTask, Episode = AnyEpisode> = match &asking {
            Some(asking) => &**asking,
            None => &choices,
        };
        let environment = Remembering::new::<S>(acting, self.config.language.memory);
        let local = LocalThreads::<S, Own, _>::new(&environment, self.args.threads)?;
        let Some(ranks) = self.ranks else { return self.restarts(out, &environment, &local) };
        let identity = format!("{}\n{}", env!("CARGO_PKG_VERSION"), self.config.to_toml());
        ranks.train(&identity, local.threads(), &local, |evaluator| self.restarts(out, &environment, evaluator))
    }

    fn restarts<S: Number, E: Environment<S>>(
        &self,
        out: &Path,
        environment: &E,
        evaluator: &dyn Evaluator<E::Task>,
    ) -> Result<Verdict, RunError>
    where
        Own: Maths<S>,
    {
        let Self { args, config, stop, .. } = *self;
        let goal = Goal { target: args.run.target, max_steps: args.run.max_steps };
        let one = |seed: u64, folder: PathBuf| {
            let resume = args.run.resume;
            let checkpoint_every = args.run.checkpoint_every(CHECKPOINT_SECONDS);
            let options = RunOptions { folder, resume, checkpoint_every, goal, ..RunOptions::default() };
            let bar = Bar::begin();
            train(config, seed, environment, evaluator, &options, |progress| {
                bar.show(progress.generations, progress.planned, || message(progress));
                if stop.load(Ordering::Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            })
        };
        let _folder = args.seeds.as_ref().map(|_| RunFolder::open(out, args.run.resume)).transpose()?;
        let seeds = args.seeds.clone().unwrap_or(args.run.seed..args.run.seed.saturating_add(1));
        let mut kept: Option<Summary> = None;
        for seed in seeds {
            let folder = if args.seeds.is_some() { out.join(format!("seed-{seed}")) } else { out.to_owned() };
            let RunEnd::Finished(best) = one(seed, folder.clone())? else { return Ok(Verdict::Interrupted) };
            let result = sentence(seed, &best.result, environment.measure());
            tpg_graph::command::note(format_args!("{result}, found in generation {}", best.generation));
            let is_better = |kept: Summary| best.result.compare(&kept, environment.preference()).is_gt();
            if args.seeds.is_some() && kept.is_none_or(is_better) {
                let graph = read_text(&folder.join("graph.json"), "the graph of a finished run")?;
                write_atomically(&out.join("graph.json"), graph.as_bytes())?;
                kept = Some(best.result);
            }
        }
        Ok(Verdict::Good)
    }
}

fn message(progress: &Progress<'_>) -> String {
    let Some(row) = progress.row else { return format!("seed {}", progress.seed) };
    let best = progress.best.map(|best| format!(", {:.2} validated", best.result.score)).unwrap_or_default();
    format!("seed {}: best {:.2}, median {:.2}{best}", progress.seed, row.best_score, row.median_score)
}

/// Returns the result of a run on the validation episodes, for people.
pub(crate) fn sentence(seed: u64, result: &Summary, measured: Option<Measure>) -> String {
    let Summary { score, success, measure, episodes, .. } = result;
    let success = success.map(|success| format!(", {:.1} % solved", 100.0 * success)).unwrap_or_default();
    let measure = measured.map(|of| format!(", mean {} {measure:.1} {}", of.name, of.unit)).unwrap_or_default();
    format!("seed {seed}: mean score {score:.2} on {episodes} validation episodes{success}{measure}")
}
