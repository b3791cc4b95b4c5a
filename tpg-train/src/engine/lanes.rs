//! Many episodes of one root side by side.
//!
//! Each node has a column with one value for each lane, so that an instruction is one loop over lanes which the compiler
//! turns into vector instructions. Lanes whose episode ended take the next task; at the end they are closed up.

use super::columns::Columns;
use super::decide::Decider;
use super::environment::{Ending, Environment};
use super::history::History;
use super::plan::Plan;
use tpg_runtime::ops::Maths;
use tpg_runtime::policy::ActionId;
use tpg_runtime::scalar::Scalar;

/// How the engine works; none of it changes an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// Episodes side by side.
    pub lanes: usize,
    /// Compute equal values once, and drop bids that cannot win.
    pub share: bool,
    /// Compute a bounded, expensive bid only where it could win.
    pub lazy: bool,
    /// Look for cycles at every step, not only at the end of an episode.
    pub look_for_cycles: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self { lanes: 112, share: true, lazy: true, look_for_cycles: true }
    }
}

/// Runs roots over tasks, one root after another, and keeps its memory between them.
#[derive(Debug)]
pub struct Lanes<'e, S: Scalar, M, E: Environment<S>> {
    environment: &'e E,
    options: Options,
    columns: Columns<S, M>,
    decider: Decider<S>,
    state: Vec<S>,
    running: Vec<Running<E::Episode>>,
    histories: Vec<History>,
    steps: u64,
}

#[derive(Debug)]
struct Running<Episode> {
    task: usize,
    /// Where its keys are: histories stay, lanes move.
    history: usize,
    episode: Episode,
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
            columns: Columns::new(options.lanes),
            decider: Decider::new(options.lanes),
            state: Vec::new(),
            running: Vec::new(),
            histories: vec![History::default(); options.lanes],
            steps: 0,
        }
    }

    /// Environment steps since the beginning.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// How the root does on each task.
    pub fn run(&mut self, plan: &Plan<S>, tasks: &[E::Task]) -> Vec<Ending> {
        self.run_watched(plan, tasks, |_, _| ())
    }

    /// As [`run`](Self::run); `watch` is told every action, with the place of its task.
    pub fn run_watched(
        &mut self,
        plan: &Plan<S>,
        tasks: &[E::Task],
        mut watch: impl FnMut(usize, ActionId),
    ) -> Vec<Ending> {
        self.prepare(plan);
        let mut endings = vec![None; tasks.len()];
        let mut next = 0;
        while next < tasks.len().min(self.options.lanes) {
            let running = self.begin(tasks, next, next);
            self.running.push(running);
            self.show(plan, next);
            next += 1;
        }
        while !self.running.is_empty() {
            self.decider.decide(plan, &mut self.columns, self.running.len());
            self.steps += self.running.len() as u64;
            // From the last lane down: closing up then only moves lanes that have had their step.
            for lane in (0..self.running.len()).rev() {
                let action = self.decider.action(lane);
                watch(self.running[lane].task, action);
                let Some(ending) = self.step(lane, action) else {
                    self.show(plan, lane);
                    continue;
                };
                endings[self.running[lane].task] = Some(ending);
                if next < tasks.len() {
                    self.running[lane] = self.begin(tasks, next, self.running[lane].history);
                    next += 1;
                    self.show(plan, lane);
                } else {
                    self.close_up(plan, lane);
                }
            }
        }
        endings.into_iter().map(|ending| ending.expect("every task was begun and every lane ended")).collect()
    }

    fn prepare(&mut self, plan: &Plan<S>) {
        self.columns.prepare(plan);
        self.decider.prepare(plan);
        self.state.clear();
        self.state.resize(plan.state_length, S::ZERO);
    }

    fn begin(&mut self, tasks: &[E::Task], task: usize, history: usize) -> Running<E::Episode> {
        let episode = self.environment.start(&tasks[task]);
        if let Some(key) = self.environment.key(&episode) {
            self.histories[history].reset(key);
        }
        Running { task, history, episode }
    }

    /// Puts what a lane's policy sees into the columns.
    fn show(&mut self, plan: &Plan<S>, lane: usize) {
        self.environment.observe(&mut self.running[lane].episode, plan.wanted, &mut self.state);
        for &(input, node) in &plan.inputs {
            self.columns.set(node, lane, self.state[usize::from(input)]);
        }
    }

    fn close_up(&mut self, plan: &Plan<S>, lane: usize) {
        self.running.swap_remove(lane);
        let last = self.running.len();
        if lane < last {
            for &(_, node) in &plan.inputs {
                let value = self.columns.get(node, last);
                self.columns.set(node, lane, value);
            }
        }
    }

    fn step(&mut self, lane: usize, action: ActionId) -> Option<Ending> {
        let Running { history, episode, .. } = &mut self.running[lane];
        let history = &mut self.histories[*history];
        let ending = self.environment.step(episode, action);
        let Some(key) = self.environment.key(episode) else { return ending };
        let repeat = match ending {
            None if self.options.look_for_cycles => history.push_and_look(key),
            None => {
                history.push(key);
                None
            }
            // An episode in a cycle never ends by itself, so only a time-out can hide an earlier repeat. One at the
            // time-out itself counts as a cycle too: the set of visited keys would have seen it.
            Some(ending) if !ending.success && ending.actions >= self.environment.time_limit() => {
                history.push(key);
                history.first_repeat().filter(|repeat| repeat.actions <= ending.actions)
            }
            Some(_) => None,
        };
        let cycle = repeat.and_then(|repeat| self.environment.cycle(episode, repeat.key, repeat.actions));
        cycle.or(ending)
    }
}
