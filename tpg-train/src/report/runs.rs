//! Reading and grouping of run folders.

use super::test::Tested;
use crate::effort::Effort;
use crate::evaluate::problem_for;
use crate::hybrid::rollout::Policies;
use crate::hybrid::setting::{Hybrid, Setting};
use crate::run_time::RunTime;
use crate::sac::network::Network;
use crate::sac::weights;
use serde::Deserialize;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::slice::from_ref;
use tpg_engine::EpisodeResult;
use tpg_graph::Graph;
use tpg_graph::error::{InputError, Place};
use tpg_graph::files::read_text;
use tpg_graph::settings;
use tpg_problems::{PolicyKind, Problem, ProblemName};

/// The name of a problem without one.
pub(super) const OWN: &str = "own";

/// Runs with the same configuration.
#[derive(Debug)]
pub(super) struct Group {
    /// Common part of their names.
    pub(super) name: String,
    /// The runs, in the order of their seeds.
    pub(super) runs: Vec<Run>,
}

/// One run.
#[derive(Debug)]
pub(super) struct Run {
    /// Name of the folder; for a restart, with its parent folder.
    pub(super) name: String,
    /// Seed, if the run states it.
    pub(super) seed: Option<u64>,
    /// The rows of its log.
    log: Vec<Value>,
    /// CPU time in seconds, if the run states it.
    pub(super) cpu: Option<f64>,
    /// The problem; `None` if a program supplied its own environment.
    pub(super) problem: Option<Problem>,
    /// The trained policy.
    pub(super) policies: Policies,
    /// The hall of fame: the best policy of each size, without the trained one itself, named by its generation.
    pub(super) hall: Vec<Self>,
    /// What the program with the environment found on test episodes of the trained policy.
    pub(super) tested: Option<TestedElsewhere>,
    /// The result on the test episodes, once they have been run.
    pub(super) result: Option<Tested>,
}

/// Test episodes that the program with the environment has run: `tested.jsonl`.
#[derive(Debug, Deserialize)]
pub(super) struct TestedElsewhere {
    /// The SHA-256 of the graph.
    graph: String,
    /// Its episodes.
    pub(super) episodes: Vec<EpisodeResult>,
    /// Its effort, where actions are values between bounds.
    #[serde(default)]
    pub(super) effort: Option<Effort>,
    /// Other controllers on the same episodes.
    #[serde(default)]
    pub(super) rivals: Vec<Rival>,
}

/// Another controller on the same episodes.
#[derive(Debug, Deserialize)]
pub(super) struct Rival {
    /// Its name.
    pub(super) name: String,
    /// Its formula, if it was tuned for this.
    pub(super) law: Option<String>,
    /// The return of each episode.
    pub(super) scores: Vec<f64>,
    /// Its effort.
    pub(super) effort: Option<Effort>,
}

impl Group {
    /// Returns the name of the problem; [`OWN`] for one that is neither built in nor named by its graph.
    pub(super) fn problem(&self) -> &str {
        let run = &self.runs[0];
        let named = || run.graph().and_then(|graph| graph.provenance().note.as_deref());
        run.problem.as_ref().map(|problem| problem.name().name()).or_else(named).unwrap_or(OWN)
    }
}

impl Run {
    fn new(name: String, problem: Option<Problem>, policies: Policies) -> Self {
        let (log, hall) = (Vec::new(), Vec::new());
        Self { name, seed: None, log, cpu: None, problem, policies, hall, tested: None, result: None }
    }

    /// Returns the mean score on the episodes by which training chose the policy.
    pub(super) fn validated(&self) -> Option<f64> {
        match &self.policies {
            Policies::Graph(graph) => graph.1.provenance().scores.get("validation_score").copied(),
            Policies::Network((_, Network::Float(network))) => {
                network.1.provenance.validation.map(|result| result.score)
            }
            _ => None,
        }
    }

    /// Returns the graph.
    pub(super) fn graph(&self) -> Option<&Graph> {
        match &self.policies {
            Policies::Graph(graph) => Some(&graph.1),
            Policies::Both(hybrid) => Some(&hybrid.graph.1),
            Policies::Network(_) => None,
        }
    }

    /// Returns the graph that evolution has found: its bytes can be compared. `None` for a network, and for a hybrid of a graph and
    /// rules, which was put together later.
    pub(super) fn evolved(&self) -> Option<&Graph> {
        let rules = matches!(&self.policies, Policies::Both(hybrid) if hybrid.setting.has_trigger());
        self.graph().filter(|_| !rules)
    }

