//! From the root to an action, in every lane at once.
//!
//! Teams are visited in an order in which edges lead forwards, each with the list of lanes that reached it. A team first
//! asks its eager edges. A bid that is bounded (a sine is at most 1) and costs a transcendental function is *lazy*: it is
//! computed only in the lanes where it could still win, which are few, because most best bids are millimetres or ticks.
//! The winner is the same: the highest bid, of equal ones the last edge.

use super::columns::Columns;
use super::plan::{Plan, PlannedTeam};
use super::policy::Destination;
use pulp::Arch;
use tpg_runtime::ops::{self, Maths};
use tpg_runtime::policy::ActionId;
use tpg_runtime::scalar::Scalar;

/// Below one lane in so many, lanes are handled one by one.
const SPARSE: usize = 6;

/// Memory for decisions.
#[derive(Debug)]
pub(super) struct Decider<S> {
    /// For each team, the lanes that reached it.
    lists: Vec<Vec<u32>>,
    /// The best bid so far in each lane, and the edge that made it.
    best: Vec<S>,
    winner: Vec<u32>,
    /// The lanes in which a lazy bid could win.
    open: Vec<u32>,
    actions: Vec<ActionId>,
    arch: Arch,
}

impl<S: Scalar> Decider<S> {
    pub(super) fn new(lanes: usize) -> Self {
        Self {
            lists: Vec::new(),
            best: vec![S::ZERO; lanes],
            winner: vec![0; lanes],
            open: Vec::with_capacity(lanes),
            actions: vec![ActionId(0); lanes],
            arch: Arch::new(),
        }
    }

    pub(super) fn prepare(&mut self, plan: &Plan<S>) {
        self.lists.resize_with(plan.teams.len().max(self.lists.len()), Vec::new);
    }

    /// The action of a lane, after [`decide`](Self::decide).
    #[inline]
    pub(super) fn action(&self, lane: usize) -> ActionId {
        self.actions[lane]
    }

    /// Decides in the first `all` lanes.
    pub(super) fn decide<M: Maths<S>>(&mut self, plan: &Plan<S>, columns: &mut Columns<S, M>, all: usize) {
        columns.next_step();
        self.lists[0].extend(0..all as u32);
        for (place, team) in plan.teams.iter().enumerate() {
            let mut list = std::mem::take(&mut self.lists[place]);
            if !list.is_empty() {
                for &node in &team.needs {
                    columns.compute(plan, node, all);
                }
                if list.len() * SPARSE > all {
                    self.ask_all(team, columns, all);
                    self.ask_lazy(plan, team, columns, &list, all);
                    for &lane in &list {
                        self.send(lane, team.edges[self.winner[lane as usize] as usize].to);
                    }
                } else {
                    for &lane in &list {
                        let winner = ask_one(plan, team, columns, lane as usize);
                        self.send(lane, team.edges[winner as usize].to);
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

    /// The winner of the eager edges in every lane, wanted or not: one pass over each bidder's column.
    fn ask_all<M: Maths<S>>(&mut self, team: &PlannedTeam<S>, columns: &Columns<S, M>, all: usize) {
        let best = &mut self.best[..all];
        let winner = &mut self.winner[..all];
        self.arch.dispatch(
            #[inline(always)]
            || {
                for (place, &index) in team.eager.iter().enumerate() {
                    let bids = columns.column(team.edges[index as usize].bid, all);
                    keep_best(index, place == 0, bids, best, winner);
                }
            },
        );
        if team.eager.is_empty() {
            best.fill(S::NEG_INFINITY);
            winner.fill(0);
        }
    }

    /// The lazy edges, in the listed lanes where they can win.
    fn ask_lazy<M: Maths<S>>(
        &mut self,
        plan: &Plan<S>,
        team: &PlannedTeam<S>,
        columns: &mut Columns<S, M>,
        list: &[u32],
        all: usize,
    ) {
        for lazy in &team.lazy {
            self.open.clear();
            let (best, winner) = (&self.best, &self.winner);
            self.open.extend(list.iter().copied().filter(|&lane| {
                let lane = lane as usize;
                could_win(lazy.most, lazy.edge, best[lane], winner[lane])
            }));
            if self.open.len() * SPARSE > all {
                for &node in &lazy.needs {
                    columns.compute(plan, node, all);
                }
            }
            let node = team.edges[lazy.edge as usize].bid;
            for &lane in &self.open {
                let lane = lane as usize;
                let bid = ops::bid(columns.value(plan, node, lane));
                if could_win(bid, lazy.edge, self.best[lane], self.winner[lane]) {
                    (self.best[lane], self.winner[lane]) = (bid, lazy.edge);
                }
            }
        }
    }
}

/// Puts an edge's bids where they are not below the best so far. Always inlined, into a function that may use wide vectors.
#[inline(always)]
fn keep_best<S: Scalar>(edge: u32, first: bool, bids: &[S], best: &mut [S], winner: &mut [u32]) {
    for ((best, winner), &bid) in best.iter_mut().zip(winner.iter_mut()).zip(bids) {
        let bid = ops::bid(bid);
        let wins = first | (bid >= *best);
        *best = if wins { bid } else { *best };
        *winner = if wins { edge } else { *winner };
    }
}

/// The winning edge in one lane.
fn ask_one<S: Scalar, M: Maths<S>>(plan: &Plan<S>, team: &PlannedTeam<S>, columns: &Columns<S, M>, lane: usize) -> u32 {
    let mut best = S::NEG_INFINITY;
    let mut winner = 0;
    for &index in &team.eager {
        let bid = ops::bid(columns.get(team.edges[index as usize].bid, lane));
        if bid >= best {
            (best, winner) = (bid, index);
        }
    }
    for lazy in &team.lazy {
        if could_win(lazy.most, lazy.edge, best, winner) {
            let bid = ops::bid(columns.value(plan, team.edges[lazy.edge as usize].bid, lane));
            if could_win(bid, lazy.edge, best, winner) {
                (best, winner) = (bid, lazy.edge);
            }
        }
    }
    winner
}

/// Whether a bid beats the best one so far: it is higher, or equal and of a later edge.
#[inline]
fn could_win<S: Scalar>(bid: S, edge: u32, best: S, winner: u32) -> bool {
    bid > best || (bid == best && edge >= winner)
}
