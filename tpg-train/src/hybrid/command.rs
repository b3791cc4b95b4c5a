//! `tpg-train hybrid`: the study of a hybrid's settings.
//!
//! The folder of a study contains `study.toml` (the request), `cells.csv` (a row for each pair and setting),
//! `settings.csv` (means over pairs, choice), `alone.csv`, `hybrid.toml` (the chosen setting with the best pair): the same bytes for equal
//! runs.

use super::cells::{Alone, Cell, Subject, grid};
use super::choice;
use super::rollout::Acting;
use super::setting::{Detector, HybridFile, Setting, UNGUARDED};
use super::shared::{Episodes, Facts, Shared};
use super::span::Span;
use super::study::{self, absolute};
use crate::csv_text::to_csv;
use crate::folder::{RunFolder, Trainer};
use crate::run_args::command_line;
use crate::sac::network::Network;
use clap::Args;
use rayon::prelude::*;
use serde::Serialize;
use std::path::PathBuf;
use tpg_engine::{Summary, TaskSet};
use tpg_graph::Graph;
use tpg_graph::command::Verdict;
use tpg_graph::error::{InputError, Place};
use tpg_graph::files::{read_graph, write_atomically};
use tpg_problems::{Problem, ProblemName};

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
    pub threads: usize,
}

/// Content of `study.toml`.
#[derive(Clone, Debug, Serialize)]
struct Asked {
    episodes: usize,
    seed: u64,
    guards: Vec<String>,
    cycle_detectors: Vec<Detector>,
    hand_back_after: Vec<Span>,
    separation: Vec<f64>,
    patience: Vec<Span>,
    tpg: Vec<PathBuf>,
    policy: Vec<PathBuf>,
    problem: toml::Table,
}

/// Runs the study that the command line asks for.
///
/// # Errors
/// Files that are not policies of the problem, settings that it does not have, a folder with a run, files that
/// cannot be written.
pub(crate) fn execute(args: &HybridArgs) -> Result<Verdict, InputError> {
    study_on(&shared_problem(args)?, &args.study)
}