    /// Returns a curve of the log, from the place of its values in a row: the number of steps or decisions, and the value.
    pub(super) fn curve(&self, place: &str) -> Vec<[f64; 2]> {
        let x = if self.kind() == "SAC" { "/decisions" } else { "/steps" };
        let value = |row: &Value, place: &str| row.pointer(place).and_then(Value::as_f64);
        // A problem without a measure has 0.
        let y = |row| value(row, place).filter(|&y| !place.ends_with("measure") || y > 0.0);
        self.log.iter().filter_map(|row| Some([value(row, x)?, y(row)?])).collect()
    }

    /// The kind in a word.
    pub(super) fn kind(&self) -> &'static str {
        match self.policies {
            Policies::Graph(_) => "TPG",
            Policies::Network(_) => "SAC",
            Policies::Both(_) => "hybrid",
        }
    }
}

/// Reads all runs and groups those with equal configurations, in the given order.
pub(super) fn read(folders: &[PathBuf]) -> Result<Vec<Group>, InputError> {
    let mut groups: Vec<(String, Group)> = Vec::new();
    for (folder, name) in folders.iter().map(|folder| with_restarts(folder)).collect::<Result<Vec<_>, _>>()?.concat() {
        let is_study = folder.join("study.toml").exists();
        let path = folder.join(if is_study { "study.toml" } else { "config.toml" });
        let (file, text) = (path.display().to_string(), read_text(&path, "the settings of a run")?);
        let settings: toml::Table = settings::from_toml(&file, &text, "the settings of a run")?;
        let section = settings.get("problem").and_then(toml::Value::as_table).filter(|it| named_in(it).is_some());
        let problem = section.map(|section| Problem::from_table(&file, section, PolicyKind::Graph));
        let run = if is_study {
            let hybrid = Policies::Both(Box::new(Hybrid::read(&folder.join("hybrid.toml"))?));
            Run::new(name, problem.transpose()?.map(Problem::for_tests), hybrid)
        } else if folder.join("generations.jsonl").exists() {
            tpg(&folder, name, problem.transpose()?.map(Problem::for_tests), &settings)?
        } else if folder.join("log.jsonl").exists() {
            sac(&folder, name)?
        } else {
            let accepted = "a folder of `tpg-train tpg`, `sac` or `hybrid` that has begun";
            return Err(InputError::new(folder.display().to_string(), Place::Whole, "not a run folder", accepted));
        };
        let key = format!("{}\n{text}", run.kind());
        match groups.iter_mut().find(|(other, _)| *other == key) {
            Some((_, group)) => group.runs.push(run),
            None => groups.push((key, Group { name: String::new(), runs: vec![run] })),
        }
    }
    Ok(groups.into_iter().map(|(_, group)| named(group)).collect())
}

/// Returns the last part of a path.
fn last(path: &Path) -> String {
    path.file_name().map_or_else(|| ".".to_owned(), |name| name.to_string_lossy().into_owned())
}

fn whole(folder: &Path) -> Result<PathBuf, InputError> {
    fs::canonicalize(folder).map_err(|error| InputError::io(folder, &error, "the folder of a run"))
}

/// Returns the folder itself, or its restarts, with their names.
fn with_restarts(folder: &Path) -> Result<Vec<(PathBuf, String)>, InputError> {
    let name = last(&whole(folder)?);
    if folder.join("config.toml").exists() || folder.join("study.toml").exists() {
        return Ok(vec![(folder.to_owned(), name)]);
    }
    let entries = fs::read_dir(folder).map_err(|error| InputError::io(folder, &error, "the folder of a run"))?;
    let mut restarts: Vec<PathBuf> = (entries.filter_map(|entry| entry.ok().map(|entry| entry.path())))
        .filter(|path| last(path).starts_with("seed-") && path.join("config.toml").exists())
        .collect();
    restarts.sort_by_key(|path| (last(path).len(), last(path)));
    if restarts.is_empty() {
        let accepted =
            "the folder of a run, with config.toml, of a study, with study.toml, or of restarts, with seed-S";
        return Err(InputError::new(folder.display().to_string(), Place::Whole, "not a run folder", accepted));
    }
    Ok(restarts.into_iter().map(|path| (path.clone(), format!("{name}/{}", last(&path)))).collect())
}

