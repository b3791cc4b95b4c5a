//! Traces of runs: the cost and the size of each unit that a run asks its evaluator for, question by question.

use serde::{Deserialize, Serialize};
use std::cell::RefCell;
use std::time::Instant;
use tpg_engine::{Environment, EvaluationError, Evaluator, LocalThreads, UnitResult, Visit, Work};
use tpg_graph::command::Verdict;
use tpg_graph::error::{InputError, Place};
use tpg_runtime::ops::Maths;
use tpg_runtime::scalar::Scalar;
use tpg_train::evolution::run::RunError;
use tpg_train::ranks::workplace::{Cells, Compute, Workplace};

/// A unit of work.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Unit {
    /// The cost that rank 0 expects, in any unit: it hands out by this.
    pub expected: u64,
    /// Time on one thread, seconds.
    pub seconds: f64,
    /// Environment steps of each episode.
    pub steps: Vec<u32>,
    /// Bytes of the unit in a message.
    pub out: u64,
    /// Bytes of its endings in a message.
    pub back: u64,
}

/// A question: units that can be evaluated at the same time.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Question {
    /// Time that rank 0 spent before it: breeding, selection, files; seconds.
    pub alone: f64,
    /// Bytes of the tasks, where they differ from those of the question before.
    pub tasks: u64,
    /// The units.
    pub units: Vec<Unit>,
}

/// Everything that a run asks.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Trace {
    /// The run's name in tables.
    pub name: String,
    /// The questions.
    pub questions: Vec<Question>,
}

/// A place that records: this process with one thread.
#[derive(Debug, Default)]
pub struct Recorder {
    questions: RefCell<Vec<Question>>,
}

impl Recorder {
    /// Returns what was asked.
    pub fn trace(self, name: &str) -> Trace {
        Trace { name: name.to_owned(), questions: self.questions.into_inner() }
    }
}

impl Workplace for Recorder {
    fn train<S: Scalar, M: Maths<S>, E: Environment<S>>(
        &self,
        _: &str,
        local: &LocalThreads<'_, S, M, E>,
        lead: impl FnOnce(&dyn Evaluator<E::Task>) -> Result<Verdict, RunError>,
    ) -> Result<Verdict, RunError> {
        let (last, tasks) = (RefCell::new(Instant::now()), RefCell::new(Vec::new()));
        lead(&Recording { recorder: self, local, last, tasks })
    }

    fn study(
        &self,
        _: &str,
        _: &rayon::ThreadPool,
        _: &Compute<'_>,
        _: impl FnOnce(&dyn Cells) -> Result<Verdict, InputError>,
    ) -> Result<Verdict, InputError> {
        let accepted = "a training: studies are not recorded";
        Err(InputError::new("<command line>", Place::Whole, "a study", accepted))
    }
}

struct Recording<'r, V> {
    recorder: &'r Recorder,
    local: &'r V,
    /// The end of the question before.
    last: RefCell<Instant>,
    /// The tasks of the question before, as bytes.
    tasks: RefCell<Vec<u8>>,
}

fn bytes(value: &impl Serialize) -> Vec<u8> {
    serde_json::to_vec(value).expect("plain data")
}

fn packed(value: &impl Serialize) -> u64 {
    postcard::to_stdvec(value).expect("plain data").len() as u64
}

impl<Task: Serialize + Clone, V: Evaluator<Task>> Evaluator<Task> for Recording<'_, V> {
    fn evaluate(&self, work: &Work<Task>) -> Result<Vec<UnitResult>, EvaluationError> {
        let alone = self.last.borrow().elapsed().as_secs_f64();
        let tasks = bytes(&work.tasks);
        let same = *self.tasks.borrow() == tasks;
        let mut question = Question { alone, tasks: if same { 0 } else { tasks.len() as u64 }, units: Vec::new() };
        self.tasks.replace(tasks);
        let mut results = Vec::new();
        for unit in &work.units {
            let one = Work { tasks: work.tasks.clone(), units: vec![unit.clone()] };
            let began = Instant::now();
            let result = self.local.evaluate(&one)?;
            let seconds = began.elapsed().as_secs_f64();
            let endings: Vec<_> = result.iter().flat_map(|result| &result.endings).collect();
            let steps = endings.iter().map(|ending| ending.actions).collect();
            let (expected, out, back) = (unit.policy.size() as u64, packed(unit), packed(&endings));
            question.units.push(Unit { expected, seconds, steps, out, back });
            results.extend(result);
        }
        self.recorder.questions.borrow_mut().push(question);
        self.last.replace(Instant::now());
        Ok(results)
    }

    fn visit(&self, visits: &[Visit<Task>]) -> Result<Vec<Vec<Vec<f64>>>, EvaluationError> {
        // Few and short: they count as rank 0's own time.
        self.local.visit(visits)
    }

    fn steps(&self) -> u64 {
        self.local.steps()
    }
}
