//! Robot arms for learned policies.

#![no_std]

pub use tpg_runtime::arm::{
    Arm, BaseEdge, Collision, Invalid, JOINTS, Joint, JointRange, Links, Move, Pose, Shapes, Step, TICKS_PER_TURN,
    WIDOWX,
};
pub use tpg_runtime::{binding, cycle, episode, frame, hybrid, kinematics, observation, sac};
