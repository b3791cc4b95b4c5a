//! A policy for the WidowX arm from its home pose, 98.7 % success in validation, trained by tpg-train 0.1.0 with seed 1.
//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix widowx_fs_fast --profile fast
//! Graph SHA-256: e6794520ca2e312cdd2e5882de94ac2dc889564793be68cfa3b4c3c8774c71d2
//! 31 teams (18 on the longest walk), 188 edges, 153 programs, 52 distinct operations.
//! A decision takes at most 113 bids and 108 operations.
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
pub struct WidowxFsFast;

impl WidowxFsFast {
    /// Values of a state.
    pub const STATE: usize = 3;
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
    pub const DEPTH: usize = 18;
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

impl Policy for WidowxFsFast {
    type State = [f32; 3];
    type Action = ActionId;

    fn decide(&self, s: &[f32; 3]) -> ActionId {
        ActionId(team_0(s))
    }
}

/// What team 0 decides.
fn team_0(s: &[f32; 3]) -> u16 {
    let mut best = 107.35707_f32;
    let mut next = 1;
    let elbow_up = s[2] - 0.7582224_f32;
    if elbow_up >= best {
        best = elbow_up;
        next = 3;
    }
    let to_team_9 = 0.0_f32 - s[1];
    if to_team_9 >= best {
        best = to_team_9;
        next = 2;
    }
    let elbow_up_2 = elbow_up / 0.0_f32 / 0.0_f32;
    if elbow_up_2 >= best {
        best = elbow_up_2;
        next = 3;
    }
    let base_up = s[0] - 0.7582224_f32;
    if base_up >= best {
        best = base_up;
        next = 4;
    }
    match next {
        1 => team_1(s),
        2 => team_9(s),
        3 => 4,
        _ => 0,
    }
}

/// What team 1 decides.
fn team_1(s: &[f32; 3]) -> u16 {
    let mut best = 1.6245565_f32;
    let mut next = 1;
    let base_up = 0.0_f32 * s[2];
    if base_up >= best {
        best = base_up;
        next = 4;
    }
    let base_up_2 = ops::negate_if_less(s[0], 0.0_f32);
    if base_up_2 >= best {
        best = base_up_2;
        next = 4;
    }
    let to_team_9 = 0.0_f32 - s[1];
    if to_team_9 >= best {
        best = to_team_9;
        next = 2;
    }
    let base_down = -107.57004_f32 * s[0];
    if base_down >= best {
        best = base_down;
        next = 3;
    }
    let base_up_3 = s[0] - 0.7582224_f32;
    if base_up_3 >= best {
        best = base_up_3;
        next = 4;
    }
    let to_team_10 = -176.74728_f32 * s[1] - 0.52844894_f32;
    if to_team_10 >= best {
        best = to_team_10;
        next = 5;
    }
    match next {
        1 => team_7(s),
        2 => team_9(s),
        3 => 1,
        4 => 0,
        _ => team_10(s),
    }
}

/// What team 9 decides.
fn team_9(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 3;
    let to_team_12 = -176.74728_f32 * s[1] - 0.52844894_f32;
    if to_team_12 >= best {
        best = to_team_12;
        next = 1;
    }
    let elbow_up = s[2] - 0.7582224_f32;
    if elbow_up >= best {
        best = elbow_up;
        next = 3;
    }
    if 20.1483_f32 >= best {
        best = 20.1483_f32;
        next = 2;
    }
    let elbow_up_2 = s[2] + elbow_up;
    if elbow_up_2 >= best {
        best = elbow_up_2;
        next = 3;
    }
    match next {
        1 => team_12(s),
        2 => team_11(s),
        _ => 4,
    }
}

/// What team 7 decides.
fn team_7(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 6;
    let base_up = 0.7582224_f32 * s[0];
    if base_up >= best {
        best = base_up;
        next = 5;
    }
    let base_down = -107.57004_f32 * s[0];
    if base_down >= best {
        best = base_down;
        next = 1;
    }
    let shoulder_down = 42.029076_f32 / s[1];
    if shoulder_down >= best {
        best = shoulder_down;
        next = 2;
    }
    let to_team_10 = -176.74728_f32 * s[1] - 0.52844894_f32;
    if to_team_10 >= best {
        best = to_team_10;
        next = 3;
    }
    if 3.135279_f32 >= best {
        best = 3.135279_f32;
        next = 4;
    }
    let base_up_2 = s[0] - 0.7582224_f32;
    if base_up_2 >= best {
        best = base_up_2;
        next = 5;
    }
    let elbow_up = (s[2] - 0.7582224_f32) / 0.0_f32;
    if elbow_up >= best {
        best = elbow_up;
        next = 6;
    }
    match next {
        1 => 1,
        2 => 3,
        3 => team_10(s),
        4 => team_13(s),
        5 => 0,
        _ => 4,
    }
}

/// What team 10 decides.
fn team_10(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 6;
    let to_team_12 = -176.74728_f32 * s[1] - 0.52844894_f32;
    if to_team_12 >= best {
        best = to_team_12;
        next = 1;
    }
    let to_team_23 = -107.57004_f32 / s[2];
    if to_team_23 >= best {
        best = to_team_23;
        next = 2;
    }
    let elbow_up = s[2] - 0.7582224_f32;
    if elbow_up >= best {
        best = elbow_up;
        next = 3;
    }
    let base_up = s[0] - 0.7582224_f32;
    if base_up >= best {
        best = base_up;
        next = 4;
    }
    let base_down = -107.57004_f32 * s[0];
    if base_down >= best {
        best = base_down;
        next = 6;
    }
    let base_down_2 = 0.0_f32 / s[1];
    if base_down_2 >= best {
        best = base_down_2;
        next = 6;
    }
    if 20.1483_f32 >= best {
        best = 20.1483_f32;
        next = 5;
    }
    let base_down_3 = -79.08088_f32 * s[0];
    if base_down_3 >= best {
        best = base_down_3;
        next = 6;
    }
    match next {
        1 => team_12(s),
        2 => team_23(s),
        3 => 4,
        4 => 0,
        5 => team_11(s),
        _ => 1,
    }
}

/// What team 12 decides.
fn team_12(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 5;
    let to_team_20 = -117.26495_f32 - s[2];
    if to_team_20 >= best {
        best = to_team_20;
        next = 1;
    }
    let elbow_up = s[0] - 117.26495_f32;
    if elbow_up >= best {
        best = elbow_up;
        next = 4;
    }
    let base_up = s[0] - 0.7582224_f32;
    if base_up >= best {
        best = base_up;
        next = 2;
    }
    let to_team_36 = -107.57004_f32 * s[0];
    if to_team_36 >= best {
        best = to_team_36;
        next = 3;
    }
    let elbow_up_2 = s[2] - 0.7582224_f32;
    if elbow_up_2 >= best {
        best = elbow_up_2;
        next = 4;
    }
    if 26.139645_f32 >= best {
        best = 26.139645_f32;
        next = 5;
    }
    match next {
        1 => team_20(s),
        2 => 0,
        3 => team_36(s),
        4 => 4,
        _ => team_13(s),
    }
}

/// What team 11 decides.
fn team_11(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 5;
    let elbow_up = s[2] - 0.7582224_f32;
    if elbow_up >= best {
        best = elbow_up;
        next = 1;
    }
    let elbow_up_2 = s[2] - 0.75724316_f32;
    if elbow_up_2 >= best {
        best = elbow_up_2;
        next = 1;
    }
    let elbow_up_3 = s[2] - 117.26495_f32;
    if elbow_up_3 >= best {
        best = elbow_up_3;
        next = 1;
    }
    if 1.6245565_f32 >= best {
        best = 1.6245565_f32;
        next = 2;
    }
    let base_up = s[0] - 0.7258825_f32;
    if base_up >= best {
        best = base_up;
        next = 5;
    }
    let base_down = -79.08088_f32 * s[0];
    if base_down >= best {
        best = base_down;
        next = 3;
    }
    let to_team_30 = -107.57004_f32 * s[0];
    if to_team_30 >= best {
        best = to_team_30;
        next = 4;
    }
    let base_up_2 = s[0] - 0.7582224_f32;
    if base_up_2 >= best {
        best = base_up_2;
        next = 5;
    }
    match next {
        1 => 4,
        2 => team_15(s),
        3 => 1,
        4 => team_30(s),
        _ => 0,
    }
}

/// What team 13 decides.
fn team_13(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 6;
    let elbow_up = s[2] - 0.7582224_f32;
    if elbow_up >= best {
        best = elbow_up;
        next = 1;
    }
    let to_team_30 = -107.57004_f32 * s[0];
    if to_team_30 >= best {
        best = to_team_30;
        next = 2;
    }
    let base_up = s[0] - 0.7582224_f32;
    if base_up >= best {
        best = base_up;
        next = 6;
    }
    if 1.6245565_f32 >= best {
        best = 1.6245565_f32;
        next = 3;
    }
    let to_team_39 = s[1] / s[1];
    if to_team_39 >= best {
        best = to_team_39;
        next = 4;
    }
    let shoulder_down = s[1] - ops::max(0.0_f32, s[0]);
    if shoulder_down >= best {
        best = shoulder_down;
        next = 5;
    }
    let base_up_2 = s[0] - 1.0168722_f32;
    if base_up_2 >= best {
        best = base_up_2;
        next = 6;
    }
    match next {
        1 => 4,
        2 => team_30(s),
        3 => team_14(s),
        4 => team_39(s),
        5 => 3,
        _ => 0,
    }
}

/// What team 23 decides.
fn team_23(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 4;
    let elbow_up = s[2] - 0.7582224_f32;
    if elbow_up >= best {
        best = elbow_up;
        next = 1;
    }
    let to_team_38 = ops::negate_if_less(s[1], 229.17769_f32);
    if to_team_38 >= best {
        best = to_team_38;
        next = 2;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        best = zero;
        next = 3;
    }
    let to_team_37 = -107.57004_f32 * s[1];
    if to_team_37 >= best {
        best = to_team_37;
        next = 4;
    }
    match next {
        1 => 4,
        2 => team_38(s),
        3 => team_24(s),
        _ => team_37(s),
    }
}

/// What team 20 decides.
fn team_20(s: &[f32; 3]) -> u16 {
    let mut best = 10.629795_f32;
    let mut next = 1;
    let to_team_21 = ops::min(s[2], 110.01199_f32);
    if to_team_21 >= best {
        best = to_team_21;
        next = 2;
    }
    let base_up = s[0] - 0.7582224_f32;
    if base_up >= best {
        best = base_up;
        next = 5;
    }
    let base_down = -107.57004_f32 * s[0];
    if base_down >= best {
        best = base_down;
        next = 3;
    }
    let base_down_2 = -79.08088_f32 * s[0];
    if base_down_2 >= best {
        best = base_down_2;
        next = 3;
    }
    let to_team_42 = -107.57004_f32 / s[0];
    if to_team_42 >= best {
        best = to_team_42;
        next = 4;
    }
    let base_up_2 = s[2] - 0.7582224_f32;
    if base_up_2 >= best {
        best = base_up_2;
        next = 5;
    }
    match next {
        1 => team_38(s),
        2 => team_21(s),
        3 => 1,
        4 => team_42(s),
        _ => 0,
    }
}

/// What team 36 decides.
fn team_36(s: &[f32; 3]) -> u16 {
    let mut best = 2.5843248_f32;
    let mut next = 1;
    let base_down = -107.57004_f32 * s[0];
    if base_down >= best {
        best = base_down;
        next = 2;
    }
    let base_up = s[0] - 0.7582224_f32;
    if base_up >= best {
        best = base_up;
        next = 3;
    }
    if s[1] >= best {
        best = s[1];
        next = 4;
    }
    match next {
        1 => team_39(s),
        2 => 1,
        3 => 0,
        _ => 3,
    }
}

/// What team 15 decides.
fn team_15(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 4;
    let to_team_23 = -107.57004_f32 / s[0];
    if to_team_23 >= best {
        best = to_team_23;
        next = 1;
    }
    let shoulder_up = s[2] - 0.7582224_f32;
    let elbow_up = ops::max(s[2], shoulder_up);
    if elbow_up >= best {
        best = elbow_up;
        next = 2;
    }
    if shoulder_up >= best {
        best = shoulder_up;
        next = 3;
    }
    if f32::INFINITY >= best {
        best = f32::INFINITY;
        next = 4;
    }
    match next {
        1 => team_23(s),
        2 => 4,
        3 => 2,
        _ => team_17(s),
    }
}

/// What team 30 decides.
fn team_30(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 6;
    let base_down = -79.08088_f32 * s[0];
    if base_down >= best {
        best = base_down;
        next = 6;
    }
    let base_up = s[0] - 0.6354382_f32;
    if base_up >= best {
        best = base_up;
        next = 2;
    }
    let elbow_up = s[0] - 5.963282_f32;
    if elbow_up >= best {
        best = elbow_up;
        next = 1;
    }
    let base_up_2 = s[0] - 0.7582224_f32;
    if base_up_2 >= best {
        best = base_up_2;
        next = 2;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        best = zero;
        next = 3;
    }
    let to_team_41 = -176.74728_f32 * s[2];
    if to_team_41 >= best {
        best = to_team_41;
        next = 4;
    }
    let to_team_42 = -107.57004_f32 / s[0];
    if to_team_42 >= best {
        best = to_team_42;
        next = 5;
    }
    let base_down_2 = -107.57004_f32 * s[0];
    if base_down_2 >= best {
        best = base_down_2;
        next = 6;
    }
    match next {
        1 => 4,
        2 => 0,
        3 => team_31(s),
        4 => team_41(s),
        5 => team_42(s),
        _ => 1,
    }
}

/// What team 14 decides.
fn team_14(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 4;
    let elbow_up = s[2] - 0.7582224_f32;
    if elbow_up >= best {
        best = elbow_up;
        next = 1;
    }
    let to_team_30 = -107.57004_f32 * s[0];
    if to_team_30 >= best {
        best = to_team_30;
        next = 2;
    }
    let to_team_24 = s[1] / 0.0_f32;
    if to_team_24 >= best {
        best = to_team_24;
        next = 3;
    }
    if 1.6245565_f32 >= best {
        best = 1.6245565_f32;
        next = 4;
    }
    match next {
        1 => 4,
        2 => team_30(s),
        3 => team_24(s),
        _ => team_15(s),
    }
}

/// What team 39 decides.
fn team_39(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut action = 5;
    let wrist_up = f32::abs(ops::max(s[1], 0.0_f32));
    if wrist_up >= best {
        best = wrist_up;
        action = 6;
    }
    let base_up = ops::min(s[0], s[1]);
    if base_up >= best {
        best = base_up;
        action = 0;
    }
    if 0.0_f32 >= best {
        best = 0.0_f32;
        action = 5;
    }
    action
}

/// What team 38 decides.
fn team_38(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 5;
    let base_up = s[0] / 0.6354382_f32;
    if base_up >= best {
        best = base_up;
        next = 4;
    }
    let base_up_2 = s[0] - 0.7582224_f32;
    if base_up_2 >= best {
        best = base_up_2;
        next = 4;
    }
    let to_team_41 = -176.74728_f32 * s[2] / s[1];
    if to_team_41 >= best {
        best = to_team_41;
        next = 1;
    }
    if 2.5843248_f32 >= best {
        best = 2.5843248_f32;
        next = 2;
    }
    let base_down = s[2] - 117.26495_f32;
    if base_down >= best {
        best = base_down;
        next = 3;
    }
    if s[0] >= best {
        best = s[0];
        next = 4;
    }
    let to_team_42 = -107.57004_f32 * s[0];
    if to_team_42 >= best {
        best = to_team_42;
        next = 5;
    }
    match next {
        1 => team_41(s),
        2 => team_39(s),
        3 => 1,
        4 => 0,
        _ => team_42(s),
    }
}

/// What team 24 decides.
fn team_24(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 6;
    let to_team_27 = s[2] - 0.7582224_f32;
    if to_team_27 >= best {
        best = to_team_27;
        next = 1;
    }
    let to_team_38 = ops::negate_if_less(s[1], 229.17769_f32);
    if to_team_38 >= best {
        best = to_team_38;
        next = 5;
    }
    let base_down = s[2] - 117.26495_f32;
    if base_down >= best {
        best = base_down;
        next = 6;
    }
    let shoulder_down = s[1] - ops::max(0.0_f32, s[0]);
    if shoulder_down >= best {
        best = shoulder_down;
        next = 2;
    }
    let base_up = s[0] - 0.7582224_f32;
    if base_up >= best {
        best = base_up;
        next = 3;
    }
    let to_team_42 = -107.57004_f32 / s[0];
    if to_team_42 >= best {
        best = to_team_42;
        next = 4;
    }
    if 10.629795_f32 >= best {
        best = 10.629795_f32;
        next = 5;
    }
    let base_down_2 = -79.08088_f32 * s[0];
    if base_down_2 >= best {
        best = base_down_2;
        next = 6;
    }
    match next {
        1 => team_27(s),
        2 => 3,
        3 => 0,
        4 => team_42(s),
        5 => team_38(s),
        _ => 1,
    }
}

/// What team 37 decides.
fn team_37(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 5;
    let base_down = -79.08088_f32 * s[0];
    if base_down >= best {
        best = base_down;
        next = 3;
    }
    let base_up = s[0] - 0.6354382_f32;
    if base_up >= best {
        best = base_up;
        next = 1;
    }
    let to_team_42 = -107.57004_f32 * s[0];
    if to_team_42 >= best {
        best = to_team_42;
        next = 2;
    }
    let base_down_2 = s[2] - 117.26495_f32;
    if base_down_2 >= best {
        best = base_down_2;
        next = 3;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        best = zero;
        next = 5;
    }
    let to_team_41 = 0.87870044_f32 * s[0];
    if to_team_41 >= best {
        best = to_team_41;
        next = 4;
    }
    let shoulder_down_2 = s[1] - ops::max(0.0_f32, s[0]);
    if shoulder_down_2 >= best {
        best = shoulder_down_2;
        next = 5;
    }
    match next {
        1 => 0,
        2 => team_42(s),
        3 => 1,
        4 => team_41(s),
        _ => 3,
    }
}

/// What team 21 decides.
fn team_21(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 5;
    let to_team_22 = ops::negate_if_less(s[1], -1.1606317_f32);
    if to_team_22 >= best {
        best = to_team_22;
        next = 1;
    }
    if 15.754999_f32 >= best {
        best = 15.754999_f32;
        next = 2;
    }
    let to_team_37 = -107.57004_f32 * s[1];
    if to_team_37 >= best {
        best = to_team_37;
        next = 3;
    }
    let base_up = s[0] - 0.7582224_f32;
    if base_up >= best {
        best = base_up;
        next = 4;
    }
    let to_team_42 = -107.57004_f32 * s[0];
    if to_team_42 >= best {
        best = to_team_42;
        next = 5;
    }
    match next {
        1 => team_22(s),
        2 => team_32(s),
        3 => team_37(s),
        4 => 0,
        _ => team_42(s),
    }
}

/// What team 42 decides.
fn team_42(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut action = 1;
    let base_down = 0.0_f32 / s[1];
    if base_down >= best {
        best = base_down;
        action = 1;
    }
    if s[0] >= best {
        best = s[0];
        action = 0;
    }
    let base_up_2 = ops::min(-8.893463_f32, s[1]);
    if base_up_2 >= best {
        best = base_up_2;
        action = 0;
    }
    if s[1] >= best {
        best = s[1];
        action = 3;
    }
    let base_down_2 = -107.57004_f32 * s[0];
    if base_down_2 >= best {
        best = base_down_2;
        action = 1;
    }
    action
}

/// What team 17 decides.
fn team_17(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 6;
    let shoulder_up = s[2] + 6.7057414_f32;
    if shoulder_up >= best {
        best = shoulder_up;
        next = 4;
    }
    if 6.543999_f32 >= best {
        best = 6.543999_f32;
        next = 1;
    }
    let to_team_24 = s[1] / 0.0_f32;
    if to_team_24 >= best {
        best = to_team_24;
        next = 2;
    }
    let base_down = -79.08088_f32 * s[0];
    if base_down >= best {
        best = base_down;
        next = 5;
    }
    let to_team_42 = -107.57004_f32 / s[0];
    if to_team_42 >= best {
        best = to_team_42;
        next = 3;
    }
    let shoulder_up_2 = s[2] - 0.7582224_f32;
    if shoulder_up_2 >= best {
        best = shoulder_up_2;
        next = 4;
    }
    let base_down_2 = -107.57004_f32 * s[0];
    if base_down_2 >= best {
        best = base_down_2;
        next = 5;
    }
    let base_up = s[0] - 0.7582224_f32;
    if base_up >= best {
        best = base_up;
        next = 6;
    }
    match next {
        1 => 7,
        2 => team_24(s),
        3 => team_42(s),
        4 => 2,
        5 => 1,
        _ => 0,
    }
}

/// What team 31 decides.
fn team_31(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 6;
    let base_down = 2.710111_f32 / (0.0_f32 - s[0]);
    if base_down >= best {
        best = base_down;
        next = 1;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        best = zero;
        next = 5;
    }
    let to_team_39 = s[1] / s[1];
    if to_team_39 >= best {
        best = to_team_39;
        next = 2;
    }
    let to_team_41 = -176.74728_f32 * s[2] / s[1];
    if to_team_41 >= best {
        best = to_team_41;
        next = 3;
    }
    let to_team_34 = s[0] - 0.6354382_f32;
    if to_team_34 >= best {
        best = to_team_34;
        next = 4;
    }
    let base_up_2 = s[0] - 0.7582224_f32;
    if base_up_2 >= best {
        best = base_up_2;
        next = 5;
    }
    let to_team_42 = -107.57004_f32 * s[0];
    if to_team_42 >= best {
        best = to_team_42;
        next = 6;
    }
    match next {
        1 => 1,
        2 => team_39(s),
        3 => team_41(s),
        4 => team_34(s),
        5 => 0,
        _ => team_42(s),
    }
}

/// What team 41 decides.
fn team_41(s: &[f32; 3]) -> u16 {
    let zero = core::hint::black_box(0.0_f32);
    let mut best = zero;
    let mut action = 3;
    let base_up = s[0] - 0.7582224_f32;
    if base_up >= best {
        best = base_up;
        action = 0;
    }
    let elbow_down = -55.687565_f32 * s[1];
    if elbow_down >= best {
        best = elbow_down;
        action = 5;
    }
    let base_down = -107.57004_f32 * s[0];
    if base_down >= best {
        best = base_down;
        action = 1;
    }
    action
}

/// What team 27 decides.
fn team_27(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 7;
    let to_team_42 = -107.57004_f32 / s[0];
    if to_team_42 >= best {
        best = to_team_42;
        next = 1;
    }
    let base_up = s[0] - 0.7582224_f32;
    if base_up >= best {
        best = base_up;
        next = 2;
    }
    let to_team_40 = -79.08088_f32 - s[0];
    if to_team_40 >= best {
        best = to_team_40;
        next = 3;
    }
    let base_down = -79.08088_f32 * s[0];
    if base_down >= best {
        best = base_down;
        next = 4;
    }
    let base_down_2 = 0.0_f32 / s[1];
    if base_down_2 >= best {
        best = base_down_2;
        next = 4;
    }
    let to_team_28 = s[2] - 0.7582224_f32;
    if to_team_28 >= best {
        best = to_team_28;
        next = 5;
    }
    if 13.937786_f32 >= best {
        best = 13.937786_f32;
        next = 6;
    }
    let to_team_30 = -107.57004_f32 * s[0];
    if to_team_30 >= best {
        best = to_team_30;
        next = 7;
    }
    match next {
        1 => team_42(s),
        2 => 0,
        3 => team_40(s),
        4 => 1,
        5 => team_28(s),
        6 => team_38(s),
        _ => team_30(s),
    }
}

/// What team 22 decides.
fn team_22(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 4;
    let to_team_42 = -107.57004_f32 / s[0];
    if to_team_42 >= best {
        best = to_team_42;
        next = 4;
    }
    let base_up = s[0] - 0.7582224_f32;
    if base_up >= best {
        best = base_up;
        next = 1;
    }
    if 15.754999_f32 >= best {
        best = 15.754999_f32;
        next = 2;
    }
    let base_down = -79.08088_f32 * s[0];
    if base_down >= best {
        best = base_down;
        next = 3;
    }
    let base_down_2 = s[2] - 117.26495_f32;
    if base_down_2 >= best {
        best = base_down_2;
        next = 3;
    }
    let to_team_42_2 = -107.57004_f32 * s[0];
    if to_team_42_2 >= best {
        best = to_team_42_2;
        next = 4;
    }
    match next {
        1 => 0,
        2 => team_32(s),
        3 => 1,
        _ => team_42(s),
    }
}

/// What team 32 decides.
fn team_32(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 6;
    let base_up = 0.87870044_f32 * s[0];
    if base_up >= best {
        best = base_up;
        next = 1;
    }
    let base_down = 2.710111_f32 / (s[2] * s[0] - s[0]);
    if base_down >= best {
        best = base_down;
        next = 6;
    }
    let base_down_2 = s[0] - 107.57004_f32;
    if base_down_2 >= best {
        best = base_down_2;
        next = 6;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        best = zero;
        next = 2;
    }
    let to_team_39 = s[1] / s[1];
    if to_team_39 >= best {
        best = to_team_39;
        next = 4;
    }
    let to_team_41 = -176.74728_f32 * s[2] / s[1];
    if to_team_41 >= best {
        best = to_team_41;
        next = 3;
    }
    let to_team_39_2 = s[0] - 0.7582224_f32;
    if to_team_39_2 >= best {
        best = to_team_39_2;
        next = 4;
    }
    let to_team_34 = s[0] - 0.6354382_f32;
    if to_team_34 >= best {
        best = to_team_34;
        next = 5;
    }
    let base_down_3 = -107.57004_f32 * s[0];
    if base_down_3 >= best {
        best = base_down_3;
        next = 6;
    }
    let base_down_4 = 0.18706028_f32 * s[0];
    if base_down_4 >= best {
        best = base_down_4;
        next = 6;
    }
    match next {
        1 => 0,
        2 => 3,
        3 => team_41(s),
        4 => team_39(s),
        5 => team_34(s),
        _ => 1,
    }
}

/// What team 34 decides.
fn team_34(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 4;
    let base_down = -79.08088_f32 * s[0];
    if base_down >= best {
        best = base_down;
        next = 4;
    }
    let base_up = s[0] - 0.6354382_f32;
    if base_up >= best {
        best = base_up;
        next = 1;
    }
    if 15.754999_f32 >= best {
        best = 15.754999_f32;
        next = 2;
    }
    let to_team_42 = -107.57004_f32 * s[0];
    if to_team_42 >= best {
        best = to_team_42;
        next = 3;
    }
    let base_down_2 = s[2] - 117.26495_f32;
    if base_down_2 >= best {
        best = base_down_2;
        next = 4;
    }
    match next {
        1 => 0,
        2 => team_35(s),
        3 => team_42(s),
        _ => 1,
    }
}

/// What team 40 decides.
fn team_40(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 4;
    if s[2] >= best {
        best = s[2];
        next = 4;
    }
    if 10.629795_f32 >= best {
        best = 10.629795_f32;
        next = 1;
    }
    let shoulder_down = s[1] - ops::max(0.0_f32, s[0]);
    if shoulder_down >= best {
        best = shoulder_down;
        next = 2;
    }
    let base_down = -107.57004_f32 * s[0];
    if base_down >= best {
        best = base_down;
        next = 3;
    }
    let base_up_2 = s[0] - 0.7582224_f32;
    if base_up_2 >= best {
        best = base_up_2;
        next = 4;
    }
    match next {
        1 => team_41(s),
        2 => 3,
        3 => 1,
        _ => 0,
    }
}

/// What team 28 decides.
fn team_28(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 6;
    let to_team_42 = -107.57004_f32 / s[0];
    if to_team_42 >= best {
        best = to_team_42;
        next = 1;
    }
    let elbow_up = s[2] - 0.7582224_f32;
    if elbow_up >= best {
        best = elbow_up;
        next = 2;
    }
    let to_team_37 = -107.57004_f32 * s[1];
    if to_team_37 >= best {
        best = to_team_37;
        next = 3;
    }
    let to_team_29 = s[0] - 0.6354382_f32;
    if to_team_29 >= best {
        best = to_team_29;
        next = 4;
    }
    let to_team_40 = -107.57004_f32 * s[0];
    if to_team_40 >= best {
        best = to_team_40;
        next = 5;
    }
    let base_down = 2.710111_f32 / (0.0_f32 - s[0]);
    if base_down >= best {
        best = base_down;
        next = 6;
    }
    match next {
        1 => team_42(s),
        2 => 4,
        3 => team_37(s),
        4 => team_29(s),
        5 => team_40(s),
        _ => 1,
    }
}

/// What team 35 decides.
fn team_35(s: &[f32; 3]) -> u16 {
    let mut best = 83.54613_f32;
    let mut next = 1;
    let base_up = s[0] - 0.7582224_f32;
    if base_up >= best {
        best = base_up;
        next = 2;
    }
    let base_down = -107.57004_f32 * s[0];
    if base_down >= best {
        best = base_down;
        next = 3;
    }
    let base_down_2 = 2.710111_f32 / (s[2] * s[0] - s[0]);
    if base_down_2 >= best {
        best = base_down_2;
        next = 3;
    }
    match next {
        1 => team_41(s),
        2 => 0,
        _ => 1,
    }
}

/// What team 29 decides.
fn team_29(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut next = 6;
    let to_team_42 = -107.57004_f32 / s[0];
    if to_team_42 >= best {
        best = to_team_42;
        next = 1;
    }
    let base_up = s[2] - 0.7582224_f32;
    if base_up >= best {
        best = base_up;
        next = 4;
    }
    if 10.629795_f32 >= best {
        best = 10.629795_f32;
        next = 2;
    }
    let elbow_up = -79.08088_f32 * s[0];
    if elbow_up >= best {
        best = elbow_up;
        next = 3;
    }
    let base_up_2 = s[0] - 0.7582224_f32;
    if base_up_2 >= best {
        best = base_up_2;
        next = 4;
    }
    let to_team_30 = -107.57004_f32 * s[0];
    if to_team_30 >= best {
        best = to_team_30;
        next = 5;
    }
    let to_team_37 = -107.57004_f32 * s[1];
    if to_team_37 >= best {
        best = to_team_37;
        next = 6;
    }
    match next {
        1 => team_42(s),
        2 => team_38(s),
        3 => 4,
        4 => 0,
        5 => team_30(s),
        _ => team_37(s),
    }
}
