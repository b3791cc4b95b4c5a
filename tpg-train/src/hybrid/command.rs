//! `tpg-train hybrid`: the study of a hybrid's settings.
//!
//! The folder of a study contains `study.toml` (the request), `cells.csv` (a row for each pair and setting), `alone.csv`, and
//! `hybrid.toml` (the chosen setting with the best pair): the same bytes for equal runs.

use super::cells::{Cell, Subject};
use super::choice::choose;
use super::rollout::Acting;
use super::setting::{Detector, HybridFile, Setting, UNGUARDED};
use super::shared::{Episodes, Shared};
use super::span::Span;
use crate::csv_text::to_csv;
use crate::folder::RunFolder;
use crate::run_args::command_line;
use crate::sac::network::Network;
use clap::Args;
use rayon::ThreadPool;
use rayon::prelude::*;
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use tpg_engine::{Summary, TaskSet};
use tpg_graph::Graph;
use tpg_graph::command::Verdict;
use tpg_graph::error::{InputError, Place};
use tpg_graph::files::{read_graph, write_atomically};
use tpg_graph::progress::Bar;
use tpg_problems::ProblemName;

/// Study how graphs and networks share a problem, on validation episodes.
#[derive(Clone, Debug, Args)]
pub(crate) struct HybridArgs {
    /// The problem
    #[arg(long, value_enum)]
    pub problem: ProblemName,
    /// The arguments of a study on any problem
    #[command(flatten)]
    pub study: StudyArgs,
    /// Use this configuration's problem settings [default: those that the policies were trained with]
    #[arg(long, value_name = "FILE")]
    pub config: Option<PathBuf>,
}

/// The arguments of a study on any problem; with their defaults and the problem they are its `study.toml`.
#[derive(Clone, Debug, Args, Serialize)]
pub struct StudyArgs {
    /// Graphs
    #[arg(long, value_name = "GRAPH", num_args = 1.., required = true)]
    pub tpg: Vec<PathBuf>,
    /// Networks: policy.safetensors or policy.q.json
    #[arg(long, value_name = "FILE", num_args = 1.., required = true)]
    pub policy: Vec<PathBuf>,
    /// The folder of the study
    #[arg(long, value_name = "RUN")]
    #[serde(skip)]
    pub out: PathBuf,
    /// Validation episodes for each pair and setting
    #[arg(long, value_name = "N", default_value_t = 500)]
    pub episodes: usize,
    /// The seed of the validation episodes
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,
    /// Guards, for problems that have some: on the arm none, joint-limits, collisions or both [default: the last]
    #[arg(long, value_name = "GUARD", value_delimiter = ',')]
    pub guard: Vec<String>,
    /// Methods of detecting cycles [default: visited; none where the problem has no keys]
    #[arg(long, value_enum, value_name = "DETECTOR", value_delimiter = ',')]
    pub cycle_detector: Vec<Detector>,
    /// Actions of the network before the graph takes over again, or `never` [default: 1, 5, 20, 50, 100 and never]
    #[arg(long, value_name = "N", value_delimiter = ',')]
    pub hand_back_after: Vec<Span>,
    /// The network takes over when the distance to the goal exceeds its minimum by this, in the problem's own unit, or `inf`
    /// [default: quantiles of what the graphs alone do, and inf]
    #[arg(long, value_name = "D", value_delimiter = ',')]
    pub separation: Vec<f64>,
    /// The network takes over after N actions of the graph without progress, or `never` [default: 5, 10, 20, 50
    /// and never]
    #[arg(long, value_name = "N", value_delimiter = ',')]
    pub patience: Vec<Span>,
    /// Threads; 0 for one per core
    #[arg(long, value_name = "N", default_value_t = 0)]
    #[serde(skip)]
    pub threads: usize,
}

/// Graphs and networks with their files.
type Parts = (Vec<(String, Graph)>, Vec<(String, Network)>);

impl StudyArgs {
    /// Returns the settings that can hand over, in the order of `cells.csv`.
    fn grid(&self) -> Vec<Setting> {
        let mut all = Vec::new();
        for guard in &self.guard {
            for &detector in &self.cycle_detector {
                for &hand_back_after in &self.hand_back_after {
                    for &separation in &self.separation {
                        all.extend(self.patience.iter().map(|&patience| {
                            let guard = guard.clone();
                            Setting { hand_back_after, separation, patience, detector, guard }
                        }));
                    }
                }
            }
        }
        all.retain(Setting::has_trigger);
        all
    }

