//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix widowx_rs --profile constant-time
//! Graph SHA-256: 4c66c6b65c6c713d5ad1fe31be297b7d3fcebbf6d3d7971a9a27b9132c25b11f
//! 30 teams (16 on the longest walk), 210 edges, 156 programs, 56 distinct operations.
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
/// - `s[0..4]`: stance, ticks, -4095 to 4095; -3072 to 3072; -3072 to 3072; -2046 to 2046
/// - `s[4..5]`: floor, mm, 0 to 606
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
    pub const STATE: usize = 5;
    /// Actions.
    pub const ACTIONS: usize = 8;
    /// Teams on the longest walk.
    pub const DEPTH: usize = 16;
    /// Bids that one decision looks at, at most.
    pub const WORST_BIDS: usize = 210;
    /// Operations of one decision, at most.
    pub const WORST_OPERATIONS: usize = 56;
    /// Sines, cosines, logarithms and exponentials among them, at most.
    pub const WORST_MATHS_CALLS: usize = 0;
    /// The sources that make up a state, in order.
    pub const SOURCES: [&str; 2] = ["stance", "floor"];
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

impl Policy for WidowxRs {
    type State = [f32; 5];
    type Action = ActionId;

    fn decide(&self, s: &[f32; 5]) -> ActionId {
        let ct = ConstantTime::<f32>::default();
        let v2 = s[0] / 0.0_f32;
        let v5 = s[1] / 9.539528_f32;
        let v6 = s[1] - 9.539528_f32;
        let v8 = f32::abs(s[2]);
        let v11 = 164.8815_f32 * s[3];
        let v13 = s[1] / 11.184899_f32;
        let v15 = s[1] / 0.0_f32;
        let v17 = -3.3748567_f32 - s[0];
        let v21 = ct.max(-161.71835_f32, s[2]);
        let v23 = -3.3748567_f32 - s[4];
        let v25 = -10.533181_f32 - s[4];
        let v27 = s[3] * -6.3484564_f32;
        let v28 = 0.0_f32 - s[4];
        let v29 = v17 * s[4];
        let v30 = s[3] / s[4];
        let v33 = ct.max(s[2], -3.385455_f32);
        let v34 = -6.3484564_f32 - s[3];
        let v35 = s[1] + 9.539528_f32;
        let v36 = ct.min(v17, s[4]);
        let v37 = ct.max(s[2], s[4]);
        let v38 = ct.max(s[4], 0.0_f32);
        let v39 = s[4] / 0.0_f32;
        let v41 = v39 * -72.49379_f32;
        let v42 = f32::abs(s[4]);
        let v43 = s[0] / v42;
        let v45 = s[1] * s[4];
        let v47 = f32::abs(s[3]);
        let v49 = s[0] / 11.077008_f32;
        let v51 = ct.negate_if_less(s[1], -26.200392_f32);
        let v52 = ct.max(s[1], s[4]);
        let v53 = ct.min(s[2], s[3]);
        let v55 = s[3] / 15.430052_f32;
        let v56 = s[1] / v42;
        let v58 = s[0] / 17.709658_f32;
        let v59 = 0.0_f32 * s[2];
        let v61 = s[1] - 9.689877_f32;
        let v64 = s[2] - 99.64715_f32;
        let v65 = s[2] + s[2];
        let v67 = ct.min(s[2], 213.59233_f32);
        let v68 = ct.max(s[0], 0.0_f32);
        let v69 = s[1] - s[4];
        let v71 = s[1] / 6.928064_f32;
        let v73 = -3.5602038_f32 - s[0];
        let v74 = s[4] * s[4];
        let v76 = s[1] / -9.539528_f32;
        let v77 = s[0] + s[4];
        let v78 = v77 / 9.539528_f32;
        let v79 = ct.negate_if_less(-3.3748567_f32, s[0]);
        let v80 = s[2] / v42;
        let v81 = s[4] - -22.172918_f32;
        let v82 = 9.539528_f32 + v81;
        let v83 = ct.max(s[2], 99.64715_f32);
        let v85 = -72.89382_f32 / s[4];
        let v87 = s[4] * -4.136917_f32;
        let v88 = f32::abs(s[0]);
        let v89 = s[1] / s[4];

        // What is bid, as integers in the same order.
        let k0 = -8388607_i32; // 0.0_f32
        let k2 = ct.order(v2);
        let k5 = ct.order(v5);
        let k6 = ct.order(v6);
        let k8 = ct.order(v8);
        let k10 = ct.order(s[3]);
        let k11 = ct.order(v11);
        let k13 = ct.order(v13);
        let k14 = 1085593448_i32; // 11.302588_f32
        let k15 = ct.order(v15);
        let k17 = ct.order(v17);
        let k18 = 1095171235_i32; // 24.873356_f32
        let k19 = 1074521978_i32; // 4.372006_f32
        let k21 = ct.order(v21);
        let k22 = ct.order(s[4]);
        let k23 = ct.order(v23);
        let k25 = ct.order(v25);
        let k27 = ct.order(v27);
        let k28 = ct.order(v28);
        let k29 = ct.order(v29);
        let k30 = ct.order(v30);
        let k31 = 1083710506_i32; // 9.506875_f32
        let k33 = ct.order(v33);
        let k34 = ct.order(v34);
        let k35 = ct.order(v35);
        let k36 = ct.order(v36);
        let k37 = ct.order(v37);
        let k38 = ct.order(v38);
        let k41 = ct.order(v41);
        let k42 = ct.order(v42);
        let k43 = ct.order(v43);
        let k44 = 1085221775_i32; // 10.948133_f32
        let k45 = ct.order(v45);
        let k46 = 1094146381_i32; // 22.918602_f32
        let k47 = ct.order(v47);
        let k49 = ct.order(v49);
        let k51 = ct.order(v51);
        let k52 = ct.order(v52);
        let k53 = ct.order(v53);
        let k55 = ct.order(v55);
        let k56 = ct.order(v56);
        let k58 = ct.order(v58);
        let k59 = ct.order(v59);
        let k61 = ct.order(v61);
        let k64 = ct.order(v64);
        let k65 = ct.order(v65);
        let k67 = ct.order(v67);
        let k68 = ct.order(v68);
        let k69 = ct.order(v69);
        let k71 = ct.order(v71);
        let k73 = ct.order(v73);
        let k74 = ct.order(v74);
        let k76 = ct.order(v76);
        let k78 = ct.order(v78);
        let k79 = ct.order(v79);
        let k80 = ct.order(v80);
        let k82 = ct.order(v82);
        let k83 = ct.order(v83);
        let k85 = ct.order(v85);
        let k87 = ct.order(v87);
        let k88 = ct.order(v88);
        let k89 = ct.order(v89);
        let k90 = 1080830793_i32; // 7.3802834_f32

        // Where each team leads: teams are numbered from 0, the root, and the actions follow them.
        // Team 0
        let best = (k5, 35);
        let best = ct.challenge(best, (k2, 1));
        let best = ct.challenge(best, (k6, 2));
        let best = ct.challenge(best, (k8, 3));
        let best = ct.challenge(best, (k11, 36));
        let best = ct.challenge(best, (k0, 32));
        let t0 = best.1 as u8;
        // Team 7
        let best = (k23, 36);
        let best = ct.challenge(best, (k6, 2));
        let best = ct.challenge(best, (k25, 4));
        let best = ct.challenge(best, (k28, 31));
        let best = ct.challenge(best, (k21, 34));
        let best = ct.challenge(best, (k0, 35));
        let best = ct.challenge(best, (k29, 31));
        let best = ct.challenge(best, (k27, 5));
        let best = ct.challenge(best, (k30, 6));
        let t1 = best.1 as u8;
        // Team 44
        let best = (k17, 31);
        let best = ct.challenge(best, (k2, 30));
        let best = ct.challenge(best, (k22, 32));
        let best = ct.challenge(best, (k31, 32));
        let t2 = best.1 as u8;
        // Team 5
        let best = (k27, 5);
        let best = ct.challenge(best, (k33, 36));
        let best = ct.challenge(best, (k2, 1));
        let best = ct.challenge(best, (k29, 31));
        let best = ct.challenge(best, (k34, 5));
        let best = ct.challenge(best, (k0, 2));
        let best = ct.challenge(best, (k23, 36));
        let best = ct.challenge(best, (k11, 36));
        let best = ct.challenge(best, (k13, 36));
        let t3 = best.1 as u8;
        // Team 11
        let best = (k13, 34);
        let best = ct.challenge(best, (k15, 6));
        let best = ct.challenge(best, (k11, 36));
        let best = ct.challenge(best, (k18, 7));
        let best = ct.challenge(best, (k17, 31));
        let best = ct.challenge(best, (k10, 37));
        let t4 = best.1 as u8;
        // Team 10
        let best = (k13, 34);
        let best = ct.challenge(best, (k61, 8));
        let best = ct.challenge(best, (k18, 7));
        let best = ct.challenge(best, (k43, 30));
        let best = ct.challenge(best, (k17, 9));
        let best = ct.challenge(best, (k28, 31));
        let best = ct.challenge(best, (k15, 6));
        let t5 = best.1 as u8;
        // Team 13
        let best = (k46, 10);
        let best = ct.challenge(best, (k47, 8));
        let best = ct.challenge(best, (k11, 36));
        let best = ct.challenge(best, (k35, 11));
        let best = ct.challenge(best, (k49, 12));
        let best = ct.challenge(best, (k2, 13));
        let best = ct.challenge(best, (k43, 14));
        let best = ct.challenge(best, (k17, 9));
        let best = ct.challenge(best, (k36, 31));
        let t6 = best.1 as u8;
        // Team 12
        let best = (k11, 36);
        let best = ct.challenge(best, (k15, 15));
        let best = ct.challenge(best, (k56, 30));
        let best = ct.challenge(best, (k17, 9));
        let best = ct.challenge(best, (k51, 33));
        let best = ct.challenge(best, (k5, 2));
        let best = ct.challenge(best, (k14, 16));
        let best = ct.challenge(best, (k28, 31));
        let t7 = best.1 as u8;
        // Team 32
        let best = (k17, 17);
        let best = ct.challenge(best, (k46, 37));
        let best = ct.challenge(best, (k2, 30));
        let best = ct.challenge(best, (k8, 18));
        let best = ct.challenge(best, (k35, 2));
        let best = ct.challenge(best, (k55, 36));
        let best = ct.challenge(best, (k5, 2));
        let t8 = best.1 as u8;
        // Team 45
        let best = (k51, 33);
        let best = ct.challenge(best, (k52, 31));
        let best = ct.challenge(best, (k2, 30));
        let best = ct.challenge(best, (k28, 31));
        let best = ct.challenge(best, (k5, 35));
        let best = ct.challenge(best, (k19, 31));
        let best = ct.challenge(best, (k53, 31));
        let t9 = best.1 as u8;
        // Team 41
        let best = (k37, 31);
        let best = ct.challenge(best, (k38, 19));
        let best = ct.challenge(best, (k41, 31));
        let best = ct.challenge(best, (k5, 2));
        let best = ct.challenge(best, (k43, 30));
        let best = ct.challenge(best, (k44, 16));
        let best = ct.challenge(best, (k2, 30));
        let t10 = best.1 as u8;
        // Team 14
        let best = (k13, 34);
        let best = ct.challenge(best, (k14, 16));
        let best = ct.challenge(best, (k28, 31));
        let best = ct.challenge(best, (k73, 31));
        let best = ct.challenge(best, (k45, 31));
        let best = ct.challenge(best, (k17, 31));
        let best = ct.challenge(best, (k11, 36));
        let best = ct.challenge(best, (k15, 15));
        let t11 = best.1 as u8;
        // Team 22
        let best = (k36, 31);
        let best = ct.challenge(best, (k8, 20));
        let best = ct.challenge(best, (k74, 8));
        let best = ct.challenge(best, (k17, 31));
        let best = ct.challenge(best, (k41, 33));
        let best = ct.challenge(best, (k46, 37));
        let best = ct.challenge(best, (k2, 13));
        let best = ct.challenge(best, (k11, 36));
        let best = ct.challenge(best, (k78, 37));
        let best = ct.challenge(best, (k69, 35));
        let t12 = best.1 as u8;
        // Team 23
        let best = (k71, 21);
        let best = ct.challenge(best, (k55, 33));
        let best = ct.challenge(best, (k43, 30));
        let best = ct.challenge(best, (k8, 22));
        let best = ct.challenge(best, (k46, 37));
        let best = ct.challenge(best, (k5, 2));
        let best = ct.challenge(best, (k21, 34));
        let t13 = best.1 as u8;
        // Team 35
        let best = (k36, 31);
        let best = ct.challenge(best, (k79, 31));
        let best = ct.challenge(best, (k65, 23));
        let best = ct.challenge(best, (k8, 24));
        let best = ct.challenge(best, (k2, 30));
        let best = ct.challenge(best, (k5, 2));
        let best = ct.challenge(best, (k0, 35));
        let t14 = best.1 as u8;
        // Team 16
        let best = (k42, 19);
        let best = ct.challenge(best, (k41, 33));
        let best = ct.challenge(best, (k69, 35));
        let best = ct.challenge(best, (k46, 10));
        let best = ct.challenge(best, (k45, 8));
        let best = ct.challenge(best, (k8, 20));
        let best = ct.challenge(best, (k11, 36));
        let best = ct.challenge(best, (k2, 25));
        let t15 = best.1 as u8;
        // Team 43
        let best = (k5, 35);
        let best = ct.challenge(best, (k2, 30));
        let best = ct.challenge(best, (k53, 31));
        let best = ct.challenge(best, (k68, 33));
        let t16 = best.1 as u8;
        // Team 38
        let best = (k65, 23);
        let best = ct.challenge(best, (k5, 2));
        let best = ct.challenge(best, (k47, 24));
        let best = ct.challenge(best, (k67, 37));
        let best = ct.challenge(best, (k56, 30));
        let best = ct.challenge(best, (k19, 31));
        let best = ct.challenge(best, (k17, 31));
        let best = ct.challenge(best, (k8, 16));
        let best = ct.challenge(best, (k35, 2));
        let t17 = best.1 as u8;
        // Team 33
        let best = (k80, 30);
        let best = ct.challenge(best, (k82, 26));
        let best = ct.challenge(best, (k83, 10));
        let best = ct.challenge(best, (k17, 9));
        let best = ct.challenge(best, (k85, 35));
        let t18 = best.1 as u8;
        // Team 42
        let best = (k2, 30);
        let best = ct.challenge(best, (k53, 31));
        let best = ct.challenge(best, (k17, 31));
        let best = ct.challenge(best, (k5, 2));
        let best = ct.challenge(best, (k0, 37));
        let best = ct.challenge(best, (k8, 16));
        let t19 = best.1 as u8;
        // Team 30
        let best = (k43, 30);
        let best = ct.challenge(best, (k78, 37));
        let best = ct.challenge(best, (k89, 21));
        let best = ct.challenge(best, (k64, 17));
        let best = ct.challenge(best, (k2, 30));
        let best = ct.challenge(best, (k8, 18));
        let best = ct.challenge(best, (k0, 35));
        let best = ct.challenge(best, (k17, 9));
        let best = ct.challenge(best, (k41, 27));
        let best = ct.challenge(best, (k5, 2));
        let t20 = best.1 as u8;
        // Team 37
        let best = (k2, 30);
        let best = ct.challenge(best, (k5, 2));
        let best = ct.challenge(best, (k19, 31));
        let best = ct.challenge(best, (k17, 31));
        let t21 = best.1 as u8;
        // Team 24
        let best = (k17, 17);
        let best = ct.challenge(best, (k46, 37));
        let best = ct.challenge(best, (k8, 18));
        let best = ct.challenge(best, (k55, 33));
        let best = ct.challenge(best, (k35, 2));
        let best = ct.challenge(best, (k2, 30));
        let t22 = best.1 as u8;
        // Team 40
        let best = (k5, 35);
        let best = ct.challenge(best, (k2, 30));
        let best = ct.challenge(best, (k17, 31));
        let best = ct.challenge(best, (k88, 31));
        let best = ct.challenge(best, (k53, 31));
        let best = ct.challenge(best, (k0, 33));
        let t23 = best.1 as u8;
        // Team 39
        let best = (k5, 35);
        let best = ct.challenge(best, (k17, 31));
        let best = ct.challenge(best, (k58, 30));
        let best = ct.challenge(best, (k53, 31));
        let best = ct.challenge(best, (k59, 32));
        let best = ct.challenge(best, (k8, 16));
        let best = ct.challenge(best, (k43, 30));
        let t24 = best.1 as u8;
        // Team 17
        let best = (k8, 14);
        let best = ct.challenge(best, (k5, 35));
        let best = ct.challenge(best, (k36, 31));
        let best = ct.challenge(best, (k46, 37));
        let best = ct.challenge(best, (k2, 13));
        let best = ct.challenge(best, (k74, 28));
        let best = ct.challenge(best, (k53, 31));
        let best = ct.challenge(best, (k76, 2));
        let t25 = best.1 as u8;
        // Team 34
        let best = (k87, 30);
        let best = ct.challenge(best, (k5, 2));
        let best = ct.challenge(best, (k0, 31));
        let best = ct.challenge(best, (k41, 31));
        let best = ct.challenge(best, (k42, 29));
        let best = ct.challenge(best, (k2, 30));
        let best = ct.challenge(best, (k35, 2));
        let best = ct.challenge(best, (k43, 14));
        let t26 = best.1 as u8;
        // Team 31
        let best = (k90, 35);
        let best = ct.challenge(best, (k8, 17));
        let best = ct.challenge(best, (k2, 30));
        let best = ct.challenge(best, (k35, 26));
        let t27 = best.1 as u8;
        // Team 18
        let best = (k46, 37);
        let best = ct.challenge(best, (k5, 33));
        let best = ct.challenge(best, (k36, 31));
        let best = ct.challenge(best, (k2, 13));
        let best = ct.challenge(best, (k74, 8));
        let best = ct.challenge(best, (k53, 31));
        let best = ct.challenge(best, (k76, 2));
        let best = ct.challenge(best, (k43, 18));
        let best = ct.challenge(best, (k8, 20));
        let best = ct.challenge(best, (k17, 31));
        let t28 = best.1 as u8;
        // Team 36
        let best = (k5, 35);
        let best = ct.challenge(best, (k0, 33));
        let best = ct.challenge(best, (k2, 30));
        let best = ct.challenge(best, (k53, 31));
        let t29 = best.1 as u8;

        // An action leads to itself, and so does what fills the array up to a power of two: it is never come to.
        let next: [u8; 64] = [
            t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, t12, t13, t14, t15, t16, t17, t18,
            t19, t20, t21, t22, t23, t24, t25, t26, t27, t28, t29, 30, 31, 32, 33, 34, 35, 36, 37,
            38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59,
            60, 61, 62, 63,
        ];
        // The longest walk decides 16 times; a shorter one waits at its action. No loop, and no end to check.
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
        ActionId(vertex.wrapping_sub(30) as u16)
    }
}
