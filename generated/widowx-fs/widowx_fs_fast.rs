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

use tpg_runtime::arm::Move;
use tpg_runtime::observation::Source;
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

impl Policy for WidowxFsFast {
    type State = [f32; 3];
    type Action = ActionId;

    fn decide(&self, s: &[f32; 3]) -> ActionId {
        let mut vertex = 0;
        for _ in 0..Self::DEPTH {
            vertex = match vertex {
                0 => team_0(s),
                1 => team_1(s),
                2 => team_9(s),
                3 => team_7(s),
                4 => team_10(s),
                5 => team_12(s),
                6 => team_11(s),
                7 => team_13(s),
                8 => team_23(s),
                9 => team_20(s),
                10 => team_36(s),
                11 => team_15(s),
                12 => team_30(s),
                13 => team_14(s),
                14 => team_39(s),
                15 => team_38(s),
                16 => team_24(s),
                17 => team_37(s),
                18 => team_21(s),
                19 => team_42(s),
                20 => team_17(s),
                21 => team_31(s),
                22 => team_41(s),
                23 => team_27(s),
                24 => team_22(s),
                25 => team_32(s),
                26 => team_34(s),
                27 => team_40(s),
                28 => team_28(s),
                29 => team_35(s),
                30 => team_29(s),
                _ => break,
            };
        }
        ActionId(vertex.wrapping_sub(31) as u16)
    }
}

/// Where team 0 leads.
fn team_0(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 31;
    if 107.35707_f32 >= best {
        vertex = 1;
    }
    if 107.35707_f32 > best {
        best = 107.35707_f32;
    }
    let v4 = s[2] - 0.7582224_f32;
    if v4 >= best {
        vertex = 35;
    }
    if v4 > best {
        best = v4;
    }
    let v8 = 0.0_f32 - s[1];
    if v8 >= best {
        vertex = 2;
    }
    if v8 > best {
        best = v8;
    }
    let v12 = v4 / 0.0_f32;
    let v13 = v12 / 0.0_f32;
    if v13 >= best {
        vertex = 35;
    }
    if v13 > best {
        best = v13;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        vertex = 31;
    }
    if v10 > best {
        best = v10;
    }
    vertex
}

/// Where team 1 leads.
fn team_1(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 4;
    if 1.6245565_f32 >= best {
        vertex = 3;
    }
    if 1.6245565_f32 > best {
        best = 1.6245565_f32;
    }
    let v15 = 0.0_f32 * s[2];
    if v15 >= best {
        vertex = 31;
    }
    if v15 > best {
        best = v15;
    }
    let v16 = ops::negate_if_less(s[0], 0.0_f32);
    if v16 >= best {
        vertex = 31;
    }
    if v16 > best {
        best = v16;
    }
    let v8 = 0.0_f32 - s[1];
    if v8 >= best {
        vertex = 2;
    }
    if v8 > best {
        best = v8;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        vertex = 32;
    }
    if v18 > best {
        best = v18;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        vertex = 31;
    }
    if v10 > best {
        best = v10;
    }
    let v20 = s[1] * -176.74728_f32;
    let v22 = v20 + -0.52844894_f32;
    if v22 >= best {
        vertex = 4;
    }
    if v22 > best {
        best = v22;
    }
    vertex
}

/// Where team 9 leads.
fn team_9(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 35;
    let v20 = s[1] * -176.74728_f32;
    let v22 = v20 + -0.52844894_f32;
    if v22 >= best {
        vertex = 5;
    }
    if v22 > best {
        best = v22;
    }
    let v4 = s[2] - 0.7582224_f32;
    if v4 >= best {
        vertex = 35;
    }
    if v4 > best {
        best = v4;
    }
    if 20.1483_f32 >= best {
        vertex = 6;
    }
    if 20.1483_f32 > best {
        best = 20.1483_f32;
    }
    let v23 = s[2] + v4;
    if v23 >= best {
        vertex = 35;
    }
    if v23 > best {
        best = v23;
    }
    vertex
}

