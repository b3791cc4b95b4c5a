//! Many episodes of one root side by side.
//!
//! Each node has a column with one value for each lane, so that an instruction is one loop over lanes which the compiler
//! turns into vector instructions. Lanes whose episode ended take the next task; at the end they are closed up.

use crate::columns::Columns;
use crate::decide::Decider;
use crate::ending::Ending;
use crate::environment::Environment;
use crate::episodes::Episodes;
use crate::evaluator::EvaluationError;
use crate::history::History;
use crate::options::Options;
use crate::plan::Plan;
use tpg_runtime::ops::Maths;
use tpg_runtime::policy::ActionId;
use tpg_runtime::scalar::Scalar;

/// Runs roots over tasks, one root after another, and keeps its memory between them.
pub struct Lanes<'e, S: Scalar, M, E: Environment<S>> {
    environment: &'e E,
    options: Options,
    constants: Vec<u16>,
    columns: Columns<S, M>,
    decider: Decider<S>,
    episodes: Box<dyn Episodes<S, E::Task> + 'e>,
    /// The place of each lane's task, and of its history: histories stay, lanes move.
    running: Vec<(usize, usize)>,
    histories: Vec<History>,
    ended: Vec<(usize, Ending)>,
    steps: u64,
}

impl<'e, S: Scalar, M: Maths<S>, E: Environment<S>> Lanes<'e, S, M, E> {
    /// Lanes for an environment.
    ///
    /// # Panics
    /// If there are no lanes.
    pub fn new(environment: &'e E, options: Options) -> Self {
        assert!(options.lanes > 0, "at least one lane");
        Self {
            environment,
            options,
            constants: environment.constants(),
            columns: Columns::new(options.lanes),
            decider: Decider::new(options.lanes),
            episodes: environment.lanes(),
            running: Vec::new(),
            histories: vec![History::default(); options.lanes],
            ended: Vec::new(),
            steps: 0,
        }
    }

    /// Environment steps since the beginning.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// The root's ending on each task.
    ///
    /// # Errors
    /// If an episode fails: see [`Episodes`].
    pub fn run(&mut self, plan: &Plan<S>, tasks: &[E::Task]) -> Result<Vec<Ending>, EvaluationError> {
        self.run_watched(plan, tasks, |_, _| ())
    }

    /// As [`run`](Self::run); `watch` is told every action, with the place of its task.
    ///
    /// # Errors
    /// As [`run`](Self::run).
    pub fn run_watched(
        &mut self,
        plan: &Plan<S>,
        tasks: &[E::Task],
        watch: impl FnMut(usize, ActionId),
    ) -> Result<Vec<Ending>, EvaluationError> {
        let result = self.run_all(plan, tasks, watch);
        if result.is_err() {
            // Episodes that were left in the middle must not be taken for new ones.
            self.running.clear();
            self.episodes = self.environment.lanes();
        }
        result
    }

    fn run_all(
        &mut self,
        plan: &Plan<S>,
        tasks: &[E::Task],
        mut watch: impl FnMut(usize, ActionId),
    ) -> Result<Vec<Ending>, EvaluationError> {
        self.columns.prepare(plan, &self.constants);
        self.decider.prepare(plan);
        let mut endings = vec![None; tasks.len()];
        let mut next = 0;
        while next < tasks.len().min(self.options.lanes) {
            self.running.push((next, next));
            self.begin(tasks, next)?;
            next += 1;
        }
        while !self.running.is_empty() {
            self.episodes.observe(plan.wanted, &mut self.columns.view(&plan.places))?;
            let actions = self.decider.decide(plan, &mut self.columns, self.running.len());
            self.running.iter().zip(actions).for_each(|(&(task, _), &action)| watch(task, action));
            self.steps += actions.len() as u64;
            self.ended.clear();
            self.episodes.step(actions, &mut self.ended)?;
            self.end_cycles();
            // From the last lane down: closing up then only moves lanes that go on.
            while let Some((lane, ending)) = self.ended.pop() {
                endings[self.running[lane].0] = Some(ending);
                if next < tasks.len() {
                    self.running[lane].0 = next;
                    self.begin(tasks, lane)?;
                    next += 1;
                } else {
                    self.running.swap_remove(lane);
                    self.episodes.close_up(lane);
                    self.columns.forget();
                }
            }
        }
        Ok(endings.into_iter().map(|ending| ending.expect("every task was begun and every lane ended")).collect())
    }

    /// Starts a lane's episode.
    fn begin(&mut self, tasks: &[E::Task], lane: usize) -> Result<(), EvaluationError> {
        let (task, history) = self.running[lane];
        self.episodes.begin(lane, &tasks[task])?;
        self.columns.forget();
        if let Some(&key) = self.episodes.keys().get(lane) {
            self.histories[history].reset(key);
        }
        Ok(())
    }

    /// Writes down where every lane is now, and ends what came back to where it was.
    fn end_cycles(&mut self) {
        let Self { episodes, running, histories, ended, options, .. } = self;
        let keys = episodes.keys();
        if keys.is_empty() {
            return;
        }
        let mut already = std::mem::take(ended).into_iter().peekable();
        for (lane, (&key, &(_, history))) in keys.iter().zip(running.iter()).enumerate() {
            let history = &mut histories[history];
            let ending = already.next_if(|&(other, _)| other == lane).map(|(_, ending)| ending);
            let repeat = match ending {
                None if options.look_for_cycles => history.push_and_look(key),
                None => {
                    history.push(key);
                    None
                }
                // An episode in a cycle never ends by itself, so only a time-out can hide an earlier repeat. One at the
                // time-out itself counts as a cycle too: the set of visited keys would have seen it.
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
