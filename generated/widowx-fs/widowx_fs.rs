//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix widowx_fs --profile constant-time
//! Graph SHA-256: 2460e91fcad64a969f9a7c8ed86478a4fcbac7ae14ca0273944e1ca3551f08ee
//! 31 teams (18 on the longest walk), 188 edges, 153 programs, 52 distinct operations.
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
/// - `s[0..3]`: polar, mm, -449 to 449
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
pub struct WidowxFs;

impl WidowxFs {
    /// Values of a state.
    pub const STATE: usize = 3;
    /// Actions.
    pub const ACTIONS: usize = 8;
    /// Teams on the longest walk.
    pub const DEPTH: usize = 18;
    /// Bids that one decision looks at, at most.
    pub const WORST_BIDS: usize = 188;
    /// Operations of one decision, at most.
    pub const WORST_OPERATIONS: usize = 52;
    /// Sines, cosines, logarithms and exponentials among them, at most.
    pub const WORST_MATHS_CALLS: usize = 0;
    /// The arm's sources that make up a state, in order.
    pub const SOURCES: [Source; 1] = [Source::Polar];
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

impl Policy for WidowxFs {
    type State = [f32; 3];
    type Action = ActionId;

    fn decide(&self, s: &[f32; 3]) -> ActionId {
        let v4 = s[2] - 0.7582224_f32;
        let v7 = ops::min(-8.893463_f32, s[1]);
        let v8 = 0.0_f32 - s[1];
        let v10 = s[0] - 0.7582224_f32;
        let v12 = v4 / 0.0_f32;
        let v13 = v12 / 0.0_f32;
        let v15 = 0.0_f32 * s[2];
        let v16 = ops::negate_if_less(s[0], 0.0_f32);
        let v18 = s[0] * -107.57004_f32;
        let v20 = s[1] * -176.74728_f32;
        let v22 = v20 + -0.52844894_f32;
        let v23 = s[2] + v4;
        let v27 = s[1] / s[1];
        let v28 = ops::max(0.0_f32, s[0]);
        let v29 = s[1] - v28;
        let v31 = s[0] - 1.0168722_f32;
        let v32 = 0.7582224_f32 * s[0];
        let v34 = 42.029076_f32 / s[1];
        let v40 = s[0] / 0.6354382_f32;
        let v41 = s[2] * -176.74728_f32;
        let v42 = v41 / s[1];
        let v43 = s[2] + -117.26495_f32;
        let v45 = s[0] * -79.08088_f32;
        let v46 = -107.57004_f32 / s[2];
        let v47 = 0.0_f32 / s[1];
        let v48 = -107.57004_f32 / s[0];
        let v49 = -117.26495_f32 - s[2];
        let v50 = s[0] + -117.26495_f32;
        let v52 = s[2] - 0.75724316_f32;
        let v54 = s[0] - 0.7258825_f32;
        let v55 = s[1] / 0.0_f32;
        let v57 = s[2] - -6.7057414_f32;
        let v58 = ops::max(s[1], 0.0_f32);
        let v59 = f32::abs(v58);
        let v60 = ops::min(s[0], s[1]);
        let v61 = ops::max(s[2], v4);
        let v64 = s[0] - 0.6354382_f32;
        let v65 = s[0] + -5.963282_f32;
        let v67 = s[1] * -55.687565_f32;
        let v69 = ops::negate_if_less(s[1], 229.17769_f32);
        let v70 = s[1] * -107.57004_f32;
        let v72 = s[0] * 0.87870044_f32;
        let v73 = s[2] * s[0];
        let v74 = v73 - s[0];
        let v75 = 2.710111_f32 / v74;
        let v76 = s[0] + -107.57004_f32;
        let v78 = s[0] * 0.18706028_f32;
        let v80 = ops::min(s[2], 110.01199_f32);
        let v82 = 0.0_f32 - s[0];
        let v83 = 2.710111_f32 / v82;
        let v85 = ops::negate_if_less(s[1], -1.1606317_f32);
        let v86 = -79.08088_f32 - s[0];

        // Where each team leads: teams are numbered from 0, the root, and the actions follow them.
        // Team 0
        let best = (ops::bid(107.35707_f32), 1_u8);
        let best = ops::challenge(best, (ops::bid(v4), 35));
        let best = ops::challenge(best, (ops::bid(v8), 2));
        let best = ops::challenge(best, (ops::bid(v13), 35));
        let best = ops::challenge(best, (ops::bid(v10), 31));
        let t0 = best.1;
        // Team 1
        let best = (ops::bid(1.6245565_f32), 3_u8);
        let best = ops::challenge(best, (ops::bid(v15), 31));
        let best = ops::challenge(best, (ops::bid(v16), 31));
        let best = ops::challenge(best, (ops::bid(v8), 2));
        let best = ops::challenge(best, (ops::bid(v18), 32));
        let best = ops::challenge(best, (ops::bid(v10), 31));
        let best = ops::challenge(best, (ops::bid(v22), 4));
        let t1 = best.1;
        // Team 9
        let best = (ops::bid(v22), 5_u8);
        let best = ops::challenge(best, (ops::bid(v4), 35));
        let best = ops::challenge(best, (ops::bid(20.1483_f32), 6));
        let best = ops::challenge(best, (ops::bid(v23), 35));
        let t2 = best.1;
        // Team 7
        let best = (ops::bid(v32), 31_u8);
        let best = ops::challenge(best, (ops::bid(v18), 32));
        let best = ops::challenge(best, (ops::bid(v34), 34));
        let best = ops::challenge(best, (ops::bid(v22), 4));
        let best = ops::challenge(best, (ops::bid(3.135279_f32), 7));
        let best = ops::challenge(best, (ops::bid(v10), 31));
        let best = ops::challenge(best, (ops::bid(v12), 35));
        let t3 = best.1;
        // Team 10
        let best = (ops::bid(v22), 5_u8);
        let best = ops::challenge(best, (ops::bid(v46), 8));
        let best = ops::challenge(best, (ops::bid(v4), 35));
        let best = ops::challenge(best, (ops::bid(v10), 31));
        let best = ops::challenge(best, (ops::bid(v18), 32));
        let best = ops::challenge(best, (ops::bid(v47), 32));
        let best = ops::challenge(best, (ops::bid(20.1483_f32), 6));
        let best = ops::challenge(best, (ops::bid(v45), 32));
        let t4 = best.1;
        // Team 12
        let best = (ops::bid(v49), 9_u8);
        let best = ops::challenge(best, (ops::bid(v50), 35));
        let best = ops::challenge(best, (ops::bid(v10), 31));
        let best = ops::challenge(best, (ops::bid(v18), 10));
        let best = ops::challenge(best, (ops::bid(v4), 35));
        let best = ops::challenge(best, (ops::bid(26.139645_f32), 7));
        let t5 = best.1;
        // Team 11
        let best = (ops::bid(v4), 35_u8);
        let best = ops::challenge(best, (ops::bid(v52), 35));
        let best = ops::challenge(best, (ops::bid(v43), 35));
        let best = ops::challenge(best, (ops::bid(1.6245565_f32), 11));
        let best = ops::challenge(best, (ops::bid(v54), 31));
        let best = ops::challenge(best, (ops::bid(v45), 32));
        let best = ops::challenge(best, (ops::bid(v18), 12));
        let best = ops::challenge(best, (ops::bid(v10), 31));
        let t6 = best.1;
        // Team 13
        let best = (ops::bid(v4), 35_u8);
        let best = ops::challenge(best, (ops::bid(v18), 12));
        let best = ops::challenge(best, (ops::bid(v10), 31));
        let best = ops::challenge(best, (ops::bid(1.6245565_f32), 13));
        let best = ops::challenge(best, (ops::bid(v27), 14));
        let best = ops::challenge(best, (ops::bid(v29), 34));
        let best = ops::challenge(best, (ops::bid(v31), 31));
        let t7 = best.1;
        // Team 23
        let best = (ops::bid(v4), 35_u8);
        let best = ops::challenge(best, (ops::bid(v69), 15));
        let best = ops::challenge(best, (ops::bid(0.0_f32), 16));
        let best = ops::challenge(best, (ops::bid(v70), 17));
        let t8 = best.1;
        // Team 20
        let best = (ops::bid(10.629795_f32), 15_u8);
        let best = ops::challenge(best, (ops::bid(v80), 18));
        let best = ops::challenge(best, (ops::bid(v10), 31));
        let best = ops::challenge(best, (ops::bid(v18), 32));
        let best = ops::challenge(best, (ops::bid(v45), 32));
        let best = ops::challenge(best, (ops::bid(v48), 19));
        let best = ops::challenge(best, (ops::bid(v4), 31));
        let t9 = best.1;
        // Team 36
        let best = (ops::bid(2.5843248_f32), 14_u8);
        let best = ops::challenge(best, (ops::bid(v18), 32));
        let best = ops::challenge(best, (ops::bid(v10), 31));
        let best = ops::challenge(best, (ops::bid(s[1]), 34));
        let t10 = best.1;
        // Team 15
        let best = (ops::bid(v48), 8_u8);
        let best = ops::challenge(best, (ops::bid(v61), 35));
        let best = ops::challenge(best, (ops::bid(v4), 33));
        let best = ops::challenge(best, (ops::bid(f32::INFINITY), 20));
        let t11 = best.1;
        // Team 30
        let best = (ops::bid(v45), 32_u8);
        let best = ops::challenge(best, (ops::bid(v64), 31));
        let best = ops::challenge(best, (ops::bid(v65), 35));
        let best = ops::challenge(best, (ops::bid(v10), 31));
        let best = ops::challenge(best, (ops::bid(0.0_f32), 21));
        let best = ops::challenge(best, (ops::bid(v41), 22));
        let best = ops::challenge(best, (ops::bid(v48), 19));
        let best = ops::challenge(best, (ops::bid(v18), 32));
        let t12 = best.1;
        // Team 14
        let best = (ops::bid(v4), 35_u8);
        let best = ops::challenge(best, (ops::bid(v18), 12));
        let best = ops::challenge(best, (ops::bid(v55), 16));
        let best = ops::challenge(best, (ops::bid(1.6245565_f32), 11));
        let t13 = best.1;
        // Team 39
        let best = (ops::bid(v59), 37_u8);
        let best = ops::challenge(best, (ops::bid(v60), 31));
        let best = ops::challenge(best, (ops::bid(0.0_f32), 36));
        let t14 = best.1;
        // Team 38
        let best = (ops::bid(v40), 31_u8);
        let best = ops::challenge(best, (ops::bid(v10), 31));
        let best = ops::challenge(best, (ops::bid(v42), 22));
        let best = ops::challenge(best, (ops::bid(2.5843248_f32), 14));
        let best = ops::challenge(best, (ops::bid(v43), 32));
        let best = ops::challenge(best, (ops::bid(s[0]), 31));
        let best = ops::challenge(best, (ops::bid(v18), 19));
        let t15 = best.1;
        // Team 24
        let best = (ops::bid(v4), 23_u8);
        let best = ops::challenge(best, (ops::bid(v69), 15));
        let best = ops::challenge(best, (ops::bid(v43), 32));
        let best = ops::challenge(best, (ops::bid(v29), 34));
        let best = ops::challenge(best, (ops::bid(v10), 31));
        let best = ops::challenge(best, (ops::bid(v48), 19));
        let best = ops::challenge(best, (ops::bid(10.629795_f32), 15));
        let best = ops::challenge(best, (ops::bid(v45), 32));
        let t16 = best.1;
        // Team 37
        let best = (ops::bid(v45), 32_u8);
        let best = ops::challenge(best, (ops::bid(v64), 31));
        let best = ops::challenge(best, (ops::bid(v18), 19));
        let best = ops::challenge(best, (ops::bid(v43), 32));
        let best = ops::challenge(best, (ops::bid(0.0_f32), 34));
        let best = ops::challenge(best, (ops::bid(v72), 22));
        let best = ops::challenge(best, (ops::bid(v29), 34));
        let t17 = best.1;
        // Team 21
        let best = (ops::bid(v85), 24_u8);
        let best = ops::challenge(best, (ops::bid(15.754999_f32), 25));
        let best = ops::challenge(best, (ops::bid(v70), 17));
        let best = ops::challenge(best, (ops::bid(v10), 31));
        let best = ops::challenge(best, (ops::bid(v18), 19));
        let t18 = best.1;
        // Team 42
        let best = (ops::bid(v47), 32_u8);
        let best = ops::challenge(best, (ops::bid(s[0]), 31));
        let best = ops::challenge(best, (ops::bid(v7), 31));
        let best = ops::challenge(best, (ops::bid(s[1]), 34));
        let best = ops::challenge(best, (ops::bid(v18), 32));
        let t19 = best.1;
        // Team 17
        let best = (ops::bid(v57), 33_u8);
        let best = ops::challenge(best, (ops::bid(6.543999_f32), 38));
        let best = ops::challenge(best, (ops::bid(v55), 16));
        let best = ops::challenge(best, (ops::bid(v45), 32));
        let best = ops::challenge(best, (ops::bid(v48), 19));
        let best = ops::challenge(best, (ops::bid(v4), 33));
        let best = ops::challenge(best, (ops::bid(v18), 32));
        let best = ops::challenge(best, (ops::bid(v10), 31));
        let t20 = best.1;
        // Team 31
        let best = (ops::bid(v83), 32_u8);
        let best = ops::challenge(best, (ops::bid(0.0_f32), 31));
        let best = ops::challenge(best, (ops::bid(v27), 14));
        let best = ops::challenge(best, (ops::bid(v42), 22));
        let best = ops::challenge(best, (ops::bid(v64), 26));
        let best = ops::challenge(best, (ops::bid(v10), 31));
        let best = ops::challenge(best, (ops::bid(v18), 19));
        let t21 = best.1;
        // Team 41
        let best = (ops::bid(0.0_f32), 34_u8);
        let best = ops::challenge(best, (ops::bid(v10), 31));
        let best = ops::challenge(best, (ops::bid(v67), 36));
        let best = ops::challenge(best, (ops::bid(v18), 32));
        let t22 = best.1;
        // Team 27
        let best = (ops::bid(v48), 19_u8);
        let best = ops::challenge(best, (ops::bid(v10), 31));
        let best = ops::challenge(best, (ops::bid(v86), 27));
        let best = ops::challenge(best, (ops::bid(v45), 32));
        let best = ops::challenge(best, (ops::bid(v47), 32));
        let best = ops::challenge(best, (ops::bid(v4), 28));
        let best = ops::challenge(best, (ops::bid(13.937786_f32), 15));
        let best = ops::challenge(best, (ops::bid(v18), 12));
        let t23 = best.1;
        // Team 22
        let best = (ops::bid(v48), 19_u8);
        let best = ops::challenge(best, (ops::bid(v10), 31));
        let best = ops::challenge(best, (ops::bid(15.754999_f32), 25));
        let best = ops::challenge(best, (ops::bid(v45), 32));
        let best = ops::challenge(best, (ops::bid(v43), 32));
        let best = ops::challenge(best, (ops::bid(v18), 19));
        let t24 = best.1;
        // Team 32
        let best = (ops::bid(v72), 31_u8);
        let best = ops::challenge(best, (ops::bid(v75), 32));
        let best = ops::challenge(best, (ops::bid(v76), 32));
        let best = ops::challenge(best, (ops::bid(0.0_f32), 34));
        let best = ops::challenge(best, (ops::bid(v27), 14));
        let best = ops::challenge(best, (ops::bid(v42), 22));
        let best = ops::challenge(best, (ops::bid(v10), 14));
        let best = ops::challenge(best, (ops::bid(v64), 26));
        let best = ops::challenge(best, (ops::bid(v18), 32));
        let best = ops::challenge(best, (ops::bid(v78), 32));
        let t25 = best.1;
        // Team 34
        let best = (ops::bid(v45), 32_u8);
        let best = ops::challenge(best, (ops::bid(v64), 31));
        let best = ops::challenge(best, (ops::bid(15.754999_f32), 29));
        let best = ops::challenge(best, (ops::bid(v18), 19));
        let best = ops::challenge(best, (ops::bid(v43), 32));
        let t26 = best.1;
        // Team 40
        let best = (ops::bid(s[2]), 31_u8);
        let best = ops::challenge(best, (ops::bid(10.629795_f32), 22));
        let best = ops::challenge(best, (ops::bid(v29), 34));
        let best = ops::challenge(best, (ops::bid(v18), 32));
        let best = ops::challenge(best, (ops::bid(v10), 31));
        let t27 = best.1;
        // Team 28
        let best = (ops::bid(v48), 19_u8);
        let best = ops::challenge(best, (ops::bid(v4), 35));
        let best = ops::challenge(best, (ops::bid(v70), 17));
        let best = ops::challenge(best, (ops::bid(v64), 30));
        let best = ops::challenge(best, (ops::bid(v18), 27));
        let best = ops::challenge(best, (ops::bid(v83), 32));
        let t28 = best.1;
        // Team 35
        let best = (ops::bid(83.54613_f32), 22_u8);
        let best = ops::challenge(best, (ops::bid(v10), 31));
        let best = ops::challenge(best, (ops::bid(v18), 32));
        let best = ops::challenge(best, (ops::bid(v75), 32));
        let t29 = best.1;
        // Team 29
        let best = (ops::bid(v48), 19_u8);
        let best = ops::challenge(best, (ops::bid(v4), 31));
        let best = ops::challenge(best, (ops::bid(10.629795_f32), 15));
        let best = ops::challenge(best, (ops::bid(v45), 35));
        let best = ops::challenge(best, (ops::bid(v10), 31));
        let best = ops::challenge(best, (ops::bid(v18), 12));
        let best = ops::challenge(best, (ops::bid(v70), 17));
        let t30 = best.1;

        // An action leads to itself; what fills the array up to a power of two is never come to.
        let next: [u8; 64] = [
            t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, t12, t13, t14, t15, t16, t17, t18,
            t19, t20, t21, t22, t23, t24, t25, t26, t27, t28, t29, t30, 31, 32, 33, 34, 35, 36, 37,
            38, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        ];
        // The longest walk decides 18 times; a shorter one waits at its action. No loop, and no end to check.
        let vertex = next[0];
        let vertex = next[(vertex & 63) as usize];
        let vertex = next[(vertex & 63) as usize];
        let vertex = next[(vertex & 63) as usize];
        let vertex = next[(vertex & 63) as usize];
        let vertex = next[(vertex & 63) as usize];
        let vertex = next[(vertex & 63) as usize];
        let vertex = next[(vertex & 63) as usize];
        let vertex = next[(vertex & 63) as usize];
        let vertex = next[(vertex & 63) as usize];
        let vertex = next[(vertex & 63) as usize];
        let vertex = next[(vertex & 63) as usize];
        let vertex = next[(vertex & 63) as usize];
        let vertex = next[(vertex & 63) as usize];
        let vertex = next[(vertex & 63) as usize];
        let vertex = next[(vertex & 63) as usize];
        let vertex = next[(vertex & 63) as usize];
        let vertex = next[(vertex & 63) as usize];
        ActionId(vertex.wrapping_sub(31) as u16)
    }
}