    fn read(&self) -> Result<Parts, InputError> {
        let graph = |path: &PathBuf| Ok::<_, InputError>((path.display().to_string(), read_graph(path)?));
        let network = |path: &PathBuf| Ok::<_, InputError>((path.display().to_string(), Network::read(path)?));
        let graphs = self.tpg.iter().map(graph).collect::<Result<_, _>>()?;
        Ok((graphs, self.policy.iter().map(network).collect::<Result<_, _>>()?))
    }
}

/// Runs the study that the command line asks for.
///
/// # Errors
/// Files that are not policies of the problem, settings that it does not have, a folder with a run, files that
/// cannot be written.
pub(crate) fn execute(args: &HybridArgs) -> Result<Verdict, InputError> {
    let parts = args.study.read()?;
    let problem = crate::evaluate::problem_for(args.problem, args.config.as_deref(), &parts.0, &parts.1)?;
    study(&problem, &args.study, parts)
}

/// Runs a study on a problem, such as [an environment of your own](super::shared::OwnProblem).
///
/// # Errors
/// Files that are not policies of the problem, settings that it does not have, files that cannot be written.
pub fn study_on(problem: &dyn Shared, args: &StudyArgs) -> Result<Verdict, InputError> {
    study(problem, args, args.read()?)
}

fn study(problem: &dyn Shared, args: &StudyArgs, (graphs, networks): Parts) -> Result<Verdict, InputError> {
    let facts = problem.facts();
    let episodes = Episodes { set: TaskSet::Study, count: args.episodes, seed: args.seed, file: None };
    let mut subject = Subject { problem, graphs, networks, settings: Vec::new(), episodes };
    let mut asked = args.clone();
    or(&mut asked.guard, || vec![facts.guards.last().copied().unwrap_or(UNGUARDED).to_owned()]);
    or(&mut asked.cycle_detector, || vec![if facts.has_key { Detector::Visited } else { Detector::None }]);
    or(&mut asked.hand_back_after, || spans(&[1, 5, 20, 50, 100]));
    or(&mut asked.patience, || spans(&[5, 10, 20, 50]));
    asked.separation = separations(args, &subject)?;
    subject.settings = asked.grid();
    let refused = |setting: &Setting| setting.check_on(&problem.name(), facts.guards, facts.has_key);
    subject.settings.iter().try_for_each(refused)?;
    if subject.graphs.iter().any(|(_, graph)| asks(graph)) {
        subject.settings.push(Setting::only_asks());
    }
    if subject.settings.is_empty() {
        let accepted = "a finite --separation, a --patience in actions, or --cycle-detector visited or brent";
        return Err(command_line("settings by which the graph never hands over", accepted));
    }
    // Policies that do not fit are refused before the folder is made.
    let threads = rayon::ThreadPoolBuilder::new().num_threads(args.threads).build().map_err(|error| {
        InputError::new("--threads", Place::Whole, error.to_string(), "a number of threads that can be started")
    })?;
    let alone = threads.install(|| alone(&subject))?;
    let folder = RunFolder::open(&args.out, false)?;
    let mut asked = toml::Table::try_from(&asked).expect("plain data");
    asked.insert("problem".to_owned(), problem.table().into());
    write_atomically(&folder.file("study.toml"), asked.to_string().as_bytes())?;
    let cells = cells(&subject, &threads)?;
    write_atomically(&folder.file("cells.csv"), &to_csv(cells.iter().map(|cell| (&cell.setting, cell, &cell.result))))?;
    write_atomically(&folder.file("alone.csv"), &to_csv(alone.iter()))?;
    if let Some(best) = choose(&cells, &subject.settings, facts.preference) {
        let setting = &best.setting;
        let hybrid = HybridFile {
            problem: Some(problem.name()),
            graph: absolute(&args.tpg[best.tpg]),
            actor: absolute(&args.policy[best.sac]),
            hand_back_after: setting.hand_back_after,
            separation: setting.separation,
            patience: setting.patience,
            cycle_detector: setting.detector,
            guard: (!facts.guards.is_empty()).then(|| setting.guard.clone()),
        };
        write_atomically(&folder.file("hybrid.toml"), toml::to_string(&hybrid).expect("plain data").as_bytes())?;
        let (setting, Cell { result, network_actions, .. }) = (setting.sentence(), best);
        tpg_graph::command::note(format_args!(
            "chosen: {setting}: score {:.2}, {network_actions:.1} of {:.1} actions by the network",
            result.score, result.actions
        ));
    }
    Ok(Verdict::Good)
}

