//! Many episodes of one root side by side.
//!
//! Each node has a column with one value for each lane, so that an instruction is one loop over lanes which the compiler
//! turns into vector instructions. Lanes whose episode ended take the next task; at the end they are closed up.

use super::environment::{Ending, Environment};
use super::history::History;
use super::nodes::{Node, NodeId};
use super::plan::{Plan, PlannedTeam};
use super::policy::Destination;
use pulp::Arch;
use std::marker::PhantomData;
use tpg_runtime::ops::{self, Instruction, Maths};
use tpg_runtime::policy::ActionId;
use tpg_runtime::scalar::Scalar;

/// How the engine works; none of it changes an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// Episodes side by side.
    pub lanes: usize,
    /// Compute equal values once, and drop bids that cannot win.
    pub share: bool,
    /// Look for cycles at every step, not only at the end of an episode.
    pub look_for_cycles: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self { lanes: 112, share: true, look_for_cycles: true }
    }
}

/// Below one lane in so many, a team decides lane by lane.
const SPARSE: usize = 6;

/// Runs roots over tasks, one root after another, and keeps its memory between them.
#[derive(Debug)]
pub struct Lanes<'e, S: Scalar, M, E: Environment<S>> {
    environment: &'e E,
    options: Options,
    columns: Vec<S>,
    computed_at: Vec<u64>,
    now: u64,
    lists: Vec<Vec<u32>>,
    best: Vec<S>,
    winner: Vec<u32>,
    actions: Vec<ActionId>,
    state: Vec<S>,
    running: Vec<Running<E::Episode>>,
    histories: Vec<History>,
    steps: u64,
    /// Loops over lanes take the widest vectors that this machine has: the same bits, sooner.
    arch: Arch,
    maths: PhantomData<M>,
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
            columns: Vec::new(),
            computed_at: Vec::new(),
            now: 0,
            lists: Vec::new(),
            best: vec![S::ZERO; options.lanes],
            winner: vec![0; options.lanes],
            actions: vec![ActionId(0); options.lanes],
            state: Vec::new(),
            running: Vec::new(),
            histories: vec![History::default(); options.lanes],
            steps: 0,
            arch: Arch::new(),
            maths: PhantomData,
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
            self.decide(plan);
            self.steps += self.running.len() as u64;
            // From the last lane down: closing up then only moves lanes that have had their step.
            for lane in (0..self.running.len()).rev() {
                let action = self.actions[lane];
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
        let lanes = self.options.lanes;
        self.columns.clear();
        self.columns.resize(plan.nodes.len() * lanes, S::ZERO);
        for (column, node) in self.columns.chunks_exact_mut(lanes).zip(&plan.nodes) {
            if let Node::Constant(value) = node {
                column.fill(*value);
            }
        }
        self.computed_at.clear();
        self.computed_at.resize(plan.nodes.len(), 0);
        self.now = 0;
        self.lists.resize_with(plan.teams.len().max(self.lists.len()), Vec::new);
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
            self.columns[node.index() * self.options.lanes + lane] = self.state[usize::from(input)];
        }
    }

    fn close_up(&mut self, plan: &Plan<S>, lane: usize) {
        self.running.swap_remove(lane);
        let last = self.running.len();
        if lane < last {
            for &(_, node) in &plan.inputs {
                let column = node.index() * self.options.lanes;
                self.columns[column + lane] = self.columns[column + last];
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
        match repeat {
            Some(repeat) => Some(self.environment.cycle(episode, repeat.key, repeat.actions)),
            None => ending,
        }
    }

    /// Walks every lane from the root to its action.
    fn decide(&mut self, plan: &Plan<S>) {
        self.now += 1;
        let all = self.running.len();
        self.lists[0].extend(0..all as u32);
        for (place, team) in plan.teams.iter().enumerate() {
            let mut list = std::mem::take(&mut self.lists[place]);
            if !list.is_empty() {
                for &node in &team.needs {
                    self.compute(plan, node, all);
                }
                if list.len() * SPARSE > all {
                    self.ask_all(team, all);
                    for &lane in &list {
                        self.send(lane, team.edges[self.winner[lane as usize] as usize].to);
                    }
                } else {
                    for &lane in &list {
                        let to = self.ask_one(team, lane as usize);
                        self.send(lane, to);
                    }
                }
                list.clear();
            }
            self.lists[place] = list;
        }
    }

    #[inline]
    fn send(&mut self, lane: u32, to: Destination) {
        match to {
            Destination::Team(team) => self.lists[team as usize].push(lane),
            Destination::Action(action) => self.actions[lane as usize] = ActionId(action),
        }
    }

    /// The winner in every lane, wanted or not: one pass over each bidder's column.
    fn ask_all(&mut self, team: &PlannedTeam, all: usize) {
        let lanes = self.options.lanes;
        let best = &mut self.best[..all];
        let winner = &mut self.winner[..all];
        let columns = &self.columns;
        self.arch.dispatch(
            #[inline(always)]
            || {
                for (index, edge) in (0u32..).zip(&team.edges) {
                    let bids = &columns[edge.bid.index() * lanes..][..all];
                    for ((best, winner), &bid) in best.iter_mut().zip(winner.iter_mut()).zip(bids) {
                        let bid = ops::bid(bid);
                        let wins = (index == 0) | (bid >= *best);
                        *best = if wins { bid } else { *best };
                        *winner = if wins { index } else { *winner };
                    }
                }
            },
        );
    }

    fn ask_one(&self, team: &PlannedTeam, lane: usize) -> Destination {
        let bid = |node: NodeId| ops::bid(self.columns[node.index() * self.options.lanes + lane]);
        let (first, others) = team.edges.split_first().expect("a team has an edge");
        let mut best = (bid(first.bid), first.to);
        for edge in others {
            let bid = bid(edge.bid);
            if bid >= best.0 {
                best = (bid, edge.to);
            }
        }
        best.1
    }

    /// Computes a node in every lane, once a step.
    fn compute(&mut self, plan: &Plan<S>, node: NodeId, all: usize) {
        if std::mem::replace(&mut self.computed_at[node.index()], self.now) == self.now {
            return;
        }
        let Node::Operation(instruction, a, b) = plan.nodes[node.index()] else { return };
        let lanes = self.options.lanes;
        let (before, from) = self.columns.split_at_mut(node.index() * lanes);
        let operands = [a, b].map(|operand| &before[operand.index() * lanes..][..all]);
        let to = &mut from[..all];
        self.arch.dispatch(
            #[inline(always)]
            || compute_column::<S, M>(instruction, operands, to),
        );
    }
}

/// One loop for each instruction, so that none has to look at it again.
#[inline(always)]
fn compute_column<S: Scalar, M: Maths<S>>(instruction: Instruction, [a, b]: [&[S]; 2], to: &mut [S]) {
    macro_rules! loops {
        ($($name:ident)*) => {
            match instruction {
                $(Instruction::$name => {
                    for ((to, &a), &b) in to.iter_mut().zip(a).zip(b) {
                        *to = Instruction::$name.apply::<S, M>(a, b);
                    }
                })*
            }
        };
    }
    loops!(Sub Add Mul Div NegateIfLess Cos Sin Ln Exp Abs Min Max);
}
