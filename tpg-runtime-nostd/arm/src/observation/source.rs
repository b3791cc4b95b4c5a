//! The named parts of an observation that a graph can read.

use crate::named::named;

named! {
    /// A data source of a graph: a named part of the observation.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum Source {
        /// The target: x, y, z in mm.
        Target = "target",
        /// Target − hand: x, y, z in mm.
        Difference = "difference",
        /// The hand's tip: x, y, z in mm.
        Hand = "hand",
        /// The four motor positions, ticks.
        Motors = "motors",
        /// The positions of all six servos, ticks: the four motors, wrist rotation and gripper. The paper's graphs read it.
        Servos = "servos",
        /// The four motor positions less 2048, ticks: 0 is the middle of a joint's travel.
        MotorsCentred = "motors_centred",
        /// Errors in the shoulder's polar frame, mm: lateral, tangential, radial. They suit an arm that stays on its front
        /// side. The frame's origin is the point of the base's axis at the shoulder's height, as of
        /// [`Bearing`](Self::Bearing).
        Polar = "polar",
        /// Errors as seen from the shoulder: azimuth (half ticks, not wrapped), elevation (1/250 rad), radial (mm). They also
        /// suit an arm that reaches over its back.
        Bearing = "bearing",
        /// By how many ticks base, shoulder and elbow are off, if the wrist stays: the closed-form inverse kinematics of
        /// the other three joints.
        Reach = "reach",
        /// Excess of [`Reach`](Self::Reach): ticks by which the shoulder's and the elbow's goal lie outside their
        /// range, and mm by which the target is too far away or too near.
        ReachExcess = "reach_excess",
        /// The hand's pitch at that goal, ticks below the horizontal.
        ReachPitch = "reach_pitch",
        /// The target as seen from the wrist: distance less the hand's length (mm), and by how many ticks the wrist is off
        /// that would point the hand at it.
        Wrist = "wrist",
        /// Height of the lower corner of the hand's tip over the table, mm.
        Floor = "floor",
        /// Ticks by which base, shoulder, elbow and wrist are off from a pose that solves the task: the closed-form inverse
        /// kinematics of the whole arm, for the first of four wrist positions that limits and shapes allow.
        Stance = "stance",
    }
}

impl Source {
    /// Number of its values.
    pub const fn length(self) -> usize {
        match self {
            Self::ReachPitch | Self::Floor => 1,
            Self::Wrist => 2,
            Self::Target | Self::Difference | Self::Hand => 3,
            Self::Polar | Self::Bearing | Self::Reach | Self::ReachExcess => 3,
            Self::Motors | Self::MotorsCentred | Self::Stance => 4,
            Self::Servos => 6,
        }
    }

    /// The unit of its values.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Target | Self::Difference | Self::Hand | Self::Polar | Self::Floor => "mm",
            Self::Motors | Self::Servos | Self::MotorsCentred | Self::Reach | Self::ReachPitch => "ticks",
            Self::Stance => "ticks",
            Self::Bearing => "half ticks, 1/250 rad, mm",
            Self::ReachExcess => "ticks, ticks, mm",
            Self::Wrist => "mm, ticks",
        }
    }
}
