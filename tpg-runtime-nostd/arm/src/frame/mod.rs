//! The geometry of arm and target in an observation: the derived quantities that the SAC's features and a graph's derived
//! sources share.
//!
//! Everything here follows from the 13 values of an [`Observation`] and the arm's own description, without memory and
//! without search. It is knowledge about the arm that the paper's policies did not have, and is named as such wherever
//! results are shown.
//!
//! # Frame
//!
//! The base's axis and the arm plane span a cylinder frame that turns with the base. Its first coordinate is the
//! *signed* radius: positive where the stretched arm points at home, negative when the hand reaches over its back.
//! It is −x of the [`Plane`]. With q0 the base's angle (0 at motor position 2048, rad), h the hand and t the target:
//!
//! | symbol | method | formula | unit |
//! | --- | --- | --- | --- |
//! | ρ | [`radius`](Frame::radius) | −plane x of the tip: h = (−ρ sin q0, ρ cos q0, z) | mm |
//! | z | [`height`](Frame::height) | height of the tip over the table | mm |
//! | t_r | [`target_radius`](Frame::target_radius) | −t_x sin q0 + t_y cos q0 | mm |
//! | t_l | [`target_lateral`](Frame::target_lateral) | t_x cos q0 + t_y sin q0 | mm |
//! | e_r | [`radial_error`](Frame::radial_error) | t_r − ρ | mm |
//! | e_z | [`height_error`](Frame::height_error) | t_z − z | mm |
//! | d | | √(e_r² + t_l² + e_z²) | mm |
//!
//! A [`Frame`] holds no more than pose, target and plane. Each quantity is a method, computed when it is asked for, so
//! that a policy pays for what it reads.

mod clearance;

pub use clearance::Clearance;

use crate::arm::{Arm, Joint, Pose};
use crate::kinematics::{self, Direction, Lattice, Plane, Point, Vector};
use crate::observation::seen::Observation;

/// The arm and its target, seen in the frame that turns with the base.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame<'a, S> {
    arm: &'a Arm<S>,
    pose: Pose,
    target: Vector<S>,
    base: Direction<S>,
    plane: Plane<S>,
}

impl<'a, S: Lattice> Frame<'a, S> {
    /// The frame of what a policy sees.
    pub fn new(arm: &'a Arm<S>, observation: &Observation<S>) -> Self {
        Self::at(arm, observation.pose, observation.target)
    }

    /// The frame at a pose, with the target in mm.
    pub fn at(arm: &'a Arm<S>, pose: Pose, target: Vector<S>) -> Self {
        // A call, which keeps no register: first.
        let plane = Plane::at(arm, pose);
        Self::with_directions(arm, pose, target, kinematics::base_direction(pose), plane)
    }

    /// The frame at a pose whose plane and base direction are known already.
    pub fn with_directions(
        arm: &'a Arm<S>,
        pose: Pose,
        target: Vector<S>,
        base: Direction<S>,
        plane: Plane<S>,
    ) -> Self {
        Self { arm, pose, target, base, plane }
    }

    /// The motor positions.
    pub fn pose(&self) -> Pose {
        self.pose
    }

    /// The target, mm.
    pub fn target(&self) -> Vector<S> {
        self.target
    }

    /// ρ, mm: the hand's signed distance from the base's axis.
    pub fn radius(&self) -> S {
        -self.plane.tip.x
    }

    /// z, mm: the hand's height over the table.
    pub fn height(&self) -> S {
        self.plane.tip.z
    }

    /// t_r, mm: the target's coordinate along the arm plane.
    pub fn target_radius(&self) -> S {
        let [x, y, _] = self.target;
        y * self.base.cos - x * self.base.sin
    }

    /// t_l, mm: the target's coordinate across the arm plane. 0 when the base points at the target or away from it.
    pub fn target_lateral(&self) -> S {
        let [x, y, _] = self.target;
        x * self.base.cos + y * self.base.sin
    }

