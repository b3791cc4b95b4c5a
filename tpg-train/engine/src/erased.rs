//! Environments whose type is only known at run time: what works with them is compiled once for all problems.

use crate::action::{Act, Output};
use crate::environment::Environment;
use crate::episode_result::{End, EpisodeResult, Step};
use crate::episodes::Episodes;
use crate::extensions::{Guarded, TaskSet, Training};
use crate::mapped::Mapped;
use crate::random::Stream;
use crate::source_set::SourceSet;
use crate::tasks::coarser;
use serde::de::{DeserializeOwned, Error as _};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::value::RawValue;
use std::any::Any;
use std::fmt;
use std::marker::PhantomData;
use std::sync::{Arc, OnceLock};
use tpg_graph::SourceDocument;
use tpg_runtime::scalar::Scalar;

/// An environment of any type. `&*environment` is an [`Environment`] like any other, with the same results.
pub type AnyEnvironment<S> = Box<dyn Environment<S, Task = AnyTask, Episode = AnyEpisode> + Send>;

/// Hides the type of an environment.
///
/// ```
/// use tpg_engine::{Environment, erase};
/// # use tpg_engine::random::{Purpose, Stream};
/// # use tpg_engine::{Act, ActionSpace, SourceSet, Step};
/// # use tpg_graph::SourceDocument;
/// # struct Counter;
/// # impl Environment<f32> for Counter {
/// #     type Task = f32;
/// #     type Episode = f32;
/// #     fn sources(&self) -> Vec<SourceDocument> { Vec::new() }
/// #     fn actions(&self) -> ActionSpace { ActionSpace::discrete(["down", "up"]) }
/// #     fn time_limit(&self) -> u32 { 5 }
/// #     fn draw(&self, _: &mut Stream) -> f32 { 0.5 }
/// #     fn start(&self, task: &f32) -> f32 { *task }
/// #     fn observe(&self, count: &mut f32, _: SourceSet, state: &mut [f32]) { state[0] = *count; }
/// #     fn step(&self, count: &mut f32, act: Act<'_, f32>) -> Step { Step::reward(1.0) }
/// # }
///
/// let environment = erase::<f32, _>(Counter);
/// let task = environment.draw(&mut Stream::new(1, 0, Purpose::Task, 0));
/// assert_eq!(serde_json::to_string(&task)?, "0.5", "a task looks as the problem's own in a file");
/// # Ok::<(), serde_json::Error>(())
/// ```
pub fn erase<'e, S: Scalar, E: Environment<S> + Send + 'e>(
    environment: E,
) -> Box<dyn Environment<S, Task = AnyTask, Episode = AnyEpisode> + Send + 'e> {
    Box::new(Typed(environment, PhantomData))
}

/// A task of an environment of any type. In JSON it looks as the problem's own.
#[derive(Clone)]
pub struct AnyTask(Arc<Forms>);

/// A task's forms; at least one is there, the other is made when it is needed.
#[derive(Default)]
struct Forms {
    typed: OnceLock<Box<dyn ErasedTask>>,
    json: OnceLock<Box<RawValue>>,
}

/// A task that can be written.
trait ErasedTask: Any + Send + Sync {
    fn to_json(&self) -> Box<RawValue>;
}

impl<T: Serialize + Send + Sync + 'static> ErasedTask for T {
    fn to_json(&self) -> Box<RawValue> {
        serde_json::value::to_raw_value(self).expect("a task is plain data")
    }
}

impl AnyTask {
    /// Hides the type of a task.
    pub fn new<T: Serialize + Send + Sync + 'static>(task: T) -> Self {
        Self(Arc::new(Forms { typed: OnceLock::from(Box::new(task) as Box<dyn ErasedTask>), json: OnceLock::new() }))
    }

    fn json(&self) -> &RawValue {
        let Forms { typed, json } = &*self.0;
        json.get_or_init(|| typed.get().expect("one of the forms").to_json())
    }

    /// Returns the task in the problem's own type; `None` if it was read from a file and is none.
    pub fn typed<T: Serialize + DeserializeOwned + Send + Sync + 'static>(&self) -> Option<&T> {
        let Forms { typed, json } = &*self.0;
        if typed.get().is_none() {
            let task: T = serde_json::from_str(json.get()?.get()).ok()?;
            // Another thread may have been faster; its task is the same.
            let _ = typed.set(Box::new(task));
        }
        (&**typed.get()? as &dyn Any).downcast_ref()
    }
}

impl fmt::Debug for AnyTask {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.json().get())
    }
}

impl PartialEq for AnyTask {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0) || self.json().get() == other.json().get()
    }
}

impl Serialize for AnyTask {
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        self.json().serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for AnyTask {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let json = Box::<RawValue>::deserialize(deserializer).map_err(D::Error::custom)?;
        Ok(Self(Arc::new(Forms { typed: OnceLock::new(), json: OnceLock::from(json) })))
    }
}

