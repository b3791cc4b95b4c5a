//! Parallel episodes of one root or several.
//!
//! Each node has a column with one value per lane, so that an instruction is one loop over lanes, which the compiler
//! vectorises. A lane whose episode ended takes the next task; when no tasks remain, lanes are compacted.

use crate::action::Act;
use crate::columns::Columns;
use crate::decide::Decider;
use crate::environment::Environment;
use crate::episode_result::EpisodeResult;
use crate::episodes::Episodes;
use crate::error::EvaluationError;
use crate::history::History;
use crate::moments::Moments;
use crate::nodes::NodeId;
use crate::parts::MOST_LANES;
use crate::plan::Plan;
use crate::work::{Play, Played};
use tpg_runtime::ops::Maths;

use tpg_runtime::scalar::Scalar;

/// Number of parallel episodes of evaluation; it changes no result.
pub const DEFAULT_LANES: usize = 112;

/// Runs roots over tasks, one plan after another, and reuses its buffers between them.
///
/// ```
/// use tpg_engine::{DEFAULT_LANES, Destination, Edge, Environment, Lanes, Plan, PolicyGraph};
/// use tpg_runtime::ops::Own;
/// # use tpg_engine::random::Stream;
/// # use tpg_engine::{Act, ActionSpace, SourceSet, Step};
/// # use tpg_graph::SourceDocument;
/// # struct Counter;
/// # impl Environment<f32> for Counter {
/// #     type Task = f32;
/// #     type Episode = f32;
/// #     fn sources(&self) -> Vec<SourceDocument> {
/// #         vec![SourceDocument::new("count", "1", vec![[0.0, 9.0]])]
/// #     }
/// #     fn actions(&self) -> ActionSpace { ActionSpace::discrete(["down", "up"]) }
/// #     fn time_limit(&self) -> u32 { 5 }
/// #     fn draw(&self, _: &mut Stream) -> f32 { 0.0 }
/// #     fn start(&self, task: &f32) -> f32 { *task }
/// #     fn observe(&self, count: &mut f32, _: SourceSet, state: &mut [f32]) { state[0] = *count; }
/// #     fn step(&self, count: &mut f32, act: Act<'_, f32>) -> Step {
/// #         let change = if act.choice() == 1 { 1.0 } else { -1.0 };
/// #         *count += change;
/// #         Step::reward(f64::from(change))
/// #     }
/// # }
///
/// // `Counter` has the actions `down` and `up`, which earn −1 and 1, and a limit of 5 actions.
/// // The policy always chooses `up`.
/// let up = Edge { program: 0, to: Destination::Action(1) };
/// let policy = PolicyGraph::new(1, 0, vec![vec![up]], vec![vec![]]);
/// let plan = Plan::new::<Own>(&policy, &Counter.sources());
/// let endings = Lanes::<f32, Own, _>::new(&Counter, DEFAULT_LANES).run(&plan, &[0.0, 3.0])?;
/// assert_eq!(endings.len(), 2);
/// assert!(endings.iter().all(|ending| ending.score == 5.0 && ending.actions == 5));
/// # Ok::<(), tpg_engine::EvaluationError>(())
/// ```
pub struct Lanes<'e, S: Scalar, M, E: Environment<S>> {
    environment: &'e E,
    lanes: usize,
    columns: Columns<S, M>,
    decider: Decider<S>,
    episodes: Box<dyn Episodes<S, E::Task> + 'e>,
    /// Index of each lane's start, and of its history: histories stay in place while lanes move.
    running: Vec<(usize, usize)>,
    histories: Vec<History>,
    ended: Vec<(usize, EpisodeResult)>,
}

/// The start of an episode: the place of the root that acts, and a task.
type LaneStart<'t, Task> = (u32, &'t Task);

/// Returns the starts of a plan's only root.
fn starts<'t, S, Task>(plan: &Plan<S>, tasks: &'t [Task]) -> Vec<LaneStart<'t, Task>> {
    let &[root] = &plan.roots[..] else { panic!("a plan of one root; this one has {}", plan.roots.len()) };
    tasks.iter().map(|task| (root, task)).collect()
}

impl<'e, S: Scalar, M: Maths<S>, E: Environment<S>> Lanes<'e, S, M, E> {
    /// Creates so many lanes for an environment; their number changes no result.
    ///
    /// # Panics
    /// If the number of lanes is 0, or more than the engine's parts cover: 512.
    pub fn new(environment: &'e E, lanes: usize) -> Self {
        assert!((1..=MOST_LANES).contains(&lanes), "{lanes} lanes; accepted: 1 to {MOST_LANES}");
        Self {
            environment,
            lanes,
            columns: Columns::new(lanes),
            decider: Decider::new(lanes),
            episodes: environment.lanes(),
            running: Vec::new(),
            histories: vec![History::default(); lanes],
            ended: Vec::new(),
        }
    }

    /// Returns the root's ending on each task.
    ///
    /// # Errors
    /// If an episode fails: see [`Episodes`].
    ///
    /// # Panics
    /// If the plan has several roots: see [`run_roots`](Self::run_roots).
    pub fn run(&mut self, plan: &Plan<S>, tasks: &[E::Task]) -> Result<Vec<EpisodeResult>, EvaluationError> {
        self.run_watched(plan, tasks, |_, _| ())
    }

