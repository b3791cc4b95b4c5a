//! A memory for policies: values that they compute at one decision and read at the next. Graphs in integers see and answer counts.

use crate::action::{Act, ActionSpace, Output};
use crate::environment::Environment;
use crate::environment::OneByOne;
use crate::episode_result::{End, EpisodeResult, Step};
use crate::episodes::Episodes;
use crate::source_set::SourceSet;
use crate::units::Units;
use tpg_graph::{Counts, Graph, MemoryDocument, SourceDocument};
use tpg_runtime::scalar::Scalar;

/// An environment that keeps a memory for its policies. To the inner environment's sources and outputs it adds one for each
/// value: what a policy puts out at one decision, it observes at the next. An episode begins with the initial values. For a
/// graph in integers, each observed value becomes its count, as a sensor gives it, and each output its value.
///
/// ```
/// use tpg_engine::{Act, Environment, Remembering, SourceSet};
/// # use tpg_engine::random::Stream;
/// # use tpg_engine::{ActionSpace, Output, Step};
/// # use tpg_graph::SourceDocument;
/// # struct Motor;
/// # impl Environment<f32> for Motor {
/// #     type Task = f32;
/// #     type Episode = f32;
/// #     fn sources(&self) -> Vec<SourceDocument> {
/// #         vec![SourceDocument::new("speed", "m/s", vec![[-9.0, 9.0]])]
/// #     }
/// #     fn actions(&self) -> ActionSpace {
/// #         let torque = Output { name: "torque".into(), unit: "N·m".into(), min: -2.0, max: 2.0 };
/// #         ActionSpace::Box(vec![torque])
/// #     }
/// #     fn time_limit(&self) -> u32 { 1 }
/// #     fn draw(&self, _: &mut Stream) -> f32 { 0.0 }
/// #     fn start(&self, task: &f32) -> f32 { *task }
/// #     fn observe(&self, speed: &mut f32, _: SourceSet, state: &mut [f32]) { state[0] = *speed; }
/// #     fn step(&self, speed: &mut f32, act: Act<'_, f32>) -> Step {
/// #         *speed += act.values()[0];
/// #         Step::reward(0.0)
/// #     }
/// # }
/// // `Motor` observes a speed, and has one output, a torque.
/// let motor = Remembering::new::<f32>(Motor, 1);
/// let mut episode = motor.start(&0.5);
/// let mut state = [0.0; 2];
/// motor.step(&mut episode, Act::Values(&[2.0, 7.0]));
/// motor.observe(&mut episode, SourceSet::ALL, &mut state);
/// assert_eq!(state, [2.5, 7.0], "the speed, and what was remembered");
/// ```
#[derive(Clone, Debug)]
pub struct Remembering<E> {
    environment: E,
    memory: Vec<MemoryDocument>,
    /// The counts of each source of the environment, for a graph in integers.
    counts: Vec<Vec<Counts>>,
    units: Units,
}

/// An episode, and the memory of its policy.
#[derive(Clone, Debug)]
pub struct WithMemory<Episode, S> {
    episode: Episode,
    /// Outputs of the inner environment.
    outputs: usize,
    memory: Vec<S>,
}

impl<E> Remembering<E> {
    /// Adds a memory of `count` values to an environment with outputs; of none changes nothing. They begin at 0 and are called `memory0`
    /// and so on. Their limits are twice the greatest magnitude that the environment's sources declare, or 20 where none is known,
    /// exact in `f32`.
    pub fn new<S: Scalar>(environment: E, count: u16) -> Self
    where
        E: Environment<S>,
    {
        let sources = environment.sources();
        let ends = sources.iter().flat_map(|source| &source.ranges).flatten().copied();
        let greatest = ends.filter(|end| end.is_finite()).fold(0.0, |most: f64, end| most.max(end.abs()));
        let limit = if greatest > 0.0 { f64::from((2.0 * greatest).min(1e30) as f32) } else { 20.0 };
        let value = |index| MemoryDocument { name: format!("memory{index}"), min: -limit, max: limit, initial: 0.0 };
        let memory = (0..count).map(value).collect();
        Self { environment, memory, counts: Vec::new(), units: Units::default() }
    }

