//! `tpg-train tpg`: trains a tangled program graph.

use super::config::{Config, EnvironmentName};
use super::presets::{PRESETS, Preset};
use super::run::{RunEnd, RunError, RunOptions, run};
use super::state::Best;
use crate::files::{make_folder, read_text, write_atomically};
use crate::interrupt;
use clap::Args;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;
use std::time::Duration;
use tpg_engine::{Environment, LocalThreads, Options};
use tpg_graph::ScalarType;
use tpg_graph::command::Verdict;
use tpg_graph::error::{InputError, Place};
use tpg_problems::Pendulum;
use tpg_problems::arm::targets::Start;
use tpg_problems::arm::{ArmEnvironment, ArmScalar};
use tpg_runtime::ops::{Maths, Own};

/// Evolve a tangled program graph.
#[derive(Clone, Debug, Args)]
pub struct TpgArgs {
    /// The problem: fixed or random start. Without --config or --preset this picks best-fs or best-rs.
    #[arg(long, value_enum)]
    pub problem: Option<Start>,
    /// A configuration (`tpg-train config` prints commented ones)
    #[arg(long, value_name = "FILE", conflicts_with = "preset")]
    pub config: Option<PathBuf>,
    /// A configuration that comes with the trainer: kelly, paper-fs, paper-rs, best-fs, polar-fs, best-rs
    #[arg(long, value_name = "NAME")]
    pub preset: Option<String>,
    /// The folder of the run
    #[arg(long, value_name = "RUN")]
    pub out: PathBuf,
    /// Go on where the folder's checkpoint is
    #[arg(long)]
    pub resume: bool,
    /// The seed
    #[arg(long, value_name = "S", default_value_t = 1, conflicts_with = "seeds")]
    pub seed: u64,
    /// Several restarts, the last seed excluded; the best on the selection set is kept
    #[arg(long, value_name = "A..B", value_parser = seeds)]
    pub seeds: Option<Seeds>,
    /// Threads; 0 for all. No result depends on it.
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub threads: usize,
    /// Episodes side by side. No result depends on it.
    #[arg(long, value_name = "N", default_value_t = 112, value_parser = clap::value_parser!(u16).range(1..))]
    pub lanes: u16,
    /// Generations, instead of the configuration's
    #[arg(long, value_name = "G", value_parser = clap::value_parser!(u64).range(1..))]
    pub generations: Option<u64>,
    /// Seconds between checkpoints
    #[arg(long, value_name = "S", default_value_t = 30)]
    pub checkpoint_seconds: u64,
}

/// Seeds from the first to before the last.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Seeds {
    first: u64,
    end: u64,
}

fn seeds(text: &str) -> Result<Seeds, String> {
    let parse = || {
        let (first, end) = text.split_once("..")?;
        Some(Seeds { first: first.parse().ok()?, end: end.parse().ok()? })
    };
    parse().filter(|seeds| seeds.first < seeds.end).ok_or_else(|| "two seeds A..B with A below B, as 1..9".to_owned())
}

/// Trains.
///
/// # Errors
/// A bad configuration, a folder with another run, files that cannot be written.
pub fn execute(args: &TpgArgs) -> Result<Verdict, RunError> {
    let config = configuration(args)?;
    let stop = interrupt::watch();
    match config.language.scalar {
        ScalarType::F32 => with_scalar::<f32>(args, &config, &stop),
        ScalarType::F64 => with_scalar::<f64>(args, &config, &stop),
    }
}

/// The configuration that the arguments ask for.
///
/// # Errors
/// If it cannot be read or is refused.
pub fn configuration(args: &TpgArgs) -> Result<Config, InputError> {
    let mut config = match (&args.config, &args.preset, args.problem) {
        (Some(path), _, _) => Config::read(path)?,
        (None, Some(name), _) => preset(name)?.config()?,
        (None, None, Some(Start::Fs)) => preset("best-fs")?.config()?,
        (None, None, Some(Start::Rs)) => preset("best-rs")?.config()?,
        (None, None, None) => {
            let accepted = "--problem fs or rs, --preset NAME or --config FILE";
            return Err(InputError::new("<command line>", Place::Whole, "no problem", accepted));
        }
    };
    if let Some(problem) = args.problem.filter(|&problem| problem != config.problem.start) {
        let found = format!("--problem {problem:?} with a configuration for {:?}", config.problem.start).to_lowercase();
        let accepted = "the same problem twice, or no --problem";
        return Err(InputError::new("<command line>", Place::Whole, found, accepted));
    }
    if let Some(generations) = args.generations {
        config.learning.nb_generations = generations;
    }
    Ok(config)
}

