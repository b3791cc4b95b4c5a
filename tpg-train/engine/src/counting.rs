//! Environments for graphs that see and answer counts.

use crate::action::{Act, ActionSpace, Output};
use crate::environment::{Environment, OneByOne};
use crate::episode_result::Step;
use crate::episodes::Episodes;
use crate::source_set::SourceSet;
use serde::{Deserialize, Serialize};
use tpg_graph::{Counts, Graph, SourceDocument};
use tpg_runtime::scalar::Scalar;

/// The counts of the values that a graph reads and answers, if they are counts.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Units {
    inputs: Vec<Option<Counts>>,
    outputs: Vec<Option<Counts>>,
}

impl Units {
    /// Returns those of a graph.
    pub fn of(graph: &Graph) -> Self {
        let inputs = graph.inputs().map(|input| graph.counts_of(input)).collect();
        Self { inputs, outputs: graph.outputs().iter().map(|output| output.counts).collect() }
    }

    /// Puts the values of a state into counts.
    pub fn count<S: Scalar>(&self, state: &mut [S]) {
        convert(&self.inputs, state, Counts::count);
    }

    /// Puts the counts of an answer into values.
    pub fn value<S: Scalar>(&self, answer: &mut [S]) {
        convert(&self.outputs, answer, Counts::value);
    }
}

fn convert<S: Scalar>(counts: &[Option<Counts>], values: &mut [S], convert: fn(Counts, f64) -> f64) {
    for (value, counts) in values.iter_mut().zip(counts) {
        *value = counts.map_or(*value, |counts| S::from_f64(convert(counts, value.to_f64())));
    }
}

/// An environment whose values are the counts that a graph sees and answers: each observed value becomes its count, as a sensor
/// gives it, and each output its value.
///
/// ```
/// use tpg_engine::{Act, Counting, Environment, SourceSet};
/// use tpg_graph::Graph;
/// # use tpg_engine::random::Stream;
/// # use tpg_engine::{ActionSpace, Output, Step};
/// # use tpg_graph::SourceDocument;
/// # struct Motor;
/// # impl Environment<f64> for Motor {
/// #     type Task = f64;
/// #     type Episode = f64;
/// #     fn sources(&self) -> Vec<SourceDocument> { vec![SourceDocument::new("speed", "m/s", vec![[-9.0, 9.0]])] }
/// #     fn actions(&self) -> ActionSpace {
/// #         ActionSpace::Box(vec![Output { name: "torque".into(), unit: "N·m".into(), min: -2.0, max: 2.0 }])
/// #     }
/// #     fn time_limit(&self) -> u32 { 1 }
/// #     fn draw(&self, _: &mut Stream) -> f64 { 0.0 }
/// #     fn start(&self, task: &f64) -> f64 { *task }
/// #     fn observe(&self, speed: &mut f64, _: SourceSet, state: &mut [f64]) { state[0] = *speed; }
/// #     fn step(&self, speed: &mut f64, act: Act<'_, f64>) -> Step {
/// #         *speed += act.values()[0];
/// #         Step::reward(0.0)
/// #     }
/// # }
/// // `Motor` observes a speed, and has one output, a torque.
/// let text = r#"{
///     "format": "tpg-graph", "version": 2, "scalar": "f64", "maths": "own", "registers": 1,
///     "sources": [{ "name": "speed", "length": 1, "unit": "m/s", "ranges": [[-90, 90]], "counts": [{ "bits": 8, "scale": 0.1 }] }],
///     "instructions": ["copy"],
///     "outputs": [{ "name": "torque", "unit": "N·m", "min": -8, "max": 8, "nan": 0, "counts": { "bits": 8, "scale": 0.25 } }],
///     "leaves": [{ "id": 0, "programs": [0] }],
///     "programs": [{ "id": 0, "lines": [{ "to": 0, "op": "copy", "args": ["speed[0]"] }] }]
/// }"#;
/// let motor = Counting::new::<f64>(Motor, &Graph::from_json("motor.json", text)?);
/// let mut episode = motor.start(&0.52);
/// let mut state = [0.0];
/// motor.observe(&mut episode, SourceSet::ALL, &mut state);
/// assert_eq!(state, [5.0]);
/// motor.step(&mut episode, Act::Values(&[8.0]));
/// motor.observe(&mut episode, SourceSet::ALL, &mut state);
/// assert_eq!(state, [25.0]);
/// # Ok::<(), tpg_graph::error::InputError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Counting<E> {
    environment: E,
    /// The sources, in counts where the graph has some.
    sources: Vec<SourceDocument>,
    units: Units,
}

impl<E> Counting<E> {
    /// Puts an environment into the counts of a graph; what the graph does not name stays as it is.
    pub fn new<S: Scalar>(environment: E, graph: &Graph) -> Self
    where
        E: Environment<S>,
    {
        let known = graph.state_sources();
        let counted = |source: SourceDocument| {
            let same = known.iter().find(|known| known.name == source.name && known.length == source.length);
            same.cloned().unwrap_or(source)
        };
        let sources: Vec<SourceDocument> = environment.sources().into_iter().map(counted).collect();
        let of_source = |source: &SourceDocument| {
            let counts = source.counts.clone();
            (0..source.length as usize).map(move |place| counts.get(place).copied())
        };
        let of_output = |output: &Output| graph.outputs().iter().find(|known| known.name == output.name)?.counts;
        let outputs = environment.actions().outputs().iter().map(of_output).collect();
        let units = Units { inputs: sources.iter().flat_map(of_source).collect(), outputs };
        Self { environment, sources, units }
    }
}

impl<S: Scalar, E: Environment<S>> Environment<S> for Counting<E> {
    type Task = E::Task;
    type Episode = E::Episode;

    crate::forward!(this => this.environment;
        time_limit draw start outcomes timeout measure preference accepts key cycle training guarded drawn distance);

    fn sources(&self) -> Vec<SourceDocument> {
        self.sources.clone()
    }

    fn actions(&self) -> ActionSpace {
        let mut space = self.environment.actions();
        if let ActionSpace::Box(outputs) = &mut space {
            for (output, counts) in outputs.iter_mut().zip(&self.units.outputs) {
                if let Some(counts) = counts {
                    (output.min, output.max) = (counts.count(output.min), counts.count(output.max));
                }
            }
        }
        space
    }

    fn lanes(&self) -> Box<dyn Episodes<S, E::Task> + '_> {
        let is_plain = self.units.inputs.iter().chain(&self.units.outputs).all(Option::is_none);
        if is_plain { self.environment.lanes() } else { Box::new(OneByOne::new(self)) }
    }

    fn observe(&self, episode: &mut Self::Episode, wanted: SourceSet, state: &mut [S]) {
        self.environment.observe(episode, wanted, state);
        self.units.count(state);
    }

    fn step(&self, episode: &mut Self::Episode, act: Act<'_, S>) -> Step {
        let Act::Values(values) = act else { return self.environment.step(episode, act) };
        let mut values = values.to_vec();
        self.units.value(&mut values);
        self.environment.step(episode, Act::Values(&values))
    }
}
