//! The classical yardstick that fits a microcontroller: straight to the stance.
//!
//! It learns nothing and looks at nothing on the way. Beside it one sees what a learned policy is worth: it costs one
//! inverse kinematics for each target, and then hardly anything.

use super::memo::TargetMemo;
use super::{Observation, Source};
use crate::arm::{Arm, JOINTS, Move};
use crate::kinematics::Lattice;
use tpg_runtime::policy::Policy;

/// Ticks by which an action moves a joint (the paper, section 4.2).
pub const STEP: i8 = 3;

/// Moves all joints at once towards the target's stance, up to three ticks a step, and stops there.
///
/// It keeps the stance of its target, so it is for one thread.
#[derive(Clone, Debug)]
pub struct Straight<'a, S: Copy> {
    arm: &'a Arm<S>,
    memo: TargetMemo<S>,
}

impl<'a, S: Lattice> Straight<'a, S> {
    /// For an arm.
    pub const fn new(arm: &'a Arm<S>) -> Self {
        Self { arm, memo: TargetMemo::new() }
    }
}

impl<S: Lattice> Policy for Straight<'_, S> {
    type State = Observation<S>;
    type Action = Move;

    fn decide(&self, seen: &Observation<S>) -> Move {
        let mut errors = [S::ZERO; JOINTS];
        Source::fill(&[Source::Stance], self.arm, seen, &self.memo, &mut errors);
        Move(errors.map(|error| {
            let half = S::from_f64(if error < S::ZERO { -0.5 } else { 0.5 });
            (error + half).to_i32().clamp(-i32::from(STEP), i32::from(STEP)) as i8
        }))
    }
}
