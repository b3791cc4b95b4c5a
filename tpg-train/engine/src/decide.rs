//! The walk from the root to an action, in all lanes at once.
//!
//! Each lane is at a place: first at a team, finally at an action. Teams are visited in topological order and move the
//! lanes that are at them. A team first evaluates its eager edges. A bid that is bounded (a sine is at most 1) and
//! needs a transcendental function is *lazy*: it is computed only in the lanes where it could still win. These are few
//! because most best bids are millimetres or ticks. The winner is the same: the highest bid, and among equal bids the
//! last edge.
//!
//! Everything from [`Decider::decide`] on is one function, compiled for each vector width; its loops use masks instead
//! of conditions, which the compiler would turn into branches.

use crate::action::Acts;
use crate::columns::Columns;
use crate::plan::{Code, LazyEdge, Plan, PlannedTeam};
use crate::view::{BLOCK, Block, HALF};
use fearless_simd::{Level, dispatch};
use tpg_runtime::ops::{self, Maths};
use tpg_runtime::policy::ActionId;
use tpg_runtime::scalar::Scalar;

/// If at most 1 in `SPARSE` lanes is active, lanes are processed individually.
const SPARSE: usize = 16;
/// The same threshold for the nodes of a lazy bid.
const SPARSE_NODES: usize = 6;
/// Place of unused lanes.
const NOWHERE: u32 = u32::MAX;

/// Buffers for decisions.
#[derive(Debug)]
pub(super) struct Decider<S> {
    /// Place of each lane, numbered as in [`Code::to`].
    at: Vec<Block<u32>>,
    /// Teams that lanes may have reached.
    reached: Vec<bool>,
    /// Best bid so far in each lane, and the code of its edge.
    best: Vec<Block<S>>,
    winner: Vec<Block<u32>>,
    /// All ones in the lanes where a lazy bid could win.
    open: Vec<Block<u32>>,
    actions: Vec<ActionId>,
    /// The outputs of a policy that has some: lane after lane.
    values: Vec<S>,
    level: Level,
}

impl<S: Scalar> Decider<S> {
    pub(super) fn new(lanes: usize) -> Self {
        let blocks = lanes.div_ceil(BLOCK);
        Self {
            at: vec![[NOWHERE; BLOCK]; blocks],
            reached: Vec::new(),
            best: vec![[S::ZERO; BLOCK]; blocks],
            winner: vec![[0; BLOCK]; blocks],
            open: vec![[0; BLOCK]; blocks],
            actions: vec![ActionId(0); lanes],
            values: Vec::new(),
            level: Level::new(),
        }
    }

    pub(super) fn prepare(&mut self, plan: &Plan<S>) {
        self.reached.clear();
        self.reached.resize(plan.teams.len(), false);
    }

    /// Returns the actions of the first `all` lanes.
    pub(super) fn decide<M: Maths<S>>(
        &mut self,
        plan: &Plan<S>,
        columns: &mut Columns<S, M>,
        all: usize,
    ) -> &[ActionId] {
        dispatch!(self.level, _ => self.decide_in_vectors(plan, columns, all));
        &self.actions[..all]
    }

