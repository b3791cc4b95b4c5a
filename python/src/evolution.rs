//! A run on a thread of its own. Python asks for its next event, does what it says, and replies.

use crate::driver::Told;
use crate::error;
use crate::graph::Graph;
use crate::mailbox::{Event, Mailbox, Reply};
use crate::native;
use crate::policy::Policy;
use crate::samples::Samples;
use crate::space::Space;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, sync_channel};
use std::sync::{Mutex, MutexGuard};
use std::thread::JoinHandle;
use std::time::Duration;
use tpg_engine::{
    Choices, Environment, EpisodeResult, Evaluator, LocalThreads, Moments, Played, PolicyGraph, Remembered, Remembering,
};
use tpg_graph::ScalarType;
use tpg_problems::{Number, Problem};
use tpg_runtime::ops::{Maths, Own};
use tpg_runtime::scalar::Scalar;
use tpg_train::{
    Best, Config as EvolutionConfig, Configuration as _, Goal, Layers, Naming, Progress, Row, RunEnd, RunError,
    RunOptions, train,
};

/// The preset that a file of settings differs from.
const DEFAULT: &str = "quick";
/// Time between two looks for Ctrl-C.
const WAIT: Duration = Duration::from_millis(50);

/// Progress of a run, for Python.
pub(crate) struct Report {
    generations: u64,
    steps: u64,
    row: Option<Row>,
    best: Option<f64>,
    /// The best policies, if they have changed.
    fresh: Option<Fame>,
}

/// The best policies of a run.
struct Fame {
    best: Graph,
    /// The size, the score and the graph of each policy in the hall of fame.
    hall: Vec<(usize, f64, Graph)>,
}

type Thread = JoinHandle<Result<RunEnd, RunError>>;

/// A run of evolution.
#[pyclass(frozen, module = "tpg_train._tpg")]
pub(crate) struct Evolution {
    inputs: usize,
    scalar: ScalarType,
    line: Mutex<Line>,
}

/// Python's end of the conversation.
struct Line {
    events: Option<Receiver<Event>>,
    replies: Option<SyncSender<Reply>>,
    thread: Option<Thread>,
    /// The request of the last event: units and tasks, or episodes.
    asked: Option<(usize, usize)>,
}

/// A run's settings.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
struct Settings {
    config: String,
    seed: u64,
    folder: PathBuf,
    resume: bool,
    target: Option<f64>,
    max_steps: Option<u64>,
    /// The name of an environment that is not built in.
    task: Option<String>,
    /// Names of the values of an observation that has none of its own.
    input_names: Vec<String>,
}

impl Settings {
    fn job(self, field: Field) -> PyResult<Job> {
        let config = EvolutionConfig::from_toml("<settings>", &self.config).map_err(error::input)?;
        let goal = Goal { target: self.target, max_steps: self.max_steps };
        let naming = Naming { task: self.task, inputs: self.input_names };
        let options = RunOptions { folder: self.folder, resume: self.resume, goal, naming, ..RunOptions::default() };
        Ok(Job { config, options, seed: self.seed, field })
    }
}

/// The episodes of a run.
enum Field {
    /// Python runs them.
    Outside(Space),
    /// Samples, on so many threads; 0 for all.
    Samples(Samples, usize),
    /// A built-in problem, on so many threads; 0 for all.
    Native(Box<Problem>, usize),
}

/// A run as its thread does it.
struct Job {
    config: EvolutionConfig,
    options: RunOptions,
    seed: u64,
    field: Field,
}

impl Job {
    fn run<S: Number>(&self, mailbox: &Mailbox) -> Result<RunEnd, RunError>
    where
        Own: Maths<S>,
    {
        match &self.field {
            Field::Outside(space) => self.evolve::<S, _>(&self.remembering::<S, _>(space.clone()), mailbox, mailbox),
            Field::Samples(samples, threads) => self.evolve_here::<S, _>(samples.clone(), *threads, mailbox),
            Field::Native(problem, threads) => {
                let environment = problem.environment::<S>();
                self.evolve_here(Choices::new(&*environment, problem.levels())?, *threads, mailbox)
            }
        }
    }

