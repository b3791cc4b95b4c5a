//! An episode of the arm, with the values cached from step to step.

use tpg_arm::frame::Frame;
use tpg_arm::kinematics::{Direction, Lattice, Plane, Vector};
use tpg_arm::observation::TargetMemo;
use tpg_arm::{Arm, Play, Pose};

/// A running episode with its cached values.
#[derive(Clone, Debug)]
pub struct ArmEpisode<S: Copy> {
    pub(super) pose: Pose,
    pub(super) target: Vector<S>,
    pub(super) roughness: u8,
    /// The joints' play.
    pub(super) play: Play,
    pub(super) plane: Plane<S>,
    pub(super) base: Direction<S>,
    pub(super) hand: Vector<S>,
    pub(super) collides: bool,
    pub(super) actions: u32,
    pub(super) memo: TargetMemo<S>,
}

impl<S: Lattice> ArmEpisode<S> {
    /// Returns the pose.
    pub fn pose(&self) -> Pose {
        self.pose
    }

    pub(super) fn frame<'a>(&self, arm: &'a Arm<S>) -> Frame<'a, S> {
        Frame::with_directions(arm, self.pose, self.target, self.base, self.plane)
    }
}
