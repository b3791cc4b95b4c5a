//! Whole episodes of a Gymnasium environment, next to the environment.

use crate::error;
use crate::policy::{Acting, Policy};
use numpy::{PyArray1, PyArrayDyn, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyMapping, PyTuple};
use tpg_engine::{End, Moments, Step};
use tpg_graph::interpret::Answer;

/// The keys of an episode's last info that say success, in the order in which they are looked for.
const SUCCESS: [&str; 2] = ["is_success", "success"];

/// The result of an episode: return, number of actions, success where the environment's info has it, and the last reward.
pub(crate) type Told = (f64, u32, Option<bool>, f64);

/// Runs episodes of an environment.
#[pyclass(frozen, module = "tpg_train._tpg")]
pub(crate) struct Driver {
    reset: Py<PyAny>,
    step: Py<PyAny>,
    flatten: Option<Py<PyAny>>,
    action: Action,
    shape: Vec<usize>,
    limit: u32,
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
    /// Creates a driver. `shape` is that of an observation, or of what `flatten` makes of it; `actions` lists the
    /// environment's actions, `None` where the policy answers with values, which `encode` turns into an action, `None` where
    /// a flat array of f32 is one.
    #[new]
    #[pyo3(signature = (env, shape, limit, flatten=None, actions=None, encode=None))]
    fn new(
        env: &Bound<'_, PyAny>,
        shape: Vec<usize>,
        limit: u32,
        flatten: Option<Py<PyAny>>,
        actions: Option<Vec<Py<PyAny>>>,
        encode: Option<Py<PyAny>>,
    ) -> PyResult<Self> {
        let action = match (actions, encode) {
            (Some(actions), _) => {
                let arrays =
                    actions.first().is_some_and(|action| action.bind(env.py()).hasattr("copy").unwrap_or(false));
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
            shape,
            limit,
        })
    }

    /// Runs one episode for each seed.
    fn run(&self, py: Python<'_>, policy: &Policy, seeds: Vec<u64>) -> PyResult<Vec<Told>> {
        let mut acting = policy.acting();
        seeds.into_iter().map(|seed| self.episode(py, policy, &mut acting, seed, |_, _| ())).collect()
    }

    /// Runs one episode and returns its result with the moments of the observations, and those after given numbers of actions,
    /// ascending.
    fn play(
        &self,
        py: Python<'_>,
        policy: &Policy,
        seed: u64,
        after: Vec<u32>,
    ) -> PyResult<(Told, String, Vec<Vec<f64>>)> {
        let (mut seen, mut states) = (Moments::new(policy.inputs()), Vec::with_capacity(after.len()));
        let played = self.episode(py, policy, &mut policy.acting(), seed, |step, state| {
            seen.push(state);
            while after.get(states.len()) == Some(&step) {
                states.push(state.to_vec());
            }
        })?;
        if states.len() < after.len() {
            return Err(error::training(format!(
                "the episode of seed {seed} was shorter than before: the environment's state survives reset(seed=...); \
                 tpg_train.wrappers.Fresh makes a new environment for each episode"
            )));
        }
        Ok((played, serde_json::to_string(&seen).map_err(error::training)?, states))
    }
}

impl Driver {
    fn inputs(&self) -> usize {
        self.shape.iter().product()
    }

    /// Runs one episode of a policy; `watch` sees each state before the action.
    fn episode(
        &self,
        py: Python<'_>,
        policy: &Policy,
        acting: &mut Acting,
        seed: u64,
        mut watch: impl FnMut(u32, &[f64]),
    ) -> PyResult<Told> {
        let mut state = Vec::with_capacity(policy.inputs());
        self.begin(py, seed, &mut state)?;
        // What it remembers is read behind the observation.
        let mut memory = vec![0.0; policy.inputs().saturating_sub(self.inputs())];
        let (mut score, mut actions, mut success, mut reward) = (0.0, 0, None, 0.0);
        while actions < self.limit {
            state.extend(&memory);
            state.iter_mut().for_each(|value| *value = policy.scalar().round(*value));
            watch(actions, &state);
            actions += 1;
            let action = self.act(py, acting(&state), &mut memory)?;
            let step = self.advance(action, &mut state, || format!("seed {seed}, step {actions}"))?;
            reward = step.reward;
            score += reward;
            if let Some(end) = step.end {
                success = end.success;
                break;
            }
        }
        Ok((score, actions, success, reward))
    }

    /// Begins an episode and reads its first observation.
    pub(crate) fn begin(&self, py: Python<'_>, seed: u64, state: &mut Vec<f64>) -> PyResult<()> {
        let arguments = PyDict::new(py);
        arguments.set_item("seed", seed)?;
        let pair = self.reset.bind(py).call((), Some(&arguments))?;
        let at = || format!("seed {seed}, step 0");
        let first = parts::<2>(&pair, "reset", "(observation, info)", &at())?;
        self.read(&first[0], state, at)
    }

