//! The values of neighbouring lanes in columns.

use std::array::from_fn;
use tpg_arm::{JOINTS, Pose};
use tpg_engine::{BLOCK, Block};

/// The values of one lane that regular steps need.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lane<S> {
    pub(super) ticks: [i32; JOINTS],
    pub(super) target: [S; 3],
    pub(super) hand: [S; 3],
    /// A squared distance above this is not a success, mm²; NaN if no step is regular.
    pub(super) far: S,
    pub(super) roughness: i32,
    /// Remaining actions, minus the last one allowed; from 0 on, steps are not regular.
    pub(super) left: i32,
}

/// Neighbouring lanes, one column per value.
#[derive(Clone, Debug)]
pub(super) struct Group<S> {
    pub(super) ticks: [Block<i32>; JOINTS],
    pub(super) target: [Block<S>; 3],
    pub(super) hand: [Block<S>; 3],
    pub(super) far: Block<S>,
    pub(super) roughness: Block<i32>,
    pub(super) left: Block<i32>,
    /// Ticks before the last action.
    pub(super) before: [Block<i32>; JOINTS],
    /// True if the last action was not a regular step.
    pub(super) other: Block<bool>,
}

impl<S: Copy> Group<S> {
    /// Creates a group of equal lanes.
    pub(super) fn new(lane: Lane<S>) -> Self {
        let ticks = lane.ticks.map(|ticks| [ticks; BLOCK]);
        Self {
            ticks,
            target: lane.target.map(|target| [target; BLOCK]),
            hand: lane.hand.map(|hand| [hand; BLOCK]),
            far: [lane.far; BLOCK],
            roughness: [lane.roughness; BLOCK],
            left: [lane.left; BLOCK],
            before: ticks,
            other: [false; BLOCK],
        }
    }

    /// Returns one lane.
    pub(super) fn lane(&self, lane: usize) -> Lane<S> {
        Lane {
            ticks: self.ticks.map(|ticks| ticks[lane]),
            target: from_fn(|axis| self.target[axis][lane]),
            hand: from_fn(|axis| self.hand[axis][lane]),
            far: self.far[lane],
            roughness: self.roughness[lane],
            left: self.left[lane],
        }
    }

    /// Stores a lane.
    pub(super) fn put(&mut self, lane: usize, new: Lane<S>) {
        (0..JOINTS).for_each(|joint| self.ticks[joint][lane] = new.ticks[joint]);
        (0..3).for_each(|axis| self.target[axis][lane] = new.target[axis]);
        (0..3).for_each(|axis| self.hand[axis][lane] = new.hand[axis]);
        self.far[lane] = new.far;
        self.roughness[lane] = new.roughness;
        self.left[lane] = new.left;
    }

    /// Undoes a lane's last action, which was not a regular step. The hand stays as if it had been done.
    pub(super) fn take_back(&mut self, lane: usize) {
        (0..JOINTS).for_each(|joint| self.ticks[joint][lane] = self.before[joint][lane]);
        self.left[lane] += 1;
    }

    /// Returns a lane's pose.
    pub(super) fn pose(&self, lane: usize) -> Pose {
        Pose(from_fn(|joint| self.ticks[joint][lane] as i16))
    }
}