    /// e_r = t_r − ρ, mm.
    pub fn radial_error(&self) -> S {
        self.target_radius() - self.radius()
    }

    /// e_z = t_z − z, mm.
    pub fn height_error(&self) -> S {
        self.target[2] - self.plane.tip.z
    }

    /// Directions of upper arm, forearm and hand over the table, in the plane whose first axis is −ρ: the angles
    /// s, s + e and s + e + w of the paper's artifact.
    pub fn links(&self) -> [Direction<S>; 3] {
        [kinematics::link_angles(self.pose)[0].direction(), self.plane.forearm, self.plane.hand]
    }

    /// −½ ∂d²/∂q of a joint, mm² per rad: the Jacobian's transpose times the error. Positive where raising the joint's
    /// motor position brings the hand nearer to the target. 0 for a joint that does not exist.
    pub fn pull(&self, joint: Joint) -> S {
        match joint.0 {
            0 => -(self.target_lateral() * self.radius()),
            1 => self.moment(self.arm.shoulder()),
            2 => -self.moment(self.plane.elbow),
            3 => -self.moment(self.plane.wrist),
            _ => S::ZERO,
        }
    }

    /// The moment of the error vector about an axis of the arm plane: e_r (z − p_z) − e_z (ρ − p_ρ), mm².
    fn moment(&self, axis: Point<S>) -> S {
        let Point { x, z } = self.plane.tip;
        // ρ − p_ρ is p_x − x: the radius runs against the plane's x.
        self.radial_error() * (z - axis.z) - self.height_error() * (axis.x - x)
    }

    /// By how much the base's angle is off when the arm reaches forwards and when it reaches over its back, rad:
    /// atan2(−t_x, t_y) − q0 and atan2(t_x, −t_y) − q0.
    ///
    /// Not wrapped: the base does not turn through its limits, so the way to the target is the difference as it is.
    /// In −2π..2π; the two differ by π.
    pub fn azimuth_errors(&self) -> [S; 2] {
        let [x, y, _] = self.target;
        let pi = S::from_f64(core::f64::consts::PI);
        let front = (-x).atan2(y);
        let back = if front > S::ZERO { front - pi } else { front + pi };
        let at = kinematics::radians(self.pose, Joint(0));
        [front - at, back - at]
    }

    /// Errors in the polar frame of the point on the base's axis at the shoulder's height, mm: lateral, tangential, radial. The radial
    /// one is the difference of the distances from there to target and hand.
    pub(crate) fn polar_errors(&self) -> [S; 3] {
        let base = self.arm.links.base;
        let ([x, y, z], radius) = (self.target, self.radius());
        let (hand, target) = (self.height() - base, z - base);
        let target_reach = (x * x + y * y + target * target).sqrt();
        let hand_reach = (radius * radius + hand * hand).sqrt();
        let tangential = (radius * target - hand * self.target_radius()) / hand_reach;
        [-self.target_lateral(), tangential, target_reach - hand_reach]
    }

    /// Ticks that a joint can still rise before its upper limit, and fall before its lower one; 0 for a joint that does not exist.
    pub fn room(&self, joint: Joint) -> [S; 2] {
        let index = usize::from(joint.0);
        let room = self.pose.0.get(index).zip(self.arm.ranges.get(index)).map_or([0; 2], |(&ticks, range)| {
            [i32::from(range.max) - i32::from(ticks), i32::from(ticks) - i32::from(range.min)]
        });
        room.map(S::from_i32)
    }

    /// Height of the lower of the hand's two tip corners over the table, mm. Below 0 the hand collides.
    pub fn lowest_corner(&self) -> S {
        let [upper, lower] = self.plane.tip_corners(&self.arm.shapes);
        if lower.z < upper.z { lower.z } else { upper.z }
    }

    /// Clearance of hand and forearm from the arm's own base where it is less than `horizon`, mm; any number from there on where it is not.
    pub fn clearance_up_to(&self, horizon: S) -> Clearance<S> {
        Clearance::up_to(&self.plane, &self.arm.shapes, horizon)
    }
}
