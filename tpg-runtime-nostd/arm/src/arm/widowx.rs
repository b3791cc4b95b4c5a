//! The paper's arm: a Trossen WidowX with its wrist rotation and gripper held still.

use super::{Arm, BaseEdge, JointRange, Links, Pose, Shapes};

/// The four-joint WidowX of the paper (section 4.1; `armlearn`, `widowxbuilder.cpp`; limits and shapes of
/// `armlearn-wrapper`, `ArmLearnWrapper.cpp`).
pub const WIDOWX: Arm<f64> = Arm {
    home: Pose([2048; 4]),
    fixed_servos: [512, 256],
    ranges: [
        JointRange { min: 2, max: 4094 },
        JointRange { min: 1025, max: 3071 },
        JointRange { min: 1025, max: 3071 },
        JointRange { min: 1025, max: 3071 },
    ],
    links: Links {
        base: 125.0,
        upper_arm: 142.0,
        elbow_offset: 49.0,
        forearm: 142.0,
        hand: 155.0,
        shoulder_radial: 0.0,
    },
    shapes: Shapes {
        hand_length: 160.0,
        hand_edges: [24.0, -32.0],
        forearm_overhang: 10.0,
        forearm_edges: [18.0, -18.0],
        base: [
            BaseEdge { x: [68.0, 90.0], z: [9.0, 9.0] },
            BaseEdge { x: [68.0, 68.0], z: [9.0, 95.0] },
            BaseEdge { x: [15.0, 68.0], z: [95.0, 95.0] },
            BaseEdge { x: [15.0, 15.0], z: [95.0, 151.0] },
        ],
    },
};
