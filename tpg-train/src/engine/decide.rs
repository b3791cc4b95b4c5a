//! From the root to an action, in every lane at once.
//!
//! Teams are visited in an order in which edges lead forwards, each with the list of lanes that reached it. A team first
//! asks its eager edges. A bid that is bounded (a sine is at most 1) and costs a transcendental function is *lazy*: it is
//! computed only in the lanes where it could still win, which are few, because most best bids are millimetres or ticks.
//! The winner is the same: the highest bid, of equal ones the last edge.

use super::columns::{BLOCK, Block, Columns};
use super::plan::{Plan, PlannedTeam};
use pulp::{Arch, Simd, WithSimd};
use tpg_runtime::ops::{self, Maths};
use tpg_runtime::policy::ActionId;
use tpg_runtime::scalar::Scalar;

/// Below one lane in so many, lanes are handled one by one.
const SPARSE: usize = 16;
/// The same for the nodes of a lazy bid.
const SPARSE_NODES: usize = 6;

/// Memory for decisions.
#[derive(Debug)]
pub(super) struct Decider<S> {
    lanes: usize,
    /// For each destination, teams before actions, the lanes that reached it: a row, and how much of it is used.
    lists: Vec<u32>,
    lengths: Vec<usize>,
    /// The best bid so far in each lane, and the edge that made it.
    best: Vec<Block<S>>,
    winner: Vec<Block<u32>>,
    /// The lanes in which a lazy bid could win.
    open: Vec<u32>,
    actions: Vec<ActionId>,
    arch: Arch,
}

/// What [`Decider::decide`] does, compiled for each width of vectors.
struct Decision<'a, S, M> {
    decider: &'a mut Decider<S>,
    plan: &'a Plan<S>,
    columns: &'a mut Columns<S, M>,
    all: usize,
}

impl<S: Scalar, M: Maths<S>> WithSimd for Decision<'_, S, M> {
    type Output = ();

    #[inline(always)]
    fn with_simd<V: Simd>(self, _: V) {
        self.decider.decide_in_vectors(self.plan, self.columns, self.all);
    }
}

impl<S: Scalar> Decider<S> {
    pub(super) fn new(lanes: usize) -> Self {
        Self {
            lanes,
            lists: Vec::new(),
            lengths: Vec::new(),
            best: vec![[S::ZERO; BLOCK]; lanes.div_ceil(BLOCK)],
            winner: vec![[0; BLOCK]; lanes.div_ceil(BLOCK)],
            open: Vec::with_capacity(lanes),
            actions: vec![ActionId(0); lanes],
            arch: Arch::new(),
        }
    }

    pub(super) fn prepare(&mut self, plan: &Plan<S>) {
        self.lengths.clear();
        self.lengths.resize(plan.destinations, 0);
        self.lists.resize((plan.destinations * self.lanes).max(self.lists.len()), 0);
    }

    /// The actions of the first `all` lanes.
    pub(super) fn decide<M: Maths<S>>(
        &mut self,
        plan: &Plan<S>,
        columns: &mut Columns<S, M>,
        all: usize,
    ) -> &[ActionId] {
        self.arch.dispatch(Decision { decider: self, plan, columns, all });
        &self.actions[..all]
    }

    #[inline(always)]
    fn decide_in_vectors<M: Maths<S>>(&mut self, plan: &Plan<S>, columns: &mut Columns<S, M>, all: usize) {
        columns.next_step();
        for (slot, lane) in self.lists[..all].iter_mut().zip(0u32..) {
            *slot = lane;
        }
        self.lengths[0] = all;
        for (place, team) in plan.teams.iter().enumerate() {
            let length = std::mem::take(&mut self.lengths[place]);
            if length == 0 {
                continue;
            }
            columns.compute(plan, &team.needs, all);
            let (first, last) = (place * self.lanes, place * self.lanes + length);
            if length * SPARSE > all {
                self.ask_all(team, columns, all);
                if !team.lazy.is_empty() {
                    self.ask_lazy(plan, team, columns, first..last, all);
                }
                for slot in first..last {
                    let lane = self.lists[slot];
                    let winner = self.winner.as_flattened()[lane as usize];
                    self.send(lane, team.to[winner as usize]);
                }
            } else {
                for slot in first..last {
                    let lane = self.lists[slot];
                    let winner = ask_one(plan, team, columns, lane as usize);
                    self.send(lane, team.to[winner as usize]);
                }
            }
        }
        for (action, place) in (0..).zip(plan.teams.len()..plan.destinations) {
            let length = std::mem::take(&mut self.lengths[place]);
            for &lane in &self.lists[place * self.lanes..][..length] {
                self.actions[lane as usize] = ActionId(action);
            }
        }
    }