/// Where team 7 leads.
fn team_7(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 35;
    let v32 = 0.7582224_f32 * s[0];
    if v32 >= best {
        vertex = 31;
    }
    if v32 > best {
        best = v32;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        vertex = 32;
    }
    if v18 > best {
        best = v18;
    }
    let v34 = 42.029076_f32 / s[1];
    if v34 >= best {
        vertex = 34;
    }
    if v34 > best {
        best = v34;
    }
    let v20 = s[1] * -176.74728_f32;
    let v22 = v20 + -0.52844894_f32;
    if v22 >= best {
        vertex = 4;
    }
    if v22 > best {
        best = v22;
    }
    if 3.135279_f32 >= best {
        vertex = 7;
    }
    if 3.135279_f32 > best {
        best = 3.135279_f32;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        vertex = 31;
    }
    if v10 > best {
        best = v10;
    }
    let v4 = s[2] - 0.7582224_f32;
    let v12 = v4 / 0.0_f32;
    if v12 >= best {
        vertex = 35;
    }
    if v12 > best {
        best = v12;
    }
    vertex
}

/// Where team 10 leads.
fn team_10(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 32;
    let v20 = s[1] * -176.74728_f32;
    let v22 = v20 + -0.52844894_f32;
    if v22 >= best {
        vertex = 5;
    }
    if v22 > best {
        best = v22;
    }
    let v46 = -107.57004_f32 / s[2];
    if v46 >= best {
        vertex = 8;
    }
    if v46 > best {
        best = v46;
    }
    let v4 = s[2] - 0.7582224_f32;
    if v4 >= best {
        vertex = 35;
    }
    if v4 > best {
        best = v4;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        vertex = 31;
    }
    if v10 > best {
        best = v10;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        vertex = 32;
    }
    if v18 > best {
        best = v18;
    }
    let v47 = 0.0_f32 / s[1];
    if v47 >= best {
        vertex = 32;
    }
    if v47 > best {
        best = v47;
    }
    if 20.1483_f32 >= best {
        vertex = 6;
    }
    if 20.1483_f32 > best {
        best = 20.1483_f32;
    }
    let v45 = s[0] * -79.08088_f32;
    if v45 >= best {
        vertex = 32;
    }
    if v45 > best {
        best = v45;
    }
    vertex
}

/// Where team 12 leads.
fn team_12(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 7;
    let v49 = -117.26495_f32 - s[2];
    if v49 >= best {
        vertex = 9;
    }
    if v49 > best {
        best = v49;
    }
    let v50 = s[0] + -117.26495_f32;
    if v50 >= best {
        vertex = 35;
    }
    if v50 > best {
        best = v50;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        vertex = 31;
    }
    if v10 > best {
        best = v10;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        vertex = 10;
    }
    if v18 > best {
        best = v18;
    }
    let v4 = s[2] - 0.7582224_f32;
    if v4 >= best {
        vertex = 35;
    }
    if v4 > best {
        best = v4;
    }
    if 26.139645_f32 >= best {
        vertex = 7;
    }
    if 26.139645_f32 > best {
        best = 26.139645_f32;
    }
    vertex
}

/// Where team 11 leads.
fn team_11(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 31;
    let v4 = s[2] - 0.7582224_f32;
    if v4 >= best {
        vertex = 35;
    }
    if v4 > best {
        best = v4;
    }
    let v52 = s[2] - 0.75724316_f32;
    if v52 >= best {
        vertex = 35;
    }
    if v52 > best {
        best = v52;
    }
    let v43 = s[2] + -117.26495_f32;
    if v43 >= best {
        vertex = 35;
    }
    if v43 > best {
        best = v43;
    }
    if 1.6245565_f32 >= best {
        vertex = 11;
    }
    if 1.6245565_f32 > best {
        best = 1.6245565_f32;
    }
    let v54 = s[0] - 0.7258825_f32;
    if v54 >= best {
        vertex = 31;
    }
    if v54 > best {
        best = v54;
    }
    let v45 = s[0] * -79.08088_f32;
    if v45 >= best {
        vertex = 32;
    }
    if v45 > best {
        best = v45;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        vertex = 12;
    }
    if v18 > best {
        best = v18;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        vertex = 31;
    }
    if v10 > best {
        best = v10;
    }
    vertex
}

