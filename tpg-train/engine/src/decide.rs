//! The walk from the roots to actions, in all lanes at once.
//!
//! Each lane is at a place: first at the team of its root, finally at an action. Teams are visited in topological order and
//! move the lanes that are at them; only the parts of blocks with such a lane are looked at. What the roots need is computed before
//! the first of them is asked, one operation in all its parts after the other.
//!
//! The highest bid wins, and among equal bids the last edge.
//!
//! Everything from [`Decider::decide_in_vectors`] on is one function, compiled for each vector width; its loops use masks instead
//! of conditions, which the compiler would turn into branches.

use crate::action::Acts;
use crate::columns::Columns;
use crate::nodes::NodeId;
use crate::parts::Parts;
use crate::plan::{Code, Plan, PlannedLeaf, PlannedTeam};
use crate::view::{BLOCK, Block, PART, part, part_mut};
use fearless_simd::{Level, dispatch};
use tpg_runtime::ops::{self, Maths};
use tpg_runtime::policy::ActionId;
use tpg_runtime::scalar::Scalar;

/// If at most 1 in `SPARSE` lanes is active, lanes are processed individually.
const SPARSE: usize = 16;
/// Place of unused lanes.
const NOWHERE: u32 = u32::MAX;

/// Buffers for decisions.
#[derive(Debug)]
pub(super) struct Decider<S> {
    /// Place of each lane's root.
    homes: Vec<Block<u32>>,
    /// The roots that lanes have, with the parts of these lanes, and what they need there: see [`Self::look_up_roots`].
    roots: Vec<(u32, Parts)>,
    needs: Vec<(NodeId, Parts)>,
    /// True if lanes have got or lost a root since that was looked up.
    moved: bool,
    /// Place of each lane, numbered as in [`Code::to`].
    at: Vec<Block<u32>>,
    /// Parts in which a lane may have reached a place.
    reached: Vec<Parts>,
    actions: Vec<ActionId>,
    /// The outputs of a policy that has some: lane after lane.
    values: Vec<S>,
    level: Level,
}

impl<S: Scalar> Decider<S> {
    pub(super) fn new(lanes: usize) -> Self {
        let blocks = lanes.div_ceil(BLOCK);
        Self {
            homes: vec![[NOWHERE; BLOCK]; blocks],
            roots: Vec::new(),
            needs: Vec::new(),
            moved: false,
            at: vec![[NOWHERE; BLOCK]; blocks],
            reached: Vec::new(),
            actions: vec![ActionId(0); lanes],
            values: Vec::new(),
            level: Level::new(),
        }
    }

    /// Allocates the buffers for a plan; no lane has a root.
    pub(super) fn prepare(&mut self, plan: &Plan<S>) {
        self.homes.fill([NOWHERE; BLOCK]);
        self.roots.clear();
        self.needs.clear();
        self.moved = true;
        self.reached.clear();
        self.reached.resize(plan.teams.len() + plan.actions.len(), Parts::NONE);
        self.values.resize(self.actions.len() * plan.limits.len(), S::ZERO);
    }

    /// Gives a lane the root at a place.
    pub(super) fn begin(&mut self, lane: usize, root: u32) {
        self.moved |= std::mem::replace(&mut self.homes.as_flattened_mut()[lane], root) != root;
    }

    /// Moves the last lane's root to `lane`.
    pub(super) fn close_up(&mut self, lane: usize, last: usize) {
        let homes = self.homes.as_flattened_mut();
        homes[lane] = homes[last];
        homes[last] = NOWHERE;
        self.moved = true;
    }

    /// Looks up which roots the lanes have, in which parts, and what these need.
    fn look_up_roots(&mut self, plan: &Plan<S>, all: usize) {
        for (lane, &home) in self.homes.as_flattened()[..all].iter().enumerate() {
            self.reached[home as usize].insert(lane / PART);
        }
        let mut roots = Vec::with_capacity(self.roots.len());
        for &root in &plan.roots {
            // Two roots can be the same team.
            let parts = std::mem::take(&mut self.reached[root as usize]);
            if !parts.is_empty() {
                roots.push((root, parts));
            }
        }
        self.moved = false;
        if roots == self.roots {
            return;
        }
        self.roots = roots;
        let mut needs = vec![Parts::NONE; plan.nodes.len()];
        for &(root, parts) in &self.roots {
            plan.teams[root as usize].needs.iter().for_each(|node| needs[node.index()].add(parts));
        }
        self.needs.clear();
        let needed = (0u32..).map(NodeId).zip(needs).filter(|(_, parts)| !parts.is_empty());
        self.needs.extend(needed);
    }

    /// Decides in the first `all` lanes.
    pub(super) fn decide<M: Maths<S>>(&mut self, plan: &Plan<S>, columns: &mut Columns<S, M>, all: usize) {
        columns.next_step();
        if all == 1 {
            self.decide_one(plan, columns);
        } else {
            if self.moved {
                self.look_up_roots(plan, all);
            }
            columns.compute(plan, self.needs.iter().copied(), all);
            dispatch!(self.level, _ => self.decide_in_vectors(plan, columns, all));
        }
    }

