//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix widowx_fs --profile constant-time
//! Graph SHA-256: 36990850ec2e9a46699110a4764611e2bc47067713cc9af0e6e5503f1e975f93
//! 28 teams (16 on the longest walk), 174 edges, 141 programs, 49 distinct operations.
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
    pub const DEPTH: usize = 16;
    /// Bids that one decision looks at, at most.
    pub const WORST_BIDS: usize = 174;
    /// Operations of one decision, at most.
    pub const WORST_OPERATIONS: usize = 49;
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
        let v2 = s[0] * 0.7582224_f32;
        let v4 = s[0] * -107.57004_f32;
        let v7 = 42.029076_f32 / s[1];
        let v10 = s[1] * -99.097435_f32;
        let v12 = v10 + -0.52844894_f32;
        let v14 = s[0] - 0.7582224_f32;
        let v16 = s[2] - 0.7582224_f32;
        let v18 = v16 / 0.0_f32;
        let v20 = s[0] * -79.08088_f32;
        let v21 = -107.57004_f32 / s[2];
        let v23 = s[1] / s[1];
        let v24 = ops::max(0.0_f32, s[0]);
        let v25 = s[1] - v24;
        let v27 = s[0] - 1.0168722_f32;
        let v29 = s[1] * -176.74728_f32;
        let v30 = -0.52844894_f32 + v29;
        let v31 = 0.0_f32 / s[1];
        let v35 = s[1] * -55.687565_f32;
        let v37 = s[1] / 0.0_f32;
        let v38 = -107.57004_f32 / s[0];
        let v40 = s[2] - -6.7057414_f32;
        let v41 = ops::max(s[2], v16);
        let v45 = s[0] - 0.6354382_f32;
        let v47 = s[0] + -5.963282_f32;
        let v48 = s[2] * -176.74728_f32;
        let v49 = ops::max(s[1], 0.0_f32);
        let v50 = f32::abs(v49);
        let v51 = ops::min(s[0], s[1]);
        let v53 = -117.26495_f32 - s[2];
        let v54 = s[0] + -117.26495_f32;
        let v56 = ops::negate_if_less(s[1], 229.17769_f32);
        let v57 = -107.57004_f32 * s[1];
        let v59 = s[2] - 0.75724316_f32;
        let v60 = s[2] + -117.26495_f32;
        let v62 = s[0] - 0.7258825_f32;
        let v64 = ops::min(s[2], 110.01199_f32);
        let v66 = ops::min(-8.893463_f32, s[1]);
        let v68 = 0.0_f32 - s[0];
        let v69 = 2.710111_f32 / v68;
        let v70 = v48 / s[1];
        let v72 = s[0] / 0.6354382_f32;
        let v74 = s[0] * 0.87870044_f32;
        let v75 = -79.08088_f32 - s[0];
        let v77 = s[0] * s[2];
        let v78 = v77 - s[0];
        let v79 = 2.710111_f32 / v78;
        let v81 = ops::negate_if_less(s[1], -1.1606317_f32);
        let v82 = s[0] + -107.57004_f32;
        let v84 = s[0] * 0.18706028_f32;

        // Where each team leads: teams are numbered from 0, the root, and the actions follow them.
        // Team 0
        let best = (ops::bid(v2), 28_u8);
        let best = ops::challenge(best, (ops::bid(v4), 29));
        let best = ops::challenge(best, (ops::bid(v12), 1));
        let best = ops::challenge(best, (ops::bid(3.135279_f32), 2));
        let best = ops::challenge(best, (ops::bid(v14), 28));
        let best = ops::challenge(best, (ops::bid(v18), 32));
        let best = ops::challenge(best, (ops::bid(v20), 29));
        let best = ops::challenge(best, (ops::bid(v7), 31));
        let best = ops::challenge(best, (ops::bid(v21), 35));
        let t0 = best.1;
        // Team 1
        let best = (ops::bid(v30), 3_u8);
        let best = ops::challenge(best, (ops::bid(v21), 4));
        let best = ops::challenge(best, (ops::bid(v16), 32));
        let best = ops::challenge(best, (ops::bid(v14), 28));
        let best = ops::challenge(best, (ops::bid(v4), 29));
        let best = ops::challenge(best, (ops::bid(v31), 29));
        let best = ops::challenge(best, (ops::bid(20.1483_f32), 5));
        let best = ops::challenge(best, (ops::bid(v20), 29));
        let t1 = best.1;
        // Team 4
        let best = (ops::bid(v16), 32_u8);
        let best = ops::challenge(best, (ops::bid(v4), 6));
        let best = ops::challenge(best, (ops::bid(v14), 28));
        let best = ops::challenge(best, (ops::bid(1.6245565_f32), 7));
        let best = ops::challenge(best, (ops::bid(v23), 8));
        let best = ops::challenge(best, (ops::bid(v25), 31));
        let best = ops::challenge(best, (ops::bid(v27), 28));
        let t2 = best.1;
        // Team 3
        let best = (ops::bid(v53), 9_u8);
        let best = ops::challenge(best, (ops::bid(v54), 32));
        let best = ops::challenge(best, (ops::bid(v14), 28));
        let best = ops::challenge(best, (ops::bid(v4), 10));
        let best = ops::challenge(best, (ops::bid(v16), 32));
        let best = ops::challenge(best, (ops::bid(26.139645_f32), 2));
        let t3 = best.1;
        // Team 14
        let best = (ops::bid(v16), 32_u8);
        let best = ops::challenge(best, (ops::bid(v56), 11));
        let best = ops::challenge(best, (ops::bid(0.0_f32), 12));
        let best = ops::challenge(best, (ops::bid(v57), 13));
        let t4 = best.1;
        // Team 2
        let best = (ops::bid(v16), 32_u8);
        let best = ops::challenge(best, (ops::bid(v59), 32));
        let best = ops::challenge(best, (ops::bid(v60), 32));
        let best = ops::challenge(best, (ops::bid(1.6245565_f32), 14));
        let best = ops::challenge(best, (ops::bid(v62), 28));
        let best = ops::challenge(best, (ops::bid(v20), 29));
        let best = ops::challenge(best, (ops::bid(v4), 6));
        let best = ops::challenge(best, (ops::bid(v14), 28));
        let t5 = best.1;
        // Team 21
        let best = (ops::bid(v20), 29_u8);
        let best = ops::challenge(best, (ops::bid(v45), 28));
        let best = ops::challenge(best, (ops::bid(v47), 32));
        let best = ops::challenge(best, (ops::bid(v14), 28));
        let best = ops::challenge(best, (ops::bid(0.0_f32), 15));
        let best = ops::challenge(best, (ops::bid(v48), 16));
        let best = ops::challenge(best, (ops::bid(v38), 17));
        let best = ops::challenge(best, (ops::bid(v4), 29));
        let t6 = best.1;
        // Team 5
        let best = (ops::bid(v16), 32_u8);
        let best = ops::challenge(best, (ops::bid(v4), 6));
        let best = ops::challenge(best, (ops::bid(v37), 12));
        let best = ops::challenge(best, (ops::bid(1.6245565_f32), 14));
        let t7 = best.1;
        // Team 30
        let best = (ops::bid(v50), 34_u8);
        let best = ops::challenge(best, (ops::bid(v51), 28));
        let best = ops::challenge(best, (ops::bid(0.0_f32), 33));
        let t8 = best.1;
        // Team 11
        let best = (ops::bid(10.629795_f32), 11_u8);
        let best = ops::challenge(best, (ops::bid(v64), 18));
        let best = ops::challenge(best, (ops::bid(v14), 28));
        let best = ops::challenge(best, (ops::bid(v4), 29));
        let best = ops::challenge(best, (ops::bid(v20), 29));
        let best = ops::challenge(best, (ops::bid(v38), 17));
        let best = ops::challenge(best, (ops::bid(v16), 28));
        let t9 = best.1;
        // Team 27
        let best = (ops::bid(2.5843248_f32), 8_u8);
        let best = ops::challenge(best, (ops::bid(v4), 29));
        let best = ops::challenge(best, (ops::bid(v14), 28));
        let best = ops::challenge(best, (ops::bid(s[1]), 31));
        let t10 = best.1;
        // Team 29
        let best = (ops::bid(v72), 28_u8);
        let best = ops::challenge(best, (ops::bid(v14), 28));
        let best = ops::challenge(best, (ops::bid(v70), 16));
        let best = ops::challenge(best, (ops::bid(2.5843248_f32), 8));
        let best = ops::challenge(best, (ops::bid(v60), 29));
        let best = ops::challenge(best, (ops::bid(s[0]), 28));
        let best = ops::challenge(best, (ops::bid(v4), 17));
        let t11 = best.1;
        // Team 15
        let best = (ops::bid(v16), 19_u8);
        let best = ops::challenge(best, (ops::bid(v56), 11));
        let best = ops::challenge(best, (ops::bid(v60), 29));
        let best = ops::challenge(best, (ops::bid(v25), 31));
        let best = ops::challenge(best, (ops::bid(v14), 28));
        let best = ops::challenge(best, (ops::bid(v38), 17));
        let best = ops::challenge(best, (ops::bid(10.629795_f32), 11));
        let best = ops::challenge(best, (ops::bid(v20), 29));
        let t12 = best.1;
        // Team 28
        let best = (ops::bid(v20), 29_u8);
        let best = ops::challenge(best, (ops::bid(v45), 28));
        let best = ops::challenge(best, (ops::bid(v4), 17));
        let best = ops::challenge(best, (ops::bid(v60), 29));
        let best = ops::challenge(best, (ops::bid(0.0_f32), 31));
        let best = ops::challenge(best, (ops::bid(v74), 16));
        let best = ops::challenge(best, (ops::bid(v25), 31));
        let t13 = best.1;
        // Team 6
        let best = (ops::bid(v38), 4_u8);
        let best = ops::challenge(best, (ops::bid(v41), 32));
        let best = ops::challenge(best, (ops::bid(v16), 30));
        let best = ops::challenge(best, (ops::bid(f32::INFINITY), 20));
        let t14 = best.1;
        // Team 22
        let best = (ops::bid(v69), 29_u8);
        let best = ops::challenge(best, (ops::bid(0.0_f32), 28));
        let best = ops::challenge(best, (ops::bid(v23), 8));
        let best = ops::challenge(best, (ops::bid(v70), 16));
        let best = ops::challenge(best, (ops::bid(v45), 21));
        let best = ops::challenge(best, (ops::bid(v14), 28));
        let best = ops::challenge(best, (ops::bid(v4), 17));
        let t15 = best.1;
        // Team 32
        let best = (ops::bid(0.0_f32), 31_u8);
        let best = ops::challenge(best, (ops::bid(v14), 28));
        let best = ops::challenge(best, (ops::bid(v35), 33));
        let best = ops::challenge(best, (ops::bid(v4), 29));
        let t16 = best.1;
        // Team 33
        let best = (ops::bid(v31), 29_u8);
        let best = ops::challenge(best, (ops::bid(s[0]), 28));
        let best = ops::challenge(best, (ops::bid(v66), 28));
        let best = ops::challenge(best, (ops::bid(s[1]), 31));
        let best = ops::challenge(best, (ops::bid(v4), 29));
        let t17 = best.1;
        // Team 12
        let best = (ops::bid(v81), 22_u8);
        let best = ops::challenge(best, (ops::bid(15.754999_f32), 23));
        let best = ops::challenge(best, (ops::bid(v57), 13));
        let best = ops::challenge(best, (ops::bid(v14), 28));
        let best = ops::challenge(best, (ops::bid(v4), 17));
        let t18 = best.1;
        // Team 18
        let best = (ops::bid(v38), 17_u8);
        let best = ops::challenge(best, (ops::bid(v14), 28));
        let best = ops::challenge(best, (ops::bid(v75), 24));
        let best = ops::challenge(best, (ops::bid(v20), 29));
        let best = ops::challenge(best, (ops::bid(v31), 29));
        let best = ops::challenge(best, (ops::bid(v16), 25));
        let best = ops::challenge(best, (ops::bid(13.937786_f32), 11));
        let best = ops::challenge(best, (ops::bid(v4), 6));
        let t19 = best.1;
        // Team 8
        let best = (ops::bid(v40), 30_u8);
        let best = ops::challenge(best, (ops::bid(6.543999_f32), 35));
        let best = ops::challenge(best, (ops::bid(v37), 12));
        let best = ops::challenge(best, (ops::bid(v20), 29));
        let best = ops::challenge(best, (ops::bid(v38), 17));
        let best = ops::challenge(best, (ops::bid(v16), 30));
        let best = ops::challenge(best, (ops::bid(v4), 29));
        let best = ops::challenge(best, (ops::bid(v14), 28));
        let t20 = best.1;
        // Team 25
        let best = (ops::bid(v20), 29_u8);
        let best = ops::challenge(best, (ops::bid(v45), 28));
        let best = ops::challenge(best, (ops::bid(15.754999_f32), 26));
        let best = ops::challenge(best, (ops::bid(v4), 17));
        let best = ops::challenge(best, (ops::bid(v60), 29));
        let t21 = best.1;
        // Team 13
        let best = (ops::bid(v38), 17_u8);
        let best = ops::challenge(best, (ops::bid(v14), 28));
        let best = ops::challenge(best, (ops::bid(15.754999_f32), 23));
        let best = ops::challenge(best, (ops::bid(v20), 29));
        let best = ops::challenge(best, (ops::bid(v60), 29));
        let best = ops::challenge(best, (ops::bid(v4), 17));
        let t22 = best.1;
        // Team 23
        let best = (ops::bid(v74), 28_u8);
        let best = ops::challenge(best, (ops::bid(v79), 29));
        let best = ops::challenge(best, (ops::bid(v82), 29));
        let best = ops::challenge(best, (ops::bid(0.0_f32), 31));
        let best = ops::challenge(best, (ops::bid(v23), 8));
        let best = ops::challenge(best, (ops::bid(v70), 16));
        let best = ops::challenge(best, (ops::bid(v14), 8));
        let best = ops::challenge(best, (ops::bid(v45), 21));
        let best = ops::challenge(best, (ops::bid(v4), 29));
        let best = ops::challenge(best, (ops::bid(v84), 29));
        let t23 = best.1;
        // Team 31
        let best = (ops::bid(s[2]), 28_u8);
        let best = ops::challenge(best, (ops::bid(10.629795_f32), 16));
        let best = ops::challenge(best, (ops::bid(v25), 31));
        let best = ops::challenge(best, (ops::bid(v4), 29));
        let best = ops::challenge(best, (ops::bid(v14), 28));
        let t24 = best.1;
        // Team 19
        let best = (ops::bid(v38), 17_u8);
        let best = ops::challenge(best, (ops::bid(v16), 32));
        let best = ops::challenge(best, (ops::bid(v57), 13));
        let best = ops::challenge(best, (ops::bid(v45), 27));
        let best = ops::challenge(best, (ops::bid(v4), 24));
        let best = ops::challenge(best, (ops::bid(v69), 29));
        let t25 = best.1;
        // Team 26
        let best = (ops::bid(83.54613_f32), 16_u8);
        let best = ops::challenge(best, (ops::bid(v14), 28));
        let best = ops::challenge(best, (ops::bid(v4), 29));
        let best = ops::challenge(best, (ops::bid(v79), 29));
        let t26 = best.1;
        // Team 20
        let best = (ops::bid(v38), 17_u8);
        let best = ops::challenge(best, (ops::bid(v16), 28));
        let best = ops::challenge(best, (ops::bid(10.629795_f32), 11));
        let best = ops::challenge(best, (ops::bid(v20), 32));
        let best = ops::challenge(best, (ops::bid(v14), 28));
        let best = ops::challenge(best, (ops::bid(v4), 6));
        let best = ops::challenge(best, (ops::bid(v57), 13));
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
