//! `tpg-train hybrid`: the study of a hybrid's settings.
//!
//! The folder of a study contains `study.toml` (the request), `cells.csv` (a row for each pair and setting),
//! `settings.csv` (means over pairs, front, choice), `alone.csv`, `hybrid.toml` (the chosen setting with the best pair)
//! and `report.html`; for the arm also `timing.csv`. All but the arm's times are the same bytes for equal runs.

use super::arm::command as arm;
use super::cells::{Cell, Subject, grid};
use super::choice;
use super::report;
use super::setting::{Detector, HybridFile, Setting};
use super::shared::{Episodes, Facts, Shared};
use super::span::Span;
use super::study::{self, Input, absolute, to_csv};
use super::trial::Acting;
use crate::files::{read_graph, write_atomically};
use crate::ranks::workplace::Workplace;
use crate::run_args::command_line;
use crate::sac::network::Network;
use clap::Args;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;
use tpg_arm::hybrid::Guard;
use tpg_engine::Summary;
use tpg_engine::random::Purpose;
use tpg_graph::Graph;
use tpg_graph::command::Verdict;
use tpg_graph::error::{Finding, InputError};
use tpg_problems::ProblemName;

/// Study how graphs and networks share a problem, on validation episodes.
#[derive(Clone, Debug, Args)]
pub struct HybridArgs {
    /// The problem
    #[arg(long, value_enum)]
    pub problem: ProblemName,
    /// The arguments of a study on any problem
    #[command(flatten)]
    pub study: StudyArgs,
    /// The problem's settings of this configuration. Default: those of the problem; on the arm those of the network's tests, and
    /// the arm that the graphs were trained for
    #[arg(long, value_name = "FILE")]
    pub config: Option<PathBuf>,
    /// The arm only: guards, none, joint-limits, collisions or both [default: every one]
    #[arg(long, value_name = "GUARD", value_delimiter = ',', value_parser = guard)]
    pub guard: Vec<Guard>,
}

/// The arguments of a study on any problem.
#[derive(Clone, Debug, Args)]
pub struct StudyArgs {
    /// Graphs
    #[arg(long, value_name = "GRAPH", num_args = 1.., required = true)]
    pub tpg: Vec<PathBuf>,
    /// Networks: policy.safetensors or policy.q.json
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
    /// Methods of detecting cycles [default: visited; none where the problem has no keys]
    #[arg(long, value_enum, value_name = "DETECTOR", value_delimiter = ',')]
    pub cycle_detector: Vec<Detector>,
    /// Actions of the network before the graph takes over again, or `never` [default: 1, 5, 20, 50, 100 and never; the
    /// paper's on the arm]
    #[arg(long, value_name = "N", value_delimiter = ',')]
    pub hand_back_after: Vec<Span>,
    /// The network takes over when the distance to the goal exceeds its least by this, in the problem's own unit, or `inf`
    /// [default: quantiles of what the graphs alone do, and inf; the paper's on the arm]
    #[arg(long, value_name = "D", value_delimiter = ',')]
    pub separation: Vec<f64>,
    /// The network takes over after that many actions of the graph without progress, or `never` [default: 5, 10, 20, 50
    /// and never]. Not on the arm
    #[arg(long, value_name = "N", value_delimiter = ',')]
    pub patience: Vec<Span>,
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
    /// Mean score.
    pub mean_score: f64,
    /// Standard deviation of the scores, over the episodes (of the sample, n − 1).
    pub std_score: f64,
    /// Fraction of successes, 0 to 1; empty if the problem does not define success.
    pub success: Option<f64>,
    /// Mean number of actions.
    pub mean_steps: f64,
}

/// Content of `study.toml`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Asked {
    episodes: usize,
    seed: u64,
    cycle_detectors: Vec<Detector>,
    hand_back_after: Vec<Span>,
    separation: Vec<f64>,
    patience: Vec<Span>,
    problem: toml::Table,
    tpg: Vec<Input>,
    policy: Vec<Input>,
}

/// Runs the study that the command line asks for.
///
/// # Errors
/// Files that are not policies of the problem, settings that it does not have, a folder with another study, files that
/// cannot be written.
pub fn execute(args: &HybridArgs, place: &impl Workplace) -> Result<Verdict, InputError> {
    if let Some(start) = args.problem.start() {
        return arm::execute(args, start, place);
    }
    if !args.guard.is_empty() {
        let found = format!("--guard with --problem {}", args.problem.name());
        return Err(command_line(found, "--guard with fs or rs: only the arm has guards"));
    }
    let problem = crate::evaluate::graph_problem(args.problem, args.config.as_deref())?;
    study_on(&problem, &args.study, place)
}