/// Where team 13 leads.
fn team_13(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 31;
    let v4 = s[2] - 0.7582224_f32;
    if v4 >= best {
        vertex = 35;
    }
    if v4 > best {
        best = v4;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        vertex = 12;
    }
    if v18 > best {
        best = v18;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        vertex = 31;
    }
    if v10 > best {
        best = v10;
    }
    if 1.6245565_f32 >= best {
        vertex = 13;
    }
    if 1.6245565_f32 > best {
        best = 1.6245565_f32;
    }
    let v27 = s[1] / s[1];
    if v27 >= best {
        vertex = 14;
    }
    if v27 > best {
        best = v27;
    }
    let v28 = ops::max(0.0_f32, s[0]);
    let v29 = s[1] - v28;
    if v29 >= best {
        vertex = 34;
    }
    if v29 > best {
        best = v29;
    }
    let v31 = s[0] - 1.0168722_f32;
    if v31 >= best {
        vertex = 31;
    }
    if v31 > best {
        best = v31;
    }
    vertex
}

/// Where team 23 leads.
fn team_23(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 17;
    let v4 = s[2] - 0.7582224_f32;
    if v4 >= best {
        vertex = 35;
    }
    if v4 > best {
        best = v4;
    }
    let v69 = ops::negate_if_less(s[1], 229.17769_f32);
    if v69 >= best {
        vertex = 15;
    }
    if v69 > best {
        best = v69;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 16;
    }
    if zero > best {
        best = zero;
    }
    let v70 = s[1] * -107.57004_f32;
    if v70 >= best {
        vertex = 17;
    }
    if v70 > best {
        best = v70;
    }
    vertex
}

/// Where team 20 leads.
fn team_20(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 31;
    if 10.629795_f32 >= best {
        vertex = 15;
    }
    if 10.629795_f32 > best {
        best = 10.629795_f32;
    }
    let v80 = ops::min(s[2], 110.01199_f32);
    if v80 >= best {
        vertex = 18;
    }
    if v80 > best {
        best = v80;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        vertex = 31;
    }
    if v10 > best {
        best = v10;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        vertex = 32;
    }
    if v18 > best {
        best = v18;
    }
    let v45 = s[0] * -79.08088_f32;
    if v45 >= best {
        vertex = 32;
    }
    if v45 > best {
        best = v45;
    }
    let v48 = -107.57004_f32 / s[0];
    if v48 >= best {
        vertex = 19;
    }
    if v48 > best {
        best = v48;
    }
    let v4 = s[2] - 0.7582224_f32;
    if v4 >= best {
        vertex = 31;
    }
    if v4 > best {
        best = v4;
    }
    vertex
}

/// Where team 36 leads.
fn team_36(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 34;
    if 2.5843248_f32 >= best {
        vertex = 14;
    }
    if 2.5843248_f32 > best {
        best = 2.5843248_f32;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        vertex = 32;
    }
    if v18 > best {
        best = v18;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        vertex = 31;
    }
    if v10 > best {
        best = v10;
    }
    if s[1] >= best {
        vertex = 34;
    }
    if s[1] > best {
        best = s[1];
    }
    vertex
}

/// Where team 15 leads.
fn team_15(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 20;
    let v48 = -107.57004_f32 / s[0];
    if v48 >= best {
        vertex = 8;
    }
    if v48 > best {
        best = v48;
    }
    let v4 = s[2] - 0.7582224_f32;
    let v61 = ops::max(s[2], v4);
    if v61 >= best {
        vertex = 35;
    }
    if v61 > best {
        best = v61;
    }
    if v4 >= best {
        vertex = 33;
    }
    if v4 > best {
        best = v4;
    }
    if f32::INFINITY >= best {
        vertex = 20;
    }
    if f32::INFINITY > best {
        best = f32::INFINITY;
    }
    vertex
}

