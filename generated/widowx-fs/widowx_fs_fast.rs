//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix widowx_fs_fast --profile fast
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
    /// Teams on the longest walk.
    pub const DEPTH: usize = 18;
    /// Bids that one decision looks at, at most.
    pub const WORST_BIDS: usize = 113;
    /// Operations of one decision, at most.
    pub const WORST_OPERATIONS: usize = 108;
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
    let mut way = 1;
    let v4 = s[2] - 0.7582224_f32;
    if v4 >= best {
        best = v4;
        way = 3;
    }
    let v8 = 0.0_f32 - s[1];
    if v8 >= best {
        best = v8;
        way = 2;
    }
    let v12 = v4 / 0.0_f32;
    let v13 = v12 / 0.0_f32;
    if v13 >= best {
        best = v13;
        way = 3;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        best = v10;
        way = 4;
    }
    match way {
        1 => team_1(s),
        2 => team_9(s),
        3 => 4,
        _ => 0,
    }
}

/// What team 1 decides.
fn team_1(s: &[f32; 3]) -> u16 {
    let mut best = 1.6245565_f32;
    let mut way = 1;
    let v15 = 0.0_f32 * s[2];
    if v15 >= best {
        best = v15;
        way = 4;
    }
    let v16 = ops::negate_if_less(s[0], 0.0_f32);
    if v16 >= best {
        best = v16;
        way = 4;
    }
    let v8 = 0.0_f32 - s[1];
    if v8 >= best {
        best = v8;
        way = 2;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        best = v18;
        way = 3;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        best = v10;
        way = 4;
    }
    let v20 = s[1] * -176.74728_f32;
    let v22 = v20 + -0.52844894_f32;
    if v22 >= best {
        best = v22;
        way = 5;
    }
    match way {
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
    let mut way = 3;
    let v20 = s[1] * -176.74728_f32;
    let v22 = v20 + -0.52844894_f32;
    if v22 >= best {
        best = v22;
        way = 1;
    }
    let v4 = s[2] - 0.7582224_f32;
    if v4 >= best {
        best = v4;
        way = 3;
    }
    if 20.1483_f32 >= best {
        best = 20.1483_f32;
        way = 2;
    }
    let v23 = s[2] + v4;
    if v23 >= best {
        best = v23;
        way = 3;
    }
    match way {
        1 => team_12(s),
        2 => team_11(s),
        _ => 4,
    }
}

/// What team 7 decides.
fn team_7(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut way = 6;
    let v32 = 0.7582224_f32 * s[0];
    if v32 >= best {
        best = v32;
        way = 5;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        best = v18;
        way = 1;
    }
    let v34 = 42.029076_f32 / s[1];
    if v34 >= best {
        best = v34;
        way = 2;
    }
    let v20 = s[1] * -176.74728_f32;
    let v22 = v20 + -0.52844894_f32;
    if v22 >= best {
        best = v22;
        way = 3;
    }
    if 3.135279_f32 >= best {
        best = 3.135279_f32;
        way = 4;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        best = v10;
        way = 5;
    }
    let v4 = s[2] - 0.7582224_f32;
    let v12 = v4 / 0.0_f32;
    if v12 >= best {
        best = v12;
        way = 6;
    }
    match way {
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
    let mut way = 6;
    let v20 = s[1] * -176.74728_f32;
    let v22 = v20 + -0.52844894_f32;
    if v22 >= best {
        best = v22;
        way = 1;
    }
    let v46 = -107.57004_f32 / s[2];
    if v46 >= best {
        best = v46;
        way = 2;
    }
    let v4 = s[2] - 0.7582224_f32;
    if v4 >= best {
        best = v4;
        way = 3;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        best = v10;
        way = 4;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        best = v18;
        way = 6;
    }
    let v47 = 0.0_f32 / s[1];
    if v47 >= best {
        best = v47;
        way = 6;
    }
    if 20.1483_f32 >= best {
        best = 20.1483_f32;
        way = 5;
    }
    let v45 = s[0] * -79.08088_f32;
    if v45 >= best {
        best = v45;
        way = 6;
    }
    match way {
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
    let mut way = 5;
    let v49 = -117.26495_f32 - s[2];
    if v49 >= best {
        best = v49;
        way = 1;
    }
    let v50 = s[0] + -117.26495_f32;
    if v50 >= best {
        best = v50;
        way = 4;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        best = v10;
        way = 2;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        best = v18;
        way = 3;
    }
    let v4 = s[2] - 0.7582224_f32;
    if v4 >= best {
        best = v4;
        way = 4;
    }
    if 26.139645_f32 >= best {
        best = 26.139645_f32;
        way = 5;
    }
    match way {
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
    let mut way = 5;
    let v4 = s[2] - 0.7582224_f32;
    if v4 >= best {
        best = v4;
        way = 1;
    }
    let v52 = s[2] - 0.75724316_f32;
    if v52 >= best {
        best = v52;
        way = 1;
    }
    let v43 = s[2] + -117.26495_f32;
    if v43 >= best {
        best = v43;
        way = 1;
    }
    if 1.6245565_f32 >= best {
        best = 1.6245565_f32;
        way = 2;
    }
    let v54 = s[0] - 0.7258825_f32;
    if v54 >= best {
        best = v54;
        way = 5;
    }
    let v45 = s[0] * -79.08088_f32;
    if v45 >= best {
        best = v45;
        way = 3;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        best = v18;
        way = 4;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        best = v10;
        way = 5;
    }
    match way {
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
    let mut way = 6;
    let v4 = s[2] - 0.7582224_f32;
    if v4 >= best {
        best = v4;
        way = 1;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        best = v18;
        way = 2;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        best = v10;
        way = 6;
    }
    if 1.6245565_f32 >= best {
        best = 1.6245565_f32;
        way = 3;
    }
    let v27 = s[1] / s[1];
    if v27 >= best {
        best = v27;
        way = 4;
    }
    let v28 = ops::max(0.0_f32, s[0]);
    let v29 = s[1] - v28;
    if v29 >= best {
        best = v29;
        way = 5;
    }
    let v31 = s[0] - 1.0168722_f32;
    if v31 >= best {
        best = v31;
        way = 6;
    }
    match way {
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
    let mut way = 4;
    let v4 = s[2] - 0.7582224_f32;
    if v4 >= best {
        best = v4;
        way = 1;
    }
    let v69 = ops::negate_if_less(s[1], 229.17769_f32);
    if v69 >= best {
        best = v69;
        way = 2;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        best = zero;
        way = 3;
    }
    let v70 = s[1] * -107.57004_f32;
    if v70 >= best {
        best = v70;
        way = 4;
    }
    match way {
        1 => 4,
        2 => team_38(s),
        3 => team_24(s),
        _ => team_37(s),
    }
}

/// What team 20 decides.
fn team_20(s: &[f32; 3]) -> u16 {
    let mut best = 10.629795_f32;
    let mut way = 1;
    let v80 = ops::min(s[2], 110.01199_f32);
    if v80 >= best {
        best = v80;
        way = 2;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        best = v10;
        way = 5;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        best = v18;
        way = 3;
    }
    let v45 = s[0] * -79.08088_f32;
    if v45 >= best {
        best = v45;
        way = 3;
    }
    let v48 = -107.57004_f32 / s[0];
    if v48 >= best {
        best = v48;
        way = 4;
    }
    let v4 = s[2] - 0.7582224_f32;
    if v4 >= best {
        best = v4;
        way = 5;
    }
    match way {
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
    let mut way = 1;
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        best = v18;
        way = 2;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        best = v10;
        way = 3;
    }
    if s[1] >= best {
        best = s[1];
        way = 4;
    }
    match way {
        1 => team_39(s),
        2 => 1,
        3 => 0,
        _ => 3,
    }
}

/// What team 15 decides.
fn team_15(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut way = 4;
    let v48 = -107.57004_f32 / s[0];
    if v48 >= best {
        best = v48;
        way = 1;
    }
    let v4 = s[2] - 0.7582224_f32;
    let v61 = ops::max(s[2], v4);
    if v61 >= best {
        best = v61;
        way = 2;
    }
    if v4 >= best {
        best = v4;
        way = 3;
    }
    if f32::INFINITY >= best {
        best = f32::INFINITY;
        way = 4;
    }
    match way {
        1 => team_23(s),
        2 => 4,
        3 => 2,
        _ => team_17(s),
    }
}

/// What team 30 decides.
fn team_30(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut way = 6;
    let v45 = s[0] * -79.08088_f32;
    if v45 >= best {
        best = v45;
        way = 6;
    }
    let v64 = s[0] - 0.6354382_f32;
    if v64 >= best {
        best = v64;
        way = 2;
    }
    let v65 = s[0] + -5.963282_f32;
    if v65 >= best {
        best = v65;
        way = 1;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        best = v10;
        way = 2;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        best = zero;
        way = 3;
    }
    let v41 = s[2] * -176.74728_f32;
    if v41 >= best {
        best = v41;
        way = 4;
    }
    let v48 = -107.57004_f32 / s[0];
    if v48 >= best {
        best = v48;
        way = 5;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        best = v18;
        way = 6;
    }
    match way {
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
    let mut way = 4;
    let v4 = s[2] - 0.7582224_f32;
    if v4 >= best {
        best = v4;
        way = 1;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        best = v18;
        way = 2;
    }
    let v55 = s[1] / 0.0_f32;
    if v55 >= best {
        best = v55;
        way = 3;
    }
    if 1.6245565_f32 >= best {
        best = 1.6245565_f32;
        way = 4;
    }
    match way {
        1 => 4,
        2 => team_30(s),
        3 => team_24(s),
        _ => team_15(s),
    }
}

/// What team 39 decides.
fn team_39(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut way = 3;
    let v58 = ops::max(s[1], 0.0_f32);
    let v59 = f32::abs(v58);
    if v59 >= best {
        best = v59;
        way = 1;
    }
    let v60 = ops::min(s[0], s[1]);
    if v60 >= best {
        best = v60;
        way = 2;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        best = zero;
        way = 3;
    }
    match way {
        1 => 6,
        2 => 0,
        _ => 5,
    }
}

/// What team 38 decides.
fn team_38(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut way = 5;
    let v40 = s[0] / 0.6354382_f32;
    if v40 >= best {
        best = v40;
        way = 4;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        best = v10;
        way = 4;
    }
    let v41 = s[2] * -176.74728_f32;
    let v42 = v41 / s[1];
    if v42 >= best {
        best = v42;
        way = 1;
    }
    if 2.5843248_f32 >= best {
        best = 2.5843248_f32;
        way = 2;
    }
    let v43 = s[2] + -117.26495_f32;
    if v43 >= best {
        best = v43;
        way = 3;
    }
    if s[0] >= best {
        best = s[0];
        way = 4;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        best = v18;
        way = 5;
    }
    match way {
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
    let mut way = 6;
    let v4 = s[2] - 0.7582224_f32;
    if v4 >= best {
        best = v4;
        way = 1;
    }
    let v69 = ops::negate_if_less(s[1], 229.17769_f32);
    if v69 >= best {
        best = v69;
        way = 5;
    }
    let v43 = s[2] + -117.26495_f32;
    if v43 >= best {
        best = v43;
        way = 6;
    }
    let v28 = ops::max(0.0_f32, s[0]);
    let v29 = s[1] - v28;
    if v29 >= best {
        best = v29;
        way = 2;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        best = v10;
        way = 3;
    }
    let v48 = -107.57004_f32 / s[0];
    if v48 >= best {
        best = v48;
        way = 4;
    }
    if 10.629795_f32 >= best {
        best = 10.629795_f32;
        way = 5;
    }
    let v45 = s[0] * -79.08088_f32;
    if v45 >= best {
        best = v45;
        way = 6;
    }
    match way {
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
    let mut way = 5;
    let v45 = s[0] * -79.08088_f32;
    if v45 >= best {
        best = v45;
        way = 3;
    }
    let v64 = s[0] - 0.6354382_f32;
    if v64 >= best {
        best = v64;
        way = 1;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        best = v18;
        way = 2;
    }
    let v43 = s[2] + -117.26495_f32;
    if v43 >= best {
        best = v43;
        way = 3;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        best = zero;
        way = 5;
    }
    let v72 = s[0] * 0.87870044_f32;
    if v72 >= best {
        best = v72;
        way = 4;
    }
    let v28 = ops::max(0.0_f32, s[0]);
    let v29 = s[1] - v28;
    if v29 >= best {
        best = v29;
        way = 5;
    }
    match way {
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
    let mut way = 5;
    let v85 = ops::negate_if_less(s[1], -1.1606317_f32);
    if v85 >= best {
        best = v85;
        way = 1;
    }
    if 15.754999_f32 >= best {
        best = 15.754999_f32;
        way = 2;
    }
    let v70 = s[1] * -107.57004_f32;
    if v70 >= best {
        best = v70;
        way = 3;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        best = v10;
        way = 4;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        best = v18;
        way = 5;
    }
    match way {
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
    let mut way = 3;
    let v47 = 0.0_f32 / s[1];
    if v47 >= best {
        best = v47;
        way = 3;
    }
    if s[0] >= best {
        best = s[0];
        way = 1;
    }
    let v7 = ops::min(-8.893463_f32, s[1]);
    if v7 >= best {
        best = v7;
        way = 1;
    }
    if s[1] >= best {
        best = s[1];
        way = 2;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        best = v18;
        way = 3;
    }
    match way {
        1 => 0,
        2 => 3,
        _ => 1,
    }
}

/// What team 17 decides.
fn team_17(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut way = 6;
    let v57 = s[2] - -6.7057414_f32;
    if v57 >= best {
        best = v57;
        way = 4;
    }
    if 6.543999_f32 >= best {
        best = 6.543999_f32;
        way = 1;
    }
    let v55 = s[1] / 0.0_f32;
    if v55 >= best {
        best = v55;
        way = 2;
    }
    let v45 = s[0] * -79.08088_f32;
    if v45 >= best {
        best = v45;
        way = 5;
    }
    let v48 = -107.57004_f32 / s[0];
    if v48 >= best {
        best = v48;
        way = 3;
    }
    let v4 = s[2] - 0.7582224_f32;
    if v4 >= best {
        best = v4;
        way = 4;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        best = v18;
        way = 5;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        best = v10;
        way = 6;
    }
    match way {
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
    let mut way = 6;
    let v82 = 0.0_f32 - s[0];
    let v83 = 2.710111_f32 / v82;
    if v83 >= best {
        best = v83;
        way = 1;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        best = zero;
        way = 5;
    }
    let v27 = s[1] / s[1];
    if v27 >= best {
        best = v27;
        way = 2;
    }
    let v41 = s[2] * -176.74728_f32;
    let v42 = v41 / s[1];
    if v42 >= best {
        best = v42;
        way = 3;
    }
    let v64 = s[0] - 0.6354382_f32;
    if v64 >= best {
        best = v64;
        way = 4;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        best = v10;
        way = 5;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        best = v18;
        way = 6;
    }
    match way {
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
    let mut way = 1;
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        best = v10;
        way = 2;
    }
    let v67 = s[1] * -55.687565_f32;
    if v67 >= best {
        best = v67;
        way = 3;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        best = v18;
        way = 4;
    }
    match way {
        1 => 3,
        2 => 0,
        3 => 5,
        _ => 1,
    }
}

/// What team 27 decides.
fn team_27(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut way = 7;
    let v48 = -107.57004_f32 / s[0];
    if v48 >= best {
        best = v48;
        way = 1;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        best = v10;
        way = 2;
    }
    let v86 = -79.08088_f32 - s[0];
    if v86 >= best {
        best = v86;
        way = 3;
    }
    let v45 = s[0] * -79.08088_f32;
    if v45 >= best {
        best = v45;
        way = 4;
    }
    let v47 = 0.0_f32 / s[1];
    if v47 >= best {
        best = v47;
        way = 4;
    }
    let v4 = s[2] - 0.7582224_f32;
    if v4 >= best {
        best = v4;
        way = 5;
    }
    if 13.937786_f32 >= best {
        best = 13.937786_f32;
        way = 6;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        best = v18;
        way = 7;
    }
    match way {
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
    let mut way = 4;
    let v48 = -107.57004_f32 / s[0];
    if v48 >= best {
        best = v48;
        way = 4;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        best = v10;
        way = 1;
    }
    if 15.754999_f32 >= best {
        best = 15.754999_f32;
        way = 2;
    }
    let v45 = s[0] * -79.08088_f32;
    if v45 >= best {
        best = v45;
        way = 3;
    }
    let v43 = s[2] + -117.26495_f32;
    if v43 >= best {
        best = v43;
        way = 3;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        best = v18;
        way = 4;
    }
    match way {
        1 => 0,
        2 => team_32(s),
        3 => 1,
        _ => team_42(s),
    }
}

/// What team 32 decides.
fn team_32(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut way = 6;
    let v72 = s[0] * 0.87870044_f32;
    if v72 >= best {
        best = v72;
        way = 1;
    }
    let v73 = s[2] * s[0];
    let v74 = v73 - s[0];
    let v75 = 2.710111_f32 / v74;
    if v75 >= best {
        best = v75;
        way = 6;
    }
    let v76 = s[0] + -107.57004_f32;
    if v76 >= best {
        best = v76;
        way = 6;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        best = zero;
        way = 2;
    }
    let v27 = s[1] / s[1];
    if v27 >= best {
        best = v27;
        way = 4;
    }
    let v41 = s[2] * -176.74728_f32;
    let v42 = v41 / s[1];
    if v42 >= best {
        best = v42;
        way = 3;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        best = v10;
        way = 4;
    }
    let v64 = s[0] - 0.6354382_f32;
    if v64 >= best {
        best = v64;
        way = 5;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        best = v18;
        way = 6;
    }
    let v78 = s[0] * 0.18706028_f32;
    if v78 >= best {
        best = v78;
        way = 6;
    }
    match way {
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
    let mut way = 4;
    let v45 = s[0] * -79.08088_f32;
    if v45 >= best {
        best = v45;
        way = 4;
    }
    let v64 = s[0] - 0.6354382_f32;
    if v64 >= best {
        best = v64;
        way = 1;
    }
    if 15.754999_f32 >= best {
        best = 15.754999_f32;
        way = 2;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        best = v18;
        way = 3;
    }
    let v43 = s[2] + -117.26495_f32;
    if v43 >= best {
        best = v43;
        way = 4;
    }
    match way {
        1 => 0,
        2 => team_35(s),
        3 => team_42(s),
        _ => 1,
    }
}

/// What team 40 decides.
fn team_40(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut way = 4;
    if s[2] >= best {
        best = s[2];
        way = 4;
    }
    if 10.629795_f32 >= best {
        best = 10.629795_f32;
        way = 1;
    }
    let v28 = ops::max(0.0_f32, s[0]);
    let v29 = s[1] - v28;
    if v29 >= best {
        best = v29;
        way = 2;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        best = v18;
        way = 3;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        best = v10;
        way = 4;
    }
    match way {
        1 => team_41(s),
        2 => 3,
        3 => 1,
        _ => 0,
    }
}

/// What team 28 decides.
fn team_28(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut way = 6;
    let v48 = -107.57004_f32 / s[0];
    if v48 >= best {
        best = v48;
        way = 1;
    }
    let v4 = s[2] - 0.7582224_f32;
    if v4 >= best {
        best = v4;
        way = 2;
    }
    let v70 = s[1] * -107.57004_f32;
    if v70 >= best {
        best = v70;
        way = 3;
    }
    let v64 = s[0] - 0.6354382_f32;
    if v64 >= best {
        best = v64;
        way = 4;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        best = v18;
        way = 5;
    }
    let v82 = 0.0_f32 - s[0];
    let v83 = 2.710111_f32 / v82;
    if v83 >= best {
        best = v83;
        way = 6;
    }
    match way {
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
    let mut way = 1;
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        best = v10;
        way = 2;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        best = v18;
        way = 3;
    }
    let v73 = s[2] * s[0];
    let v74 = v73 - s[0];
    let v75 = 2.710111_f32 / v74;
    if v75 >= best {
        best = v75;
        way = 3;
    }
    match way {
        1 => team_41(s),
        2 => 0,
        _ => 1,
    }
}

/// What team 29 decides.
fn team_29(s: &[f32; 3]) -> u16 {
    let mut best = f32::MIN;
    let mut way = 6;
    let v48 = -107.57004_f32 / s[0];
    if v48 >= best {
        best = v48;
        way = 1;
    }
    let v4 = s[2] - 0.7582224_f32;
    if v4 >= best {
        best = v4;
        way = 4;
    }
    if 10.629795_f32 >= best {
        best = 10.629795_f32;
        way = 2;
    }
    let v45 = s[0] * -79.08088_f32;
    if v45 >= best {
        best = v45;
        way = 3;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        best = v10;
        way = 4;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        best = v18;
        way = 5;
    }
    let v70 = s[1] * -107.57004_f32;
    if v70 >= best {
        best = v70;
        way = 6;
    }
    match way {
        1 => team_42(s),
        2 => team_38(s),
        3 => 4,
        4 => 0,
        5 => team_30(s),
        _ => team_37(s),
    }
}