fn named(mut group: Group) -> Group {
    group.runs.sort_by_key(|run| run.seed);
    let first = group.runs[0].name.as_str();
    let shared = |name: &str| first.bytes().zip(name.bytes()).take_while(|(a, b)| a == b).count();
    let length = group.runs.iter().map(|run| shared(&run.name)).min().unwrap_or(0);
    let name = first.get(..length).unwrap_or(first).trim_end_matches(['-', '_', '/', '.']);
    let name = name.strip_suffix("/seed").unwrap_or(name);
    group.name = if name.is_empty() { first.to_owned() } else { name.to_owned() };
    group
}

fn tpg(folder: &Path, name: String, problem: Option<Problem>, settings: &toml::Table) -> Result<Run, InputError> {
    let ask = settings.get("ask").and_then(|ask| ask.get("policy")?.as_str());
    let path = folder.join("graph.json");
    let graph = Graph::from_json(&path.display().to_string(), &read_text(&path, "the graph of a run")?)?;
    let hall = hall(&folder.join("hall.jsonl"), &graph)?;
    let tested = folder.join("tested.jsonl");
    let tested = if tested.exists() { lines::<TestedElsewhere>(&tested)? } else { Vec::new() };
    // A graph that has been trained further has not been tested.
    let tested = tested.into_iter().find(|one| one.graph == graph.sha256());
    let log = lines(&folder.join("generations.jsonl"))?;
    let seed = graph.provenance().seed;
    let run = |name: String, graph: Graph| {
        let graph = (path.display().to_string(), graph);
        let policies = match ask {
            Some(policy) => {
                let network = (policy.to_owned(), Network::read(Path::new(policy))?);
                Policies::Both(Box::new(Hybrid { problem: None, graph, network, setting: Setting::only_asks() }))
            }
            None => Policies::Graph(Box::new(graph)),
        };
        Ok(Run { seed, ..Run::new(name, problem.clone(), policies) })
    };
    let of_hall = |graph: Graph| {
        let generation = graph.provenance().scores.get("generation").copied().unwrap_or_default();
        run(format!("generation {generation}"), graph)
    };
    let hall = hall.into_iter().map(of_hall).collect::<Result<_, InputError>>()?;
    Ok(Run { log, cpu: cpu_seconds(folder), hall, tested, ..run(name, graph)? })
}

/// Reads a run's hall of fame, without its best graph; empty for a run of an earlier version, which has none.
fn hall(path: &Path, best: &Graph) -> Result<Vec<Graph>, InputError> {
    if !path.exists() {
        return Ok(Vec::new());
    }
    let read = |(line, text): (usize, &str)| Graph::from_json(&format!("{}:{line}", path.display()), text);
    let text = read_text(path, "the hall of fame of a run")?;
    let all = (1..).zip(text.lines()).map(read).collect::<Result<Vec<_>, _>>()?;
    Ok(all.into_iter().filter(|graph| graph != best).collect())
}

/// Returns the CPU time of a run, if it states it.
fn cpu_seconds(folder: &Path) -> Option<f64> {
    RunTime::read(folder)?.cpu_seconds
}

fn sac(folder: &Path, name: String) -> Result<Run, InputError> {
    let log = lines(&folder.join("log.jsonl"))?;
    let path = folder.join("policy.safetensors");
    let (network, contract) = weights::read(&path)?;
    let file = path.display().to_string();
    let known = named_in(&contract.problem).ok_or_else(|| {
        InputError::new(&file, Place::Whole, "a network of a problem that is not built in", "one that is")
    })?;
    let (seed, cpu) = (Some(contract.provenance.seed), cpu_seconds(folder));
    let network = (file, Network::Float(Box::new((network, contract))));
    let problem = problem_for(known, None, &[], from_ref(&network))?;
    Ok(Run { seed, log, cpu, ..Run::new(name, Some(problem), Policies::Network(network)) })
}

/// The problem that settings name, if it is built in.
fn named_in(settings: &toml::Table) -> Option<ProblemName> {
    settings.get("name").and_then(toml::Value::as_str).and_then(ProblemName::from_name)
}

/// Parses one JSON value per line.
fn lines<T: serde::de::DeserializeOwned>(path: &Path) -> Result<Vec<T>, InputError> {
    let parse = |(line, text): (usize, &str)| {
        serde_json::from_str(text).map_err(|error| {
            InputError::new(path.display().to_string(), Place::Line(line), error.to_string(), "a row of a log")
        })
    };
    (1..).zip(read_text(path, "the log of a run")?.lines()).map(parse).collect()
}
