//! `tpg-train hybrid`: the study of both parameters.
//!
//! The folder of a study contains `study.toml` (the request), `cells.csv` (a row for each pair and setting),
//! `settings.csv` (means over pairs, front, choice), `alone.csv`, `hybrid.toml` (the chosen setting with the best
//! pair), `timing.csv` (the only measurement that differs between equal runs, and with it the times elsewhere) and
//! `report.html`.

use super::choice::{self, Summary};
use super::cost::Costs;
use super::graph::read_graph;
use super::report;
use super::setting::{Detector, HybridFile};
use super::study::{Cell, Study, settings, to_csv};
use crate::actor::file::Actor;
use crate::files::{make_folder, read_text, write_atomically};
use crate::interrupt;
use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};
use std::fs;
use std::path::{Path, PathBuf};

use tpg_arm::WIDOWX;
use tpg_arm::hybrid::Guard;
use tpg_graph::command::Verdict;
use tpg_graph::error::{InputError, Place};
use tpg_problems::arm::targets::{Set, Start, tasks};

/// Study how graphs and actors share the arm, on validation episodes.
#[derive(Clone, Debug, Args)]
pub struct HybridArgs {
    /// The problem: fixed or random start
    #[arg(long, value_enum)]
    pub problem: Start,
    /// Graphs
    #[arg(long, value_name = "GRAPH", num_args = 1.., required = true)]
    pub tpg: Vec<PathBuf>,
    /// Actors: policy.safetensors or policy.q.json
    #[arg(long, value_name = "FILE", num_args = 1.., required = true)]
    pub policy: Vec<PathBuf>,
    /// The folder of the study
    #[arg(long, value_name = "RUN")]
    pub out: PathBuf,
    /// Continue the study in the folder
    #[arg(long)]
    pub resume: bool,
    /// Validation episodes for each pair and setting
    #[arg(long, value_name = "N", default_value_t = 500)]
    pub episodes: usize,
    /// The seed of the validation episodes
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,
    /// Guards: none, joint-limits, collisions, both
    #[arg(long, value_name = "GUARD", value_delimiter = ',', default_value = "none,joint-limits,collisions,both",
          value_parser = guard)]
    pub guard: Vec<Guard>,
    /// Methods of detecting cycles
    #[arg(long, value_enum, value_name = "DETECTOR", value_delimiter = ',', default_value = "visited")]
    pub cycle_detector: Vec<Detector>,
    /// Threads; 0 for one per core
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub threads: usize,
}

/// Finds a guard by name.
///
/// # Errors
/// If there is no guard with that name.
pub fn guard(name: &str) -> Result<Guard, String> {
    Guard::from_name(name).ok_or_else(|| format!("accepted: {}", Guard::ALL.map(Guard::name).join(", ")))
}

/// One row of `alone.csv`: a policy acting alone.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Alone {
    /// `tpg` or `sac`.
    pub kind: &'static str,
    /// Its position on the command line, from 0.
    pub place: usize,
    /// Its file.
    pub file: String,
    /// Fraction of the episodes that reached their target.
    pub success: f64,
    /// Fraction of the episodes that ended with an invalid action.
    pub collision: f64,
    /// Mean final distance.
    pub distance_mm: f64,
    /// Mean number of actions.
    pub actions: f64,
}

/// Content of `study.toml`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Asked {
    problem: Start,
    episodes: usize,
    seed: u64,
    guards: Vec<String>,
    cycle_detectors: Vec<Detector>,
    tpg: Vec<Input>,
    policy: Vec<Input>,
}

/// An input file with its content.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Input {
    file: String,
    sha256: String,
}

impl Input {
    fn of(path: &Path) -> Result<Self, InputError> {
        let bytes = fs::read(path).map_err(|error| InputError::io(path, &error, "a graph or an actor"))?;
        let sha256 = Sha256::digest(&bytes).iter().map(|byte| format!("{byte:02x}")).collect();
        Ok(Self { file: path.display().to_string(), sha256 })
    }
}

/// Runs the study.
///
/// # Errors
/// Files that are not policies, a folder with another study, files that cannot be written.
pub fn execute(args: &HybridArgs) -> Result<Verdict, InputError> {
    let inputs = |paths: &[PathBuf]| paths.iter().map(|path| Input::of(path)).collect::<Result<Vec<_>, _>>();
    let asked = Asked {
        problem: args.problem,
        episodes: args.episodes,
        seed: args.seed,
        guards: args.guard.iter().map(|guard| guard.name().to_owned()).collect(),
        cycle_detectors: args.cycle_detector.clone(),
        tpg: inputs(&args.tpg)?,
        policy: inputs(&args.policy)?,
    };
    let study = Study {
        tpgs: args.tpg.iter().map(|p| Ok((p.display().to_string(), read_graph(p)?))).collect::<Result<_, _>>()?,
        sacs: args.policy.iter().map(|p| Ok((p.display().to_string(), Actor::read(p)?))).collect::<Result<_, _>>()?,
        settings: settings(&args.guard, &args.cycle_detector),
        start: args.problem,
        tasks: tasks(&WIDOWX, args.seed, Set::Validation, args.problem, args.episodes),
    };
    open_folder(args, &asked)?;
    let stop = interrupt::watch();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(args.threads).build();
    let pool = pool.map_err(|e| {
        InputError::new("--threads", Place::Whole, e.to_string(), "a number of threads that can be started")
    })?;
    let progress = ProgressBar::new(study.size() as u64);
    let style = ProgressStyle::with_template("{bar:30} {pos} of {len}  {eta} left");
    progress.set_style(style.expect("a template that is right"));
    let costs = Costs::measure(&study)?;
    let Some(cells) = pool.install(|| study.run(&args.out.join("cells.csv"), &progress, &stop))? else {
        return Ok(Verdict::Interrupted);
    };
    let alone = pool.install(|| alone(&study))?;
    progress.finish_and_clear();
    finish(args, &study, &costs, &cells, &alone)?;
    Ok(Verdict::Good)
}