    /// Decides for a single lane, which is cheaper to walk through alone.
    fn decide_one<M: Maths<S>>(&mut self, plan: &Plan<S>, columns: &mut Columns<S, M>) {
        let mut at = self.homes[0][0];
        while let Some(team) = plan.teams.get(at as usize) {
            columns.compute_one(plan, &team.needs);
            at = ask_one(team, columns, 0).to();
        }
        let end = at as usize - plan.teams.len();
        self.actions[0] = plan.actions[end];
        if let Some(leaf) = plan.leaves.get(end) {
            columns.compute_one(plan, &leaf.needs);
            limit_outputs(&mut self.values, plan, leaf, columns, 0);
        }
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
        let used = all.div_ceil(BLOCK);
        self.at[..used].copy_from_slice(&self.homes[..used]);
        for &(root, parts) in &self.roots {
            self.reached[root as usize].add(parts);
        }
        for (place, team) in (0u32..).zip(&plan.teams) {
            let reached = std::mem::take(&mut self.reached[place as usize]);
            let (here, count) = self.lanes_at(place, reached);
            if here.is_empty() {
                continue;
            }
            columns.compute(plan, team.needs.iter().map(|&node| (node, here)), all);
            if count * SPARSE > all.min(here.lanes()) {
                for block in here.blocks() {
                    advance(&mut self.at[block], place, &ask(team, columns, block));
                }
            } else {
                for index in here {
                    for (lane, at) in (index * PART..).zip(part_mut(&mut self.at, index)) {
                        if *at == place {
                            *at = ask_one(team, columns, lane).to();
                        }
                    }
                }
            }
            for &next in &team.next {
                self.reached[next as usize].add(here);
            }
        }
        for (action, &at) in self.actions[..all].iter_mut().zip(self.at.as_flattened()) {
            *action = plan.actions[at as usize - plan.teams.len()];
        }
        self.compute_outputs(plan, columns, all);
        self.reached[plan.teams.len()..].fill(Parts::NONE);
    }

    /// Returns the parts with a lane at a place, of those in which one may be, and the number of these lanes.
    #[inline(always)]
    fn lanes_at(&self, place: u32, reached: Parts) -> (Parts, usize) {
        let (mut here, mut counts) = (Parts::NONE, [0; PART]);
        for index in reached {
            let mut any = 0;
            for (count, &at) in counts.iter_mut().zip(part(&self.at, index)) {
                let is_here = all_ones(at == place);
                *count -= is_here.cast_signed();
                any |= is_here;
            }
            if any != 0 {
                here.insert(index);
            }
        }
        (here, counts.into_iter().sum::<i32>() as usize)
    }

    /// Computes the outputs of every lane at its leaf, and limits them.
    #[inline(always)]
    fn compute_outputs<M: Maths<S>>(&mut self, plan: &Plan<S>, columns: &mut Columns<S, M>, all: usize) {
        for (place, leaf) in (plan.teams.len() as u32..).zip(&plan.leaves) {
            let (here, _) = self.lanes_at(place, self.reached[place as usize]);
            if here.is_empty() {
                continue;
            }
            columns.compute(plan, leaf.needs.iter().map(|&node| (node, here)), all);
            for index in here {
                let lanes = (index * PART..).zip(part(&self.at, index)).filter(|&(_, &at)| at == place);
                for (lane, _) in lanes {
                    limit_outputs(&mut self.values, plan, leaf, columns, lane);
                }
            }
        }
    }
}

/// Limits the outputs that a leaf has computed in one lane.
#[inline(always)]
fn limit_outputs<S: Scalar, M: Maths<S>>(
    outputs: &mut [S],
    plan: &Plan<S>,
    leaf: &PlannedLeaf,
    columns: &Columns<S, M>,
    lane: usize,
) {
    let of_lane = outputs.chunks_exact_mut(plan.limits.len()).skip(lane).take(1).flatten();
    for ((output, &node), &[low, high, nan]) in of_lane.zip(&leaf.values).zip(&plan.limits) {
        *output = ops::clamp(columns.get(node, lane), low, high, nan);
    }
}

/// Returns the code of the winning edge in every lane of a block, whether the lane is at the team or not.
#[inline(always)]
fn ask<S: Scalar, M: Maths<S>>(team: &PlannedTeam, columns: &Columns<S, M>, block: usize) -> Block<u32> {
    let mut best = [S::NEG_INFINITY; BLOCK];
    let mut winner = [team.first.0; BLOCK];
    for edge in &team.edges {
        let mut wins = [0; BLOCK];
        for ((best, wins), &bid) in best.iter_mut().zip(&mut wins).zip(columns.block(edge.bid, block)) {
            // As `ops::bid`: NaN is not above −∞.
            let bid = ops::max(bid, S::NEG_INFINITY);
            *wins = all_ones(bid >= *best);
            *best = ops::max(bid, *best);
        }
        for (winner, wins) in winner.iter_mut().zip(wins) {
            *winner ^= (*winner ^ edge.code.0) & wins;
        }
    }
    winner
}

/// Moves the lanes that are at a place to the destination of their winner.
#[inline(always)]
fn advance(at: &mut Block<u32>, place: u32, winner: &Block<u32>) {
    for (at, &winner) in at.iter_mut().zip(winner) {
        let here = all_ones(*at == place);
        *at ^= (*at ^ Code(winner).to()) & here;
    }
}

/// Returns the winning edge in one lane.
#[inline(always)]
fn ask_one<S: Scalar, M: Maths<S>>(team: &PlannedTeam, columns: &Columns<S, M>, lane: usize) -> Code {
    let (mut best, mut winner) = (S::NEG_INFINITY, team.first);
    for edge in &team.edges {
        let bid = ops::bid(columns.get(edge.bid, lane));
        if bid >= best {
            (best, winner) = (bid, edge.code);
        }
    }
    winner
}

/// Converts a condition to a mask.
#[inline(always)]
fn all_ones(condition: bool) -> u32 {
    u32::from(condition).wrapping_neg()
}