    /// Adds the memory of policies to an environment.
    fn remembering<S: Scalar, E: Environment<S>>(&self, environment: E) -> Remembering<E> {
        let memory = Remembered::zeros(self.config.language.memory, &environment.sources());
        Remembering::new(environment, memory)
    }

    /// A run whose episodes this process runs.
    fn evolve_here<S: Scalar, E: Environment<S>>(
        &self,
        environment: E,
        threads: usize,
        mailbox: &Mailbox,
    ) -> Result<RunEnd, RunError>
    where
        Own: Maths<S>,
    {
        let environment = self.remembering::<S, _>(environment);
        let evaluator = LocalThreads::<S, Own, _>::new(&environment, threads)?;
        self.evolve::<S, _>(&environment, &evaluator, mailbox)
    }

    /// A run that reports to a mailbox.
    fn evolve<S: Scalar, E: Environment<S>>(
        &self,
        environment: &E,
        evaluator: &dyn Evaluator<E::Task>,
        mailbox: &Mailbox,
    ) -> Result<RunEnd, RunError> {
        let mut shown: Vec<u64> = Vec::new();
        train(&self.config, self.seed, environment, evaluator, &self.options, |progress| {
            let report = Report {
                generations: progress.generations,
                steps: progress.steps,
                row: progress.row.cloned(),
                best: progress.best.map(|best| best.result.score),
                fresh: fresh(progress, &mut shown),
            };
            if mailbox.report(report) { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        })
    }
}

/// Returns a preset, or a file of settings, with other values of some settings, as TOML: `settings` is a JSON object from keys such
/// as `tpg.nb_roots` to values.
#[pyfunction]
pub(crate) fn configuration(preset: &str, settings: &str) -> PyResult<String> {
    let path = Path::new(preset);
    let file = Some(path).filter(|path| path.is_file() && EvolutionConfig::table(preset).is_err());
    let preset = Some(preset).filter(|_| file.is_none());
    let layers = Layers::of::<EvolutionConfig>(preset, file, |_| Ok(DEFAULT));
    let mut layers = layers.map_err(|error| match preset {
        Some(_) => error::input(format!("{}; accepted: {}, or a file", error.found, error.accepted)),
        None => error::input(error),
    })?;
    set_all(&mut layers, settings)?;
    let mut config = layers.read(EvolutionConfig::from_toml).map_err(error::input)?;
    // The environment is the problem.
    config.problem = toml::Table::new();
    Ok(config.to_toml())
}

/// Sets the values of a JSON object from keys such as `tpg.nb_roots`.
pub(crate) fn set_all(layers: &mut Layers, settings: &str) -> PyResult<()> {
    let settings: toml::Table = serde_json::from_str(settings).map_err(error::input)?;
    settings.into_iter().for_each(|(key, value)| layers.set(&key, value));
    Ok(())
}

#[pymethods]
impl Evolution {
    /// Starts a run whose episodes Python runs.
    #[staticmethod]
    fn start(space: &Space, settings: Settings) -> PyResult<Self> {
        Self::spawn(settings, Field::Outside(space.clone()))
    }

    /// Starts a run on samples, on `threads` threads; 0 for all.
    #[staticmethod]
    fn start_samples(samples: &Samples, settings: Settings, threads: usize) -> PyResult<Self> {
        Self::spawn(settings, Field::Samples(samples.clone(), threads))
    }

    /// Starts a run on a built-in problem, on `threads` threads; 0 for all.
    #[staticmethod]
    fn start_native(problem: &str, settings: Settings, threads: usize) -> PyResult<Self> {
        Self::spawn(settings, Field::Native(Box::new(native::problem(problem)?), threads))
    }

