//! Backlash: joints that are some ticks away from their motors.

use super::{JOINTS, Pose};

/// Offset of each joint from its motor, ticks: the weight of a joint rests on one flank of its gears.
///
/// A controller reads the motors, and limits and collisions are told by them; only the hand is where the joints put it.
///
/// ```
/// use tpg_arm::{Play, Pose};
///
/// let play = Play([6, -6, 0, 1]);
/// assert_eq!(play.joints(Pose([2048; 4])), Pose([2054, 2042, 2048, 2049]));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Play(pub [i16; JOINTS]);

impl Play {
    /// No offset.
    pub const NONE: Self = Self([0; JOINTS]);

    /// The joints' positions while the motors are at `motors`.
    pub fn joints(self, Pose(motors): Pose) -> Pose {
        let mut joints = motors;
        for (ticks, beside) in joints.iter_mut().zip(self.0) {
            *ticks = ticks.saturating_add(beside);
        }
        Pose(joints)
    }
}
