//! The values of neighbouring lanes in columns.

use std::array::from_fn;
use tpg_arm::{JOINTS, Pose};
use tpg_engine::{BLOCK, Block};

/// The values that regular steps need: of one lane, or of neighbouring ones, then a column for each.
#[derive(Clone, Copy, Debug)]
pub(super) struct Values<Integers, Numbers> {
    pub(super) ticks: [Integers; JOINTS],
    pub(super) target: [Numbers; 3],
    pub(super) hand: [Numbers; 3],
    /// A squared distance above this is not a success, mm²; NaN if no step is regular.
    pub(super) far: Numbers,
    pub(super) roughness: Integers,
    /// Remaining actions, minus the last one allowed; from 0 on, steps are not regular.
    pub(super) left: Integers,
}

/// The values of one lane.
pub(super) type Lane<S> = Values<i32, S>;

/// Neighbouring lanes.
#[derive(Clone, Debug)]
pub(super) struct Group<S> {
    pub(super) now: Values<Block<i32>, Block<S>>,
    /// Ticks before the last action.
    pub(super) before: [Block<i32>; JOINTS],
    /// True if the last action was not a regular step.
    pub(super) other: Block<bool>,
}

impl<Integers, Numbers> Values<Integers, Numbers> {
    fn map<I, N>(&self, integer: impl Fn(&Integers) -> I, number: impl Fn(&Numbers) -> N) -> Values<I, N> {
        Values {
            ticks: self.ticks.each_ref().map(&integer),
            target: self.target.each_ref().map(&number),
            hand: self.hand.each_ref().map(&number),
            far: number(&self.far),
            roughness: integer(&self.roughness),
            left: integer(&self.left),
        }
    }
}

impl<S: Copy> Group<S> {
    /// Creates a group of equal lanes.
    pub(super) fn new(lane: Lane<S>) -> Self {
        let now = lane.map(|&integer| [integer; BLOCK], |&number| [number; BLOCK]);
        Self { now, before: now.ticks, other: [false; BLOCK] }
    }

    /// Returns one lane.
    pub(super) fn lane(&self, lane: usize) -> Lane<S> {
        self.now.map(|integers| integers[lane], |numbers| numbers[lane])
    }

    /// Stores a lane.
    pub(super) fn put(&mut self, lane: usize, new: Lane<S>) {
        let now = &mut self.now;
        (0..JOINTS).for_each(|joint| now.ticks[joint][lane] = new.ticks[joint]);
        (0..3).for_each(|axis| now.target[axis][lane] = new.target[axis]);
        (0..3).for_each(|axis| now.hand[axis][lane] = new.hand[axis]);
        (now.far[lane], now.roughness[lane], now.left[lane]) = (new.far, new.roughness, new.left);
    }

    /// Undoes a lane's last action, which was not a regular step. The hand stays as if it had been done.
    pub(super) fn take_back(&mut self, lane: usize) {
        (0..JOINTS).for_each(|joint| self.now.ticks[joint][lane] = self.before[joint][lane]);
        self.now.left[lane] += 1;
    }

    /// Returns a lane's pose.
    pub(super) fn pose(&self, lane: usize) -> Pose {
        Pose(from_fn(|joint| self.now.ticks[joint][lane] as i16))
    }
}
