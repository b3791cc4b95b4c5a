//! The part of the network's move that can be done.

use crate::arm::{Arm, Leeway, Move, Pose};
use crate::kinematics::Lattice;

/// Joints that are held, as bits from the base on: fewer first, and of as many those nearer to the hand.
const HELD: [u8; 14] =
    [0b1000, 0b0100, 0b0010, 0b0001, 0b1100, 0b1010, 0b0110, 0b1001, 0b0101, 0b0011, 0b1110, 0b1101, 0b1011, 0b0111];

/// The move, or where it is invalid the first valid one with fewer joints that moves at all.
///
/// As [`Arm::step`] judges them. It judges the joints' limits one by one, and collisions in the arm's plane, which the base
/// does not change: no more than 8 of these 15 moves differ there, and none is tested twice.
pub(super) fn valid_part<S: Lattice>(arm: &Arm<S>, leeway: &Leeway, pose: Pose, wanted: Move) -> Option<Move> {
    // As bits, like `HELD`: joints that move; that would be out of range if they did; that are if they do not.
    let [mut moving, mut out_there, mut out_here] = [0u8; 3];
    let Move(deltas) = wanted;
    for (joint, ((ticks, delta), range)) in pose.0.into_iter().zip(deltas).zip(arm.ranges).enumerate() {
        let bit = |is: bool| u8::from(is) << joint;
        moving |= bit(delta != 0);
        out_there |= bit(!range.contains(ticks.saturating_add(i16::from(delta))));
        out_here |= bit(!range.contains(ticks));
    }
    let part = |moves: u8| {
        let mut joint = 0u8;
        Move(deltas.map(|delta| {
            joint += 1;
            if moves >> (joint - 1) & 1 == 1 { delta } else { 0 }
        }))
    };
    // By what moves in the plane: whether that was tested, and was free.
    let [mut tested, mut free] = [0u8; 2];
    let mut valid = |moves: u8| {
        if (moves & out_there) | (!moves & out_here) != 0 {
            return false;
        }
        let plane = 1u8 << (moves >> 1);
        if tested & plane == 0 {
            tested |= plane;
            let is_free = |moved| leeway.collision(arm, moved).is_none();
            free |= if arm.moved(pose, part(moves)).is_some_and(is_free) { plane } else { 0 };
        }
        free & plane != 0
    };
    if valid(moving) {
        return Some(wanted);
    }
    let mut fewer = HELD.into_iter().map(|held| moving & !held).filter(|&moves| moves != 0 && moves != moving);
    fewer.find(|&moves| valid(moves)).map(part)
}

#[cfg(test)]
mod tests {
    use super::{HELD, valid_part};
    use crate::arm::{Arm, Leeway, Move, Pose, WIDOWX};
    use proptest::prelude::*;

    const ARM: Arm<f32> = WIDOWX.to_f32();

    /// As it is said: one step after another, in order.
    fn plainly(pose: Pose, wanted: Move) -> Option<Move> {
        let valid = |wanted| ARM.step(pose, wanted).invalid.is_none();
        let fewer = HELD.into_iter().map(|held| {
            let Move(mut deltas) = wanted;
            for (joint, delta) in deltas.iter_mut().enumerate() {
                *delta = if held >> joint & 1 == 1 { 0 } else { *delta };
            }
            Move(deltas)
        });
        let moving = fewer.filter(|&fewer| fewer != Move::STOP && fewer != wanted);
        core::iter::once(wanted).chain(moving).find(|&part| valid(part))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

        /// Near limits, table and base, from valid poses and others.
        #[test]
        fn it_is_the_first_valid_part(
            base in prop_oneof![0i16..8, 4088i16..4096],
            plane in prop_oneof![
                prop::array::uniform3(1020i16..3076),
                prop::array::uniform3(prop_oneof![1020i16..1032, 3064i16..3076, 1020i16..3076]),
            ],
            deltas in prop::array::uniform4(-4i8..=4),
        ) {
            let [shoulder, elbow, wrist] = plane;
            let (pose, wanted) = (Pose([base, shoulder, elbow, wrist]), Move(deltas));
            prop_assert_eq!(valid_part(&ARM, &Leeway::new(), pose, wanted), plainly(pose, wanted));
        }
    }
}
