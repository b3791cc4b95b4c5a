//! A policy for the WidowX arm from any pose, 97.4 % success in validation, trained by tpg-train 0.1.0 with seed 1.
//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix widowx_rs_fast --profile fast
//! Graph SHA-256: c354d98892012e8559994649b02ad2e36c193c87e20be9aacffa833615cf752b
//! 30 teams (16 on the longest walk), 210 edges, 156 programs, 56 distinct operations.
//! A decision takes at most 118 bids and 118 operations.
//! Computes in f32 with own maths.
#![forbid(unsafe_code)]
#![allow(
    clippy::all,
    unused_variables,
    unused_assignments,
    reason = "evolved expressions need not make sense"
)]

use tpg_runtime::ops;
use tpg_runtime::policy::{ActionId, Policy};

/// A tangled program graph: expensive bids are computed only where they can win.
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
pub struct WidowxRsFast;

impl WidowxRsFast {
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

impl Policy for WidowxRsFast {
    type State = [f32; 5];
    type Action = ActionId;

    fn decide(&self, s: &[f32; 5]) -> ActionId {
        ActionId(team_0(s))
    }
}

/// What team 0 decides.
fn team_0(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 6;
    let elbow_down = s[1] / 9.539528_f32;
    if elbow_down >= best {
        best = elbow_down;
        next = 1;
    }
    let to_team_7 = s[0] / 0.0_f32;
    if to_team_7 >= best {
        best = to_team_7;
        next = 2;
    }
    let to_team_44 = s[1] - 9.539528_f32;
    if to_team_44 >= best {
        best = to_team_44;
        next = 3;
    }
    let to_team_5 = f32::abs(s[2]);
    if to_team_5 >= best {
        best = to_team_5;
        next = 4;
    }
    let wrist_up = 164.8815_f32 * s[3];
    if wrist_up >= best {
        best = wrist_up;
        next = 5;
    }
    if 0.0_f32 >= best {
        best = 0.0_f32;
        next = 6;
    }
    match next {
        1 => 5,
        2 => team_7(s),
        3 => team_44(s),
        4 => team_5(s),
        5 => 6,
        _ => 2,
    }
}

/// What team 7 decides.
fn team_7(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 8;
    let wrist_up = -3.3748567_f32 - s[4];
    if wrist_up >= best {
        best = wrist_up;
        next = 1;
    }
    let to_team_44 = s[1] - 9.539528_f32;
    if to_team_44 >= best {
        best = to_team_44;
        next = 2;
    }
    let to_team_11 = -10.533181_f32 - s[4];
    if to_team_11 >= best {
        best = to_team_11;
        next = 3;
    }
    let base_down = 0.0_f32 - s[4];
    if base_down >= best {
        best = base_down;
        next = 6;
    }
    let elbow_up = ops::max(-161.71835_f32, s[2]);
    if elbow_up >= best {
        best = elbow_up;
        next = 4;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        best = zero;
        next = 5;
    }
    let base_down_2 = (-3.3748567_f32 - s[0]) * s[4];
    if base_down_2 >= best {
        best = base_down_2;
        next = 6;
    }
    let to_team_10 = -6.3484564_f32 * s[3];
    if to_team_10 >= best {
        best = to_team_10;
        next = 7;
    }
    let to_team_13 = s[3] / s[4];
    if to_team_13 >= best {
        best = to_team_13;
        next = 8;
    }
    match next {
        1 => 6,
        2 => team_44(s),
        3 => team_11(s),
        4 => 4,
        5 => 5,
        6 => 1,
        7 => team_10(s),
        _ => team_13(s),
    }
}

/// What team 44 decides.
fn team_44(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut action = 2;
    let base_down = -3.3748567_f32 - s[0];
    if base_down >= best {
        best = base_down;
        action = 1;
    }
    let base_up = s[0] / 0.0_f32;
    if base_up >= best {
        best = base_up;
        action = 0;
    }
    if s[4] >= best {
        best = s[4];
        action = 2;
    }
    if 9.506875_f32 >= best {
        best = 9.506875_f32;
        action = 2;
    }
    action
}

/// What team 5 decides.
fn team_5(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 5;
    let to_team_10 = -6.3484564_f32 * s[3];
    if to_team_10 >= best {
        best = to_team_10;
        next = 3;
    }
    let wrist_up = ops::max(s[2], -3.385455_f32);
    if wrist_up >= best {
        best = wrist_up;
        next = 5;
    }
    let to_team_7 = s[0] / 0.0_f32;
    if to_team_7 >= best {
        best = to_team_7;
        next = 1;
    }
    let base_down = (-3.3748567_f32 - s[0]) * s[4];
    if base_down >= best {
        best = base_down;
        next = 2;
    }
    let to_team_10_2 = -6.3484564_f32 - s[3];
    if to_team_10_2 >= best {
        best = to_team_10_2;
        next = 3;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        best = zero;
        next = 4;
    }
    let wrist_up_2 = -3.3748567_f32 - s[4];
    if wrist_up_2 >= best {
        best = wrist_up_2;
        next = 5;
    }
    let wrist_up_3 = 164.8815_f32 * s[3];
    if wrist_up_3 >= best {
        best = wrist_up_3;
        next = 5;
    }
    let wrist_up_4 = s[1] / 11.184899_f32;
    if wrist_up_4 >= best {
        best = wrist_up_4;
        next = 5;
    }
    match next {
        1 => team_7(s),
        2 => 1,
        3 => team_10(s),
        4 => team_44(s),
        _ => 6,
    }
}

/// What team 11 decides.
fn team_11(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 6;
    let elbow_up = s[1] / 11.184899_f32;
    if elbow_up >= best {
        best = elbow_up;
        next = 1;
    }
    let to_team_13 = s[1] / 0.0_f32;
    if to_team_13 >= best {
        best = to_team_13;
        next = 2;
    }
    let wrist_up = 164.8815_f32 * s[3];
    if wrist_up >= best {
        best = wrist_up;
        next = 3;
    }
    if 24.873356_f32 >= best {
        best = 24.873356_f32;
        next = 4;
    }
    let base_down = -3.3748567_f32 - s[0];
    if base_down >= best {
        best = base_down;
        next = 5;
    }
    if s[3] >= best {
        best = s[3];
        next = 6;
    }
    match next {
        1 => 4,
        2 => team_13(s),
        3 => 6,
        4 => team_12(s),
        5 => 1,
        _ => 7,
    }
}

/// What team 10 decides.
fn team_10(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 7;
    let elbow_up = s[1] / 11.184899_f32;
    if elbow_up >= best {
        best = elbow_up;
        next = 1;
    }
    let to_team_32 = s[1] - 9.689877_f32;
    if to_team_32 >= best {
        best = to_team_32;
        next = 2;
    }
    if 24.873356_f32 >= best {
        best = 24.873356_f32;
        next = 3;
    }
    let base_up = s[0] / f32::abs(s[4]);
    if base_up >= best {
        best = base_up;
        next = 4;
    }
    let to_team_45 = -3.3748567_f32 - s[0];
    if to_team_45 >= best {
        best = to_team_45;
        next = 5;
    }
    let base_down = 0.0_f32 - s[4];
    if base_down >= best {
        best = base_down;
        next = 6;
    }
    let to_team_13 = s[1] / 0.0_f32;
    if to_team_13 >= best {
        best = to_team_13;
        next = 7;
    }
    match next {
        1 => 4,
        2 => team_32(s),
        3 => team_12(s),
        4 => 0,
        5 => team_45(s),
        6 => 1,
        _ => team_13(s),
    }
}

/// What team 13 decides.
fn team_13(s: &[f32; 5]) -> u16 {
    let mut best = 22.918602_f32;
    let mut next = 1;
    let to_team_32 = f32::abs(s[3]);
    if to_team_32 >= best {
        best = to_team_32;
        next = 2;
    }
    let wrist_up = 164.8815_f32 * s[3];
    if wrist_up >= best {
        best = wrist_up;
        next = 3;
    }
    let to_team_14 = s[1] + 9.539528_f32;
    if to_team_14 >= best {
        best = to_team_14;
        next = 4;
    }
    let to_team_22 = s[0] / 11.077008_f32;
    if to_team_22 >= best {
        best = to_team_22;
        next = 5;
    }
    let to_team_23 = s[0] / 0.0_f32;
    if to_team_23 >= best {
        best = to_team_23;
        next = 6;
    }
    let to_team_35 = s[0] / f32::abs(s[4]);
    if to_team_35 >= best {
        best = to_team_35;
        next = 7;
    }
    let to_team_45 = -3.3748567_f32 - s[0];
    if to_team_45 >= best {
        best = to_team_45;
        next = 8;
    }
    let base_down = ops::min(to_team_45, s[4]);
    if base_down >= best {
        best = base_down;
        next = 9;
    }
    match next {
        1 => team_41(s),
        2 => team_32(s),
        3 => 6,
        4 => team_14(s),
        5 => team_22(s),
        6 => team_23(s),
        7 => team_35(s),
        8 => team_45(s),
        _ => 1,
    }
}

/// What team 12 decides.
fn team_12(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 8;
    let wrist_up = 164.8815_f32 * s[3];
    if wrist_up >= best {
        best = wrist_up;
        next = 1;
    }
    let to_team_16 = s[1] / 0.0_f32;
    if to_team_16 >= best {
        best = to_team_16;
        next = 2;
    }
    let base_up = s[1] / f32::abs(s[4]);
    if base_up >= best {
        best = base_up;
        next = 3;
    }
    let to_team_45 = -3.3748567_f32 - s[0];
    if to_team_45 >= best {
        best = to_team_45;
        next = 4;
    }
    let shoulder_down = ops::negate_if_less(s[1], -26.200392_f32);
    if shoulder_down >= best {
        best = shoulder_down;
        next = 5;
    }
    let to_team_44 = s[1] / 9.539528_f32;
    if to_team_44 >= best {
        best = to_team_44;
        next = 6;
    }
    if 11.302588_f32 >= best {
        best = 11.302588_f32;
        next = 7;
    }
    let base_down = 0.0_f32 - s[4];
    if base_down >= best {
        best = base_down;
        next = 8;
    }
    match next {
        1 => 6,
        2 => team_16(s),
        3 => 0,
        4 => team_45(s),
        5 => 3,
        6 => team_44(s),
        7 => team_43(s),
        _ => 1,
    }
}

/// What team 32 decides.
fn team_32(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 6;
    let to_team_38 = -3.3748567_f32 - s[0];
    if to_team_38 >= best {
        best = to_team_38;
        next = 1;
    }
    if 22.918602_f32 >= best {
        best = 22.918602_f32;
        next = 2;
    }
    let base_up = s[0] / 0.0_f32;
    if base_up >= best {
        best = base_up;
        next = 3;
    }
    let to_team_33 = f32::abs(s[2]);
    if to_team_33 >= best {
        best = to_team_33;
        next = 4;
    }
    let to_team_44 = s[1] + 9.539528_f32;
    if to_team_44 >= best {
        best = to_team_44;
        next = 6;
    }
    let wrist_up = s[3] / 15.430052_f32;
    if wrist_up >= best {
        best = wrist_up;
        next = 5;
    }
    let to_team_44_2 = s[1] / 9.539528_f32;
    if to_team_44_2 >= best {
        best = to_team_44_2;
        next = 6;
    }
    match next {
        1 => team_38(s),
        2 => 7,
        3 => 0,
        4 => team_33(s),
        5 => 6,
        _ => team_44(s),
    }
}

/// What team 45 decides.
fn team_45(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut action = 1;
    let shoulder_down = ops::negate_if_less(s[1], -26.200392_f32);
    if shoulder_down >= best {
        best = shoulder_down;
        action = 3;
    }
    let base_down = ops::max(s[1], s[4]);
    if base_down >= best {
        best = base_down;
        action = 1;
    }
    let base_up = s[0] / 0.0_f32;
    if base_up >= best {
        best = base_up;
        action = 0;
    }
    let base_down_2 = 0.0_f32 - s[4];
    if base_down_2 >= best {
        best = base_down_2;
        action = 1;
    }
    let elbow_down = s[1] / 9.539528_f32;
    if elbow_down >= best {
        best = elbow_down;
        action = 5;
    }
    if 4.372006_f32 >= best {
        best = 4.372006_f32;
        action = 1;
    }
    let base_down_4 = ops::min(s[2], s[3]);
    if base_down_4 >= best {
        best = base_down_4;
        action = 1;
    }
    action
}

/// What team 41 decides.
fn team_41(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 5;
    let base_down = ops::max(s[2], s[4]);
    if base_down >= best {
        best = base_down;
        next = 2;
    }
    let to_team_42 = ops::max(s[4], 0.0_f32);
    if to_team_42 >= best {
        best = to_team_42;
        next = 1;
    }
    let base_down_2 = -72.49379_f32 * (s[4] / 0.0_f32);
    if base_down_2 >= best {
        best = base_down_2;
        next = 2;
    }
    let to_team_44 = s[1] / 9.539528_f32;
    if to_team_44 >= best {
        best = to_team_44;
        next = 3;
    }
    let base_up = s[0] / f32::abs(s[4]);
    if base_up >= best {
        best = base_up;
        next = 5;
    }
    if 10.948133_f32 >= best {
        best = 10.948133_f32;
        next = 4;
    }
    let base_up_2 = s[0] / 0.0_f32;
    if base_up_2 >= best {
        best = base_up_2;
        next = 5;
    }
    match next {
        1 => team_42(s),
        2 => 1,
        3 => team_44(s),
        4 => team_43(s),
        _ => 0,
    }
}

/// What team 14 decides.
fn team_14(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 5;
    let elbow_up = s[1] / 11.184899_f32;
    if elbow_up >= best {
        best = elbow_up;
        next = 1;
    }
    if 11.302588_f32 >= best {
        best = 11.302588_f32;
        next = 2;
    }
    let base_down = 0.0_f32 - s[4];
    if base_down >= best {
        best = base_down;
        next = 3;
    }
    let base_down_2 = -3.5602038_f32 - s[0];
    if base_down_2 >= best {
        best = base_down_2;
        next = 3;
    }
    let base_down_3 = s[1] * s[4];
    if base_down_3 >= best {
        best = base_down_3;
        next = 3;
    }
    let base_down_4 = -3.3748567_f32 - s[0];
    if base_down_4 >= best {
        best = base_down_4;
        next = 3;
    }
    let wrist_up = 164.8815_f32 * s[3];
    if wrist_up >= best {
        best = wrist_up;
        next = 4;
    }
    let to_team_16 = s[1] / 0.0_f32;
    if to_team_16 >= best {
        best = to_team_16;
        next = 5;
    }
    match next {
        1 => 4,
        2 => team_43(s),
        3 => 1,
        4 => 6,
        _ => team_16(s),
    }
}

/// What team 22 decides.
fn team_22(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 8;
    let base_down_2 = -3.3748567_f32 - s[0];
    let base_down = ops::min(base_down_2, s[4]);
    if base_down >= best {
        best = base_down;
        next = 3;
    }
    let to_team_30 = f32::abs(s[2]);
    if to_team_30 >= best {
        best = to_team_30;
        next = 1;
    }
    let to_team_32 = s[4] * s[4];
    if to_team_32 >= best {
        best = to_team_32;
        next = 2;
    }
    if base_down_2 >= best {
        best = base_down_2;
        next = 3;
    }
    let shoulder_down = -72.49379_f32 * (s[4] / 0.0_f32);
    if shoulder_down >= best {
        best = shoulder_down;
        next = 4;
    }
    if 22.918602_f32 >= best {
        best = 22.918602_f32;
        next = 7;
    }
    let to_team_23 = s[0] / 0.0_f32;
    if to_team_23 >= best {
        best = to_team_23;
        next = 5;
    }
    let wrist_up = 164.8815_f32 * s[3];
    if wrist_up >= best {
        best = wrist_up;
        next = 6;
    }
    let wrist_down_2 = (s[0] + s[4]) / 9.539528_f32;
    if wrist_down_2 >= best {
        best = wrist_down_2;
        next = 7;
    }
    let elbow_down = s[1] - s[4];
    if elbow_down >= best {
        best = elbow_down;
        next = 8;
    }
    match next {
        1 => team_30(s),
        2 => team_32(s),
        3 => 1,
        4 => 3,
        5 => team_23(s),
        6 => 6,
        7 => 7,
        _ => 5,
    }
}

/// What team 23 decides.
fn team_23(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 7;
    let to_team_37 = s[1] / 6.928064_f32;
    if to_team_37 >= best {
        best = to_team_37;
        next = 1;
    }
    let shoulder_down = s[3] / 15.430052_f32;
    if shoulder_down >= best {
        best = shoulder_down;
        next = 2;
    }
    let base_up = s[0] / f32::abs(s[4]);
    if base_up >= best {
        best = base_up;
        next = 3;
    }
    let to_team_24 = f32::abs(s[2]);
    if to_team_24 >= best {
        best = to_team_24;
        next = 4;
    }
    if 22.918602_f32 >= best {
        best = 22.918602_f32;
        next = 5;
    }
    let to_team_44 = s[1] / 9.539528_f32;
    if to_team_44 >= best {
        best = to_team_44;
        next = 6;
    }
    let elbow_up = ops::max(-161.71835_f32, s[2]);
    if elbow_up >= best {
        best = elbow_up;
        next = 7;
    }
    match next {
        1 => team_37(s),
        2 => 3,
        3 => 0,
        4 => team_24(s),
        5 => 7,
        6 => team_44(s),
        _ => 4,
    }
}

/// What team 35 decides.
fn team_35(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 6;
    let base_down = ops::min(-3.3748567_f32 - s[0], s[4]);
    if base_down >= best {
        best = base_down;
        next = 1;
    }
    let base_down_2 = ops::negate_if_less(-3.3748567_f32, s[0]);
    if base_down_2 >= best {
        best = base_down_2;
        next = 1;
    }
    let to_team_40 = s[2] + s[2];
    if to_team_40 >= best {
        best = to_team_40;
        next = 2;
    }
    let to_team_39 = f32::abs(s[2]);
    if to_team_39 >= best {
        best = to_team_39;
        next = 3;
    }
    let base_up = s[0] / 0.0_f32;
    if base_up >= best {
        best = base_up;
        next = 4;
    }
    let to_team_44 = s[1] / 9.539528_f32;
    if to_team_44 >= best {
        best = to_team_44;
        next = 5;
    }
    if 0.0_f32 >= best {
        best = 0.0_f32;
        next = 6;
    }
    match next {
        1 => 1,
        2 => team_40(s),
        3 => team_39(s),
        4 => 0,
        5 => team_44(s),
        _ => 5,
    }
}

/// What team 16 decides.
fn team_16(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 8;
    let to_team_42 = f32::abs(s[4]);
    if to_team_42 >= best {
        best = to_team_42;
        next = 1;
    }
    let shoulder_down = -72.49379_f32 * (s[4] / 0.0_f32);
    if shoulder_down >= best {
        best = shoulder_down;
        next = 2;
    }
    let elbow_down = s[1] - s[4];
    if elbow_down >= best {
        best = elbow_down;
        next = 3;
    }
    if 22.918602_f32 >= best {
        best = 22.918602_f32;
        next = 4;
    }
    let to_team_32 = s[1] * s[4];
    if to_team_32 >= best {
        best = to_team_32;
        next = 5;
    }
    let to_team_30 = f32::abs(s[2]);
    if to_team_30 >= best {
        best = to_team_30;
        next = 6;
    }
    let wrist_up = 164.8815_f32 * s[3];
    if wrist_up >= best {
        best = wrist_up;
        next = 7;
    }
    let to_team_17 = s[0] / 0.0_f32;
    if to_team_17 >= best {
        best = to_team_17;
        next = 8;
    }
    match next {
        1 => team_42(s),
        2 => 3,
        3 => 5,
        4 => team_41(s),
        5 => team_32(s),
        6 => team_30(s),
        7 => 6,
        _ => team_17(s),
    }
}

/// What team 43 decides.
fn team_43(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut action = 3;
    let elbow_down = s[1] / 9.539528_f32;
    if elbow_down >= best {
        best = elbow_down;
        action = 5;
    }
    let base_up = s[0] / 0.0_f32;
    if base_up >= best {
        best = base_up;
        action = 0;
    }
    let base_down = ops::min(s[2], s[3]);
    if base_down >= best {
        best = base_down;
        action = 1;
    }
    let shoulder_down = ops::max(s[0], 0.0_f32);
    if shoulder_down >= best {
        best = shoulder_down;
        action = 3;
    }
    action
}

/// What team 38 decides.
fn team_38(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 7;
    let to_team_40 = s[2] + s[2];
    if to_team_40 >= best {
        best = to_team_40;
        next = 1;
    }
    let to_team_44 = s[1] / 9.539528_f32;
    if to_team_44 >= best {
        best = to_team_44;
        next = 7;
    }
    let to_team_39 = f32::abs(s[3]);
    if to_team_39 >= best {
        best = to_team_39;
        next = 2;
    }
    let wrist_down = ops::min(s[2], 213.59233_f32);
    if wrist_down >= best {
        best = wrist_down;
        next = 3;
    }
    let base_up = s[1] / f32::abs(s[4]);
    if base_up >= best {
        best = base_up;
        next = 4;
    }
    if 4.372006_f32 >= best {
        best = 4.372006_f32;
        next = 5;
    }
    let base_down_2 = -3.3748567_f32 - s[0];
    if base_down_2 >= best {
        best = base_down_2;
        next = 5;
    }
    let to_team_43 = f32::abs(s[2]);
    if to_team_43 >= best {
        best = to_team_43;
        next = 6;
    }
    let to_team_44_2 = s[1] + 9.539528_f32;
    if to_team_44_2 >= best {
        best = to_team_44_2;
        next = 7;
    }
    match next {
        1 => team_40(s),
        2 => team_39(s),
        3 => 7,
        4 => 0,
        5 => 1,
        6 => team_43(s),
        _ => team_44(s),
    }
}

/// What team 33 decides.
fn team_33(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 5;
    let base_up = s[2] / f32::abs(s[4]);
    if base_up >= best {
        best = base_up;
        next = 1;
    }
    let to_team_34 = s[4] + 22.172918_f32 + 9.539528_f32;
    if to_team_34 >= best {
        best = to_team_34;
        next = 2;
    }
    let to_team_41 = ops::max(s[2], 99.64715_f32);
    if to_team_41 >= best {
        best = to_team_41;
        next = 3;
    }
    let to_team_45 = -3.3748567_f32 - s[0];
    if to_team_45 >= best {
        best = to_team_45;
        next = 4;
    }
    let elbow_down = -72.89382_f32 / s[4];
    if elbow_down >= best {
        best = elbow_down;
        next = 5;
    }
    match next {
        1 => 0,
        2 => team_34(s),
        3 => team_41(s),
        4 => team_45(s),
        _ => 5,
    }
}

/// What team 42 decides.
fn team_42(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 5;
    let base_up = s[0] / 0.0_f32;
    if base_up >= best {
        best = base_up;
        next = 1;
    }
    let base_down = ops::min(s[2], s[3]);
    if base_down >= best {
        best = base_down;
        next = 2;
    }
    let base_down_2 = -3.3748567_f32 - s[0];
    if base_down_2 >= best {
        best = base_down_2;
        next = 2;
    }
    let to_team_44 = s[1] / 9.539528_f32;
    if to_team_44 >= best {
        best = to_team_44;
        next = 3;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        best = zero;
        next = 4;
    }
    let to_team_43 = f32::abs(s[2]);
    if to_team_43 >= best {
        best = to_team_43;
        next = 5;
    }
    match next {
        1 => 0,
        2 => 1,
        3 => team_44(s),
        4 => 7,
        _ => team_43(s),
    }
}

/// What team 30 decides.
fn team_30(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 9;
    let base_up = s[0] / f32::abs(s[4]);
    if base_up >= best {
        best = base_up;
        next = 4;
    }
    let wrist_down = (s[0] + s[4]) / 9.539528_f32;
    if wrist_down >= best {
        best = wrist_down;
        next = 1;
    }
    let to_team_37 = s[1] / s[4];
    if to_team_37 >= best {
        best = to_team_37;
        next = 2;
    }
    let to_team_38 = s[2] - 99.64715_f32;
    if to_team_38 >= best {
        best = to_team_38;
        next = 3;
    }
    let base_up_2 = s[0] / 0.0_f32;
    if base_up_2 >= best {
        best = base_up_2;
        next = 4;
    }
    let to_team_33 = f32::abs(s[2]);
    if to_team_33 >= best {
        best = to_team_33;
        next = 5;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        best = zero;
        next = 6;
    }
    let to_team_45 = -3.3748567_f32 - s[0];
    if to_team_45 >= best {
        best = to_team_45;
        next = 7;
    }
    let to_team_31 = -72.49379_f32 * (s[4] / 0.0_f32);
    if to_team_31 >= best {
        best = to_team_31;
        next = 8;
    }
    let to_team_44 = s[1] / 9.539528_f32;
    if to_team_44 >= best {
        best = to_team_44;
        next = 9;
    }
    match next {
        1 => 7,
        2 => team_37(s),
        3 => team_38(s),
        4 => 0,
        5 => team_33(s),
        6 => 5,
        7 => team_45(s),
        8 => team_31(s),
        _ => team_44(s),
    }
}

/// What team 37 decides.
fn team_37(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 3;
    let base_up = s[0] / 0.0_f32;
    if base_up >= best {
        best = base_up;
        next = 1;
    }
    let to_team_44 = s[1] / 9.539528_f32;
    if to_team_44 >= best {
        best = to_team_44;
        next = 2;
    }
    if 4.372006_f32 >= best {
        best = 4.372006_f32;
        next = 3;
    }
    let base_down_2 = -3.3748567_f32 - s[0];
    if base_down_2 >= best {
        best = base_down_2;
        next = 3;
    }
    match next {
        1 => 0,
        2 => team_44(s),
        _ => 1,
    }
}

/// What team 24 decides.
fn team_24(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 6;
    let to_team_38 = -3.3748567_f32 - s[0];
    if to_team_38 >= best {
        best = to_team_38;
        next = 1;
    }
    if 22.918602_f32 >= best {
        best = 22.918602_f32;
        next = 2;
    }
    let to_team_33 = f32::abs(s[2]);
    if to_team_33 >= best {
        best = to_team_33;
        next = 3;
    }
    let shoulder_down = s[3] / 15.430052_f32;
    if shoulder_down >= best {
        best = shoulder_down;
        next = 4;
    }
    let to_team_44 = s[1] + 9.539528_f32;
    if to_team_44 >= best {
        best = to_team_44;
        next = 5;
    }
    let base_up = s[0] / 0.0_f32;
    if base_up >= best {
        best = base_up;
        next = 6;
    }
    match next {
        1 => team_38(s),
        2 => 7,
        3 => team_33(s),
        4 => 3,
        5 => team_44(s),
        _ => 0,
    }
}

/// What team 40 decides.
fn team_40(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut action = 3;
    let elbow_down = s[1] / 9.539528_f32;
    if elbow_down >= best {
        best = elbow_down;
        action = 5;
    }
    let base_up = s[0] / 0.0_f32;
    if base_up >= best {
        best = base_up;
        action = 0;
    }
    let base_down = -3.3748567_f32 - s[0];
    if base_down >= best {
        best = base_down;
        action = 1;
    }
    let base_down_2 = f32::abs(s[0]);
    if base_down_2 >= best {
        best = base_down_2;
        action = 1;
    }
    let base_down_3 = ops::min(s[2], s[3]);
    if base_down_3 >= best {
        best = base_down_3;
        action = 1;
    }
    if 0.0_f32 >= best {
        best = 0.0_f32;
        action = 3;
    }
    action
}

/// What team 39 decides.
fn team_39(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 5;
    let elbow_down = s[1] / 9.539528_f32;
    if elbow_down >= best {
        best = elbow_down;
        next = 1;
    }
    let base_down = -3.3748567_f32 - s[0];
    if base_down >= best {
        best = base_down;
        next = 2;
    }
    let base_up = s[0] / 17.709658_f32;
    if base_up >= best {
        best = base_up;
        next = 5;
    }
    let base_down_2 = ops::min(s[2], s[3]);
    if base_down_2 >= best {
        best = base_down_2;
        next = 2;
    }
    let shoulder_up = 0.0_f32 * s[2];
    if shoulder_up >= best {
        best = shoulder_up;
        next = 3;
    }
    let to_team_43 = f32::abs(s[2]);
    if to_team_43 >= best {
        best = to_team_43;
        next = 4;
    }
    let base_up_2 = s[0] / f32::abs(s[4]);
    if base_up_2 >= best {
        best = base_up_2;
        next = 5;
    }
    match next {
        1 => 5,
        2 => 1,
        3 => 2,
        4 => team_43(s),
        _ => 0,
    }
}

/// What team 17 decides.
fn team_17(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 7;
    let to_team_35 = f32::abs(s[2]);
    if to_team_35 >= best {
        best = to_team_35;
        next = 1;
    }
    let elbow_down = s[1] / 9.539528_f32;
    if elbow_down >= best {
        best = elbow_down;
        next = 2;
    }
    let base_down = ops::min(-3.3748567_f32 - s[0], s[4]);
    if base_down >= best {
        best = base_down;
        next = 6;
    }
    if 22.918602_f32 >= best {
        best = 22.918602_f32;
        next = 3;
    }
    let to_team_23 = s[0] / 0.0_f32;
    if to_team_23 >= best {
        best = to_team_23;
        next = 4;
    }
    let to_team_18 = s[4] * s[4];
    if to_team_18 >= best {
        best = to_team_18;
        next = 5;
    }
    let base_down_2 = ops::min(s[2], s[3]);
    if base_down_2 >= best {
        best = base_down_2;
        next = 6;
    }
    let to_team_44 = s[1] / -9.539528_f32;
    if to_team_44 >= best {
        best = to_team_44;
        next = 7;
    }
    match next {
        1 => team_35(s),
        2 => 5,
        3 => 7,
        4 => team_23(s),
        5 => team_18(s),
        6 => 1,
        _ => team_44(s),
    }
}

/// What team 34 decides.
fn team_34(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 5;
    let base_up = -4.136917_f32 * s[4];
    if base_up >= best {
        best = base_up;
        next = 3;
    }
    let to_team_44 = s[1] / 9.539528_f32;
    if to_team_44 >= best {
        best = to_team_44;
        next = 4;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        best = zero;
        next = 1;
    }
    let base_down_2 = -72.49379_f32 * (s[4] / 0.0_f32);
    if base_down_2 >= best {
        best = base_down_2;
        next = 1;
    }
    let to_team_36 = f32::abs(s[4]);
    if to_team_36 >= best {
        best = to_team_36;
        next = 2;
    }
    let base_up_2 = s[0] / 0.0_f32;
    if base_up_2 >= best {
        best = base_up_2;
        next = 3;
    }
    let to_team_44_2 = s[1] + 9.539528_f32;
    if to_team_44_2 >= best {
        best = to_team_44_2;
        next = 4;
    }
    let to_team_35 = s[0] / to_team_36;
    if to_team_35 >= best {
        best = to_team_35;
        next = 5;
    }
    match next {
        1 => 1,
        2 => team_36(s),
        3 => 0,
        4 => team_44(s),
        _ => team_35(s),
    }
}

/// What team 31 decides.
fn team_31(s: &[f32; 5]) -> u16 {
    let mut best = 7.3802834_f32;
    let mut next = 1;
    let to_team_38 = f32::abs(s[2]);
    if to_team_38 >= best {
        best = to_team_38;
        next = 2;
    }
    let base_up = s[0] / 0.0_f32;
    if base_up >= best {
        best = base_up;
        next = 3;
    }
    let to_team_34 = s[1] + 9.539528_f32;
    if to_team_34 >= best {
        best = to_team_34;
        next = 4;
    }
    match next {
        1 => 5,
        2 => team_38(s),
        3 => 0,
        _ => team_34(s),
    }
}

/// What team 18 decides.
fn team_18(s: &[f32; 5]) -> u16 {
    let mut best = 22.918602_f32;
    let mut next = 1;
    let shoulder_down = s[1] / 9.539528_f32;
    if shoulder_down >= best {
        best = shoulder_down;
        next = 2;
    }
    let base_down_3 = -3.3748567_f32 - s[0];
    let base_down = ops::min(base_down_3, s[4]);
    if base_down >= best {
        best = base_down;
        next = 8;
    }
    let to_team_23 = s[0] / 0.0_f32;
    if to_team_23 >= best {
        best = to_team_23;
        next = 3;
    }
    let to_team_32 = s[4] * s[4];
    if to_team_32 >= best {
        best = to_team_32;
        next = 4;
    }
    let base_down_2 = ops::min(s[2], s[3]);
    if base_down_2 >= best {
        best = base_down_2;
        next = 8;
    }
    let to_team_44 = s[1] / -9.539528_f32;
    if to_team_44 >= best {
        best = to_team_44;
        next = 5;
    }
    let to_team_33 = s[0] / f32::abs(s[4]);
    if to_team_33 >= best {
        best = to_team_33;
        next = 6;
    }
    let to_team_30 = f32::abs(s[2]);
    if to_team_30 >= best {
        best = to_team_30;
        next = 7;
    }
    if base_down_3 >= best {
        best = base_down_3;
        next = 8;
    }
    match next {
        1 => 7,
        2 => 3,
        3 => team_23(s),
        4 => team_32(s),
        5 => team_44(s),
        6 => team_33(s),
        7 => team_30(s),
        _ => 1,
    }
}

/// What team 36 decides.
fn team_36(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut action = 1;
    let elbow_down = s[1] / 9.539528_f32;
    if elbow_down >= best {
        best = elbow_down;
        action = 5;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        best = zero;
        action = 3;
    }
    let base_up = s[0] / 0.0_f32;
    if base_up >= best {
        best = base_up;
        action = 0;
    }
    let base_down = ops::min(s[2], s[3]);
    if base_down >= best {
        best = base_down;
        action = 1;
    }
    action
}
