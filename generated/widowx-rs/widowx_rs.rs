//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix widowx_rs --profile constant-time
//! Graph SHA-256: e03ca780ae182528e6a99c13b83e6fc72c791b0b352167b3af393d1d05d741ce
//! 28 teams (15 on the longest walk), 214 edges, 163 programs, 55 distinct operations.
//! Computes in f32 with own maths.
#![forbid(unsafe_code)]
#![allow(
    clippy::all,
    unused_variables,
    unused_assignments,
    reason = "evolved expressions need not make sense"
)]

use tpg_runtime::arm::Move;
use tpg_runtime::observation::Source;
use tpg_runtime::ops;
use tpg_runtime::policy::{ActionId, Policy};

/// A tangled program graph: branch-free, the same time for every state.
///
/// It sees, one after another:
/// - `s[0..3]`: reach, ticks, -4095 to 4095
/// - `s[3..6]`: reach_excess, ticks, ticks, mm, -1026 to 1026
/// - `s[6..7]`: reach_pitch, ticks, -2049 to 2049
/// - `s[7..11]`: motors_centred, ticks, -2046 to 2046
///
/// Values outside the ranges are legal, NaN and infinities too. It answers:
/// - 0: base_up
/// - 1: base_down
/// - 2: shoulder_up
/// - 3: shoulder_down
/// - 4: elbow_up
/// - 5: elbow_down
/// - 6: wrist_up
/// - 7: wrist_down
#[derive(Clone, Copy, Debug, Default)]
pub struct WidowxRs;

impl WidowxRs {
    /// Values of a state.
    pub const STATE: usize = 11;
    /// Actions.
    pub const ACTIONS: usize = 8;
    /// Teams on the longest walk.
    pub const DEPTH: usize = 15;
    /// Bids that one decision looks at, at most.
    pub const WORST_BIDS: usize = 214;
    /// Operations of one decision, at most.
    pub const WORST_OPERATIONS: usize = 55;
    /// Sines, cosines, logarithms and exponentials among them, at most.
    pub const WORST_MATHS_CALLS: usize = 0;
    /// The arm's sources that make up a state, in order.
    pub const SOURCES: [Source; 4] = [
        Source::Reach,
        Source::ReachExcess,
        Source::ReachPitch,
        Source::MotorsCentred,
    ];
    /// What each action moves, in motor ticks.
    pub const MOVES: [Move; 8] = [
        Move([3, 0, 0, 0]),
        Move([-3, 0, 0, 0]),
        Move([0, 3, 0, 0]),
        Move([0, -3, 0, 0]),
        Move([0, 0, 3, 0]),
        Move([0, 0, -3, 0]),
        Move([0, 0, 0, 3]),
        Move([0, 0, 0, -3]),
    ];
}

impl Policy for WidowxRs {
    type State = [f32; 11];
    type Action = ActionId;

