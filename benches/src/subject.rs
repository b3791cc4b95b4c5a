//! Policies, each with the states of its own episodes, in order.

use std::path::{Path, PathBuf};
use std::{env, fs};
use tpg_arm::WIDOWX;
use tpg_arm::cycle::Brent;
use tpg_arm::episode::Episode;
use tpg_arm::observation::{Observation, Source, TargetMemo};
use tpg_graph::Graph;
use tpg_graph::engine::Reference;
use tpg_graph::error::InputError;
use tpg_graph::import::{self, Profile};
use tpg_graph::interpret;
use tpg_paper::binding::Binding;
use tpg_paper::chain::Chain;
use tpg_paper::episode::Rules;
use tpg_paper::limits::max_actions;
use tpg_paper::{data, replay};
use tpg_problems::ProblemName;
use tpg_problems::arm::targets::{self, Start};

/// Number of states of a subject: too many for a branch predictor to memorise.
const STATES: usize = 8192;

/// Origin of a policy; policies of a kind are summarised together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SubjectKind {
    /// The paper's, as evolved.
    Trained,
    /// The paper's, with everything that no episode visits removed by its authors.
    Pruned,
    /// This project's.
    Own,
}

/// A policy and the states to decide.
#[derive(Debug)]
pub struct Subject {
    /// Name in the table.
    pub name: String,
    /// Origin.
    pub kind: SubjectKind,
    /// The policy.
    pub graph: Graph,
    /// Flat states, in the order of the episodes.
    pub states: Vec<f64>,
}

impl Subject {
    /// Returns the number of states.
    pub fn count(&self) -> usize {
        self.states.len() / self.graph.state_length()
    }
}

/// Returns this project's policies: `generated/widowx-fs` and the like, on the first of their test episodes.
///
/// # Panics
/// If a committed file cannot be read.
pub fn own() -> Vec<Subject> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../generated");
    let subject = |start: Start| {
        let problem = ProblemName::from(start).name();
        let name = format!("widowx-{problem}");
        let read = || -> Result<_, InputError> {
            let graph = import::load(&folder.join(&name).join("graph.json"), None, None)?;
            Ok((graph, targets::read_csv(&WIDOWX, &folder.join(format!("test-targets/{problem}.csv")))?))
        };
        let (graph, tasks) = read().unwrap_or_else(|error| panic!("{error}"));
        let states = episodes(&graph, &tasks, start);
        Subject { name, kind: SubjectKind::Own, graph, states }
    };
    [Start::Fs, Start::Rs].map(subject).into()
}

fn episodes(graph: &Graph, tasks: &[targets::Task], start: Start) -> Vec<f64> {
    let (arm, Binding { sources, moves, .. }) = (WIDOWX.to_f32(), Binding::new(graph).expect("a graph of the arm"));
    let mut state = vec![0.0; graph.state_length()];
    let mut states = Vec::with_capacity(STATES * state.len());
    for task in tasks {
        let mut episode = Episode::new(&arm, task.problem(start), Brent::new());
        let memo = TargetMemo::new();
        loop {
            if states.len() == STATES * state.len() {
                return states;
            }
            Source::fill(&sources, &arm, episode.observation(), &memo, &mut state);
            let flat: Vec<f64> = state.iter().copied().map(f64::from).collect();
            let action = interpret::actions(graph, &flat)[0];
            states.extend(flat);
            if episode.advance(moves[usize::from(action.0)]).is_some() {
                break;
            }
        }
    }
    states
}

/// Returns the paper's policies on the first states of their recorded episodes, if available; otherwise reports the
/// skip.
///
/// # Panics
/// If the folder exists and cannot be read, or a policy does not end its episodes as recorded.
pub fn conformance() -> Vec<Subject> {
    let default = || Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/conformance");
    let folder = env::var_os("TPG_CONFORMANCE").map_or_else(default, PathBuf::from);
    if !folder.is_dir() {
        tpg_testing::skip(&format!("the paper's policies: no folder {} (TPG_CONFORMANCE)", folder.display()));
        return Vec::new();
    }
    let mut graphs: Vec<PathBuf> = ["tpg_traced", "tpg"]
        .iter()
        .flat_map(|part| fs::read_dir(folder.join(part)).expect("a part of the recorded data"))
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "dot"))
        .collect();
    graphs.sort();
    graphs
        .iter()
        .map(|path| {
            let mut subject = recorded(&folder, path);
            subject.states.truncate(STATES * subject.graph.state_length());
            subject
        })
        .collect()
}

/// Reads a recorded policy; its name identifies the recordings.
fn recorded(folder: &Path, path: &Path) -> Subject {
    let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
    let (problem, targets) = match name.split('_').next() {
        Some("rs") => (Start::Rs, "targets_rs.csv"),
        _ => (Start::Fs, "targets_fs.csv"),
    };
    let tolerance = if name.contains("range0.03") { 0.03 } else { 3.0 };
    let read = || -> Result<_, InputError> {
        let graph = import::load(path, Some(Profile::Ecta24), None)?;
        let tasks = data::tasks(&folder.join(targets))?;
        let ends = path.with_file_name(format!("{}.ends.csv", name.trim_end_matches(".cleaned")));
        Ok((graph, tasks, data::ends(&ends)?))
    };
    let (graph, tasks, ends) = read().unwrap_or_else(|error| panic!("{error}"));
    let binding = Binding::new(&graph).expect("a graph of the arm");
    let chain = Chain::new(WIDOWX);
    let rules = Rules { max_actions: max_actions(problem), tolerance };
    let done = replay::run(&chain, rules, &tasks, &binding, &mut Reference::new(&graph))
        .unwrap_or_else(|error| panic!("{name}: {error}"));
    let comparison = replay::compare(&ends, &done, replay::end_difference);
    assert!(comparison.is_exact(), "{name}: {comparison:?}");

    let mut states = Vec::new();
    for (row, task) in &tasks {
        let poses = &done[row].poses;
        // Every action was decided in the preceding pose.
        for &pose in [task.start].iter().chain(&poses[..poses.len() - 1]) {
            let seen = Observation::new(chain.arm(), pose, chain.hand(pose), task.target);
            binding.push_state(&seen, &mut states);
        }
    }
    let kind = if name.ends_with(".cleaned") { SubjectKind::Pruned } else { SubjectKind::Trained };
    Subject { name, kind, graph, states }
}