    /// Takes an action and reads what follows, unless the episode ends.
    pub(crate) fn advance(
        &self,
        action: Bound<'_, PyAny>,
        state: &mut Vec<f64>,
        at: impl Fn() -> String,
    ) -> PyResult<Step> {
        let told = self.step.bind(action.py()).call1((action,))?;
        let accepted = "(observation, reward, terminated, truncated, info)";
        let [observation, reward, terminated, truncated, info] = parts::<5>(&told, "step", accepted, &at())?;
        let reward: f64 = reward.extract()?;
        if reward.is_nan() || reward == f64::INFINITY {
            return Err(error::input(format!("{}: a reward of {reward}; accepted: a number", at())));
        }
        let terminated = truth(&terminated, "terminated", &at)?;
        if terminated || truth(&truncated, "truncated", &at)? {
            let success = find_success(&info, &at)?;
            // The last observation still has a value where the episode was cut.
            if !terminated {
                self.read(&observation, state, at)?;
            }
            let end = End { truncated: !terminated, success, ..End::new(u8::from(!terminated)) };
            return Ok(Step::reward(reward).ending(end));
        }
        self.read(&observation, state, at)?;
        Ok(Step::reward(reward))
    }

    /// Returns an answer as the environment's action, and keeps what the policy remembers.
    fn act<'py>(&self, py: Python<'py>, answer: Answer, memory: &mut [f64]) -> PyResult<Bound<'py, PyAny>> {
        match (answer, &self.action) {
            (Answer::Action(action), Action::Listed(actions, arrays)) => {
                let action = actions[usize::from(action.0)].bind(py);
                if *arrays { action.call_method0("copy") } else { Ok(action.clone()) }
            }
            (Answer::Action(_), _) => unreachable!("a policy of a box has outputs"),
            (Answer::Values(mut values), _) => {
                let remembered = values.split_off(values.len().saturating_sub(memory.len()));
                memory.iter_mut().zip(remembered).for_each(|(to, value)| *to = value);
                self.values(py, values)
            }
        }
    }

    /// Returns values as the environment's action.
    pub(crate) fn values<'py>(&self, py: Python<'py>, values: Vec<f64>) -> PyResult<Bound<'py, PyAny>> {
        match &self.action {
            Action::Encoded(encode) => encode.bind(py).call1((values,)),
            _ => Ok(PyArray1::from_iter(py, values.iter().map(|&value| value as f32)).into_any()),
        }
    }

    /// Reads an observation.
    fn read(&self, observation: &Bound<'_, PyAny>, state: &mut Vec<f64>, at: impl Fn() -> String) -> PyResult<()> {
        let flat = match &self.flatten {
            Some(flatten) => flatten.bind(observation.py()).call1((observation,))?,
            None => observation.clone(),
        };
        extend_flat(&flat, &self.shape, state, &at)?;
        match state.iter().position(|value| value.is_nan()) {
            Some(place) => Err(error::input(format!("{}: observation[{place}] is NaN; accepted: a number", at()))),
            None => Ok(()),
        }
    }
}

/// Returns an observation of the given shape as a flat array: what training, `predict` and networks read, whatever the memory
/// layout and the type of its numbers.
#[pyfunction]
pub(crate) fn flat<'py>(observation: &Bound<'py, PyAny>, shape: Vec<usize>) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let mut values = Vec::with_capacity(shape.iter().product());
    extend_flat(observation, &shape, &mut values, &|| "predict".to_owned())?;
    Ok(PyArray1::from_vec(observation.py(), values))
}

/// Writes an observation's values in C order, the last index fastest.
fn extend_flat(
    observation: &Bound<'_, PyAny>,
    shape: &[usize],
    state: &mut Vec<f64>,
    at: &impl Fn() -> String,
) -> PyResult<()> {
    state.clear();
    let check = |found: &[usize]| match found == shape {
        true => Ok(()),
        false => Err(error::input(format!("{}: an observation of shape {found:?}; accepted: {shape:?}", at()))),
    };
    if let Ok(array) = observation.cast::<PyArrayDyn<f32>>() {
        check(array.shape())?;
        state.extend(array.readonly().as_array().iter().map(|&value| f64::from(value)));
        return Ok(());
    }
    let array = observation.py().import(intern!(observation.py(), "numpy"))?;
    let array = array.call_method1(intern!(observation.py(), "asarray"), (observation, "float64"))?;
    let array = array.cast::<PyArrayDyn<f64>>()?;
    check(array.shape())?;
    state.extend(array.readonly().as_array());
    Ok(())
}

/// Reads a flag by Python's truth: a bool, a number, an array of one element.
fn truth(value: &Bound<'_, PyAny>, name: &str, at: &impl Fn() -> String) -> PyResult<bool> {
    let refused = |found: String| error::input(format!("{}: {name} is {found}; accepted: true or false", at()));
    if value.is_none() {
        return Err(refused("None".to_owned()));
    }
    value.is_truthy().map_err(|error| refused(format!("{}, {error}", value.get_type())))
}

/// Returns what an episode's last info says about success: `is_success` or `success`; None where it has neither.
#[pyfunction]
pub(crate) fn success_of(info: &Bound<'_, PyAny>) -> PyResult<Option<bool>> {
    find_success(info, &|| "evaluate".to_owned())
}

/// Returns what an episode's last info says about success; nothing where it has no such key, or None.
fn find_success(info: &Bound<'_, PyAny>, at: &impl Fn() -> String) -> PyResult<Option<bool>> {
    let Ok(info) = info.cast::<PyMapping>() else { return Ok(None) };
    for name in SUCCESS {
        if info.contains(name)? {
            let value = info.get_item(name)?;
            return if value.is_none() { Ok(None) } else { truth(&value, name, at).map(Some) };
        }
    }
    Ok(None)
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