fn preset(name: &str) -> Result<&'static Preset, InputError> {
    Preset::find(name).ok_or_else(|| {
        let accepted = PRESETS.map(|preset| preset.name).join(", ");
        InputError::new("<command line>", Place::Whole, format!("the preset {name:?}"), accepted)
    })
}

/// The arm as a configuration describes it.
pub fn arm_environment<S: ArmScalar>(config: &Config) -> ArmEnvironment<S> {
    ArmEnvironment::new(&config.arm(), config.arm_problem())
}

fn with_scalar<S: ArmScalar>(args: &TpgArgs, config: &Config, stop: &AtomicBool) -> Result<Verdict, RunError>
where
    Own: Maths<S>,
{
    match config.problem.environment {
        EnvironmentName::Arm => restarts::<S, _>(args, config, &arm_environment::<S>(config), stop),
        EnvironmentName::Pendulum => {
            restarts::<S, _>(args, config, &Pendulum::new(config.learning.max_nb_actions_per_eval), stop)
        }
        EnvironmentName::Own => {
            let accepted = "arm or pendulum; \"own\" is for programs that use this library";
            let place = Place::Path("problem.environment".to_owned());
            Err(InputError::new("<configuration>", place, "own", accepted).into())
        }
    }
}

fn restarts<S: ArmScalar, E: Environment<S>>(
    args: &TpgArgs,
    config: &Config,
    environment: &E,
    stop: &AtomicBool,
) -> Result<Verdict, RunError>
where
    Own: Maths<S>,
{
    let options = Options { lanes: args.lanes.into(), ..Options::default() };
    let evaluator = LocalThreads::<S, Own, E>::new(environment, options, args.threads)?;
    let one = |seed: u64, folder: PathBuf| {
        let checkpoint_every = Duration::from_secs(args.checkpoint_seconds);
        let options = RunOptions { folder, resume: args.resume, checkpoint_every };
        run::<S, Own, E, _>(config, seed, environment, &evaluator, &options, stop)
    };
    let Some(seeds) = args.seeds else {
        return match one(args.seed, args.out.clone())? {
            RunEnd::Finished(best) => {
                eprintln!("{}", told(args.seed, &best));
                Ok(Verdict::Good)
            }
            RunEnd::Interrupted => Ok(Verdict::Interrupted),
        };
    };
    make_folder(&args.out)?;
    let mut finished = Vec::new();
    for seed in seeds.first..seeds.end {
        let folder = args.out.join(format!("seed-{seed}"));
        match one(seed, folder)? {
            RunEnd::Finished(best) => {
                eprintln!("{}", told(seed, &best));
                finished.push((seed, best));
            }
            RunEnd::Interrupted => return Ok(Verdict::Interrupted),
        }
        keep_best(&args.out, &finished)?;
    }
    Ok(Verdict::Good)
}

/// Writes `restarts.csv`, and the best seed's graph as `graph.json`.
fn keep_best(folder: &Path, finished: &[(u64, Box<Best>)]) -> Result<(), InputError> {
    let mut csv = String::from("seed,generation,validation_success,validation_error\n");
    for (seed, best) in finished {
        let _ = writeln!(csv, "{seed},{},{},{}", best.generation, best.success, best.error);
    }
    write_atomically(&folder.join("restarts.csv"), csv.as_bytes())?;
    let best = finished.iter().reduce(|a, b| if b.1.worth > a.1.worth { b } else { a });
    if let Some((seed, _)) = best {
        let graph = read_text(&folder.join(format!("seed-{seed}/graph.json")), "the graph of a finished run")?;
        write_atomically(&folder.join("graph.json"), graph.as_bytes())?;
    }
    Ok(())
}

fn told(seed: u64, best: &Best) -> String {
    format!(
        "seed {seed}: {:.1} % of the selection episodes, mean error {:.1}, found in generation {}",
        100.0 * best.success,
        best.error,
        best.generation
    )
}