/// A running episode of an environment of any type.
pub struct AnyEpisode(Box<dyn Any + Send>);

impl AnyEpisode {
    fn typed<T: 'static>(&self) -> &T {
        self.0.downcast_ref().expect("an episode of this environment")
    }

    fn typed_mut<T: 'static>(&mut self) -> &mut T {
        self.0.downcast_mut().expect("an episode of this environment")
    }
}

/// An environment with its type, which nobody sees.
struct Typed<S, E>(E, PhantomData<fn() -> S>);

impl<S: Scalar, E: Environment<S>> Environment<S> for Typed<S, E> {
    type Task = AnyTask;
    type Episode = AnyEpisode;

    crate::forward!(this => this.0; sources actions time_limit outcomes measure preference);

    fn draw(&self, stream: &mut Stream) -> AnyTask {
        AnyTask::new(self.0.draw(stream))
    }
    fn start(&self, task: &AnyTask) -> AnyEpisode {
        AnyEpisode(Box::new(self.0.start(task.typed().expect(ACCEPTED))))
    }
    fn observe(&self, episode: &mut AnyEpisode, wanted: SourceSet, state: &mut [S]) {
        self.0.observe(episode.typed_mut(), wanted, state);
    }
    fn step(&self, episode: &mut AnyEpisode, act: Act<'_, S>) -> Step {
        self.0.step(episode.typed_mut(), act)
    }
    fn timeout(&self, episode: &AnyEpisode) -> End {
        self.0.timeout(episode.typed())
    }
    fn accepts(&self, task: &AnyTask) -> bool {
        task.typed().is_some_and(|task| self.0.accepts(task))
    }
    fn lanes(&self) -> Box<dyn Episodes<S, AnyTask> + '_> {
        Box::new(Mapped::new(self.0.lanes(), |task: &AnyTask| task.typed().expect(ACCEPTED)))
    }
    fn key(&self, episode: &AnyEpisode) -> Option<u64> {
        self.0.key(episode.typed())
    }
    fn cycle(&self, episode: &AnyEpisode, key: u64, actions: u32) -> Option<EpisodeResult> {
        self.0.cycle(episode.typed(), key, actions)
    }
    fn distance(&self, episode: &AnyEpisode) -> Option<f64> {
        self.0.distance(episode.typed())
    }
    fn training(&self) -> Option<&dyn Training<AnyTask>> {
        self.0.training().map(|_| self as _)
    }
    fn task_from(&self, episode: &AnyEpisode) -> Option<AnyTask> {
        self.0.task_from(episode.typed()).map(AnyTask::new)
    }
    fn guarded(&self) -> Option<&dyn Guarded<S, AnyEpisode>> {
        self.0.guarded().map(|_| self as _)
    }
    fn moment(&self, episode: &AnyEpisode) -> Vec<f64> {
        self.0.moment(episode.typed())
    }
}

impl<S: Scalar, E: Environment<S>> Typed<S, E> {
    fn guard(&self) -> &dyn Guarded<S, E::Episode> {
        self.0.guarded().expect("an environment with a guard")
    }
}

impl<S: Scalar, E: Environment<S>> Training<AnyTask> for Typed<S, E> {
    fn coarser(&self, task: AnyTask, factor: u8) -> AnyTask {
        AnyTask::new(coarser(&self.0, task.typed::<E::Task>().expect(ACCEPTED).clone(), factor))
    }
    fn tasks(&self, set: TaskSet, seed: u64, count: usize) -> Option<Vec<AnyTask>> {
        Some(self.0.training()?.tasks(set, seed, count)?.into_iter().map(AnyTask::new).collect())
    }
    fn evaluation_tasks(&self, stream: &mut Stream, count: usize) -> Option<Vec<AnyTask>> {
        Some(self.0.training()?.evaluation_tasks(stream, count)?.into_iter().map(AnyTask::new).collect())
    }
}

impl<S: Scalar, E: Environment<S>> Guarded<S, AnyEpisode> for Typed<S, E> {
    fn network_sources(&self) -> Vec<SourceDocument> {
        self.guard().network_sources()
    }
    fn network_outputs(&self) -> Vec<Output> {
        self.guard().network_outputs()
    }
    fn network_observe(&self, episode: &mut AnyEpisode, state: &mut [f32]) {
        self.guard().network_observe(episode.typed_mut(), state);
    }
    fn guards(&self) -> &'static [&'static str] {
        self.guard().guards()
    }
    fn refuses(&self, guard: &str, episode: &AnyEpisode, act: Act<'_, S>) -> bool {
        self.guard().refuses(guard, episode.typed(), act)
    }
    fn mend(&self, guard: &str, episode: &AnyEpisode, values: &mut [S]) -> bool {
        self.guard().mend(guard, episode.typed(), values)
    }
}

/// Tasks that were read from a file have been [accepted](Environment::accepts).
const ACCEPTED: &str = "a task that the environment accepts";
