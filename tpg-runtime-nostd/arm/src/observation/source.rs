//! The named parts of an observation that a graph can read.

use tpg_runtime::named;

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
        /// Errors in the shoulder's polar frame, mm: lateral, tangential, radial. They suit an arm that stays on its front
        /// side. The frame's origin is the point of the base's axis at the shoulder's height.
        Polar = "polar",
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
            Self::Floor => 1,
            Self::Target | Self::Difference | Self::Hand | Self::Polar => 3,
            Self::Motors | Self::Stance => 4,
            Self::Servos => 6,
        }
    }

    /// The unit of its values.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Target | Self::Difference | Self::Hand | Self::Polar | Self::Floor => "mm",
            Self::Motors | Self::Servos | Self::Stance => "ticks",
        }
    }
}