/// Where team 30 leads.
fn team_30(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 32;
    let v45 = s[0] * -79.08088_f32;
    if v45 >= best {
        vertex = 32;
    }
    if v45 > best {
        best = v45;
    }
    let v64 = s[0] - 0.6354382_f32;
    if v64 >= best {
        vertex = 31;
    }
    if v64 > best {
        best = v64;
    }
    let v65 = s[0] + -5.963282_f32;
    if v65 >= best {
        vertex = 35;
    }
    if v65 > best {
        best = v65;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        vertex = 31;
    }
    if v10 > best {
        best = v10;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 21;
    }
    if zero > best {
        best = zero;
    }
    let v41 = s[2] * -176.74728_f32;
    if v41 >= best {
        vertex = 22;
    }
    if v41 > best {
        best = v41;
    }
    let v48 = -107.57004_f32 / s[0];
    if v48 >= best {
        vertex = 19;
    }
    if v48 > best {
        best = v48;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        vertex = 32;
    }
    if v18 > best {
        best = v18;
    }
    vertex
}

/// Where team 14 leads.
fn team_14(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 11;
    let v4 = s[2] - 0.7582224_f32;
    if v4 >= best {
        vertex = 35;
    }
    if v4 > best {
        best = v4;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        vertex = 12;
    }
    if v18 > best {
        best = v18;
    }
    let v55 = s[1] / 0.0_f32;
    if v55 >= best {
        vertex = 16;
    }
    if v55 > best {
        best = v55;
    }
    if 1.6245565_f32 >= best {
        vertex = 11;
    }
    if 1.6245565_f32 > best {
        best = 1.6245565_f32;
    }
    vertex
}

/// Where team 39 leads.
fn team_39(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 36;
    let v58 = ops::max(s[1], 0.0_f32);
    let v59 = f32::abs(v58);
    if v59 >= best {
        vertex = 37;
    }
    if v59 > best {
        best = v59;
    }
    let v60 = ops::min(s[0], s[1]);
    if v60 >= best {
        vertex = 31;
    }
    if v60 > best {
        best = v60;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 36;
    }
    if zero > best {
        best = zero;
    }
    vertex
}

/// Where team 38 leads.
fn team_38(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 19;
    let v40 = s[0] / 0.6354382_f32;
    if v40 >= best {
        vertex = 31;
    }
    if v40 > best {
        best = v40;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        vertex = 31;
    }
    if v10 > best {
        best = v10;
    }
    let v41 = s[2] * -176.74728_f32;
    let v42 = v41 / s[1];
    if v42 >= best {
        vertex = 22;
    }
    if v42 > best {
        best = v42;
    }
    if 2.5843248_f32 >= best {
        vertex = 14;
    }
    if 2.5843248_f32 > best {
        best = 2.5843248_f32;
    }
    let v43 = s[2] + -117.26495_f32;
    if v43 >= best {
        vertex = 32;
    }
    if v43 > best {
        best = v43;
    }
    if s[0] >= best {
        vertex = 31;
    }
    if s[0] > best {
        best = s[0];
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        vertex = 19;
    }
    if v18 > best {
        best = v18;
    }
    vertex
}

/// Where team 24 leads.
fn team_24(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 32;
    let v4 = s[2] - 0.7582224_f32;
    if v4 >= best {
        vertex = 23;
    }
    if v4 > best {
        best = v4;
    }
    let v69 = ops::negate_if_less(s[1], 229.17769_f32);
    if v69 >= best {
        vertex = 15;
    }
    if v69 > best {
        best = v69;
    }
    let v43 = s[2] + -117.26495_f32;
    if v43 >= best {
        vertex = 32;
    }
    if v43 > best {
        best = v43;
    }
    let v28 = ops::max(0.0_f32, s[0]);
    let v29 = s[1] - v28;
    if v29 >= best {
        vertex = 34;
    }
    if v29 > best {
        best = v29;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        vertex = 31;
    }
    if v10 > best {
        best = v10;
    }
    let v48 = -107.57004_f32 / s[0];
    if v48 >= best {
        vertex = 19;
    }
    if v48 > best {
        best = v48;
    }
    if 10.629795_f32 >= best {
        vertex = 15;
    }
    if 10.629795_f32 > best {
        best = 10.629795_f32;
    }
    let v45 = s[0] * -79.08088_f32;
    if v45 >= best {
        vertex = 32;
    }
    if v45 > best {
        best = v45;
    }
    vertex
}

