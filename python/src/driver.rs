//! Whole episodes of a Gymnasium environment, next to the environment.

use crate::error;
use crate::policy::Policy;
use numpy::{PyArray1, PyArrayDyn, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use tpg_engine::{Moments, Single};
use tpg_graph::ScalarType;
use tpg_graph::interpret::Answer;
use tpg_runtime::ops::{Maths, Own};
use tpg_runtime::scalar::Scalar;

/// The result of an episode: return, number of actions, and success where the environment's info says `is_success`.
type Played = (f64, u32, Option<bool>);

/// The moments of states: their number, the means of their values, and the sums of the squared distances from these.
pub(crate) type Parts = (u64, Vec<f64>, Vec<f64>);

/// The outcome of a step, as an environment tells it.
pub(crate) struct Told {
    /// The reward.
    pub(crate) reward: f64,
    /// The end of the episode.
    pub(crate) end: Option<Ended>,
}

/// The end of an episode.
pub(crate) struct Ended {
    /// True if it was cut off, not over.
    pub(crate) truncated: bool,
    /// Success, where the environment's info says `is_success`.
    pub(crate) success: Option<bool>,
}

/// Runs episodes of an environment.
#[pyclass(frozen, module = "tpg_train._tpg")]
pub(crate) struct Driver {
    reset: Py<PyAny>,
    step: Py<PyAny>,
    flatten: Option<Py<PyAny>>,
    action: Action,
    inputs: usize,
    limit: u32,
    asarray: Py<PyAny>,
}

/// The way from an answer to the environment's action.
enum Action {
    /// An object for each action's number; arrays are copied, so that an environment may change what it is given.
    Listed(Vec<Py<PyAny>>, bool),
    /// A flat array of `f32`.
    Flat,
    /// A function of the list of values.
    Encoded(Py<PyAny>),
}

#[pymethods]
impl Driver {
    /// Creates a driver. `flatten` turns an observation into a flat array, `None` where it is one; `actions` lists the
    /// environment's actions, `None` where the policy answers with values, which `encode` turns into an action, `None` where
    /// a flat array of f32 is one.
    #[new]
    #[pyo3(signature = (env, inputs, limit, flatten=None, actions=None, encode=None))]
    fn new(
        env: &Bound<'_, PyAny>,
        inputs: usize,
        limit: u32,
        flatten: Option<Py<PyAny>>,
        actions: Option<Vec<Py<PyAny>>>,
        encode: Option<Py<PyAny>>,
    ) -> PyResult<Self> {
        let py = env.py();
        let action = match (actions, encode) {
            (Some(actions), _) => {
                let arrays = actions.first().is_some_and(|action| action.bind(py).hasattr("copy").unwrap_or(false));
                Action::Listed(actions, arrays)
            }
            (None, Some(encode)) => Action::Encoded(encode),
            (None, None) => Action::Flat,
        };
        Ok(Self {
            reset: env.getattr("reset")?.unbind(),
            step: env.getattr("step")?.unbind(),
            flatten,
            action,
            inputs,
            limit,
            asarray: py.import("numpy")?.getattr("asarray")?.unbind(),
        })
    }

    /// Runs one episode for each seed.
    fn run(&self, py: Python<'_>, policy: &Policy, seeds: Vec<u64>) -> PyResult<Vec<Played>> {
        match policy.scalar() {
            ScalarType::F32 => self.run_in(py, &policy.single::<f32>(), seeds),
            ScalarType::F64 => self.run_in(py, &policy.single::<f64>(), seeds),
        }
    }

    /// Returns the observations after given numbers of actions, ascending.
    fn visit(&self, py: Python<'_>, policy: &Policy, seed: u64, after: Vec<u32>) -> PyResult<Vec<Vec<f64>>> {
        match policy.scalar() {
            ScalarType::F32 => self.visit_in(py, &policy.single::<f32>(), seed, &after),
            ScalarType::F64 => self.visit_in(py, &policy.single::<f64>(), seed, &after),
        }
    }

    /// Runs one episode and returns its result with the moments of the observations.
    fn play(&self, py: Python<'_>, policy: &Policy, seed: u64) -> PyResult<(Played, Parts)> {
        match policy.scalar() {
            ScalarType::F32 => self.play_in(py, &policy.single::<f32>(), seed),
            ScalarType::F64 => self.play_in(py, &policy.single::<f64>(), seed),
        }
    }
}

impl Driver {
    fn run_in<S: Scalar>(&self, py: Python<'_>, single: &Single<S, Own>, seeds: Vec<u64>) -> PyResult<Vec<Played>>
    where
        Own: Maths<S>,
    {
        seeds.into_iter().map(|seed| self.episode(py, single, seed, |_, _| true)).collect()
    }

    fn visit_in<S: Scalar>(
        &self,
        py: Python<'_>,
        single: &Single<S, Own>,
        seed: u64,
        after: &[u32],
    ) -> PyResult<Vec<Vec<f64>>>
    where
        Own: Maths<S>,
    {
        let mut seen = Vec::with_capacity(after.len());
        self.episode(py, single, seed, |step, state| {
            while after.get(seen.len()) == Some(&step) {
                seen.push(state.iter().map(|value| value.to_f64()).collect());
            }
            seen.len() < after.len()
        })?;
        match seen.len() == after.len() {
            true => Ok(seen),
            false => Err(error::training(format!(
                "the episode of seed {seed} was shorter than before: the environment's state survives reset(seed=...); \
                 tpg_train.wrappers.Fresh makes a new environment for each episode"
            ))),
        }
    }

    fn play_in<S: Scalar>(&self, py: Python<'_>, single: &Single<S, Own>, seed: u64) -> PyResult<(Played, Parts)>
    where
        Own: Maths<S>,
    {
        let (mut seen, mut values) = (Moments::new(self.inputs), Vec::with_capacity(self.inputs));
        let played = self.episode(py, single, seed, |_, state| {
            values.clear();
            values.extend(state.iter().map(|value| value.to_f64()));
            seen.push(&values);
            true
        })?;
        Ok((played, seen.into_parts()))
    }

    /// Runs one episode; `watch` sees each observation before the action, and ends the episode with false.
    fn episode<S: Scalar>(
        &self,
        py: Python<'_>,
        single: &Single<S, Own>,
        seed: u64,
        mut watch: impl FnMut(u32, &[S]) -> bool,
    ) -> PyResult<Played>
    where
        Own: Maths<S>,
    {
        let mut state = Vec::with_capacity(self.inputs);
        self.begin(py, seed, &mut state)?;
        let (mut score, mut actions, mut success) = (0.0, 0, None);
        while actions < self.limit && watch(actions, &state) {
            actions += 1;
            let at = || format!("seed {seed}, step {actions}");
            let told = self.advance(self.act(py, single, &state)?, &mut state, at)?;
            score += told.reward;
            if let Some(end) = told.end {
                success = end.success;
                break;
            }
        }
        Ok((score, actions, success))
    }

    /// Begins an episode and reads its first observation.
    pub(crate) fn begin<S: Scalar>(&self, py: Python<'_>, seed: u64, state: &mut Vec<S>) -> PyResult<()> {
        let arguments = PyDict::new(py);
        arguments.set_item("seed", seed)?;
        let pair = self.reset.bind(py).call((), Some(&arguments))?;
        let at = || format!("seed {seed}, step 0");
        let first = parts::<2>(&pair, "reset", "(observation, info)", &at())?;
        self.read(&first[0], state, at)
    }

    /// Takes an action and reads what follows, unless the episode ends.
    pub(crate) fn advance<S: Scalar>(
        &self,
        action: Bound<'_, PyAny>,
        state: &mut Vec<S>,
        at: impl Fn() -> String,
    ) -> PyResult<Told> {
        let told = self.step.bind(action.py()).call1((action,))?;
        let accepted = "(observation, reward, terminated, truncated, info)";
        let [observation, reward, terminated, truncated, info] = parts::<5>(&told, "step", accepted, &at())?;
        let reward: f64 = reward.extract()?;
        if reward.is_nan() {
            return Err(error::input(format!("{}: the reward is NaN; accepted: a number", at())));
        }
        let terminated = terminated.extract::<bool>()?;
        if terminated || truncated.extract::<bool>()? {
            let info = info.cast::<PyDict>().ok().and_then(|info| info.get_item("is_success").ok().flatten());
            let success = info.and_then(|info| info.extract().ok());
            // The last observation still has a value where the episode was cut.
            if !terminated {
                self.read(&observation, state, at)?;
            }
            return Ok(Told { reward, end: Some(Ended { truncated: !terminated, success }) });
        }
        self.read(&observation, state, at)?;
        Ok(Told { reward, end: None })
    }

    fn act<'py, S: Scalar>(&self, py: Python<'py>, single: &Single<S, Own>, state: &[S]) -> PyResult<Bound<'py, PyAny>>
    where
        Own: Maths<S>,
    {
        if let Action::Listed(actions, arrays) = &self.action {
            let action = actions[usize::from(single.decide(state).0)].bind(py);
            return if *arrays { action.call_method0("copy") } else { Ok(action.clone()) };
        }
        let Answer::Values(values) = single.answer(state) else { unreachable!("a policy of a box has outputs") };
        self.values(py, values)
    }

    /// Returns values as the environment's action.
    pub(crate) fn values<'py>(&self, py: Python<'py>, values: Vec<f64>) -> PyResult<Bound<'py, PyAny>> {
        match &self.action {
            Action::Encoded(encode) => encode.bind(py).call1((values,)),
            _ => Ok(PyArray1::from_iter(py, values.iter().map(|&value| value as f32)).into_any()),
        }
    }

    /// Reads an observation.
    fn read<S: Scalar>(
        &self,
        observation: &Bound<'_, PyAny>,
        state: &mut Vec<S>,
        at: impl Fn() -> String,
    ) -> PyResult<()> {
        let flat = match &self.flatten {
            Some(flatten) => flatten.bind(observation.py()).call1((observation,))?,
            None => observation.clone(),
        };
        state.clear();
        if let Ok(array) = flat.cast::<PyArrayDyn<f32>>() {
            let array = array.readonly();
            let number = |&value: &f32| S::from_f64(f64::from(value));
            match array.as_slice() {
                Ok(values) => state.extend(values.iter().map(number)),
                Err(_) => state.extend(array.as_array().iter().map(number)),
            }
        } else if let Ok(array) = flat.cast::<PyArrayDyn<f64>>() {
            state.extend(array.readonly().as_array().iter().map(|&value| S::from_f64(value)));
        } else {
            let array = self.asarray.bind(flat.py()).call1((&flat, "float64"))?;
            let array = array.cast::<PyArrayDyn<f64>>()?.readonly();
            state.extend(array.as_array().iter().map(|&value| S::from_f64(value)));
        }
        if state.len() != self.inputs {
            let (found, accepted) = (state.len(), self.inputs);
            return Err(error::input(format!("{}: an observation of {found} values; accepted: {accepted}", at())));
        }
        match state.iter().position(|value| value.to_f64().is_nan()) {
            Some(place) => Err(error::input(format!("{}: observation[{place}] is NaN; accepted: a number", at()))),
            None => Ok(()),
        }
    }
}

/// Takes a tuple apart.
fn parts<'py, const N: usize>(
    told: &Bound<'py, PyAny>,
    method: &str,
    accepted: &str,
    at: &str,
) -> PyResult<[Bound<'py, PyAny>; N]> {
    let items = told.cast::<PyTuple>().ok().map(|tuple| tuple.iter().collect::<Vec<_>>());
    items.and_then(|items| items.try_into().ok()).ok_or_else(|| {
        let found = told.get_type().name().map(|name| name.to_string()).unwrap_or_default();
        let length = told.len().map(|length| format!(" of {length}")).unwrap_or_default();
        error::input(format!("{at}: {method}() returned a {found}{length}; accepted: {accepted}, as Gymnasium's"))
    })
}
