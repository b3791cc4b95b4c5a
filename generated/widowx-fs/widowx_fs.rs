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

use tpg_runtime::ops::constant_time::ConstantTime;
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
    /// The sources that make up a state, in order.
    pub const SOURCES: [&str; 1] = ["polar"];
    /// Motor ticks by which each action moves each joint.
    pub const MOVES: [[i8; 4]; 8] = [
        [3, 0, 0, 0],
        [-3, 0, 0, 0],
        [0, 3, 0, 0],
        [0, -3, 0, 0],
        [0, 0, 3, 0],
        [0, 0, -3, 0],
        [0, 0, 0, 3],
        [0, 0, 0, -3],
    ];
}

impl Policy for WidowxFs {
    type State = [f32; 3];
    type Action = ActionId;

    fn decide(&self, s: &[f32; 3]) -> ActionId {
        let ct = ConstantTime::<f32>::default();
        let v4 = s[2] - 0.7582224_f32;
        let v7 = ct.min(-8.893463_f32, s[1]);
        let v8 = 0.0_f32 - s[1];
        let v10 = s[0] - 0.7582224_f32;
        let v12 = v4 / 0.0_f32;
        let v13 = v12 / 0.0_f32;
        let v15 = 0.0_f32 * s[2];
        let v16 = ct.negate_if_less(s[0], 0.0_f32);
        let v18 = s[0] * -107.57004_f32;
        let v20 = s[1] * -176.74728_f32;
        let v22 = v20 + -0.52844894_f32;
        let v23 = s[2] + v4;
        let v27 = s[1] / s[1];
        let v28 = ct.max(0.0_f32, s[0]);
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
        let v58 = ct.max(s[1], 0.0_f32);
        let v59 = f32::abs(v58);
        let v60 = ct.min(s[0], s[1]);
        let v61 = ct.max(s[2], v4);
        let v64 = s[0] - 0.6354382_f32;
        let v65 = s[0] + -5.963282_f32;
        let v67 = s[1] * -55.687565_f32;
        let v69 = ct.negate_if_less(s[1], 229.17769_f32);
        let v70 = s[1] * -107.57004_f32;
        let v72 = s[0] * 0.87870044_f32;
        let v73 = s[2] * s[0];
        let v74 = v73 - s[0];
        let v75 = 2.710111_f32 / v74;
        let v76 = s[0] + -107.57004_f32;
        let v78 = s[0] * 0.18706028_f32;
        let v80 = ct.min(s[2], 110.01199_f32);
        let v82 = 0.0_f32 - s[0];
        let v83 = 2.710111_f32 / v82;
        let v85 = ct.negate_if_less(s[1], -1.1606317_f32);
        let v86 = -79.08088_f32 - s[0];

        // What is bid, as integers in the same order.
        let k0 = 1112979155_i32; // 107.35707_f32
        let k1 = -8388607_i32; // 0.0_f32
        let k2 = ct.order(s[2]);
        let k4 = ct.order(v4);
        let k6 = ct.order(s[1]);
        let k7 = ct.order(v7);
        let k8 = ct.order(v8);
        let k9 = ct.order(s[0]);
        let k10 = ct.order(v10);
        let k11 = 1095835135_i32; // 26.139645_f32
        let k12 = ct.order(v12);
        let k13 = ct.order(v13);
        let k14 = 1062203769_i32; // 1.6245565_f32
        let k15 = ct.order(v15);
        let k16 = ct.order(v16);
        let k18 = ct.order(v18);
        let k22 = ct.order(v22);
        let k23 = ct.order(v23);
        let k24 = 1090262139_i32; // 15.754999_f32
        let k25 = 1092693945_i32; // 20.1483_f32
        let k26 = 1067804053_i32; // 2.5843248_f32
        let k27 = ct.order(v27);
        let k29 = ct.order(v29);
        let k31 = ct.order(v31);
        let k32 = ct.order(v32);
        let k34 = ct.order(v34);
        let k35 = 1070114922_i32; // 3.135279_f32
        let k37 = 1084887973_i32; // 10.629795_f32
        let k40 = ct.order(v40);
        let k41 = ct.order(v41);
        let k42 = ct.order(v42);
        let k43 = ct.order(v43);
        let k45 = ct.order(v45);
        let k46 = ct.order(v46);
        let k47 = ct.order(v47);
        let k48 = ct.order(v48);
        let k49 = ct.order(v49);
        let k50 = ct.order(v50);
        let k52 = ct.order(v52);
        let k54 = ct.order(v54);
        let k55 = ct.order(v55);
        let k57 = ct.order(v57);
        let k59 = ct.order(v59);
        let k60 = ct.order(v60);
        let k61 = ct.order(v61);
        let k63 = 2130706433_i32; // f32::INFINITY
        let k64 = ct.order(v64);
        let k65 = ct.order(v65);
        let k67 = ct.order(v67);
        let k69 = ct.order(v69);
        let k70 = ct.order(v70);
        let k72 = ct.order(v72);
        let k75 = ct.order(v75);
        let k76 = ct.order(v76);
        let k78 = ct.order(v78);
        let k80 = ct.order(v80);
        let k81 = 1079076978_i32; // 6.543999_f32
        let k83 = ct.order(v83);
        let k85 = ct.order(v85);
        let k86 = ct.order(v86);
        let k87 = 1088356653_i32; // 13.937786_f32
        let k88 = 1109858207_i32; // 83.54613_f32

        // Where each team leads: teams are numbered from 0, the root, and the actions follow them.
        // Team 0
        let best = (k0, 1);
        let best = ct.challenge(best, (k4, 35));
        let best = ct.challenge(best, (k8, 2));
        let best = ct.challenge(best, (k13, 35));
        let best = ct.challenge(best, (k10, 31));
        let t0 = best.1 as u8;
        // Team 1
        let best = (k14, 3);
        let best = ct.challenge(best, (k15, 31));
        let best = ct.challenge(best, (k16, 31));
        let best = ct.challenge(best, (k8, 2));
        let best = ct.challenge(best, (k18, 32));
        let best = ct.challenge(best, (k10, 31));
        let best = ct.challenge(best, (k22, 4));
        let t1 = best.1 as u8;
        // Team 9
        let best = (k22, 5);
        let best = ct.challenge(best, (k4, 35));
        let best = ct.challenge(best, (k25, 6));
        let best = ct.challenge(best, (k23, 35));
        let t2 = best.1 as u8;
        // Team 7
        let best = (k32, 31);
        let best = ct.challenge(best, (k18, 32));
        let best = ct.challenge(best, (k34, 34));
        let best = ct.challenge(best, (k22, 4));
        let best = ct.challenge(best, (k35, 7));
        let best = ct.challenge(best, (k10, 31));
        let best = ct.challenge(best, (k12, 35));
        let t3 = best.1 as u8;
        // Team 10
        let best = (k22, 5);
        let best = ct.challenge(best, (k46, 8));
        let best = ct.challenge(best, (k4, 35));
        let best = ct.challenge(best, (k10, 31));
        let best = ct.challenge(best, (k18, 32));
        let best = ct.challenge(best, (k47, 32));
        let best = ct.challenge(best, (k25, 6));
        let best = ct.challenge(best, (k45, 32));
        let t4 = best.1 as u8;
        // Team 12
        let best = (k49, 9);
        let best = ct.challenge(best, (k50, 35));
        let best = ct.challenge(best, (k10, 31));
        let best = ct.challenge(best, (k18, 10));
        let best = ct.challenge(best, (k4, 35));
        let best = ct.challenge(best, (k11, 7));
        let t5 = best.1 as u8;
        // Team 11
        let best = (k4, 35);
        let best = ct.challenge(best, (k52, 35));
        let best = ct.challenge(best, (k43, 35));
        let best = ct.challenge(best, (k14, 11));
        let best = ct.challenge(best, (k54, 31));
        let best = ct.challenge(best, (k45, 32));
        let best = ct.challenge(best, (k18, 12));
        let best = ct.challenge(best, (k10, 31));
        let t6 = best.1 as u8;
        // Team 13
        let best = (k4, 35);
        let best = ct.challenge(best, (k18, 12));
        let best = ct.challenge(best, (k10, 31));
        let best = ct.challenge(best, (k14, 13));
        let best = ct.challenge(best, (k27, 14));
        let best = ct.challenge(best, (k29, 34));
        let best = ct.challenge(best, (k31, 31));
        let t7 = best.1 as u8;
        // Team 23
        let best = (k4, 35);
        let best = ct.challenge(best, (k69, 15));
        let best = ct.challenge(best, (k1, 16));
        let best = ct.challenge(best, (k70, 17));
        let t8 = best.1 as u8;
        // Team 20
        let best = (k37, 15);
        let best = ct.challenge(best, (k80, 18));
        let best = ct.challenge(best, (k10, 31));
        let best = ct.challenge(best, (k18, 32));
        let best = ct.challenge(best, (k45, 32));
        let best = ct.challenge(best, (k48, 19));
        let best = ct.challenge(best, (k4, 31));
        let t9 = best.1 as u8;
        // Team 36
        let best = (k26, 14);
        let best = ct.challenge(best, (k18, 32));
        let best = ct.challenge(best, (k10, 31));
        let best = ct.challenge(best, (k6, 34));
        let t10 = best.1 as u8;
        // Team 15
        let best = (k48, 8);
        let best = ct.challenge(best, (k61, 35));
        let best = ct.challenge(best, (k4, 33));
        let best = ct.challenge(best, (k63, 20));
        let t11 = best.1 as u8;
        // Team 30
        let best = (k45, 32);
        let best = ct.challenge(best, (k64, 31));
        let best = ct.challenge(best, (k65, 35));
        let best = ct.challenge(best, (k10, 31));
        let best = ct.challenge(best, (k1, 21));
        let best = ct.challenge(best, (k41, 22));
        let best = ct.challenge(best, (k48, 19));
        let best = ct.challenge(best, (k18, 32));
        let t12 = best.1 as u8;
        // Team 14
        let best = (k4, 35);
        let best = ct.challenge(best, (k18, 12));
        let best = ct.challenge(best, (k55, 16));
        let best = ct.challenge(best, (k14, 11));
        let t13 = best.1 as u8;
        // Team 39
        let best = (k59, 37);
        let best = ct.challenge(best, (k60, 31));
        let best = ct.challenge(best, (k1, 36));
        let t14 = best.1 as u8;
        // Team 38
        let best = (k40, 31);
        let best = ct.challenge(best, (k10, 31));
        let best = ct.challenge(best, (k42, 22));
        let best = ct.challenge(best, (k26, 14));
        let best = ct.challenge(best, (k43, 32));
        let best = ct.challenge(best, (k9, 31));
        let best = ct.challenge(best, (k18, 19));
        let t15 = best.1 as u8;
        // Team 24
        let best = (k4, 23);
        let best = ct.challenge(best, (k69, 15));
        let best = ct.challenge(best, (k43, 32));
        let best = ct.challenge(best, (k29, 34));
        let best = ct.challenge(best, (k10, 31));
        let best = ct.challenge(best, (k48, 19));
        let best = ct.challenge(best, (k37, 15));
        let best = ct.challenge(best, (k45, 32));
        let t16 = best.1 as u8;
        // Team 37
        let best = (k45, 32);
        let best = ct.challenge(best, (k64, 31));
        let best = ct.challenge(best, (k18, 19));
        let best = ct.challenge(best, (k43, 32));
        let best = ct.challenge(best, (k1, 34));
        let best = ct.challenge(best, (k72, 22));
        let best = ct.challenge(best, (k29, 34));
        let t17 = best.1 as u8;
        // Team 21
        let best = (k85, 24);
        let best = ct.challenge(best, (k24, 25));
        let best = ct.challenge(best, (k70, 17));
        let best = ct.challenge(best, (k10, 31));
        let best = ct.challenge(best, (k18, 19));
        let t18 = best.1 as u8;
        // Team 42
        let best = (k47, 32);
        let best = ct.challenge(best, (k9, 31));
        let best = ct.challenge(best, (k7, 31));
        let best = ct.challenge(best, (k6, 34));
        let best = ct.challenge(best, (k18, 32));
        let t19 = best.1 as u8;
        // Team 17
        let best = (k57, 33);
        let best = ct.challenge(best, (k81, 38));
        let best = ct.challenge(best, (k55, 16));
        let best = ct.challenge(best, (k45, 32));
        let best = ct.challenge(best, (k48, 19));
        let best = ct.challenge(best, (k4, 33));
        let best = ct.challenge(best, (k18, 32));
        let best = ct.challenge(best, (k10, 31));
        let t20 = best.1 as u8;
        // Team 31
        let best = (k83, 32);
        let best = ct.challenge(best, (k1, 31));
        let best = ct.challenge(best, (k27, 14));
        let best = ct.challenge(best, (k42, 22));
        let best = ct.challenge(best, (k64, 26));
        let best = ct.challenge(best, (k10, 31));
        let best = ct.challenge(best, (k18, 19));
        let t21 = best.1 as u8;
        // Team 41
        let best = (k1, 34);
        let best = ct.challenge(best, (k10, 31));
        let best = ct.challenge(best, (k67, 36));
        let best = ct.challenge(best, (k18, 32));
        let t22 = best.1 as u8;
        // Team 27
        let best = (k48, 19);
        let best = ct.challenge(best, (k10, 31));
        let best = ct.challenge(best, (k86, 27));
        let best = ct.challenge(best, (k45, 32));
        let best = ct.challenge(best, (k47, 32));
        let best = ct.challenge(best, (k4, 28));
        let best = ct.challenge(best, (k87, 15));
        let best = ct.challenge(best, (k18, 12));
        let t23 = best.1 as u8;
        // Team 22
        let best = (k48, 19);
        let best = ct.challenge(best, (k10, 31));
        let best = ct.challenge(best, (k24, 25));
        let best = ct.challenge(best, (k45, 32));
        let best = ct.challenge(best, (k43, 32));
        let best = ct.challenge(best, (k18, 19));
        let t24 = best.1 as u8;
        // Team 32
        let best = (k72, 31);
        let best = ct.challenge(best, (k75, 32));
        let best = ct.challenge(best, (k76, 32));
        let best = ct.challenge(best, (k1, 34));
        let best = ct.challenge(best, (k27, 14));
        let best = ct.challenge(best, (k42, 22));
        let best = ct.challenge(best, (k10, 14));
        let best = ct.challenge(best, (k64, 26));
        let best = ct.challenge(best, (k18, 32));
        let best = ct.challenge(best, (k78, 32));
        let t25 = best.1 as u8;
        // Team 34
        let best = (k45, 32);
        let best = ct.challenge(best, (k64, 31));
        let best = ct.challenge(best, (k24, 29));
        let best = ct.challenge(best, (k18, 19));
        let best = ct.challenge(best, (k43, 32));
        let t26 = best.1 as u8;
        // Team 40
        let best = (k2, 31);
        let best = ct.challenge(best, (k37, 22));
        let best = ct.challenge(best, (k29, 34));
        let best = ct.challenge(best, (k18, 32));
        let best = ct.challenge(best, (k10, 31));
        let t27 = best.1 as u8;
        // Team 28
        let best = (k48, 19);
        let best = ct.challenge(best, (k4, 35));
        let best = ct.challenge(best, (k70, 17));
        let best = ct.challenge(best, (k64, 30));
        let best = ct.challenge(best, (k18, 27));
        let best = ct.challenge(best, (k83, 32));
        let t28 = best.1 as u8;
        // Team 35
        let best = (k88, 22);
        let best = ct.challenge(best, (k10, 31));
        let best = ct.challenge(best, (k18, 32));
        let best = ct.challenge(best, (k75, 32));
        let t29 = best.1 as u8;
        // Team 29
        let best = (k48, 19);
        let best = ct.challenge(best, (k4, 31));
        let best = ct.challenge(best, (k37, 15));
        let best = ct.challenge(best, (k45, 35));
        let best = ct.challenge(best, (k10, 31));
        let best = ct.challenge(best, (k18, 12));
        let best = ct.challenge(best, (k70, 17));
        let t30 = best.1 as u8;

        // An action leads to itself, and so does what fills the array up to a power of two: it is never come to.
        let next: [u8; 64] = [
            t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, t12, t13, t14, t15, t16, t17, t18,
            t19, t20, t21, t22, t23, t24, t25, t26, t27, t28, t29, t30, 31, 32, 33, 34, 35, 36, 37,
            38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59,
            60, 61, 62, 63,
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