/// Where team 37 leads.
fn team_37(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 34;
    let v45 = s[0] * -79.08088_f32;
    if v45 >= best {
        vertex = 32;
    }
    if v45 > best {
        best = v45;
    }
    let v64 = s[0] - 0.6354382_f32;
    if v64 >= best {
        vertex = 31;
    }
    if v64 > best {
        best = v64;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        vertex = 19;
    }
    if v18 > best {
        best = v18;
    }
    let v43 = s[2] + -117.26495_f32;
    if v43 >= best {
        vertex = 32;
    }
    if v43 > best {
        best = v43;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 34;
    }
    if zero > best {
        best = zero;
    }
    let v72 = s[0] * 0.87870044_f32;
    if v72 >= best {
        vertex = 22;
    }
    if v72 > best {
        best = v72;
    }
    let v28 = ops::max(0.0_f32, s[0]);
    let v29 = s[1] - v28;
    if v29 >= best {
        vertex = 34;
    }
    if v29 > best {
        best = v29;
    }
    vertex
}

/// Where team 21 leads.
fn team_21(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 19;
    let v85 = ops::negate_if_less(s[1], -1.1606317_f32);
    if v85 >= best {
        vertex = 24;
    }
    if v85 > best {
        best = v85;
    }
    if 15.754999_f32 >= best {
        vertex = 25;
    }
    if 15.754999_f32 > best {
        best = 15.754999_f32;
    }
    let v70 = s[1] * -107.57004_f32;
    if v70 >= best {
        vertex = 17;
    }
    if v70 > best {
        best = v70;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        vertex = 31;
    }
    if v10 > best {
        best = v10;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        vertex = 19;
    }
    if v18 > best {
        best = v18;
    }
    vertex
}

/// Where team 42 leads.
fn team_42(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 32;
    let v47 = 0.0_f32 / s[1];
    if v47 >= best {
        vertex = 32;
    }
    if v47 > best {
        best = v47;
    }
    if s[0] >= best {
        vertex = 31;
    }
    if s[0] > best {
        best = s[0];
    }
    let v7 = ops::min(-8.893463_f32, s[1]);
    if v7 >= best {
        vertex = 31;
    }
    if v7 > best {
        best = v7;
    }
    if s[1] >= best {
        vertex = 34;
    }
    if s[1] > best {
        best = s[1];
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        vertex = 32;
    }
    if v18 > best {
        best = v18;
    }
    vertex
}

/// Where team 17 leads.
fn team_17(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 31;
    let v57 = s[2] - -6.7057414_f32;
    if v57 >= best {
        vertex = 33;
    }
    if v57 > best {
        best = v57;
    }
    if 6.543999_f32 >= best {
        vertex = 38;
    }
    if 6.543999_f32 > best {
        best = 6.543999_f32;
    }
    let v55 = s[1] / 0.0_f32;
    if v55 >= best {
        vertex = 16;
    }
    if v55 > best {
        best = v55;
    }
    let v45 = s[0] * -79.08088_f32;
    if v45 >= best {
        vertex = 32;
    }
    if v45 > best {
        best = v45;
    }
    let v48 = -107.57004_f32 / s[0];
    if v48 >= best {
        vertex = 19;
    }
    if v48 > best {
        best = v48;
    }
    let v4 = s[2] - 0.7582224_f32;
    if v4 >= best {
        vertex = 33;
    }
    if v4 > best {
        best = v4;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        vertex = 32;
    }
    if v18 > best {
        best = v18;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        vertex = 31;
    }
    if v10 > best {
        best = v10;
    }
    vertex
}

/// Where team 31 leads.
fn team_31(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 19;
    let v82 = 0.0_f32 - s[0];
    let v83 = 2.710111_f32 / v82;
    if v83 >= best {
        vertex = 32;
    }
    if v83 > best {
        best = v83;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 31;
    }
    if zero > best {
        best = zero;
    }
    let v27 = s[1] / s[1];
    if v27 >= best {
        vertex = 14;
    }
    if v27 > best {
        best = v27;
    }
    let v41 = s[2] * -176.74728_f32;
    let v42 = v41 / s[1];
    if v42 >= best {
        vertex = 22;
    }
    if v42 > best {
        best = v42;
    }
    let v64 = s[0] - 0.6354382_f32;
    if v64 >= best {
        vertex = 26;
    }
    if v64 > best {
        best = v64;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        vertex = 31;
    }
    if v10 > best {
        best = v10;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        vertex = 19;
    }
    if v18 > best {
        best = v18;
    }
    vertex
}