    /// Waits for the next event and returns its kind and what it says: `evaluate` (policies, seeds), `play` (policy, seed,
    /// numbers of actions), `progress` (figures) or `end` (true if the run is complete).
    fn next<'py>(&self, py: Python<'py>) -> PyResult<(&'static str, Bound<'py, PyAny>)> {
        loop {
            let received = py.detach(|| {
                let line = self.line();
                line.events.as_ref().map_or(Err(RecvTimeoutError::Disconnected), |events| events.recv_timeout(WAIT))
            });
            match received {
                Ok(event) => return self.told(py, event),
                Err(RecvTimeoutError::Timeout) => py.check_signals()?,
                Err(RecvTimeoutError::Disconnected) => return self.ended(py),
            }
        }
    }

    /// Replies to `evaluate`: for each policy the return, the number of actions and the success of each seed's episode.
    fn endings(&self, py: Python<'_>, endings: Vec<Vec<Told>>) -> PyResult<()> {
        let lengths = (endings.len(), endings.first().map_or(0, Vec::len));
        if endings.iter().any(|results| results.len() != lengths.1) {
            return Err(error::input("another number of endings for each policy; accepted: one for each seed"));
        }
        let endings = endings.into_iter().map(|results| results.into_iter().map(ending).collect()).collect();
        self.reply(py, lengths, Reply::Endings(endings))
    }

    /// Replies to `play`: for each episode its return, number of actions and success, the moments of what was seen, and the state
    /// after each number of actions.
    fn played(&self, py: Python<'_>, played: Vec<(Told, String, Vec<Vec<f64>>)>) -> PyResult<()> {
        let inputs = self.inputs;
        let one = |(told, seen, mut states): (Told, String, Vec<Vec<f64>>)| {
            let seen = serde_json::from_str(&seen).ok().filter(|seen: &Moments| seen.length() == inputs);
            let refused = || error::input(format!("{told:?}; accepted: moments of {inputs} values"));
            // What the policy read: the bench may tell more digits.
            states.iter_mut().flatten().for_each(|value| *value = self.scalar.round(*value));
            Ok(Played { ending: ending(told), seen: seen.ok_or_else(refused)?, states })
        };
        let played = played.into_iter().map(one).collect::<PyResult<Vec<_>>>()?;
        self.reply(py, (played.len(), 0), Reply::Played(played))
    }

    /// Replies to `progress`: true to go on, false to save and stop.
    fn go_on(&self, py: Python<'_>, on: bool) -> PyResult<()> {
        self.reply(py, (0, 0), Reply::GoOn(on))
    }

    /// Ends the run, which saves itself as it was after its last complete generation, and waits for that.
    fn close(&self, py: Python<'_>) {
        py.detach(|| {
            let mut line = self.line();
            line.replies = None;
            line.events = None;
            line.thread.take().map(JoinHandle::join);
        });
    }
}

fn ending((score, actions, success, final_reward): Told) -> EpisodeResult {
    EpisodeResult { outcome: 0, success, score, final_reward, measure: 0.0, actions }
}

impl Evolution {
    fn spawn(settings: Settings, field: Field) -> PyResult<Self> {
        let mut job = settings.job(field)?;
        let scalar = job.config.language.scalar;
        let inputs = match &job.field {
            Field::Outside(space) => space.length() + usize::from(job.config.language.memory),
            _ => 0,
        };
        if let Field::Native(problem, _) = &job.field {
            job.config.problem = problem.to_table();
        }
        let (events, told) = sync_channel(1);
        let (answers, replies) = sync_channel(1);
        let thread = std::thread::spawn(move || {
            let mailbox = Mailbox::new(events, replies);
            match scalar {
                ScalarType::F32 => job.run::<f32>(&mailbox),
                ScalarType::F64 => job.run::<f64>(&mailbox),
            }
        });
        let line = Line { events: Some(told), replies: Some(answers), thread: Some(thread), asked: None };
        Ok(Self { inputs, scalar, line: Mutex::new(line) })
    }

