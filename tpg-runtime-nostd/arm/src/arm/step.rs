//! The rule of one step: joint limits first, then the collision test.

use super::{Arm, Collision, Joint, Move, Pose};
use crate::kinematics::{Lattice, Plane};
use tpg_runtime::scalar::Scalar;

/// A reason to refuse an action.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Invalid {
    /// The joint would leave its range.
    JointLimit(Joint),
    /// The arm would collide.
    Collision(Collision),
}

/// The result of trying a [`Move`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Step {
    /// The pose afterwards.
    pub pose: Pose,
    /// The reason that the move, or a part of it, was refused.
    pub invalid: Option<Invalid>,
}

impl<S: Lattice> Arm<S> {
    /// Tries a move, by the rules of the paper's artifact (`ArmLearnWrapper.cpp`, `doActions`).
    ///
    /// A joint that would leave its range stays where it is, the others still move. If the arm then collides, the whole
    /// move is taken back. Either makes the step invalid.
    pub fn step(&self, pose: Pose, wanted: Move) -> Step {
        self.step_with(pose, wanted, |moved| Plane::at(self, moved).collision(&self.shapes))
    }
}

impl<S: Scalar> Arm<S> {
    /// The pose behind a move that leaves no joint's range; `None` for another move.
    #[inline(always)]
    pub(crate) fn moved(&self, pose: Pose, wanted: Move) -> Option<Pose> {
        let mut moved = pose;
        let mut joints = moved.0.iter_mut().zip(wanted.0).zip(&self.ranges);
        let within = joints.all(|((ticks, delta), range)| {
            *ticks = ticks.saturating_add(i16::from(delta));
            range.contains(*ticks)
        });
        within.then_some(moved)
    }

    /// [`step`](Self::step) with another evaluation of the collision test.
    ///
    /// The conformance suite uses it: the recorded episodes come from the same rule in another arithmetic.
    #[inline]
    pub fn step_with(&self, pose: Pose, wanted: Move, collision: impl FnOnce(Pose) -> Option<Collision>) -> Step {
        let mut moved = pose;
        let mut invalid = None;
        let joints = moved.0.iter_mut().zip(wanted.0).zip(&self.ranges);
        for (index, ((ticks, delta), range)) in (0u8..).zip(joints) {
            let to = ticks.saturating_add(i16::from(delta));
            if range.contains(to) {
                *ticks = to;
            } else if invalid.is_none() {
                invalid = Some(Invalid::JointLimit(Joint(index)));
            }
        }
        match collision(moved) {
            Some(collision) => Step { pose, invalid: Some(invalid.unwrap_or(Invalid::Collision(collision))) },
            None => Step { pose: moved, invalid },
        }
    }
}