/// Runs a study on a problem, such as [an environment of your own](super::shared::OwnProblem).
///
/// # Errors
/// Files that are not policies of the problem, settings that it does not have, files that cannot be written.
pub fn study_on(problem: &dyn Shared, args: &StudyArgs) -> Result<Verdict, InputError> {
    let facts = problem.facts();
    let read_networks = args.policy.iter().map(|path| Ok((path.display().to_string(), Network::read(path)?)));
    let mut subject = Subject {
        problem,
        graphs: args.tpg.iter().map(|p| Ok((p.display().to_string(), read_graph(p)?))).collect::<Result<_, _>>()?,
        networks: read_networks.collect::<Result<_, InputError>>()?,
        settings: Vec::new(),
        episodes: Episodes { set: TaskSet::Study, count: args.episodes, seed: args.seed, file: None },
    };
    for (file, network) in &subject.networks {
        crate::evaluate::same_problem(&problem.name(), file, network)?;
    }
    let asked = Asked {
        episodes: args.episodes,
        seed: args.seed,
        guards: or(&args.guard, || vec![facts.guards.last().copied().unwrap_or(UNGUARDED).to_owned()]),
        cycle_detectors: or(&args.cycle_detector, || {
            vec![if facts.has_key { Detector::Visited } else { Detector::None }]
        }),
        hand_back_after: or_spans(&args.hand_back_after, &[1, 5, 20, 50, 100], &facts),
        separation: separations(args, &subject)?,
        patience: or_spans(&args.patience, &[5, 10, 20, 50], &facts),
        tpg: args.tpg.clone(),
        policy: args.policy.clone(),
        problem: problem.table(),
    };
    let Asked { guards, cycle_detectors, hand_back_after, separation, patience, .. } = &asked;
    subject.settings = grid(guards, cycle_detectors, hand_back_after, separation, patience);
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
    let threads = study::threads(args.threads)?;
    let alone = threads.install(|| alone(&subject))?;
    let folder = RunFolder::open(&args.out, Trainer::Hybrid, false)?;
    write_atomically(&folder.file("study.toml"), toml::to_string(&asked).expect("plain data").as_bytes())?;
    let cells = study::run(&subject, &folder, &threads)?;
    finish(args, &subject, &facts, &cells, &alone)
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
    write_atomically(&file("settings.csv"), &to_csv(summaries.iter().map(|summary| (&summary.setting, summary))))?;
    write_atomically(&file("alone.csv"), &to_csv(alone.iter()))?;
    let chosen = summaries.iter().find(|summary| summary.chosen);
    let best = chosen.and_then(|chosen| choice::best_pair(cells, &chosen.setting, facts.preference));
    let Some((chosen, best)) = chosen.zip(best) else { return Ok(Verdict::Good) };
    let hybrid = HybridFile {
        problem: Some(problem.name()),
        graph: absolute(&args.tpg[best.tpg]),
        actor: absolute(&args.policy[best.sac]),
        hand_back_after: chosen.setting.hand_back_after,
        separation: chosen.setting.separation,
        patience: chosen.setting.patience,
        cycle_detector: chosen.setting.detector,
        guard: (!facts.guards.is_empty()).then(|| chosen.setting.guard.clone()),
    };
    write_atomically(&file("hybrid.toml"), toml::to_string(&hybrid).expect("plain data").as_bytes())?;
    tpg_graph::command::note(format_args!(
        "chosen: {}: score {:.2}, {:.1} of {:.1} actions by the network",
        chosen.setting.sentence(),
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

/// Returns the problem of the arguments with what the policies say of their training.
fn shared_problem(args: &HybridArgs) -> Result<Problem, InputError> {
    let mut problem: Option<Problem> = None;
    for path in &args.study.tpg {
        let (file, graph) = (path.display().to_string(), read_graph(path)?);
        let own = crate::evaluate::problem_for(args.problem, args.config.as_deref(), Some((&file, &graph)))?;
        if problem.as_ref().is_some_and(|first| *first != own) {
            let accepted = "one as the first, or --config";
            return Err(InputError::new(file, Place::Whole, "a graph for another arm", accepted));
        }
        problem = Some(own);
    }
    let mut problem = problem.unwrap_or_else(|| Problem::new(args.problem));
    // The first network's rules of tests hold for all.
    for (place, path) in args.study.policy.iter().enumerate().rev() {
        let rules = place == 0 && args.config.is_none();
        problem = problem.joined(&path.display().to_string(), &Network::read(path)?.settings(), rules, true)?;
    }
    Ok(problem)
}

/// Returns what is asked for, or the default.
fn or<T: Clone>(asked: &[T], default: impl FnOnce() -> Vec<T>) -> Vec<T> {
    if asked.is_empty() { default() } else { asked.to_vec() }
}

/// Returns the numbers asked for, or the common ones that an episode can reach, and never.
fn or_spans(asked: &[Span], common: &[u32], facts: &Facts) -> Vec<Span> {
    let reached = common.iter().copied().filter(|&actions| actions < facts.time_limit).map(Span);
    or(asked, || reached.chain([Span::NEVER]).collect())
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

/// Lets every policy that can act alone.
fn alone(subject: &Subject<'_>) -> Result<Vec<Alone>, InputError> {
    let graphs = subject.graphs.iter().map(|graph| ("tpg", &graph.0, Acting::Graph(graph))).enumerate();
    let networks = subject.networks.iter().map(|network| ("sac", &network.0, Acting::Network(network))).enumerate();
    let graphs = graphs.filter(|&(place, _)| !asks(&subject.graphs[place].1));
    let all: Vec<_> = graphs.chain(networks).collect();
    all.into_par_iter()
        .map(|(place, (kind, file, acting))| {
            let endings = subject.problem.play(acting, subject.episodes)?.endings;
            let summary = Summary::new(&endings);
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