    /// Adds the memory of a graph to an environment, and puts that into the graph's counts; what the graph does not name stays as it
    /// is.
    ///
    /// ```
    /// use tpg_engine::{Act, Environment, Remembering, SourceSet};
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
    /// let motor = Remembering::for_graph::<f64>(Motor, &Graph::from_json("motor.json", text)?);
    /// let mut episode = motor.start(&0.52);
    /// let mut state = [0.0];
    /// motor.observe(&mut episode, SourceSet::ALL, &mut state);
    /// assert_eq!(state, [5.0]);
    /// motor.step(&mut episode, Act::Values(&[8.0]));
    /// motor.observe(&mut episode, SourceSet::ALL, &mut state);
    /// assert_eq!(state, [25.0]);
    /// # Ok::<(), tpg_graph::error::InputError>(())
    /// ```
    pub fn for_graph<S: Scalar>(environment: E, graph: &Graph) -> Self
    where
        E: Environment<S>,
    {
        let known = graph.sources();
        let (mut counts, mut units) = (Vec::new(), Units::default());
        for source in environment.sources() {
            let same = known.iter().find(|known| known.name == source.name && known.length == source.length);
            let of_source = same.map(|known| known.counts.clone()).unwrap_or_default();
            units.inputs.extend((0..source.length as usize).map(|place| of_source.get(place).copied()));
            counts.push(of_source);
        }
        let of_output = |output: &Output| graph.outputs().iter().find(|known| known.name == output.name)?.counts;
        units.outputs = environment.actions().outputs().iter().map(of_output).collect();
        let remembered = &graph.outputs()[graph.outputs().len() - graph.memory()..];
        let value = |output: &tpg_graph::Output| {
            let tpg_graph::Range { min, max } = output.range;
            MemoryDocument { name: output.name.clone(), min, max, initial: output.nan }
        };
        Self { environment, memory: remembered.iter().map(value).collect(), counts, units }
    }
}

impl<S: Scalar, E: Environment<S>> Environment<S> for Remembering<E> {
    type Task = E::Task;
    type Episode = WithMemory<E::Episode, S>;

    crate::forward!(this => this.environment;
        time_limit draw outcomes measure preference accepts training);

    fn sources(&self) -> Vec<SourceDocument> {
        let value =
            |value: &MemoryDocument| SourceDocument::new(value.name.clone(), "memory", vec![[value.min, value.max]]);
        let mut sources = self.environment.sources();
        sources.iter_mut().zip(&self.counts).for_each(|(source, counts)| source.counts.clone_from(counts));
        sources.extend(self.memory.iter().map(value));
        sources
    }

    fn actions(&self) -> ActionSpace {
        let value = |value: &MemoryDocument| Output {
            name: value.name.clone(),
            unit: "memory".to_owned(),
            min: value.min,
            max: value.max,
        };
        match self.environment.actions() {
            ActionSpace::Box(mut outputs) => {
                for (output, counts) in outputs.iter_mut().zip(&self.units.outputs) {
                    if let Some(counts) = counts {
                        (output.min, output.max) = (counts.count(output.min), counts.count(output.max));
                    }
                }
                outputs.extend(self.memory.iter().map(value));
                ActionSpace::Box(outputs)
            }
            space => space,
        }
    }

    fn start(&self, task: &E::Task) -> Self::Episode {
        let memory = self.memory.iter().map(|value| S::from_f64(value.initial)).collect();
        let outputs = self.environment.actions().outputs().len();
        WithMemory { episode: self.environment.start(task), outputs, memory }
    }

    fn observe(&self, with: &mut Self::Episode, wanted: SourceSet, state: &mut [S]) {
        let (observed, memory) = state.split_at_mut(state.len() - with.memory.len());
        self.environment.observe(&mut with.episode, wanted, observed);
        self.units.count(observed);
        memory.copy_from_slice(&with.memory);
    }

    /// Takes an action. One without values for the memory, as a network takes it, leaves the memory as it is.
    fn step(&self, with: &mut Self::Episode, act: Act<'_, S>) -> Step {
        let Act::Values(values) = act else { return self.environment.step(&mut with.episode, act) };
        let (values, memory) = values.split_at(with.outputs.min(values.len()));
        if memory.len() == with.memory.len() {
            with.memory.copy_from_slice(memory);
        }
        if self.units.is_plain() {
            return self.environment.step(&mut with.episode, Act::Values(values));
        }
        let mut values = values.to_vec();
        self.units.value(&mut values);
        self.environment.step(&mut with.episode, Act::Values(&values))
    }

    fn timeout(&self, with: &Self::Episode) -> End {
        self.environment.timeout(&with.episode)
    }
    /// With a memory, the default: a repeated state of the environment alone repeats nothing.
    fn key(&self, with: &Self::Episode) -> Option<u64> {
        self.environment.key(&with.episode).filter(|_| self.memory.is_empty())
    }
    fn cycle(&self, with: &Self::Episode, key: u64, actions: u32) -> Option<EpisodeResult> {
        self.environment.cycle(&with.episode, key, actions)
    }
    fn lanes(&self) -> Box<dyn Episodes<S, E::Task> + '_> {
        let is_bare = self.memory.is_empty() && self.units.is_plain();
        if is_bare { self.environment.lanes() } else { Box::new(OneByOne::new(self)) }
    }
    fn distance(&self, with: &Self::Episode) -> Option<f64> {
        self.environment.distance(&with.episode)
    }
}

/// Returns the number of values that a policy remembers: its last outputs that are sources, too.
pub fn remembered(sources: &[SourceDocument], actions: &ActionSpace) -> usize {
    let is_read = |output: &&Output| sources.iter().any(|source| source.name == output.name);
    actions.outputs().iter().rev().take_while(is_read).count()
}