/// Runs a study on a problem, such as [an environment of your own](super::shared::OwnProblem).
///
/// # Errors
/// As [`execute`].
pub fn study_on(problem: &dyn Shared, args: &StudyArgs, place: &impl Workplace) -> Result<Verdict, InputError> {
    let facts = problem.facts();
    let read_networks = args.policy.iter().map(|path| Ok((path.display().to_string(), Network::read(path)?)));
    let mut subject = Subject {
        problem,
        graphs: args.tpg.iter().map(|p| Ok((p.display().to_string(), read_graph(p)?))).collect::<Result<_, _>>()?,
        networks: read_networks.collect::<Result<_, InputError>>()?,
        settings: Vec::new(),
        episodes: Episodes { purpose: Purpose::Selection, count: args.episodes, seed: args.seed },
    };
    for (file, network) in &subject.networks {
        crate::evaluate::same_problem(&problem.name(), file, network)?;
    }
    let asked = Asked {
        episodes: args.episodes,
        seed: args.seed,
        cycle_detectors: detectors(args, &facts, &problem.name())?,
        hand_back_after: or_spans(&args.hand_back_after, &[1, 5, 20, 50, 100], &facts),
        separation: separations(args, &subject)?,
        patience: or_spans(&args.patience, &[5, 10, 20, 50], &facts),
        problem: problem.table(),
        tpg: Input::of(&args.tpg)?,
        policy: Input::of(&args.policy)?,
    };
    subject.settings = grid(&asked.cycle_detectors, &asked.hand_back_after, &asked.separation, &asked.patience);
    if subject.graphs.iter().any(|(_, graph)| asks(graph)) {
        subject.settings.push(Setting::ONLY_ASKS);
    }
    if subject.settings.is_empty() {
        let accepted = "a finite --separation, a --patience in actions, or --cycle-detector visited or brent";
        return Err(command_line("settings by which the graph never hands over", accepted));
    }
    // Policies that do not fit are refused before the folder is made.
    let threads = study::threads(args.threads)?;
    place.study(&study::identity(&asked), &threads, &|number| study::numbered(&subject, number), |cells| {
        let alone = threads.install(|| alone(&subject))?;
        let folder = study::open_folder(&args.out, args.resume, &asked)?;
        let Some(cells) = study::in_folder(&subject, &folder, cells)? else { return Ok(Verdict::Interrupted) };
        finish(args, &subject, &facts, &cells, &alone)
    })
}

/// Writes the results of a study.
fn finish(
    args: &StudyArgs,
    subject: &Subject<'_>,
    facts: &Facts,
    cells: &[Cell],
    alone: &[Alone],
) -> Result<Verdict, InputError> {
    let problem = subject.problem;
    let summaries = choice::summarise(cells, &subject.settings, facts.preference);
    let file = |name: &str| args.out.join(name);
    write_atomically(&file("settings.csv"), &to_csv(summaries.iter()))?;
    write_atomically(&file("alone.csv"), &to_csv(alone.iter()))?;
    write_atomically(&file("report.html"), report::page(&problem.name(), cells, &summaries, alone).as_bytes())?;
    let Some(chosen) = summaries.iter().find(|summary| summary.chosen) else { return Ok(Verdict::Good) };
    let Some(best) = choice::best_pair(cells, &chosen.setting(), facts.preference) else { return Ok(Verdict::Good) };
    let hybrid = HybridFile {
        problem: problem.name(),
        graph: absolute(&args.tpg[best.tpg]),
        actor: absolute(&args.policy[best.sac]),
        hand_back_after: chosen.hand_back_after,
        separation: chosen.separation,
        patience: chosen.patience,
        cycle_detector: chosen.cycle_detector,
    };
    write_atomically(&file("hybrid.toml"), toml::to_string(&hybrid).expect("plain data").as_bytes())?;
    tpg_graph::command::note(format_args!(
        "chosen: {}: score {:.2}, {:.1} of {:.1} actions by the network",
        chosen.setting().sentence(),
        chosen.score,
        chosen.network_actions,
        chosen.steps
    ));
    for Alone { kind, file, mean_score, .. } in alone {
        tpg_graph::command::note(format_args!(
            "{}: {file}: score {mean_score:.2}",
            if *kind == "tpg" { "graph alone" } else { "network alone" }
        ));
    }
    Ok(Verdict::Good)
}

