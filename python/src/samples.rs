//! A table of labelled samples as an environment: an episode is one sample, and its only action names a class.

use crate::error;
use crate::space::Space;
use numpy::{PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use tpg_engine::random::Stream;
use tpg_engine::{Act, ActionSpace, End, Environment, SourceSet, Step, TaskSet, Training};
use tpg_graph::SourceDocument;
use tpg_runtime::scalar::Scalar;

/// Labelled samples: those of training first, then those that choose the policy.
#[pyclass(frozen, from_py_object, module = "tpg_train._tpg")]
#[derive(Clone, Debug)]
pub(crate) struct Samples {
    space: Space,
    /// The inputs, row after row.
    values: Vec<f64>,
    /// The number of each row's class, and the score of naming it.
    labels: Vec<(u16, f64)>,
    /// The number of rows for training.
    training: usize,
    /// Linear policies to begin with.
    linear: Vec<Vec<Vec<f64>>>,
}

#[pymethods]
impl Samples {
    /// Creates a table. The first `training` of the rows are trained on, the others choose the policy: all of them where no others are
    /// left. Evolution begins with `linear` policies: for each class the weights of its inputs, and a constant.
    #[new]
    fn new(
        space: &Space,
        rows: PyReadonlyArray2<'_, f64>,
        classes: PyReadonlyArray1<'_, u16>,
        scores: PyReadonlyArray1<'_, f64>,
        training: usize,
        linear: Vec<Vec<Vec<f64>>>,
    ) -> PyResult<Self> {
        let values: Vec<f64> = rows.as_array().iter().copied().collect();
        let labels: Vec<(u16, f64)> =
            classes.as_array().iter().copied().zip(scores.as_array().iter().copied()).collect();
        let (length, count) = (space.length(), labels.len());
        if values.len() != length * count || !(1..=count).contains(&training) {
            let found = format!("{} values, {count} labels, {training} rows for training", values.len());
            return Err(error::input(format!("{found}; accepted: {length} values for each label, 1 to {count} rows")));
        }
        Ok(Self { space: space.clone(), values, labels, training, linear })
    }
}

impl<S: Scalar> Environment<S> for Samples {
    /// The number of a row.
    type Task = usize;
    type Episode = usize;

    fn sources(&self) -> Vec<SourceDocument> {
        self.space.sources.clone()
    }
    fn actions(&self) -> ActionSpace {
        self.space.actions.clone()
    }
    fn time_limit(&self) -> u32 {
        1
    }
    fn draw(&self, stream: &mut Stream) -> usize {
        stream.below(self.training)
    }
    fn start(&self, &row: &usize) -> usize {
        row
    }
    fn observe(&self, &mut row: &mut usize, _wanted: SourceSet, state: &mut [S]) {
        let values = &self.values[row * state.len()..];
        state.iter_mut().zip(values).for_each(|(slot, value)| *slot = S::from_f64(*value));
    }
    fn step(&self, &mut row: &mut usize, act: Act<'_, S>) -> Step {
        let (class, score) = self.labels[row];
        let is_right = act.choice() == usize::from(class);
        Step::reward(if is_right { score } else { 0.0 }).ending(End { success: Some(is_right), ..End::new(0) })
    }
    fn training(&self) -> Option<&dyn Training<usize>> {
        Some(self)
    }
}

impl Training<usize> for Samples {
    fn tasks(&self, _set: TaskSet, _seed: u64, count: usize) -> Option<Vec<usize>> {
        let first = if self.training < self.labels.len() { self.training } else { 0 };
        Some((first..self.labels.len()).cycle().take(count).collect())
    }
    fn linear(&self) -> Vec<Vec<Vec<f64>>> {
        self.linear.clone()
    }
}
