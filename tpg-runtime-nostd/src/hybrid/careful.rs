//! A policy that does not collide where holding some joints avoids it.

use crate::arm::{Arm, Move};
use crate::kinematics::Lattice;
use crate::observation::Observation;
use crate::policy::Policy;

/// Another policy, with a second look at moves of several joints: a move that would be invalid is tried again with fewer
/// joints, and the first valid one counts; if there is none, the move stays as it was.
///
/// Costs one collision test a decision, and up to 15 where the move would be invalid. Still memoryless.
#[derive(Clone, Copy, Debug)]
pub struct Careful<'a, S, P> {
    /// The arm whose limits and shapes count.
    pub arm: &'a Arm<S>,
    /// Whose moves are looked at.
    pub policy: P,
}

/// Joints that are held, as bits from the base on: fewer first, and of as many those nearer to the hand, which change the
/// arm's pose least.
const HELD: [u8; 14] =
    [0b1000, 0b0100, 0b0010, 0b0001, 0b1100, 0b1010, 0b0110, 0b1001, 0b0101, 0b0011, 0b1110, 0b1101, 0b1011, 0b0111];

impl<S, P> Policy for Careful<'_, S, P>
where
    S: Lattice,
    P: Policy<State = Observation<S>, Action = Move>,
{
    type State = Observation<S>;
    type Action = Move;

    fn decide(&self, seen: &Observation<S>) -> Move {
        let wanted = self.policy.decide(seen);
        let valid = |wanted| self.arm.step(seen.pose, wanted).invalid.is_none();
        if valid(wanted) {
            return wanted;
        }
        let fewer = HELD.into_iter().map(|held| holding(wanted, held));
        // Resting is no way out.
        let mut moving = fewer.filter(|&fewer| fewer != Move::STOP && fewer != wanted);
        moving.find(|&fewer| valid(fewer)).unwrap_or(wanted)
    }
}

fn holding(Move(mut deltas): Move, held: u8) -> Move {
    for (joint, delta) in deltas.iter_mut().enumerate() {
        if held >> joint & 1 == 1 {
            *delta = 0;
        }
    }
    Move(deltas)
}