    /// Returns the actions or values that were decided for the first lanes.
    pub(super) fn acts(&self, plan: &Plan<S>, lanes: usize) -> Acts<'_, S> {
        match plan.limits.len() {
            0 => Acts::Choices(&self.actions[..lanes]),
            outputs => Acts::Values { values: &self.values[..lanes * outputs], outputs },
        }
    }

    #[inline(always)]
    fn decide_in_vectors<M: Maths<S>>(&mut self, plan: &Plan<S>, columns: &mut Columns<S, M>, all: usize) {
        columns.next_step();
        let used = all.div_ceil(BLOCK);
        let at = self.at[..used].as_flattened_mut();
        at[..all].fill(0);
        at[all..].fill(NOWHERE);
        self.reached[0] = true;
        for (place, team) in (0u32..).zip(&plan.teams) {
            if !std::mem::take(&mut self.reached[place as usize]) {
                continue;
            }
            let at = self.at[..used].as_flattened();
            // Every lane begins at the root.
            let here = if place == 0 { all as u32 } else { at.iter().map(|&at| u32::from(at == place)).sum() };
            if here == 0 {
                continue;
            }
            columns.compute(plan, &team.needs, all);
            if here as usize * SPARSE > all && all > 1 {
                self.ask_all(team, columns, all);
                for lazy in &team.lazy {
                    self.ask_lazy(plan, place, lazy, columns, all);
                }
                let winners = self.winner[..used].as_flattened();
                for (at, &winner) in self.at[..used].as_flattened_mut().iter_mut().zip(winners) {
                    let here = all_ones(*at == place);
                    *at ^= (*at ^ Code(winner).to()) & here;
                }
            } else {
                for (lane, at) in self.at.as_flattened_mut()[..all].iter_mut().enumerate() {
                    if *at == place {
                        *at = ask_one(plan, team, columns, lane).to();
                    }
                }
            }
            for &next in &team.next {
                self.reached[next as usize] = true;
            }
        }
        for (action, &at) in self.actions[..all].iter_mut().zip(self.at.as_flattened()) {
            *action = plan.actions[at as usize - plan.teams.len()];
        }
        if !plan.leaves.is_empty() {
            self.compute_outputs(plan, columns, all);
        }
    }

    /// Computes the outputs of every lane at its leaf, and limits them.
    #[inline(always)]
    fn compute_outputs<M: Maths<S>>(&mut self, plan: &Plan<S>, columns: &mut Columns<S, M>, all: usize) {
        let outputs = plan.limits.len();
        self.values.resize(self.actions.len() * outputs, S::ZERO);
        let at = &self.at.as_flattened()[..all];
        for (place, leaf) in (plan.teams.len() as u32..).zip(&plan.leaves) {
            if !at.contains(&place) {
                continue;
            }
            columns.compute(plan, &leaf.needs, all);
            for (lane, values) in self.values.chunks_exact_mut(outputs).take(all).enumerate() {
                if at[lane] == place {
                    for ((value, &node), &[low, high, nan]) in values.iter_mut().zip(&leaf.values).zip(&plan.limits) {
                        *value = ops::clamp(columns.get(node, lane), low, high, nan);
                    }
                }
            }
        }
    }

    /// Finds the winner among the eager edges in every lane, whether the lane is at the team or not.
    #[inline(always)]
    fn ask_all<M: Maths<S>>(&mut self, team: &PlannedTeam<S>, columns: &Columns<S, M>, all: usize) {
        if all <= HALF {
            return self.ask_part::<M, HALF>(team, columns, 0);
        }
        for block in 0..all.div_ceil(BLOCK) {
            self.ask_part::<M, BLOCK>(team, columns, block);
        }
    }

    /// Does so in the first lanes of a block.
    #[inline(always)]
    fn ask_part<M: Maths<S>, const PART: usize>(
        &mut self,
        team: &PlannedTeam<S>,
        columns: &Columns<S, M>,
        block: usize,
    ) {
        let mut best = [S::NEG_INFINITY; PART];
        let mut winner = [team.first.0; PART];
        for edge in &team.eager {
            let mut wins = [0; PART];
            for ((best, wins), &bid) in best.iter_mut().zip(&mut wins).zip(&columns.column(edge.bid)[block]) {
                // As `ops::bid`: NaN is not above −∞.
                let bid = ops::max(bid, S::NEG_INFINITY);
                *wins = all_ones(bid >= *best);
                *best = ops::max(bid, *best);
            }
            for (winner, wins) in winner.iter_mut().zip(wins) {
                *winner ^= (*winner ^ edge.code.0) & wins;
            }
        }
        self.best[block][..PART].copy_from_slice(&best);
        self.winner[block][..PART].copy_from_slice(&winner);
    }

    /// Evaluates a lazy edge in those lanes of the team where it can win.
    #[inline(always)]
    fn ask_lazy<M: Maths<S>>(
        &mut self,
        plan: &Plan<S>,
        place: u32,
        lazy: &LazyEdge<S>,
        columns: &mut Columns<S, M>,
        all: usize,
    ) {
        let used = all.div_ceil(BLOCK);
        let (at, open) = (self.at[..used].as_flattened(), self.open[..used].as_flattened_mut());
        let (best, winner) = (self.best[..used].as_flattened_mut(), self.winner[..used].as_flattened_mut());
        let mut count = 0;
        for (((open, &at), &best), &winner) in open.iter_mut().zip(at).zip(&*best).zip(&*winner) {
            let could = (at == place) & could_win(lazy.most, lazy.code, best, Code(winner));
            *open = all_ones(could);
            count += u32::from(could);
        }
        if count == 0 {
            return;
        }
        if count as usize * SPARSE_NODES > all {
            columns.compute(plan, &lazy.needs, all);
            let bids = columns.column(lazy.bid)[..used].as_flattened();
            for (((&bid, &open), best), winner) in bids.iter().zip(&*open).zip(best).zip(winner) {
                let bid = ops::max(bid, S::NEG_INFINITY);
                let wins = (open != 0) & could_win(bid, lazy.code, *best, Code(*winner));
                *best = if wins { bid } else { *best };
                *winner ^= (*winner ^ lazy.code.0) & all_ones(wins);
            }
            return;
        }
        for (lane, _) in open.iter().enumerate().filter(|&(_, &open)| open != 0) {
            let bid = ops::bid(columns.value(plan, lazy.bid, lane));
            if could_win(bid, lazy.code, best[lane], Code(winner[lane])) {
                (best[lane], winner[lane]) = (bid, lazy.code.0);
            }
        }
    }
}

/// Returns the winning edge in one lane.
#[inline(always)]
fn ask_one<S: Scalar, M: Maths<S>>(
    plan: &Plan<S>,
    team: &PlannedTeam<S>,
    columns: &Columns<S, M>,
    lane: usize,
) -> Code {
    let mut best = S::NEG_INFINITY;
    let mut winner = team.first;
    for edge in &team.eager {
        let bid = ops::bid(columns.get(edge.bid, lane));
        if bid >= best {
            (best, winner) = (bid, edge.code);
        }
    }
    for lazy in &team.lazy {
        if could_win(lazy.most, lazy.code, best, winner) {
            let bid = ops::bid(columns.value(plan, lazy.bid, lane));
            if could_win(bid, lazy.code, best, winner) {
                (best, winner) = (bid, lazy.code);
            }
        }
    }
    winner
}

/// True if a bid beats the best one so far: it is higher, or equal and of a later edge.
#[inline(always)]
fn could_win<S: Scalar>(bid: S, edge: Code, best: S, winner: Code) -> bool {
    (bid > best) | ((bid == best) & (edge >= winner))
}

/// Converts a condition to a mask.
#[inline(always)]
fn all_ones(condition: bool) -> u32 {
    u32::from(condition).wrapping_neg()
}