    fn decide(&self, s: &[f32; 11]) -> ActionId {
        let v2 = s[0] * 0.0_f32;
        let v5 = s[2] * s[3];
        let v7 = f32::abs(s[6]);
        let v10 = 104.24504_f32 * s[4];
        let v11 = s[3] - s[6];
        let v12 = s[2] - s[6];
        let v13 = f32::abs(s[0]);
        let v15 = ops::max(s[6], 82.87463_f32);
        let v16 = s[0] * v15;
        let v17 = s[0] - s[6];
        let v18 = 0.0_f32 - s[0];
        let v20 = ops::max(s[0], s[6]);
        let v21 = ops::min(v20, s[1]);
        let v22 = ops::max(s[0], s[2]);
        let v25 = s[9] / 99.55378_f32;
        let v26 = f32::abs(s[9]);
        let v27 = ops::min(v26, s[1]);
        let v29 = ops::min(s[2], -12.947205_f32);
        let v30 = ops::negate_if_less(s[2], s[3]);
        let v31 = v30 - s[1];
        let v33 = ops::min(81.83404_f32, s[0]);
        let v36 = ops::min(s[5], 17.596085_f32);
        let v37 = ops::min(s[6], 17.596085_f32);
        let v39 = ops::min(71.53701_f32, s[1]);
        let v41 = s[0] - 9.366141_f32;
        let v42 = ops::min(0.0_f32, s[4]);
        let v44 = ops::negate_if_less(2.633784_f32, s[0]);
        let v45 = ops::negate_if_less(s[6], v44);
        let v46 = s[2] * s[4];
        let v48 = ops::max(s[6], 59.26271_f32);
        let v50 = s[6] - 5.2186666_f32;
        let v51 = s[5] / 17.596085_f32;
        let v52 = s[0] / s[5];
        let v54 = s[0] - 7.9593115_f32;
        let v55 = s[0] - v48;
        let v56 = ops::negate_if_less(s[0], 0.0_f32);
        let v58 = ops::min(77.8404_f32, s[0]);
        let v59 = s[2] + s[6];
        let v60 = s[0] * v48;
        let v61 = s[3] - s[0];
        let v63 = s[4] / s[10];
        let v64 = v48 - v63;
        let v65 = s[0] * v64;
        let v67 = s[0] + s[8];
        let v68 = s[1] + s[1];
        let v70 = ops::max(s[10], -52.018345_f32);
        let v71 = s[2] - s[3];
        let v73 = ops::min(36.712555_f32, s[1]);
        let v75 = ops::min(v20, 5.95553_f32);
        let v77 = -190.21367_f32 - s[6];
        let v78 = ops::min(s[0], s[8]);
        let v79 = s[6] - s[9];
        let v81 = ops::min(s[3], s[8]);
        let v82 = v81 - s[0];
        let v83 = s[0] * s[6];

        // Where each team leads: teams are numbered from 0, the root, and the actions follow them.
        // Team 0
        let best = (ops::bid(v2), 28_u8);
        let best = ops::challenge(best, (ops::bid(v7), 1));
        let best = ops::challenge(best, (ops::bid(v10), 2));
        let best = ops::challenge(best, (ops::bid(v11), 3));
        let best = ops::challenge(best, (ops::bid(v12), 4));
        let best = ops::challenge(best, (ops::bid(0.0_f32), 28));
        let best = ops::challenge(best, (ops::bid(v5), 35));
        let best = ops::challenge(best, (ops::bid(v13), 29));
        let best = ops::challenge(best, (ops::bid(v16), 5));
        let t0 = best.1;
        // Team 11
        let best = (ops::bid(v17), 3_u8);
        let best = ops::challenge(best, (ops::bid(v12), 6));
        let best = ops::challenge(best, (ops::bid(v18), 7));
        let best = ops::challenge(best, (ops::bid(v21), 30));
        let best = ops::challenge(best, (ops::bid(v22), 8));
        let best = ops::challenge(best, (ops::bid(v25), 35));
        let best = ops::challenge(best, (ops::bid(v27), 30));
        let best = ops::challenge(best, (ops::bid(v31), 3));
        let best = ops::challenge(best, (ops::bid(v33), 28));
        let best = ops::challenge(best, (ops::bid(v36), 9));
        let best = ops::challenge(best, (ops::bid(0.0_f32), 28));
        let t1 = best.1;
        // Team 15
        let best = (ops::bid(v12), 8_u8);
        let best = ops::challenge(best, (ops::bid(v18), 10));
        let best = ops::challenge(best, (ops::bid(v37), 9));
        let best = ops::challenge(best, (ops::bid(v17), 3));
        let best = ops::challenge(best, (ops::bid(v39), 30));
        let best = ops::challenge(best, (ops::bid(v36), 9));
        let best = ops::challenge(best, (ops::bid(v41), 11));
        let best = ops::challenge(best, (ops::bid(s[0]), 28));
        let best = ops::challenge(best, (ops::bid(v25), 12));
        let best = ops::challenge(best, (ops::bid(v22), 8));
        let t2 = best.1;
        // Team 23
        let best = (ops::bid(v12), 12_u8);
        let best = ops::challenge(best, (ops::bid(s[0]), 13));
        let best = ops::challenge(best, (ops::bid(0.0_f32), 28));
        let best = ops::challenge(best, (ops::bid(v25), 35));
        let best = ops::challenge(best, (ops::bid(v42), 14));
        let best = ops::challenge(best, (ops::bid(v39), 30));
        let best = ops::challenge(best, (ops::bid(v45), 15));
        let t3 = best.1;
        // Team 5
        let best = (ops::bid(v16), 28_u8);
        let best = ops::challenge(best, (ops::bid(v39), 30));
        let best = ops::challenge(best, (ops::bid(v27), 30));
        let best = ops::challenge(best, (ops::bid(v25), 16));
        let best = ops::challenge(best, (ops::bid(v13), 29));
        let best = ops::challenge(best, (ops::bid(v18), 7));
        let best = ops::challenge(best, (ops::bid(v31), 17));
        let best = ops::challenge(best, (ops::bid(v22), 18));
        let best = ops::challenge(best, (ops::bid(0.0_f32), 33));
        let t4 = best.1;
        // Team 1
        let best = (ops::bid(v5), 35_u8);
        let best = ops::challenge(best, (ops::bid(v46), 8));
        let best = ops::challenge(best, (ops::bid(v18), 7));
        let best = ops::challenge(best, (ops::bid(v16), 19));
        let best = ops::challenge(best, (ops::bid(v48), 1));
        let best = ops::challenge(best, (ops::bid(v25), 20));
        let best = ops::challenge(best, (ops::bid(v12), 4));
        let t5 = best.1;
        // Team 12
        let best = (ops::bid(v20), 21_u8);
        let best = ops::challenge(best, (ops::bid(v50), 28));
        let best = ops::challenge(best, (ops::bid(v18), 7));
        let best = ops::challenge(best, (ops::bid(v16), 28));
        let best = ops::challenge(best, (ops::bid(v25), 8));
        let best = ops::challenge(best, (ops::bid(v33), 28));
        let best = ops::challenge(best, (ops::bid(0.0_f32), 14));
        let best = ops::challenge(best, (ops::bid(v39), 30));
        let best = ops::challenge(best, (ops::bid(v22), 32));
        let best = ops::challenge(best, (ops::bid(v51), 9));
        let best = ops::challenge(best, (ops::bid(s[0]), 13));
        let t6 = best.1;
        // Team 29
        let best = (ops::bid(v52), 35_u8);
        let best = ops::challenge(best, (ops::bid(0.0_f32), 29));
        let t7 = best.1;
        // Team 21
        let best = (ops::bid(v54), 28_u8);
        let best = ops::challenge(best, (ops::bid(0.0_f32), 33));
        let best = ops::challenge(best, (ops::bid(v39), 30));
        let best = ops::challenge(best, (ops::bid(v55), 28));
        let best = ops::challenge(best, (ops::bid(v56), 22));
        let best = ops::challenge(best, (ops::bid(v25), 12));
        let best = ops::challenge(best, (ops::bid(v58), 28));
        let best = ops::challenge(best, (ops::bid(v18), 7));
        let best = ops::challenge(best, (ops::bid(v59), 34));
        let t8 = best.1;
        // Team 17
        let best = (ops::bid(v45), 15_u8);
        let best = ops::challenge(best, (ops::bid(v25), 35));
        let best = ops::challenge(best, (ops::bid(0.0_f32), 28));
        let best = ops::challenge(best, (ops::bid(s[0]), 23));
        let best = ops::challenge(best, (ops::bid(v60), 28));
        let best = ops::challenge(best, (ops::bid(v13), 29));
        let t9 = best.1;
        // Team 20
        let best = (ops::bid(v55), 28_u8);
        let best = ops::challenge(best, (ops::bid(v18), 7));
        let best = ops::challenge(best, (ops::bid(v60), 28));
        let best = ops::challenge(best, (ops::bid(v25), 12));
        let best = ops::challenge(best, (ops::bid(v58), 28));
        let best = ops::challenge(best, (ops::bid(0.0_f32), 28));
        let t10 = best.1;
        // Team 16
        let best = (ops::bid(v25), 12_u8);
        let best = ops::challenge(best, (ops::bid(v12), 8));
        let best = ops::challenge(best, (ops::bid(v37), 9));
        let best = ops::challenge(best, (ops::bid(v61), 7));
        let best = ops::challenge(best, (ops::bid(v65), 8));
        let best = ops::challenge(best, (ops::bid(0.0_f32), 29));
        let best = ops::challenge(best, (ops::bid(v22), 8));
        let best = ops::challenge(best, (ops::bid(v39), 30));
        let t11 = best.1;
        // Team 27
        let best = (ops::bid(s[0]), 28_u8);
        let best = ops::challenge(best, (ops::bid(v18), 7));
        let best = ops::challenge(best, (ops::bid(0.0_f32), 29));
        let best = ops::challenge(best, (ops::bid(v25), 35));
        let best = ops::challenge(best, (ops::bid(v67), 24));
        let t12 = best.1;
        // Team 26
        let best = (ops::bid(v54), 28_u8);
        let best = ops::challenge(best, (ops::bid(0.0_f32), 33));
        let best = ops::challenge(best, (ops::bid(v39), 30));
        let best = ops::challenge(best, (ops::bid(s[0]), 28));
        let best = ops::challenge(best, (ops::bid(v33), 28));
        let best = ops::challenge(best, (ops::bid(v60), 28));
        let best = ops::challenge(best, (ops::bid(v30), 12));
        let best = ops::challenge(best, (ops::bid(v25), 12));
        let t13 = best.1;
        // Team 25
        let best = (ops::bid(v13), 29_u8);
        let best = ops::challenge(best, (ops::bid(s[0]), 28));
        let best = ops::challenge(best, (ops::bid(v68), 33));
        let best = ops::challenge(best, (ops::bid(0.0_f32), 35));
        let best = ops::challenge(best, (ops::bid(v59), 34));
        let t14 = best.1;
        // Team 24
        let best = (ops::bid(v68), 33_u8);
        let best = ops::challenge(best, (ops::bid(0.0_f32), 31));
        let t15 = best.1;
        // Team 7
        let best = (ops::bid(v39), 30_u8);
        let best = ops::challenge(best, (ops::bid(v25), 20));
        let best = ops::challenge(best, (ops::bid(v20), 21));
        let best = ops::challenge(best, (ops::bid(v70), 25));
        let best = ops::challenge(best, (ops::bid(v16), 28));
        let best = ops::challenge(best, (ops::bid(v58), 28));
        let best = ops::challenge(best, (ops::bid(0.0_f32), 33));
        let best = ops::challenge(best, (ops::bid(v18), 7));
        let best = ops::challenge(best, (ops::bid(v59), 34));
        let best = ops::challenge(best, (ops::bid(v13), 29));
        let t16 = best.1;
        // Team 9
        let best = (ops::bid(v17), 3_u8);
        let best = ops::challenge(best, (ops::bid(v71), 8));
        let best = ops::challenge(best, (ops::bid(v12), 6));
        let best = ops::challenge(best, (ops::bid(v18), 7));
        let best = ops::challenge(best, (ops::bid(v27), 30));
        let best = ops::challenge(best, (ops::bid(v22), 8));
        let best = ops::challenge(best, (ops::bid(0.0_f32), 28));
        let best = ops::challenge(best, (ops::bid(v25), 35));
        let best = ops::challenge(best, (ops::bid(v39), 30));
        let best = ops::challenge(best, (ops::bid(v37), 9));
        let best = ops::challenge(best, (ops::bid(v73), 30));
        let t17 = best.1;
        // Team 6
        let best = (ops::bid(v25), 30_u8);
        let best = ops::challenge(best, (ops::bid(v71), 8));
        let best = ops::challenge(best, (ops::bid(v12), 32));
        let best = ops::challenge(best, (ops::bid(v18), 7));
        let best = ops::challenge(best, (ops::bid(v73), 30));
        let best = ops::challenge(best, (ops::bid(v27), 30));
        let best = ops::challenge(best, (ops::bid(v22), 8));
        let best = ops::challenge(best, (ops::bid(v29), 9));
        let best = ops::challenge(best, (ops::bid(v36), 9));
        let best = ops::challenge(best, (ops::bid(v37), 9));
        let best = ops::challenge(best, (ops::bid(v17), 3));
        let t18 = best.1;
        // Team 4
        let best = (ops::bid(v12), 4_u8);
        let best = ops::challenge(best, (ops::bid(v16), 28));
        let best = ops::challenge(best, (ops::bid(v5), 35));
        let best = ops::challenge(best, (ops::bid(0.0_f32), 1));
        let best = ops::challenge(best, (ops::bid(v75), 30));
        let best = ops::challenge(best, (ops::bid(v60), 28));
        let best = ops::challenge(best, (ops::bid(v50), 28));
        let best = ops::challenge(best, (ops::bid(s[0]), 28));
        let best = ops::challenge(best, (ops::bid(v7), 1));
        let best = ops::challenge(best, (ops::bid(v18), 7));
        let best = ops::challenge(best, (ops::bid(v2), 28));
        let t19 = best.1;
        // Team 10
        let best = (ops::bid(v54), 28_u8);
        let best = ops::challenge(best, (ops::bid(s[0]), 28));
        let best = ops::challenge(best, (ops::bid(v60), 28));
        let best = ops::challenge(best, (ops::bid(v25), 12));
        let best = ops::challenge(best, (ops::bid(v18), 7));
        let best = ops::challenge(best, (ops::bid(v39), 30));
        let best = ops::challenge(best, (ops::bid(0.0_f32), 24));
        let t20 = best.1;
        // Team 13
        let best = (ops::bid(v41), 2_u8);
        let best = ops::challenge(best, (ops::bid(v37), 9));
        let best = ops::challenge(best, (ops::bid(v18), 7));
        let best = ops::challenge(best, (ops::bid(v22), 8));
        let best = ops::challenge(best, (ops::bid(v39), 30));
        let best = ops::challenge(best, (ops::bid(v17), 3));
        let best = ops::challenge(best, (ops::bid(s[0]), 13));
        let best = ops::challenge(best, (ops::bid(v25), 26));
        let best = ops::challenge(best, (ops::bid(0.0_f32), 29));
        let best = ops::challenge(best, (ops::bid(v12), 8));
        let best = ops::challenge(best, (ops::bid(v16), 28));
        let t21 = best.1;
        // Team 22
        let best = (ops::bid(v55), 28_u8);
        let best = ops::challenge(best, (ops::bid(v13), 29));
        let best = ops::challenge(best, (ops::bid(v60), 28));
        let best = ops::challenge(best, (ops::bid(s[0]), 28));
        let best = ops::challenge(best, (ops::bid(v25), 12));
        let best = ops::challenge(best, (ops::bid(v33), 28));
        let best = ops::challenge(best, (ops::bid(v45), 15));
        let best = ops::challenge(best, (ops::bid(0.0_f32), 28));
        let t22 = best.1;
        // Team 18
        let best = (ops::bid(v18), 7_u8);
        let best = ops::challenge(best, (ops::bid(v58), 28));
        let best = ops::challenge(best, (ops::bid(s[0]), 28));
        let best = ops::challenge(best, (ops::bid(v77), 34));
        let best = ops::challenge(best, (ops::bid(v67), 24));
        let best = ops::challenge(best, (ops::bid(v78), 27));
        let best = ops::challenge(best, (ops::bid(0.0_f32), 28));
        let t23 = best.1;
        // Team 28
        let best = (ops::bid(v79), 35_u8);
        let best = ops::challenge(best, (ops::bid(0.0_f32), 34));
        let best = ops::challenge(best, (ops::bid(s[0]), 28));
        let t24 = best.1;
        // Team 8
        let best = (ops::bid(v50), 28_u8);
        let best = ops::challenge(best, (ops::bid(v25), 35));
        let best = ops::challenge(best, (ops::bid(v31), 17));
        let best = ops::challenge(best, (ops::bid(v39), 30));
        let best = ops::challenge(best, (ops::bid(v37), 9));
        let best = ops::challenge(best, (ops::bid(0.05277237_f32), 35));
        let best = ops::challenge(best, (ops::bid(v20), 21));
        let best = ops::challenge(best, (ops::bid(v82), 7));
        let best = ops::challenge(best, (ops::bid(v58), 28));
        let best = ops::challenge(best, (ops::bid(v18), 7));
        let t25 = best.1;
        // Team 14
        let best = (ops::bid(0.0_f32), 33_u8);
        let best = ops::challenge(best, (ops::bid(v25), 35));
        let best = ops::challenge(best, (ops::bid(v39), 30));
        let best = ops::challenge(best, (ops::bid(v83), 8));
        let best = ops::challenge(best, (ops::bid(v18), 7));
        let best = ops::challenge(best, (ops::bid(v37), 9));
        let best = ops::challenge(best, (ops::bid(v12), 8));
        let t26 = best.1;
        // Team 19
        let best = (ops::bid(v13), 29_u8);
        let best = ops::challenge(best, (ops::bid(s[0]), 28));
        let best = ops::challenge(best, (ops::bid(0.0_f32), 30));
        let t27 = best.1;
        let next = [
            t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, t12, t13, t14, t15, t16, t17, t18,
            t19, t20, t21, t22, t23, t24, t25, t26, t27,
        ];
        let mut vertex = 0_u8;
        for _ in 0..Self::DEPTH {
            // An action is past the end: it leads to itself.
            vertex = next.get(vertex as usize).copied().unwrap_or(vertex);
        }
        ActionId(vertex.wrapping_sub(28) as u16)
    }
}