fn open_folder(args: &HybridArgs, asked: &Asked) -> Result<(), InputError> {
    let path = args.out.join("study.toml");
    let text = toml::to_string(asked).expect("plain data");
    if path.exists() {
        let name = path.display().to_string();
        if !args.resume {
            return Err(InputError::new(name, Place::Whole, "a study", "an empty folder, or --resume"));
        }
        if read_text(&path, "a study.toml")? != text {
            let accepted = "the same arguments and the same files as at the start";
            return Err(InputError::new(name, Place::Whole, "another study", accepted));
        }
    }
    make_folder(&args.out)?;
    write_atomically(&path, text.as_bytes())
}

fn alone(study: &Study) -> Result<Vec<Alone>, InputError> {
    let tpgs = (0..study.tpgs.len()).map(|place| ("tpg", place));
    let all: Vec<(&'static str, usize)> = tpgs.chain((0..study.sacs.len()).map(|place| ("sac", place))).collect();
    all.into_par_iter()
        .map(|(kind, place)| {
            let (file, trial) = if kind == "tpg" {
                let (file, graph) = &study.tpgs[place];
                (file, super::trial::graph_alone(file, graph, study.start, &study.tasks)?)
            } else {
                let (file, actor) = &study.sacs[place];
                let arm = WIDOWX.to_f32();
                (file, tpg_problems::arm::trial::run(&arm, &*actor.policy(), study.start, &study.tasks))
            };
            Ok(Alone {
                kind,
                place,
                file: file.clone(),
                success: trial.success_rate,
                collision: trial.collision_rate,
                distance_mm: trial.mean_distance_mm,
                actions: trial.mean_actions,
            })
        })
        .collect()
}

fn finish(args: &HybridArgs, study: &Study, costs: &Costs, cells: &[Cell], alone: &[Alone]) -> Result<(), InputError> {
    let summaries = choice::summarise(cells, &study.settings, costs);
    let file = |name: &str| args.out.join(name);
    write_atomically(&file("settings.csv"), &to_csv(summaries.iter()))?;
    write_atomically(&file("alone.csv"), &to_csv(alone.iter()))?;
    write_atomically(&file("timing.csv"), timing(study, costs).as_bytes())?;
    write_atomically(&file("report.html"), report::page(args.problem, cells, &summaries, alone).as_bytes())?;
    let Some(chosen) = summaries.iter().find(|summary| summary.chosen) else { return Ok(()) };
    if let Some(text) = best_pair(args, cells, chosen) {
        write_atomically(&file("hybrid.toml"), text.as_bytes())?;
    }
    if let Some(setting) = chosen.setting(cells) {
        eprintln!(
            "chosen: {}: {:.1} % success, {:.1} % collision, {:.2} mm, {:.0} % of the actions by the graph",
            setting.sentence(),
            100.0 * chosen.success,
            100.0 * chosen.collision,
            chosen.distance_mm,
            100.0 * chosen.tpg_action_ratio
        );
    }
    Ok(())
}

/// Returns the chosen setting with the pair that has the highest success rate under it; ties go to the smaller final
/// distance.
fn best_pair(args: &HybridArgs, cells: &[Cell], chosen: &Summary) -> Option<String> {
    let better = |a: &&Cell, b: &&Cell| a.success.total_cmp(&b.success).then(b.distance_mm.total_cmp(&a.distance_mm));
    let best = cells.iter().filter(|cell| chosen.is_of(cell)).max_by(better)?;
    let absolute = |path: &Path| {
        let path = path.canonicalize().unwrap_or_else(|_| path.to_owned());
        path.display().to_string()
    };
    let file = HybridFile {
        graph: absolute(&args.tpg[best.tpg]),
        actor: absolute(&args.policy[best.sac]),
        hand_back_after: best.hand_back_after,
        separation_mm: best.separation_mm,
        guard: best.guard.clone(),
        cycle_detector: best.cycle_detector,
    };
    Some(toml::to_string(&file).expect("plain data"))
}

fn timing(study: &Study, costs: &Costs) -> String {
    let mut text = "what,ns_per_decision\n".to_owned();
    let files = study.tpgs.iter().map(|(file, _)| file).chain(study.sacs.iter().map(|(file, _)| file));
    for (file, ns) in files.zip(costs.tpg.iter().chain(&costs.sac)) {
        text += &format!("{file},{ns:.1}\n");
    }
    for (guard, ns) in Guard::ALL.iter().zip(costs.guards) {
        text += &format!("guard {},{ns:.1}\n", guard.name());
    }
    text
}