/// Where team 41 leads.
fn team_41(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 32;
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 34;
    }
    if zero > best {
        best = zero;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        vertex = 31;
    }
    if v10 > best {
        best = v10;
    }
    let v67 = s[1] * -55.687565_f32;
    if v67 >= best {
        vertex = 36;
    }
    if v67 > best {
        best = v67;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        vertex = 32;
    }
    if v18 > best {
        best = v18;
    }
    vertex
}

/// Where team 27 leads.
fn team_27(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 12;
    let v48 = -107.57004_f32 / s[0];
    if v48 >= best {
        vertex = 19;
    }
    if v48 > best {
        best = v48;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        vertex = 31;
    }
    if v10 > best {
        best = v10;
    }
    let v86 = -79.08088_f32 - s[0];
    if v86 >= best {
        vertex = 27;
    }
    if v86 > best {
        best = v86;
    }
    let v45 = s[0] * -79.08088_f32;
    if v45 >= best {
        vertex = 32;
    }
    if v45 > best {
        best = v45;
    }
    let v47 = 0.0_f32 / s[1];
    if v47 >= best {
        vertex = 32;
    }
    if v47 > best {
        best = v47;
    }
    let v4 = s[2] - 0.7582224_f32;
    if v4 >= best {
        vertex = 28;
    }
    if v4 > best {
        best = v4;
    }
    if 13.937786_f32 >= best {
        vertex = 15;
    }
    if 13.937786_f32 > best {
        best = 13.937786_f32;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        vertex = 12;
    }
    if v18 > best {
        best = v18;
    }
    vertex
}

/// Where team 22 leads.
fn team_22(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 19;
    let v48 = -107.57004_f32 / s[0];
    if v48 >= best {
        vertex = 19;
    }
    if v48 > best {
        best = v48;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        vertex = 31;
    }
    if v10 > best {
        best = v10;
    }
    if 15.754999_f32 >= best {
        vertex = 25;
    }
    if 15.754999_f32 > best {
        best = 15.754999_f32;
    }
    let v45 = s[0] * -79.08088_f32;
    if v45 >= best {
        vertex = 32;
    }
    if v45 > best {
        best = v45;
    }
    let v43 = s[2] + -117.26495_f32;
    if v43 >= best {
        vertex = 32;
    }
    if v43 > best {
        best = v43;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        vertex = 19;
    }
    if v18 > best {
        best = v18;
    }
    vertex
}

/// Where team 32 leads.
fn team_32(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 32;
    let v72 = s[0] * 0.87870044_f32;
    if v72 >= best {
        vertex = 31;
    }
    if v72 > best {
        best = v72;
    }
    let v73 = s[2] * s[0];
    let v74 = v73 - s[0];
    let v75 = 2.710111_f32 / v74;
    if v75 >= best {
        vertex = 32;
    }
    if v75 > best {
        best = v75;
    }
    let v76 = s[0] + -107.57004_f32;
    if v76 >= best {
        vertex = 32;
    }
    if v76 > best {
        best = v76;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 34;
    }
    if zero > best {
        best = zero;
    }
    let v27 = s[1] / s[1];
    if v27 >= best {
        vertex = 14;
    }
    if v27 > best {
        best = v27;
    }
    let v41 = s[2] * -176.74728_f32;
    let v42 = v41 / s[1];
    if v42 >= best {
        vertex = 22;
    }
    if v42 > best {
        best = v42;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        vertex = 14;
    }
    if v10 > best {
        best = v10;
    }
    let v64 = s[0] - 0.6354382_f32;
    if v64 >= best {
        vertex = 26;
    }
    if v64 > best {
        best = v64;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        vertex = 32;
    }
    if v18 > best {
        best = v18;
    }
    let v78 = s[0] * 0.18706028_f32;
    if v78 >= best {
        vertex = 32;
    }
    if v78 > best {
        best = v78;
    }
    vertex
}

