//! Plans: a walk to a goal, at once or by way of another pose.

use crate::arm::{JOINTS, Move, Pose};

/// Ticks that a joint moves in one step at most.
pub const STEP: i16 = 3;

/// A way to a goal. Every joint walks its own way at full speed and waits for the others where the leg ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(align(4))] // it is copied word by word
pub struct Plan {
    /// The pose to pass first, with the steps to wait there; `None`: straight to the goal.
    pub via: Option<(Pose, u16)>,
    /// The pose that solves the task.
    pub goal: Pose,
}

impl Plan {
    /// Goes straight to a goal.
    pub const fn straight(goal: Pose) -> Self {
        Self { via: None, goal }
    }

    /// Returns the number of steps from a pose to the goal.
    pub fn arrival(&self, from: Pose) -> u32 {
        self.turn(from) + steps(self.last_corner(from), self.goal)
    }

    /// Returns the number of steps from a pose until the last leg begins.
    #[inline]
    pub(super) fn turn(&self, from: Pose) -> u32 {
        self.via.map_or(0, |(via, wait)| steps(from, via) + u32::from(wait))
    }

    /// Returns the pose at which the last leg begins.
    #[inline]
    pub(super) fn last_corner(&self, from: Pose) -> Pose {
        self.via.map_or(from, |(via, _)| via)
    }

    /// Returns the next step from a pose, and forgets what has been passed.
    pub fn advance(&mut self, from: Pose) -> Move {
        match &mut self.via {
            Some((via, 0)) if *via == from => {
                self.via = None;
                straight(from, self.goal)
            }
            Some((via, wait)) if *via == from => {
                *wait -= 1;
                Move::STOP
            }
            Some((via, _)) => straight(from, *via),
            None => straight(from, self.goal),
        }
    }

    /// Returns the pose that the next steps lead to.
    pub fn next(&self) -> Pose {
        self.via.map_or(self.goal, |(via, _)| via)
    }
}

/// Returns the step of a straight walk: every joint by as much as it can, at most [`STEP`] ticks.
pub fn straight(from: Pose, to: Pose) -> Move {
    let mut ticks = [0; JOINTS];
    for ((ticks, from), to) in ticks.iter_mut().zip(from.0).zip(to.0) {
        *ticks = to.saturating_sub(from).clamp(-STEP, STEP) as i8;
    }
    Move(ticks)
}

/// Returns the number of steps of a straight walk.
#[inline]
pub fn steps(from: Pose, to: Pose) -> u32 {
    let mut most = 0;
    for (from, to) in from.0.into_iter().zip(to.0) {
        most = most.max(from.abs_diff(to));
    }
    u32::from(most.div_ceil(STEP as u16))
}

/// Returns the pose after a number of steps of a straight walk.
#[inline(always)]
pub(super) fn towards(from: Pose, to: Pose, steps: u16) -> Pose {
    let most = i32::from(steps) * i32::from(STEP);
    let mut pose = from;
    for (position, to) in pose.0.iter_mut().zip(to.0) {
        let left = i32::from(to) - i32::from(*position);
        *position = (i32::from(*position) + left.max(-most).min(most)) as i16;
    }
    pose
}