/// Returns the detectors asked for, or the usual one.
fn detectors(args: &StudyArgs, facts: &Facts, problem: &str) -> Result<Vec<Detector>, InputError> {
    if args.cycle_detector.is_empty() {
        return Ok(vec![if facts.has_key { Detector::Visited } else { Detector::None }]);
    }
    args.cycle_detector.iter().try_for_each(|&detector| check_detector(detector, facts.has_key, problem))?;
    Ok(args.cycle_detector.clone())
}

/// Refuses to detect cycles on a problem without keys.
///
/// # Errors
/// If it has none and the detector needs them.
pub fn check_detector(detector: Detector, has_key: bool, problem: &str) -> Result<(), InputError> {
    if has_key || detector == Detector::None {
        return Ok(());
    }
    let found = format!("cycle detector {} for {problem}, which has no keys to detect cycles by", detector.name());
    Err(command_line(found, "none, with a separation or a patience; or an Environment with `key`"))
}

/// Returns the numbers asked for, or the usual ones that an episode can reach, and never.
fn or_spans(asked: &[Span], usual: &[u32], facts: &Facts) -> Vec<Span> {
    if !asked.is_empty() {
        return asked.to_vec();
    }
    let reached = usual.iter().copied().filter(|&actions| actions < facts.time_limit).map(Span);
    reached.chain([Span::NEVER]).collect()
}

/// Quantiles of a graph's rises above its least distance that become separations.
const QUANTILES: [f64; 5] = [0.5, 0.75, 0.9, 0.95, 0.99];
/// Number of episodes in which the rises are measured.
const MEASURED: usize = 50;

/// Returns the separations asked for, or quantiles of the rises of the graphs alone, to two digits, and infinity.
fn separations(args: &StudyArgs, subject: &Subject<'_>) -> Result<Vec<f64>, InputError> {
    if !args.separation.is_empty() {
        let bad = args.separation.iter().find(|separation| !matches!(separation, 0.0..));
        return match bad {
            Some(bad) => Err(command_line(format!("--separation {bad}"), "distances from 0, or inf")),
            None => Ok(args.separation.clone()),
        };
    }
    let episodes = Episodes { count: MEASURED.min(args.episodes), ..subject.episodes };
    let mut rises = Vec::new();
    for graph in &subject.graphs {
        // A graph that asks rises with each network in its own way, any other as without one.
        for network in subject.networks.iter().take(if asks(&graph.1) { usize::MAX } else { 1 }) {
            rises.extend(subject.problem.rises(graph, network, episodes)?);
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

/// Lets every policy that can act alone.
fn alone(subject: &Subject<'_>) -> Result<Vec<Alone>, InputError> {
    let graphs = subject.graphs.iter().map(|graph| ("tpg", &graph.0, Acting::Graph(graph))).enumerate();
    let networks = subject.networks.iter().map(|network| ("sac", &network.0, Acting::Network(network))).enumerate();
    let graphs = graphs.filter(|&(place, _)| !asks(&subject.graphs[place].1));
    let all: Vec<_> = graphs.chain(networks).collect();
    all.into_par_iter()
        .map(|(place, (kind, file, acting))| {
            let endings = subject.trial(acting)?.endings;
            let summary = Summary::of(&endings);
            Ok(Alone {
                kind,
                place,
                file: file.clone(),
                mean_score: summary.score,
                std_score: summary.score_deviation(&endings),
                success: summary.success,
                mean_steps: summary.actions,
            })
        })
        .collect()
}

/// Returns the setting of a graph and a network that were named on the command line.
///
/// # Errors
/// If it has no trigger and the graph asks nobody, or if its separation is no distance.
pub fn setting_of(
    graph: &Graph,
    hand_back_after: Span,
    separation: f64,
    patience: Span,
    detector: Detector,
) -> Result<Setting, InputError> {
    let setting = Setting { hand_back_after, separation, patience, detector };
    let refuse = |Finding { key, found, accepted }: Finding| command_line(format!("{key} = {found}"), accepted);
    setting.check_for(graph).map_err(refuse)?;
    Ok(setting)
}