/// Where team 34 leads.
fn team_34(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 32;
    let v45 = s[0] * -79.08088_f32;
    if v45 >= best {
        vertex = 32;
    }
    if v45 > best {
        best = v45;
    }
    let v64 = s[0] - 0.6354382_f32;
    if v64 >= best {
        vertex = 31;
    }
    if v64 > best {
        best = v64;
    }
    if 15.754999_f32 >= best {
        vertex = 29;
    }
    if 15.754999_f32 > best {
        best = 15.754999_f32;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        vertex = 19;
    }
    if v18 > best {
        best = v18;
    }
    let v43 = s[2] + -117.26495_f32;
    if v43 >= best {
        vertex = 32;
    }
    if v43 > best {
        best = v43;
    }
    vertex
}

/// Where team 40 leads.
fn team_40(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 31;
    if s[2] >= best {
        vertex = 31;
    }
    if s[2] > best {
        best = s[2];
    }
    if 10.629795_f32 >= best {
        vertex = 22;
    }
    if 10.629795_f32 > best {
        best = 10.629795_f32;
    }
    let v28 = ops::max(0.0_f32, s[0]);
    let v29 = s[1] - v28;
    if v29 >= best {
        vertex = 34;
    }
    if v29 > best {
        best = v29;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        vertex = 32;
    }
    if v18 > best {
        best = v18;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        vertex = 31;
    }
    if v10 > best {
        best = v10;
    }
    vertex
}

/// Where team 28 leads.
fn team_28(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 32;
    let v48 = -107.57004_f32 / s[0];
    if v48 >= best {
        vertex = 19;
    }
    if v48 > best {
        best = v48;
    }
    let v4 = s[2] - 0.7582224_f32;
    if v4 >= best {
        vertex = 35;
    }
    if v4 > best {
        best = v4;
    }
    let v70 = s[1] * -107.57004_f32;
    if v70 >= best {
        vertex = 17;
    }
    if v70 > best {
        best = v70;
    }
    let v64 = s[0] - 0.6354382_f32;
    if v64 >= best {
        vertex = 30;
    }
    if v64 > best {
        best = v64;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        vertex = 27;
    }
    if v18 > best {
        best = v18;
    }
    let v82 = 0.0_f32 - s[0];
    let v83 = 2.710111_f32 / v82;
    if v83 >= best {
        vertex = 32;
    }
    if v83 > best {
        best = v83;
    }
    vertex
}

/// Where team 35 leads.
fn team_35(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 32;
    if 83.54613_f32 >= best {
        vertex = 22;
    }
    if 83.54613_f32 > best {
        best = 83.54613_f32;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        vertex = 31;
    }
    if v10 > best {
        best = v10;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        vertex = 32;
    }
    if v18 > best {
        best = v18;
    }
    let v73 = s[2] * s[0];
    let v74 = v73 - s[0];
    let v75 = 2.710111_f32 / v74;
    if v75 >= best {
        vertex = 32;
    }
    if v75 > best {
        best = v75;
    }
    vertex
}

/// Where team 29 leads.
fn team_29(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 17;
    let v48 = -107.57004_f32 / s[0];
    if v48 >= best {
        vertex = 19;
    }
    if v48 > best {
        best = v48;
    }
    let v4 = s[2] - 0.7582224_f32;
    if v4 >= best {
        vertex = 31;
    }
    if v4 > best {
        best = v4;
    }
    if 10.629795_f32 >= best {
        vertex = 15;
    }
    if 10.629795_f32 > best {
        best = 10.629795_f32;
    }
    let v45 = s[0] * -79.08088_f32;
    if v45 >= best {
        vertex = 35;
    }
    if v45 > best {
        best = v45;
    }
    let v10 = s[0] - 0.7582224_f32;
    if v10 >= best {
        vertex = 31;
    }
    if v10 > best {
        best = v10;
    }
    let v18 = s[0] * -107.57004_f32;
    if v18 >= best {
        vertex = 12;
    }
    if v18 > best {
        best = v18;
    }
    let v70 = s[1] * -107.57004_f32;
    if v70 >= best {
        vertex = 17;
    }
    if v70 > best {
        best = v70;
    }
    vertex
}