    /// Returns the endings of each root of a plan on its tasks.
    ///
    /// # Errors
    /// As [`run`](Self::run).
    ///
    /// # Panics
    /// If there are not as many lists of tasks as roots.
    pub fn run_roots<'t>(
        &mut self,
        plan: &Plan<S>,
        tasks: &[&'t [E::Task]],
    ) -> Result<Vec<Vec<EpisodeResult>>, EvaluationError> {
        assert_eq!(tasks.len(), plan.roots.len(), "tasks for each root");
        let starts = |(&root, &tasks): (&u32, &&'t [E::Task])| tasks.iter().map(move |task| (root, task));
        let episodes: Vec<_> = plan.roots.iter().zip(tasks).flat_map(starts).collect();
        let mut ended = self.run_all(plan, &episodes, |_, _, _, _| ())?.into_iter();
        Ok(tasks.iter().map(|tasks| ended.by_ref().take(tasks.len()).collect()).collect())
    }

    /// As [`run`](Self::run); `watch` is called before every action, with the index of its task.
    ///
    /// # Errors
    /// As [`run`](Self::run).
    ///
    /// # Panics
    /// As [`run`](Self::run).
    pub fn run_watched(
        &mut self,
        plan: &Plan<S>,
        tasks: &[E::Task],
        mut watch: impl FnMut(usize, Act<'_, S>),
    ) -> Result<Vec<EpisodeResult>, EvaluationError> {
        self.run_all(plan, &starts(plan, tasks), |_, _, task, act| watch(task, act))
    }

    /// Runs the root on a task and keeps the states that are asked for, and the moments of all in which it decides. The plan must
    /// observe all of the state.
    pub(super) fn play(
        &mut self,
        plan: &Plan<S>,
        Play { task, after, .. }: &Play<E::Task>,
    ) -> Result<Played, EvaluationError> {
        let mut state = vec![0.0; plan.state_length()];
        let (mut seen, mut states, mut done) = (Moments::new(state.len()), Vec::new(), 0);
        let endings = self.run_all(plan, &starts(plan, std::slice::from_ref(task)), |columns, lane, _, _| {
            for (value, &place) in state.iter_mut().zip(&plan.places) {
                *value = columns.get(NodeId(place), lane).to_f64();
            }
            seen.push(&state);
            states.extend(after.iter().filter(|&&after| after == done).map(|_| state.clone()));
            done += 1;
        })?;
        Ok(Played { ending: endings[0], seen, states })
    }

    /// Runs every episode to its end; `watch` gets each lane's observed state, the index of its start, and its action.
    fn run_all(
        &mut self,
        plan: &Plan<S>,
        starts: &[LaneStart<'_, E::Task>],
        mut watch: impl FnMut(&Columns<S, M>, usize, usize, Act<'_, S>),
    ) -> Result<Vec<EpisodeResult>, EvaluationError> {
        if !self.running.is_empty() {
            // An earlier call failed: its episodes must not be continued.
            self.running.clear();
            self.episodes = self.environment.lanes();
        }
        self.columns.prepare(plan);
        self.decider.prepare(plan);
        let mut endings = vec![None; starts.len()];
        let mut next = 0;
        while next < starts.len().min(self.lanes) {
            self.running.push((next, next));
            self.begin(starts, next)?;
            next += 1;
        }
        while !self.running.is_empty() {
            self.episodes.observe(plan.wanted, &mut self.columns.view(&plan.places))?;
            self.decider.decide(plan, &mut self.columns, self.running.len());
            let acts = self.decider.acts(plan, self.running.len());
            for (lane, (&(task, _), act)) in self.running.iter().zip(acts.iter()).enumerate() {
                watch(&self.columns, lane, task, act);
            }
            self.ended.clear();
            self.episodes.step(acts, &mut self.ended)?;
            self.end_cycles();
            // From the last lane down, so that compaction only moves running lanes.
            while let Some((lane, ending)) = self.ended.pop() {
                endings[self.running[lane].0] = Some(ending);
                if next < starts.len() {
                    self.running[lane].0 = next;
                    self.begin(starts, lane)?;
                    next += 1;
                } else {
                    self.running.swap_remove(lane);
                    self.episodes.close_up(lane);
                    self.decider.close_up(lane, self.running.len());
                }
            }
        }
        Ok(endings.into_iter().map(|ending| ending.expect("every task was begun and every lane ended")).collect())
    }

    /// Starts a lane's episode.
    fn begin(&mut self, starts: &[LaneStart<'_, E::Task>], lane: usize) -> Result<(), EvaluationError> {
        let (start, history) = self.running[lane];
        let (root, task) = starts[start];
        self.episodes.begin(lane, task)?;
        self.decider.begin(lane, root);
        if let Some(&key) = self.episodes.keys().get(lane) {
            self.histories[history].reset(key);
        }
        Ok(())
    }

    /// Records the current key of every lane and ends the episodes that came back to an earlier one.
    fn end_cycles(&mut self) {
        let Self { episodes, running, histories, ended, .. } = self;
        let keys = episodes.keys();
        if keys.is_empty() {
            return;
        }
        let mut already = std::mem::take(ended).into_iter().peekable();
        for (lane, (&key, &(_, history))) in keys.iter().zip(running.iter()).enumerate() {
            let history = &mut histories[history];
            let ending = already.next_if(|&(other, _)| other == lane).map(|(_, ending)| ending);
            let repeat = match ending {
                None => history.push_and_look(key),
                // An episode in a cycle never ends by itself, so only a timeout can hide an earlier repeat. A repeat at
                // the timeout itself counts as a cycle, just as a set of visited keys would report it.
                Some(ending) if ending.success != Some(true) && ending.actions >= self.environment.time_limit() => {
                    history.push(key);
                    history.first_repeat().filter(|repeat| repeat.actions <= ending.actions)
                }
                Some(_) => None,
            };
            let cycle = repeat.and_then(|repeat| episodes.cycle(lane, repeat.key, repeat.actions));
            ended.extend(cycle.or(ending).map(|ending| (lane, ending)));
        }
    }
}