    fn line(&self) -> MutexGuard<'_, Line> {
        self.line.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
    }

    fn policy(&self, policy: PolicyGraph) -> Policy {
        Policy::new(policy, self.inputs, self.scalar)
    }

    fn told<'py>(&self, py: Python<'py>, event: Event) -> PyResult<(&'static str, Bound<'py, PyAny>)> {
        let (kind, says, asked) = match event {
            Event::Evaluate(work) => {
                let asked = (work.policies.len(), work.tasks.len());
                let policies: Vec<Policy> = work.policies.into_iter().map(|policy| self.policy(policy)).collect();
                ("evaluate", (policies, work.tasks).into_pyobject(py)?.into_any(), asked)
            }
            Event::Play(plays) => {
                let asked = (plays.len(), 0);
                let plays: Vec<(Policy, u64, Vec<u32>)> =
                    plays.into_iter().map(|play| (self.policy(play.policy), play.task, play.after)).collect();
                ("play", plays.into_pyobject(py)?.into_any(), asked)
            }
            Event::Progress(report) => ("progress", report.into_dict(py)?.into_any(), (0, 0)),
        };
        self.line().asked = Some(asked);
        Ok((kind, says))
    }

    fn reply(&self, py: Python<'_>, lengths: (usize, usize), reply: Reply) -> PyResult<()> {
        let mut line = self.line();
        if line.asked != Some(lengths) {
            let (found, accepted) = (lengths, line.asked);
            return Err(error::input(format!("a reply of {found:?} results; accepted: {accepted:?}")));
        }
        line.asked = None;
        let replies = line.replies.clone();
        // A run that has ended says why in its next event.
        let _ = py.detach(|| replies.map(|replies| replies.send(reply)));
        Ok(())
    }

    fn ended<'py>(&self, py: Python<'py>) -> PyResult<(&'static str, Bound<'py, PyAny>)> {
        let thread = self.line().thread.take();
        let result = py.detach(|| thread.map(JoinHandle::join));
        let complete = match result {
            None => return Err(error::training("the run has ended")),
            Some(Err(_)) => return Err(error::training("the run ended by a defect of the trainer")),
            Some(Ok(Err(RunError::Evaluation(failed)))) => return Err(error::training(failed)),
            // The library speaks of its command line.
            Some(Ok(Err(failed))) => return Err(error::input(failed.to_string().replace("--resume", "resume=True"))),
            Some(Ok(Ok(RunEnd::Finished(_)))) => true,
            Some(Ok(Ok(RunEnd::Interrupted))) => false,
        };
        Ok(("end", complete.into_pyobject(py)?.to_owned().into_any()))
    }
}

impl Report {
    fn into_dict(self, py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
        let says = PyDict::new(py);
        says.set_item("generations", self.generations)?;
        says.set_item("steps", self.steps)?;
        says.set_item("best_validated", self.best)?;
        if let Some(row) = &self.row {
            says.set_item("best_score", row.best_score)?;
            says.set_item("median_score", row.median_score)?;
            says.set_item("roots", row.roots)?;
            says.set_item("teams", row.teams)?;
            says.set_item("programs", row.programs)?;
            says.set_item("validation_score", row.validation.as_ref().map(|result| result.score))?;
        }
        if let Some(Fame { best, hall }) = self.fresh {
            says.set_item("graph", Py::new(py, best)?)?;
            let entry = |(size, score, graph)| Ok::<_, PyErr>((size, score, Py::new(py, graph)?));
            says.set_item("hall", hall.into_iter().map(entry).collect::<PyResult<Vec<_>>>()?)?;
        }
        Ok(says)
    }
}

/// Returns the best graph and the hall of fame, if these are others than those that were shown.
fn fresh(progress: &Progress<'_>, shown: &mut Vec<u64>) -> Option<Fame> {
    let best = progress.best?;
    let now: Vec<u64> = std::iter::once(best).chain(progress.hall).map(|best| best.generation).collect();
    if now == *shown {
        return None;
    }
    *shown = now;
    // A graph that cannot be made is an error of the run itself, which makes the same one.
    let graph = |best: &Best| progress.graph(best).ok().map(Graph);
    let hall = progress.hall.iter().filter_map(|best| Some((best.policy.size(), best.result.score, graph(best)?)));
    Some(Fame { best: graph(best)?, hall: hall.collect() })
}