/// Computes a cell for each pair and setting.
fn cells(subject: &Subject<'_>, threads: &ThreadPool) -> Result<Vec<Cell>, InputError> {
    let pairs = (0..subject.graphs.len()).flat_map(|tpg| (0..subject.networks.len()).map(move |sac| (tpg, sac)));
    let all: Vec<_> = pairs.flat_map(|pair| subject.settings.iter().map(move |setting| (pair, setting))).collect();
    let (progress, done) = (Bar::begin(), AtomicU64::new(0));
    let cell = |&((tpg, sac), setting)| {
        let cell = subject.cell(tpg, sac, setting)?;
        progress.show(done.fetch_add(1, Ordering::Relaxed) + 1, all.len() as u64, String::new);
        Ok(cell)
    };
    threads.install(|| all.par_iter().map(cell).collect())
}

/// Returns the absolute path of a file.
fn absolute(path: &Path) -> String {
    path.canonicalize().unwrap_or_else(|_| path.to_owned()).display().to_string()
}

/// Puts the default where nothing is asked for.
fn or<T>(asked: &mut Vec<T>, default: impl FnOnce() -> Vec<T>) {
    if asked.is_empty() {
        *asked = default();
    }
}

/// Returns some numbers of actions, and never.
fn spans(actions: &[u32]) -> Vec<Span> {
    actions.iter().copied().map(Span).chain([Span::NEVER]).collect()
}

/// Quantiles of a graph's rises above its least distance that become separations.
const QUANTILES: [f64; 5] = [0.5, 0.75, 0.9, 0.95, 0.99];
/// Number of episodes in which the rises are measured.
const MEASURED: usize = 50;

/// Returns the separations asked for, or quantiles of the rises of the graphs alone, to two digits, and infinity.
fn separations(args: &StudyArgs, subject: &Subject<'_>) -> Result<Vec<f64>, InputError> {
    if !args.separation.is_empty() {
        let refused = |bad| Err(command_line(format!("--separation {bad}"), "distances from 0, or inf"));
        let bad = args.separation.iter().find(|separation| !matches!(separation, 0.0..));
        return bad.map_or_else(|| Ok(args.separation.clone()), refused);
    }
    let episodes = Episodes { count: MEASURED.min(args.episodes), ..subject.episodes };
    let (mut rises, only_asks) = (Vec::new(), Setting::only_asks());
    for graph in &subject.graphs {
        // A graph that asks rises with each network in its own way, any other as without one.
        for network in subject.networks.iter().take(if asks(&graph.1) { usize::MAX } else { 1 }) {
            let both = Acting::Both(graph, network, &only_asks);
            rises.extend(subject.problem.play(both, episodes)?.rises);
        }
    }
    Ok(quantiles(rises))
}

/// Returns separations for rises that were seen: quantiles, to two digits, and infinity.
pub(super) fn quantiles(mut rises: Vec<f64>) -> Vec<f64> {
    rises.retain(|rise| rise.is_finite());
    rises.sort_by(f64::total_cmp);
    let two_digits = |value: f64| format!("{value:.1e}").parse::<f64>().unwrap_or(value);
    let quantile = |part: f64| rises.get((part * rises.len() as f64) as usize).map(|&rise| two_digits(rise));
    let mut all: Vec<f64> = QUANTILES.into_iter().filter_map(quantile).filter(|&rise| rise > 0.0).collect();
    all.push(f64::INFINITY);
    all.dedup();
    all
}

/// Returns true if a graph asks for a network, and so cannot act alone.
fn asks(graph: &Graph) -> bool {
    graph.asks().next().is_some()
}

/// A policy that acts alone: with its result, a row of `alone.csv`.
#[derive(Serialize)]
struct Alone<'a> {
    /// `tpg` or `sac`.
    kind: &'static str,
    /// Its file.
    file: &'a str,
}

/// Lets every policy that can act alone.
fn alone<'a>(subject: &'a Subject<'_>) -> Result<Vec<(Alone<'a>, Summary)>, InputError> {
    let graphs = subject.graphs.iter().filter(|(_, graph)| !asks(graph));
    let graphs = graphs.map(|graph| (Alone { kind: "tpg", file: &graph.0 }, Acting::Graph(graph)));
    let networks = subject.networks.iter();
    let networks = networks.map(|network| (Alone { kind: "sac", file: &network.0 }, Acting::Network(network)));
    let all: Vec<_> = graphs.chain(networks).collect();
    let play = |(policy, acting)| Ok((policy, Summary::new(&subject.problem.play(acting, subject.episodes)?.endings)));
    all.into_par_iter().map(play).collect()
}