    #[inline(always)]
    fn send(&mut self, lane: u32, to: u32) {
        let length = &mut self.lengths[to as usize];
        self.lists[to as usize * self.lanes + *length] = lane;
        *length += 1;
    }

    /// The winner of the eager edges in every lane, wanted or not.
    #[inline(always)]
    fn ask_all<M: Maths<S>>(&mut self, team: &PlannedTeam<S>, columns: &Columns<S, M>, all: usize) {
        let blocks = all.div_ceil(BLOCK);
        for (block, (to_best, to_winner)) in self.best[..blocks].iter_mut().zip(&mut self.winner[..blocks]).enumerate()
        {
            let mut best = [S::NEG_INFINITY; BLOCK];
            let mut winner = [0; BLOCK];
            for edge in &team.eager {
                let mut wins = [0; BLOCK];
                for ((best, wins), &bid) in best.iter_mut().zip(&mut wins).zip(&columns.column(edge.bid)[block]) {
                    // As `ops::bid`: a NaN is not above −∞.
                    let bid = ops::max(bid, S::NEG_INFINITY);
                    *wins = u32::from(bid >= *best).wrapping_neg();
                    *best = ops::max(bid, *best);
                }
                // With masks: conditions become branches here.
                for (winner, wins) in winner.iter_mut().zip(wins) {
                    *winner ^= (*winner ^ edge.edge) & wins;
                }
            }
            (*to_best, *to_winner) = (best, winner);
        }
    }

    /// The lazy edges, in the listed lanes where they can win.
    #[inline(always)]
    fn ask_lazy<M: Maths<S>>(
        &mut self,
        plan: &Plan<S>,
        team: &PlannedTeam<S>,
        columns: &mut Columns<S, M>,
        list: std::ops::Range<usize>,
        all: usize,
    ) {
        let Self { lists, best, winner, open, .. } = self;
        let (list, best, winner) = (&lists[list], best.as_flattened_mut(), winner.as_flattened_mut());
        for lazy in &team.lazy {
            open.clear();
            open.extend(list.iter().copied().filter(|&lane| {
                let lane = lane as usize;
                could_win(lazy.most, lazy.edge, best[lane], winner[lane])
            }));
            if open.len() * SPARSE_NODES > all {
                columns.compute(plan, &lazy.needs, all);
            }
            for &lane in open.iter() {
                let lane = lane as usize;
                let bid = ops::bid(columns.value(plan, lazy.bid, lane));
                if could_win(bid, lazy.edge, best[lane], winner[lane]) {
                    (best[lane], winner[lane]) = (bid, lazy.edge);
                }
            }
        }
    }
}

/// The winning edge in one lane.
#[inline(always)]
fn ask_one<S: Scalar, M: Maths<S>>(plan: &Plan<S>, team: &PlannedTeam<S>, columns: &Columns<S, M>, lane: usize) -> u32 {
    let mut best = S::NEG_INFINITY;
    let mut winner = 0;
    for edge in &team.eager {
        let bid = ops::bid(columns.get(edge.bid, lane));
        if bid >= best {
            (best, winner) = (bid, edge.edge);
        }
    }
    for lazy in &team.lazy {
        if could_win(lazy.most, lazy.edge, best, winner) {
            let bid = ops::bid(columns.value(plan, lazy.bid, lane));
            if could_win(bid, lazy.edge, best, winner) {
                (best, winner) = (bid, lazy.edge);
            }
        }
    }
    winner
}

/// Whether a bid beats the best one so far: it is higher, or equal and of a later edge.
#[inline(always)]
fn could_win<S: Scalar>(bid: S, edge: u32, best: S, winner: u32) -> bool {
    bid > best || (bid == best && edge >= winner)
}
