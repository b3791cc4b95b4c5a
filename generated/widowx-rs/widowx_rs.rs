//! A policy for the WidowX arm from any pose, 97.4 % success in validation, trained by tpg-train 0.1.0 with seed 1.
//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix widowx_rs --profile constant-time
//! Graph SHA-256: c354d98892012e8559994649b02ad2e36c193c87e20be9aacffa833615cf752b
//! 30 teams (16 on the longest walk), 210 edges, 156 programs, 56 distinct operations.
//! A decision takes at most 210 bids and 56 operations.
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
    /// An action.
    pub const BASE_UP: ActionId = ActionId(0);
    /// An action.
    pub const BASE_DOWN: ActionId = ActionId(1);
    /// An action.
    pub const SHOULDER_UP: ActionId = ActionId(2);
    /// An action.
    pub const SHOULDER_DOWN: ActionId = ActionId(3);
    /// An action.
    pub const ELBOW_UP: ActionId = ActionId(4);
    /// An action.
    pub const ELBOW_DOWN: ActionId = ActionId(5);
    /// An action.
    pub const WRIST_UP: ActionId = ActionId(6);
    /// An action.
    pub const WRIST_DOWN: ActionId = ActionId(7);
    /// Teams on the longest walk.
    pub const DEPTH: usize = 16;
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
        let stance_0_term = -3.3748567_f32 - s[0];
        let floor_term = f32::abs(s[4]);

        // What is bid, as integers in the same order.
        let bid_10 = -8388607_i32; // 0.0_f32
        let bid_4 = ct.order(s[0] / 0.0_f32);
        let bid_2 = ct.order(s[1] / 9.539528_f32);
        let bid_5 = ct.order(s[1] - 9.539528_f32);
        let bid_6 = ct.order(f32::abs(s[2]));
        let bid_140 = ct.order(s[3]);
        let bid_7 = ct.order(164.8815_f32 * s[3]);
        let bid_72 = ct.order(s[1] / 11.184899_f32);
        let bid_150 = 1085593448_i32; // 11.302588_f32
        let bid_127 = ct.order(s[1] / 0.0_f32);
        let bid_348 = ct.order(stance_0_term);
        let bid_136 = 1095171235_i32; // 24.873356_f32
        let bid_48 = 1074521978_i32; // 4.372006_f32
        let bid_89 = ct.order(ct.max(-161.71835_f32, s[2]));
        let bid_350 = ct.order(s[4]);
        let bid_84 = ct.order(-3.3748567_f32 - s[4]);
        let bid_86 = ct.order(-10.533181_f32 - s[4]);
        let bid_92 = ct.order(-6.3484564_f32 * s[3]);
        let bid_87 = ct.order(0.0_f32 - s[4]);
        let bid_91 = ct.order(stance_0_term * s[4]);
        let bid_26 = ct.order(s[3] / s[4]);
        let bid_221 = 1083710506_i32; // 9.506875_f32
        let bid_61 = ct.order(ct.max(s[2], -3.385455_f32));
        let bid_67 = ct.order(-6.3484564_f32 - s[3]);
        let bid_52 = ct.order(s[1] + 9.539528_f32);
        let bid_21 = ct.order(ct.min(stance_0_term, s[4]));
        let bid_341 = ct.order(ct.max(s[2], s[4]));
        let bid_343 = ct.order(ct.max(s[4], 0.0_f32));
        let bid_315 = ct.order(-72.49379_f32 * (s[4] / 0.0_f32));
        let bid_172 = ct.order(floor_term);
        let bid_125 = ct.order(s[0] / floor_term);
        let bid_344 = 1085221775_i32; // 10.948133_f32
        let bid_159 = ct.order(s[1] * s[4]);
        let bid_32 = 1094146381_i32; // 22.918602_f32
        let bid_50 = ct.order(f32::abs(s[3]));
        let bid_152 = ct.order(s[0] / 11.077008_f32);
        let bid_148 = ct.order(ct.negate_if_less(s[1], -26.200392_f32));
        let bid_351 = ct.order(ct.max(s[1], s[4]));
        let bid_357 = ct.order(ct.min(s[2], s[3]));
        let bid_301 = ct.order(s[3] / 15.430052_f32);
        let bid_145 = ct.order(s[1] / floor_term);
        let bid_337 = ct.order(s[0] / 17.709658_f32);
        let bid_338 = ct.order(0.0_f32 * s[2]);
        let bid_120 = ct.order(s[1] - 9.689877_f32);
        let bid_289 = ct.order(s[2] - 99.64715_f32);
        let bid_319 = ct.order(s[2] + s[2]);
        let bid_332 = ct.order(ct.min(s[2], 213.59233_f32));
        let bid_347 = ct.order(ct.max(s[0], 0.0_f32));
        let bid_176 = ct.order(s[1] - s[4]);
        let bid_208 = ct.order(s[1] / 6.928064_f32);
        let bid_157 = ct.order(-3.5602038_f32 - s[0]);
        let bid_194 = ct.order(s[4] * s[4]);
        let bid_188 = ct.order(s[1] / -9.539528_f32);
        let bid_229 = ct.order((s[0] + s[4]) / 9.539528_f32);
        let bid_268 = ct.order(ct.negate_if_less(-3.3748567_f32, s[0]));
        let bid_303 = ct.order(s[2] / floor_term);
        let bid_304 = ct.order(s[4] + 22.172918_f32 + 9.539528_f32);
        let bid_305 = ct.order(ct.max(s[2], 99.64715_f32));
        let bid_306 = ct.order(-72.89382_f32 / s[4]);
        let bid_311 = ct.order(-4.136917_f32 * s[4]);
        let bid_340 = ct.order(f32::abs(s[0]));
        let bid_288 = ct.order(s[1] / s[4]);
        let bid_252 = 1080830793_i32; // 7.3802834_f32

        // Where each team leads: teams are numbered from 0, the root, and the actions follow them.
        // Team 0
        let best = (bid_2, 35);
        let best = ct.challenge(best, (bid_4, 1));
        let best = ct.challenge(best, (bid_5, 2));
        let best = ct.challenge(best, (bid_6, 3));
        let best = ct.challenge(best, (bid_7, 36));
        let best = ct.challenge(best, (bid_10, 32));
        let t0 = best.1 as u8;
        // Team 7
        let best = (bid_84, 36);
        let best = ct.challenge(best, (bid_5, 2));
        let best = ct.challenge(best, (bid_86, 4));
        let best = ct.challenge(best, (bid_87, 31));
        let best = ct.challenge(best, (bid_89, 34));
        let best = ct.challenge(best, (bid_10, 35));
        let best = ct.challenge(best, (bid_91, 31));
        let best = ct.challenge(best, (bid_92, 5));
        let best = ct.challenge(best, (bid_26, 6));
        let t1 = best.1 as u8;
        // Team 44
        let best = (bid_348, 31);
        let best = ct.challenge(best, (bid_4, 30));
        let best = ct.challenge(best, (bid_350, 32));
        let best = ct.challenge(best, (bid_221, 32));
        let t2 = best.1 as u8;
        // Team 5
        let best = (bid_92, 5);
        let best = ct.challenge(best, (bid_61, 36));
        let best = ct.challenge(best, (bid_4, 1));
        let best = ct.challenge(best, (bid_91, 31));
        let best = ct.challenge(best, (bid_67, 5));
        let best = ct.challenge(best, (bid_10, 2));
        let best = ct.challenge(best, (bid_84, 36));
        let best = ct.challenge(best, (bid_7, 36));
        let best = ct.challenge(best, (bid_72, 36));
        let t3 = best.1 as u8;
        // Team 11
        let best = (bid_72, 34);
        let best = ct.challenge(best, (bid_127, 6));
        let best = ct.challenge(best, (bid_7, 36));
        let best = ct.challenge(best, (bid_136, 7));
        let best = ct.challenge(best, (bid_348, 31));
        let best = ct.challenge(best, (bid_140, 37));
        let t4 = best.1 as u8;
        // Team 10
        let best = (bid_72, 34);
        let best = ct.challenge(best, (bid_120, 8));
        let best = ct.challenge(best, (bid_136, 7));
        let best = ct.challenge(best, (bid_125, 30));
        let best = ct.challenge(best, (bid_348, 9));
        let best = ct.challenge(best, (bid_87, 31));
        let best = ct.challenge(best, (bid_127, 6));
        let t5 = best.1 as u8;
        // Team 13
        let best = (bid_32, 10);
        let best = ct.challenge(best, (bid_50, 8));
        let best = ct.challenge(best, (bid_7, 36));
        let best = ct.challenge(best, (bid_52, 11));
        let best = ct.challenge(best, (bid_152, 12));
        let best = ct.challenge(best, (bid_4, 13));
        let best = ct.challenge(best, (bid_125, 14));
        let best = ct.challenge(best, (bid_348, 9));
        let best = ct.challenge(best, (bid_21, 31));
        let t6 = best.1 as u8;
        // Team 12
        let best = (bid_7, 36);
        let best = ct.challenge(best, (bid_127, 15));
        let best = ct.challenge(best, (bid_145, 30));
        let best = ct.challenge(best, (bid_348, 9));
        let best = ct.challenge(best, (bid_148, 33));
        let best = ct.challenge(best, (bid_2, 2));
        let best = ct.challenge(best, (bid_150, 16));
        let best = ct.challenge(best, (bid_87, 31));
        let t7 = best.1 as u8;
        // Team 32
        let best = (bid_348, 17);
        let best = ct.challenge(best, (bid_32, 37));
        let best = ct.challenge(best, (bid_4, 30));
        let best = ct.challenge(best, (bid_6, 18));
        let best = ct.challenge(best, (bid_52, 2));
        let best = ct.challenge(best, (bid_301, 36));
        let best = ct.challenge(best, (bid_2, 2));
        let t8 = best.1 as u8;
        // Team 45
        let best = (bid_148, 33);
        let best = ct.challenge(best, (bid_351, 31));
        let best = ct.challenge(best, (bid_4, 30));
        let best = ct.challenge(best, (bid_87, 31));
        let best = ct.challenge(best, (bid_2, 35));
        let best = ct.challenge(best, (bid_48, 31));
        let best = ct.challenge(best, (bid_357, 31));
        let t9 = best.1 as u8;
        // Team 41
        let best = (bid_341, 31);
        let best = ct.challenge(best, (bid_343, 19));
        let best = ct.challenge(best, (bid_315, 31));
        let best = ct.challenge(best, (bid_2, 2));
        let best = ct.challenge(best, (bid_125, 30));
        let best = ct.challenge(best, (bid_344, 16));
        let best = ct.challenge(best, (bid_4, 30));
        let t10 = best.1 as u8;
        // Team 14
        let best = (bid_72, 34);
        let best = ct.challenge(best, (bid_150, 16));
        let best = ct.challenge(best, (bid_87, 31));
        let best = ct.challenge(best, (bid_157, 31));
        let best = ct.challenge(best, (bid_159, 31));
        let best = ct.challenge(best, (bid_348, 31));
        let best = ct.challenge(best, (bid_7, 36));
        let best = ct.challenge(best, (bid_127, 15));
        let t11 = best.1 as u8;
        // Team 22
        let best = (bid_21, 31);
        let best = ct.challenge(best, (bid_6, 20));
        let best = ct.challenge(best, (bid_194, 8));
        let best = ct.challenge(best, (bid_348, 31));
        let best = ct.challenge(best, (bid_315, 33));
        let best = ct.challenge(best, (bid_32, 37));
        let best = ct.challenge(best, (bid_4, 13));
        let best = ct.challenge(best, (bid_7, 36));
        let best = ct.challenge(best, (bid_229, 37));
        let best = ct.challenge(best, (bid_176, 35));
        let t12 = best.1 as u8;
        // Team 23
        let best = (bid_208, 21);
        let best = ct.challenge(best, (bid_301, 33));
        let best = ct.challenge(best, (bid_125, 30));
        let best = ct.challenge(best, (bid_6, 22));
        let best = ct.challenge(best, (bid_32, 37));
        let best = ct.challenge(best, (bid_2, 2));
        let best = ct.challenge(best, (bid_89, 34));
        let t13 = best.1 as u8;
        // Team 35
        let best = (bid_21, 31);
        let best = ct.challenge(best, (bid_268, 31));
        let best = ct.challenge(best, (bid_319, 23));
        let best = ct.challenge(best, (bid_6, 24));
        let best = ct.challenge(best, (bid_4, 30));
        let best = ct.challenge(best, (bid_2, 2));
        let best = ct.challenge(best, (bid_10, 35));
        let t14 = best.1 as u8;
        // Team 16
        let best = (bid_172, 19);
        let best = ct.challenge(best, (bid_315, 33));
        let best = ct.challenge(best, (bid_176, 35));
        let best = ct.challenge(best, (bid_32, 10));
        let best = ct.challenge(best, (bid_159, 8));
        let best = ct.challenge(best, (bid_6, 20));
        let best = ct.challenge(best, (bid_7, 36));
        let best = ct.challenge(best, (bid_4, 25));
        let t15 = best.1 as u8;
        // Team 43
        let best = (bid_2, 35);
        let best = ct.challenge(best, (bid_4, 30));
        let best = ct.challenge(best, (bid_357, 31));
        let best = ct.challenge(best, (bid_347, 33));
        let t16 = best.1 as u8;
        // Team 38
        let best = (bid_319, 23);
        let best = ct.challenge(best, (bid_2, 2));
        let best = ct.challenge(best, (bid_50, 24));
        let best = ct.challenge(best, (bid_332, 37));
        let best = ct.challenge(best, (bid_145, 30));
        let best = ct.challenge(best, (bid_48, 31));
        let best = ct.challenge(best, (bid_348, 31));
        let best = ct.challenge(best, (bid_6, 16));
        let best = ct.challenge(best, (bid_52, 2));
        let t17 = best.1 as u8;
        // Team 33
        let best = (bid_303, 30);
        let best = ct.challenge(best, (bid_304, 26));
        let best = ct.challenge(best, (bid_305, 10));
        let best = ct.challenge(best, (bid_348, 9));
        let best = ct.challenge(best, (bid_306, 35));
        let t18 = best.1 as u8;
        // Team 42
        let best = (bid_4, 30);
        let best = ct.challenge(best, (bid_357, 31));
        let best = ct.challenge(best, (bid_348, 31));
        let best = ct.challenge(best, (bid_2, 2));
        let best = ct.challenge(best, (bid_10, 37));
        let best = ct.challenge(best, (bid_6, 16));
        let t19 = best.1 as u8;
        // Team 30
        let best = (bid_125, 30);
        let best = ct.challenge(best, (bid_229, 37));
        let best = ct.challenge(best, (bid_288, 21));
        let best = ct.challenge(best, (bid_289, 17));
        let best = ct.challenge(best, (bid_4, 30));
        let best = ct.challenge(best, (bid_6, 18));
        let best = ct.challenge(best, (bid_10, 35));
        let best = ct.challenge(best, (bid_348, 9));
        let best = ct.challenge(best, (bid_315, 27));
        let best = ct.challenge(best, (bid_2, 2));
        let t20 = best.1 as u8;
        // Team 37
        let best = (bid_4, 30);
        let best = ct.challenge(best, (bid_2, 2));
        let best = ct.challenge(best, (bid_48, 31));
        let best = ct.challenge(best, (bid_348, 31));
        let t21 = best.1 as u8;
        // Team 24
        let best = (bid_348, 17);
        let best = ct.challenge(best, (bid_32, 37));
        let best = ct.challenge(best, (bid_6, 18));
        let best = ct.challenge(best, (bid_301, 33));
        let best = ct.challenge(best, (bid_52, 2));
        let best = ct.challenge(best, (bid_4, 30));
        let t22 = best.1 as u8;
        // Team 40
        let best = (bid_2, 35);
        let best = ct.challenge(best, (bid_4, 30));
        let best = ct.challenge(best, (bid_348, 31));
        let best = ct.challenge(best, (bid_340, 31));
        let best = ct.challenge(best, (bid_357, 31));
        let best = ct.challenge(best, (bid_10, 33));
        let t23 = best.1 as u8;
        // Team 39
        let best = (bid_2, 35);
        let best = ct.challenge(best, (bid_348, 31));
        let best = ct.challenge(best, (bid_337, 30));
        let best = ct.challenge(best, (bid_357, 31));
        let best = ct.challenge(best, (bid_338, 32));
        let best = ct.challenge(best, (bid_6, 16));
        let best = ct.challenge(best, (bid_125, 30));
        let t24 = best.1 as u8;
        // Team 17
        let best = (bid_6, 14);
        let best = ct.challenge(best, (bid_2, 35));
        let best = ct.challenge(best, (bid_21, 31));
        let best = ct.challenge(best, (bid_32, 37));
        let best = ct.challenge(best, (bid_4, 13));
        let best = ct.challenge(best, (bid_194, 28));
        let best = ct.challenge(best, (bid_357, 31));
        let best = ct.challenge(best, (bid_188, 2));
        let t25 = best.1 as u8;
        // Team 34
        let best = (bid_311, 30);
        let best = ct.challenge(best, (bid_2, 2));
        let best = ct.challenge(best, (bid_10, 31));
        let best = ct.challenge(best, (bid_315, 31));
        let best = ct.challenge(best, (bid_172, 29));
        let best = ct.challenge(best, (bid_4, 30));
        let best = ct.challenge(best, (bid_52, 2));
        let best = ct.challenge(best, (bid_125, 14));
        let t26 = best.1 as u8;
        // Team 31
        let best = (bid_252, 35);
        let best = ct.challenge(best, (bid_6, 17));
        let best = ct.challenge(best, (bid_4, 30));
        let best = ct.challenge(best, (bid_52, 26));
        let t27 = best.1 as u8;
        // Team 18
        let best = (bid_32, 37);
        let best = ct.challenge(best, (bid_2, 33));
        let best = ct.challenge(best, (bid_21, 31));
        let best = ct.challenge(best, (bid_4, 13));
        let best = ct.challenge(best, (bid_194, 8));
        let best = ct.challenge(best, (bid_357, 31));
        let best = ct.challenge(best, (bid_188, 2));
        let best = ct.challenge(best, (bid_125, 18));
        let best = ct.challenge(best, (bid_6, 20));
        let best = ct.challenge(best, (bid_348, 31));
        let t28 = best.1 as u8;
        // Team 36
        let best = (bid_2, 35);
        let best = ct.challenge(best, (bid_10, 33));
        let best = ct.challenge(best, (bid_4, 30));
        let best = ct.challenge(best, (bid_357, 31));
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
