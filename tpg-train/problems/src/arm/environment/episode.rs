//! An episode of the arm, with the values cached from step to step.

use tpg_arm::frame::Frame;
use tpg_arm::kinematics::{Direction, Lattice, Plane, Vector};
use tpg_arm::observation::{Aim, Reach, ReachTarget, Stance};
use tpg_arm::{Arm, Play, Pose};

/// A running episode with its cached values.
#[derive(Clone, Debug)]
pub struct ArmEpisode<S> {
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
    pub(super) aim: Option<Aim<S>>,
    /// Elevation and reach of the hand; cleared when the plane moves.
    pub(super) hand_polar: Option<[S; 2]>,
    pub(super) reach_target: Option<ReachTarget<S>>,
    pub(super) stance: Option<Stance<S>>,
    /// Reach, with the wrist position that it is valid for.
    pub(super) reach: Option<(i16, Reach<S>)>,
}

impl<S: Lattice> ArmEpisode<S> {
    /// Returns the pose.
    pub fn pose(&self) -> Pose {
        self.pose
    }

    pub(super) fn frame<'a>(&self, arm: &'a Arm<S>) -> Frame<'a, S> {
        Frame::with_directions(arm, self.pose, self.target, self.base, self.plane)
    }

    pub(super) fn aim(&mut self, arm: &Arm<S>) -> Aim<S> {
        *self.aim.get_or_insert_with(|| Aim::at(arm, self.target))
    }

    pub(super) fn hand_polar(&mut self, frame: &Frame<'_, S>) -> [S; 2] {
        *self.hand_polar.get_or_insert_with(|| [frame.hand_elevation(), frame.hand_reach()])
    }

    pub(super) fn stance(&mut self, arm: &Arm<S>) -> &Stance<S> {
        self.stance.get_or_insert_with(|| Stance::at(arm, self.target))
    }

    pub(super) fn reach(&mut self, arm: &Arm<S>) -> &Reach<S> {
        let [.., wrist] = self.pose.0;
        if self.reach.is_none_or(|(at, _)| at != wrist) {
            self.reach = None;
        }
        let target = self.reach_target.get_or_insert_with(|| ReachTarget::at(arm, self.target));
        &self.reach.get_or_insert_with(|| (wrist, target.keeping_wrist(arm, wrist))).1
    }
}
