//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix widowx_fs_fast --profile fast
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
    pub const DEPTH: usize = 16;
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
                2 => team_4(s),
                3 => team_3(s),
                4 => team_14(s),
                5 => team_2(s),
                6 => team_21(s),
                7 => team_5(s),
                8 => team_30(s),
                9 => team_11(s),
                10 => team_27(s),
                11 => team_29(s),
                12 => team_15(s),
                13 => team_28(s),
                14 => team_6(s),
                15 => team_22(s),
                16 => team_32(s),
                17 => team_33(s),
                18 => team_12(s),
                19 => team_18(s),
                20 => team_8(s),
                21 => team_25(s),
                22 => team_13(s),
                23 => team_23(s),
                24 => team_31(s),
                25 => team_19(s),
                26 => team_26(s),
                27 => team_20(s),
                _ => break,
            };
        }
        ActionId(vertex.wrapping_sub(28) as u16)
    }
}

/// Where team 0 leads.
fn team_0(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 35;
    let v2 = s[0] * 0.7582224_f32;
    if v2 >= best {
        vertex = 28;
    }
    if v2 > best {
        best = v2;
    }
    let v4 = s[0] * -107.57004_f32;
    if v4 >= best {
        vertex = 29;
    }
    if v4 > best {
        best = v4;
    }
    let v10 = s[1] * -99.097435_f32;
    let v12 = v10 + -0.52844894_f32;
    if v12 >= best {
        vertex = 1;
    }
    if v12 > best {
        best = v12;
    }
    if 3.135279_f32 >= best {
        vertex = 2;
    }
    if 3.135279_f32 > best {
        best = 3.135279_f32;
    }
    let v14 = s[0] - 0.7582224_f32;
    if v14 >= best {
        vertex = 28;
    }
    if v14 > best {
        best = v14;
    }
    let v16 = s[2] - 0.7582224_f32;
    let v18 = v16 / 0.0_f32;
    if v18 >= best {
        vertex = 32;
    }
    if v18 > best {
        best = v18;
    }
    let v20 = s[0] * -79.08088_f32;
    if v20 >= best {
        vertex = 29;
    }
    if v20 > best {
        best = v20;
    }
    let v7 = 42.029076_f32 / s[1];
    if v7 >= best {
        vertex = 31;
    }
    if v7 > best {
        best = v7;
    }
    let v21 = -107.57004_f32 / s[2];
    if v21 >= best {
        vertex = 35;
    }
    if v21 > best {
        best = v21;
    }
    vertex
}

/// Where team 1 leads.
fn team_1(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 29;
    let v29 = s[1] * -176.74728_f32;
    let v30 = -0.52844894_f32 + v29;
    if v30 >= best {
        vertex = 3;
    }
    if v30 > best {
        best = v30;
    }
    let v21 = -107.57004_f32 / s[2];
    if v21 >= best {
        vertex = 4;
    }
    if v21 > best {
        best = v21;
    }
    let v16 = s[2] - 0.7582224_f32;
    if v16 >= best {
        vertex = 32;
    }
    if v16 > best {
        best = v16;
    }
    let v14 = s[0] - 0.7582224_f32;
    if v14 >= best {
        vertex = 28;
    }
    if v14 > best {
        best = v14;
    }
    let v4 = s[0] * -107.57004_f32;
    if v4 >= best {
        vertex = 29;
    }
    if v4 > best {
        best = v4;
    }
    let v31 = 0.0_f32 / s[1];
    if v31 >= best {
        vertex = 29;
    }
    if v31 > best {
        best = v31;
    }
    if 20.1483_f32 >= best {
        vertex = 5;
    }
    if 20.1483_f32 > best {
        best = 20.1483_f32;
    }
    let v20 = s[0] * -79.08088_f32;
    if v20 >= best {
        vertex = 29;
    }
    if v20 > best {
        best = v20;
    }
    vertex
}

/// Where team 4 leads.
fn team_4(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 28;
    let v16 = s[2] - 0.7582224_f32;
    if v16 >= best {
        vertex = 32;
    }
    if v16 > best {
        best = v16;
    }
    let v4 = s[0] * -107.57004_f32;
    if v4 >= best {
        vertex = 6;
    }
    if v4 > best {
        best = v4;
    }
    let v14 = s[0] - 0.7582224_f32;
    if v14 >= best {
        vertex = 28;
    }
    if v14 > best {
        best = v14;
    }
    if 1.6245565_f32 >= best {
        vertex = 7;
    }
    if 1.6245565_f32 > best {
        best = 1.6245565_f32;
    }
    let v23 = s[1] / s[1];
    if v23 >= best {
        vertex = 8;
    }
    if v23 > best {
        best = v23;
    }
    let v24 = ops::max(0.0_f32, s[0]);
    let v25 = s[1] - v24;
    if v25 >= best {
        vertex = 31;
    }
    if v25 > best {
        best = v25;
    }
    let v27 = s[0] - 1.0168722_f32;
    if v27 >= best {
        vertex = 28;
    }
    if v27 > best {
        best = v27;
    }
    vertex
}

/// Where team 3 leads.
fn team_3(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 2;
    let v53 = -117.26495_f32 - s[2];
    if v53 >= best {
        vertex = 9;
    }
    if v53 > best {
        best = v53;
    }
    let v54 = s[0] + -117.26495_f32;
    if v54 >= best {
        vertex = 32;
    }
    if v54 > best {
        best = v54;
    }
    let v14 = s[0] - 0.7582224_f32;
    if v14 >= best {
        vertex = 28;
    }
    if v14 > best {
        best = v14;
    }
    let v4 = s[0] * -107.57004_f32;
    if v4 >= best {
        vertex = 10;
    }
    if v4 > best {
        best = v4;
    }
    let v16 = s[2] - 0.7582224_f32;
    if v16 >= best {
        vertex = 32;
    }
    if v16 > best {
        best = v16;
    }
    if 26.139645_f32 >= best {
        vertex = 2;
    }
    if 26.139645_f32 > best {
        best = 26.139645_f32;
    }
    vertex
}

/// Where team 14 leads.
fn team_14(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 13;
    let v16 = s[2] - 0.7582224_f32;
    if v16 >= best {
        vertex = 32;
    }
    if v16 > best {
        best = v16;
    }
    let v56 = ops::negate_if_less(s[1], 229.17769_f32);
    if v56 >= best {
        vertex = 11;
    }
    if v56 > best {
        best = v56;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 12;
    }
    if zero > best {
        best = zero;
    }
    let v57 = -107.57004_f32 * s[1];
    if v57 >= best {
        vertex = 13;
    }
    if v57 > best {
        best = v57;
    }
    vertex
}

/// Where team 2 leads.
fn team_2(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 28;
    let v16 = s[2] - 0.7582224_f32;
    if v16 >= best {
        vertex = 32;
    }
    if v16 > best {
        best = v16;
    }
    let v59 = s[2] - 0.75724316_f32;
    if v59 >= best {
        vertex = 32;
    }
    if v59 > best {
        best = v59;
    }
    let v60 = s[2] + -117.26495_f32;
    if v60 >= best {
        vertex = 32;
    }
    if v60 > best {
        best = v60;
    }
    if 1.6245565_f32 >= best {
        vertex = 14;
    }
    if 1.6245565_f32 > best {
        best = 1.6245565_f32;
    }
    let v62 = s[0] - 0.7258825_f32;
    if v62 >= best {
        vertex = 28;
    }
    if v62 > best {
        best = v62;
    }
    let v20 = s[0] * -79.08088_f32;
    if v20 >= best {
        vertex = 29;
    }
    if v20 > best {
        best = v20;
    }
    let v4 = s[0] * -107.57004_f32;
    if v4 >= best {
        vertex = 6;
    }
    if v4 > best {
        best = v4;
    }
    let v14 = s[0] - 0.7582224_f32;
    if v14 >= best {
        vertex = 28;
    }
    if v14 > best {
        best = v14;
    }
    vertex
}

/// Where team 21 leads.
fn team_21(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 29;
    let v20 = s[0] * -79.08088_f32;
    if v20 >= best {
        vertex = 29;
    }
    if v20 > best {
        best = v20;
    }
    let v45 = s[0] - 0.6354382_f32;
    if v45 >= best {
        vertex = 28;
    }
    if v45 > best {
        best = v45;
    }
    let v47 = s[0] + -5.963282_f32;
    if v47 >= best {
        vertex = 32;
    }
    if v47 > best {
        best = v47;
    }
    let v14 = s[0] - 0.7582224_f32;
    if v14 >= best {
        vertex = 28;
    }
    if v14 > best {
        best = v14;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 15;
    }
    if zero > best {
        best = zero;
    }
    let v48 = s[2] * -176.74728_f32;
    if v48 >= best {
        vertex = 16;
    }
    if v48 > best {
        best = v48;
    }
    let v38 = -107.57004_f32 / s[0];
    if v38 >= best {
        vertex = 17;
    }
    if v38 > best {
        best = v38;
    }
    let v4 = s[0] * -107.57004_f32;
    if v4 >= best {
        vertex = 29;
    }
    if v4 > best {
        best = v4;
    }
    vertex
}

/// Where team 5 leads.
fn team_5(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 14;
    let v16 = s[2] - 0.7582224_f32;
    if v16 >= best {
        vertex = 32;
    }
    if v16 > best {
        best = v16;
    }
    let v4 = s[0] * -107.57004_f32;
    if v4 >= best {
        vertex = 6;
    }
    if v4 > best {
        best = v4;
    }
    let v37 = s[1] / 0.0_f32;
    if v37 >= best {
        vertex = 12;
    }
    if v37 > best {
        best = v37;
    }
    if 1.6245565_f32 >= best {
        vertex = 14;
    }
    if 1.6245565_f32 > best {
        best = 1.6245565_f32;
    }
    vertex
}

/// Where team 30 leads.
fn team_30(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 33;
    let v49 = ops::max(s[1], 0.0_f32);
    let v50 = f32::abs(v49);
    if v50 >= best {
        vertex = 34;
    }
    if v50 > best {
        best = v50;
    }
    let v51 = ops::min(s[0], s[1]);
    if v51 >= best {
        vertex = 28;
    }
    if v51 > best {
        best = v51;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 33;
    }
    if zero > best {
        best = zero;
    }
    vertex
}

/// Where team 11 leads.
fn team_11(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 28;
    if 10.629795_f32 >= best {
        vertex = 11;
    }
    if 10.629795_f32 > best {
        best = 10.629795_f32;
    }
    let v64 = ops::min(s[2], 110.01199_f32);
    if v64 >= best {
        vertex = 18;
    }
    if v64 > best {
        best = v64;
    }
    let v14 = s[0] - 0.7582224_f32;
    if v14 >= best {
        vertex = 28;
    }
    if v14 > best {
        best = v14;
    }
    let v4 = s[0] * -107.57004_f32;
    if v4 >= best {
        vertex = 29;
    }
    if v4 > best {
        best = v4;
    }
    let v20 = s[0] * -79.08088_f32;
    if v20 >= best {
        vertex = 29;
    }
    if v20 > best {
        best = v20;
    }
    let v38 = -107.57004_f32 / s[0];
    if v38 >= best {
        vertex = 17;
    }
    if v38 > best {
        best = v38;
    }
    let v16 = s[2] - 0.7582224_f32;
    if v16 >= best {
        vertex = 28;
    }
    if v16 > best {
        best = v16;
    }
    vertex
}

/// Where team 27 leads.
fn team_27(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 31;
    if 2.5843248_f32 >= best {
        vertex = 8;
    }
    if 2.5843248_f32 > best {
        best = 2.5843248_f32;
    }
    let v4 = s[0] * -107.57004_f32;
    if v4 >= best {
        vertex = 29;
    }
    if v4 > best {
        best = v4;
    }
    let v14 = s[0] - 0.7582224_f32;
    if v14 >= best {
        vertex = 28;
    }
    if v14 > best {
        best = v14;
    }
    if s[1] >= best {
        vertex = 31;
    }
    if s[1] > best {
        best = s[1];
    }
    vertex
}

/// Where team 29 leads.
fn team_29(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 17;
    let v72 = s[0] / 0.6354382_f32;
    if v72 >= best {
        vertex = 28;
    }
    if v72 > best {
        best = v72;
    }
    let v14 = s[0] - 0.7582224_f32;
    if v14 >= best {
        vertex = 28;
    }
    if v14 > best {
        best = v14;
    }
    let v48 = s[2] * -176.74728_f32;
    let v70 = v48 / s[1];
    if v70 >= best {
        vertex = 16;
    }
    if v70 > best {
        best = v70;
    }
    if 2.5843248_f32 >= best {
        vertex = 8;
    }
    if 2.5843248_f32 > best {
        best = 2.5843248_f32;
    }
    let v60 = s[2] + -117.26495_f32;
    if v60 >= best {
        vertex = 29;
    }
    if v60 > best {
        best = v60;
    }
    if s[0] >= best {
        vertex = 28;
    }
    if s[0] > best {
        best = s[0];
    }
    let v4 = s[0] * -107.57004_f32;
    if v4 >= best {
        vertex = 17;
    }
    if v4 > best {
        best = v4;
    }
    vertex
}

/// Where team 15 leads.
fn team_15(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 29;
    let v16 = s[2] - 0.7582224_f32;
    if v16 >= best {
        vertex = 19;
    }
    if v16 > best {
        best = v16;
    }
    let v56 = ops::negate_if_less(s[1], 229.17769_f32);
    if v56 >= best {
        vertex = 11;
    }
    if v56 > best {
        best = v56;
    }
    let v60 = s[2] + -117.26495_f32;
    if v60 >= best {
        vertex = 29;
    }
    if v60 > best {
        best = v60;
    }
    let v24 = ops::max(0.0_f32, s[0]);
    let v25 = s[1] - v24;
    if v25 >= best {
        vertex = 31;
    }
    if v25 > best {
        best = v25;
    }
    let v14 = s[0] - 0.7582224_f32;
    if v14 >= best {
        vertex = 28;
    }
    if v14 > best {
        best = v14;
    }
    let v38 = -107.57004_f32 / s[0];
    if v38 >= best {
        vertex = 17;
    }
    if v38 > best {
        best = v38;
    }
    if 10.629795_f32 >= best {
        vertex = 11;
    }
    if 10.629795_f32 > best {
        best = 10.629795_f32;
    }
    let v20 = s[0] * -79.08088_f32;
    if v20 >= best {
        vertex = 29;
    }
    if v20 > best {
        best = v20;
    }
    vertex
}

/// Where team 28 leads.
fn team_28(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 31;
    let v20 = s[0] * -79.08088_f32;
    if v20 >= best {
        vertex = 29;
    }
    if v20 > best {
        best = v20;
    }
    let v45 = s[0] - 0.6354382_f32;
    if v45 >= best {
        vertex = 28;
    }
    if v45 > best {
        best = v45;
    }
    let v4 = s[0] * -107.57004_f32;
    if v4 >= best {
        vertex = 17;
    }
    if v4 > best {
        best = v4;
    }
    let v60 = s[2] + -117.26495_f32;
    if v60 >= best {
        vertex = 29;
    }
    if v60 > best {
        best = v60;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 31;
    }
    if zero > best {
        best = zero;
    }
    let v74 = s[0] * 0.87870044_f32;
    if v74 >= best {
        vertex = 16;
    }
    if v74 > best {
        best = v74;
    }
    let v24 = ops::max(0.0_f32, s[0]);
    let v25 = s[1] - v24;
    if v25 >= best {
        vertex = 31;
    }
    if v25 > best {
        best = v25;
    }
    vertex
}

/// Where team 6 leads.
fn team_6(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 20;
    let v38 = -107.57004_f32 / s[0];
    if v38 >= best {
        vertex = 4;
    }
    if v38 > best {
        best = v38;
    }
    let v16 = s[2] - 0.7582224_f32;
    let v41 = ops::max(s[2], v16);
    if v41 >= best {
        vertex = 32;
    }
    if v41 > best {
        best = v41;
    }
    if v16 >= best {
        vertex = 30;
    }
    if v16 > best {
        best = v16;
    }
    if f32::INFINITY >= best {
        vertex = 20;
    }
    if f32::INFINITY > best {
        best = f32::INFINITY;
    }
    vertex
}

/// Where team 22 leads.
fn team_22(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 17;
    let v68 = 0.0_f32 - s[0];
    let v69 = 2.710111_f32 / v68;
    if v69 >= best {
        vertex = 29;
    }
    if v69 > best {
        best = v69;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 28;
    }
    if zero > best {
        best = zero;
    }
    let v23 = s[1] / s[1];
    if v23 >= best {
        vertex = 8;
    }
    if v23 > best {
        best = v23;
    }
    let v48 = s[2] * -176.74728_f32;
    let v70 = v48 / s[1];
    if v70 >= best {
        vertex = 16;
    }
    if v70 > best {
        best = v70;
    }
    let v45 = s[0] - 0.6354382_f32;
    if v45 >= best {
        vertex = 21;
    }
    if v45 > best {
        best = v45;
    }
    let v14 = s[0] - 0.7582224_f32;
    if v14 >= best {
        vertex = 28;
    }
    if v14 > best {
        best = v14;
    }
    let v4 = s[0] * -107.57004_f32;
    if v4 >= best {
        vertex = 17;
    }
    if v4 > best {
        best = v4;
    }
    vertex
}

/// Where team 32 leads.
fn team_32(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 29;
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 31;
    }
    if zero > best {
        best = zero;
    }
    let v14 = s[0] - 0.7582224_f32;
    if v14 >= best {
        vertex = 28;
    }
    if v14 > best {
        best = v14;
    }
    let v35 = s[1] * -55.687565_f32;
    if v35 >= best {
        vertex = 33;
    }
    if v35 > best {
        best = v35;
    }
    let v4 = s[0] * -107.57004_f32;
    if v4 >= best {
        vertex = 29;
    }
    if v4 > best {
        best = v4;
    }
    vertex
}

/// Where team 33 leads.
fn team_33(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 29;
    let v31 = 0.0_f32 / s[1];
    if v31 >= best {
        vertex = 29;
    }
    if v31 > best {
        best = v31;
    }
    if s[0] >= best {
        vertex = 28;
    }
    if s[0] > best {
        best = s[0];
    }
    let v66 = ops::min(-8.893463_f32, s[1]);
    if v66 >= best {
        vertex = 28;
    }
    if v66 > best {
        best = v66;
    }
    if s[1] >= best {
        vertex = 31;
    }
    if s[1] > best {
        best = s[1];
    }
    let v4 = s[0] * -107.57004_f32;
    if v4 >= best {
        vertex = 29;
    }
    if v4 > best {
        best = v4;
    }
    vertex
}

/// Where team 12 leads.
fn team_12(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 17;
    let v81 = ops::negate_if_less(s[1], -1.1606317_f32);
    if v81 >= best {
        vertex = 22;
    }
    if v81 > best {
        best = v81;
    }
    if 15.754999_f32 >= best {
        vertex = 23;
    }
    if 15.754999_f32 > best {
        best = 15.754999_f32;
    }
    let v57 = -107.57004_f32 * s[1];
    if v57 >= best {
        vertex = 13;
    }
    if v57 > best {
        best = v57;
    }
    let v14 = s[0] - 0.7582224_f32;
    if v14 >= best {
        vertex = 28;
    }
    if v14 > best {
        best = v14;
    }
    let v4 = s[0] * -107.57004_f32;
    if v4 >= best {
        vertex = 17;
    }
    if v4 > best {
        best = v4;
    }
    vertex
}

/// Where team 18 leads.
fn team_18(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 6;
    let v38 = -107.57004_f32 / s[0];
    if v38 >= best {
        vertex = 17;
    }
    if v38 > best {
        best = v38;
    }
    let v14 = s[0] - 0.7582224_f32;
    if v14 >= best {
        vertex = 28;
    }
    if v14 > best {
        best = v14;
    }
    let v75 = -79.08088_f32 - s[0];
    if v75 >= best {
        vertex = 24;
    }
    if v75 > best {
        best = v75;
    }
    let v20 = s[0] * -79.08088_f32;
    if v20 >= best {
        vertex = 29;
    }
    if v20 > best {
        best = v20;
    }
    let v31 = 0.0_f32 / s[1];
    if v31 >= best {
        vertex = 29;
    }
    if v31 > best {
        best = v31;
    }
    let v16 = s[2] - 0.7582224_f32;
    if v16 >= best {
        vertex = 25;
    }
    if v16 > best {
        best = v16;
    }
    if 13.937786_f32 >= best {
        vertex = 11;
    }
    if 13.937786_f32 > best {
        best = 13.937786_f32;
    }
    let v4 = s[0] * -107.57004_f32;
    if v4 >= best {
        vertex = 6;
    }
    if v4 > best {
        best = v4;
    }
    vertex
}

/// Where team 8 leads.
fn team_8(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 28;
    let v40 = s[2] - -6.7057414_f32;
    if v40 >= best {
        vertex = 30;
    }
    if v40 > best {
        best = v40;
    }
    if 6.543999_f32 >= best {
        vertex = 35;
    }
    if 6.543999_f32 > best {
        best = 6.543999_f32;
    }
    let v37 = s[1] / 0.0_f32;
    if v37 >= best {
        vertex = 12;
    }
    if v37 > best {
        best = v37;
    }
    let v20 = s[0] * -79.08088_f32;
    if v20 >= best {
        vertex = 29;
    }
    if v20 > best {
        best = v20;
    }
    let v38 = -107.57004_f32 / s[0];
    if v38 >= best {
        vertex = 17;
    }
    if v38 > best {
        best = v38;
    }
    let v16 = s[2] - 0.7582224_f32;
    if v16 >= best {
        vertex = 30;
    }
    if v16 > best {
        best = v16;
    }
    let v4 = s[0] * -107.57004_f32;
    if v4 >= best {
        vertex = 29;
    }
    if v4 > best {
        best = v4;
    }
    let v14 = s[0] - 0.7582224_f32;
    if v14 >= best {
        vertex = 28;
    }
    if v14 > best {
        best = v14;
    }
    vertex
}

/// Where team 25 leads.
fn team_25(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 29;
    let v20 = s[0] * -79.08088_f32;
    if v20 >= best {
        vertex = 29;
    }
    if v20 > best {
        best = v20;
    }
    let v45 = s[0] - 0.6354382_f32;
    if v45 >= best {
        vertex = 28;
    }
    if v45 > best {
        best = v45;
    }
    if 15.754999_f32 >= best {
        vertex = 26;
    }
    if 15.754999_f32 > best {
        best = 15.754999_f32;
    }
    let v4 = s[0] * -107.57004_f32;
    if v4 >= best {
        vertex = 17;
    }
    if v4 > best {
        best = v4;
    }
    let v60 = s[2] + -117.26495_f32;
    if v60 >= best {
        vertex = 29;
    }
    if v60 > best {
        best = v60;
    }
    vertex
}

/// Where team 13 leads.
fn team_13(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 17;
    let v38 = -107.57004_f32 / s[0];
    if v38 >= best {
        vertex = 17;
    }
    if v38 > best {
        best = v38;
    }
    let v14 = s[0] - 0.7582224_f32;
    if v14 >= best {
        vertex = 28;
    }
    if v14 > best {
        best = v14;
    }
    if 15.754999_f32 >= best {
        vertex = 23;
    }
    if 15.754999_f32 > best {
        best = 15.754999_f32;
    }
    let v20 = s[0] * -79.08088_f32;
    if v20 >= best {
        vertex = 29;
    }
    if v20 > best {
        best = v20;
    }
    let v60 = s[2] + -117.26495_f32;
    if v60 >= best {
        vertex = 29;
    }
    if v60 > best {
        best = v60;
    }
    let v4 = s[0] * -107.57004_f32;
    if v4 >= best {
        vertex = 17;
    }
    if v4 > best {
        best = v4;
    }
    vertex
}

/// Where team 23 leads.
fn team_23(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 29;
    let v74 = s[0] * 0.87870044_f32;
    if v74 >= best {
        vertex = 28;
    }
    if v74 > best {
        best = v74;
    }
    let v77 = s[0] * s[2];
    let v78 = v77 - s[0];
    let v79 = 2.710111_f32 / v78;
    if v79 >= best {
        vertex = 29;
    }
    if v79 > best {
        best = v79;
    }
    let v82 = s[0] + -107.57004_f32;
    if v82 >= best {
        vertex = 29;
    }
    if v82 > best {
        best = v82;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 31;
    }
    if zero > best {
        best = zero;
    }
    let v23 = s[1] / s[1];
    if v23 >= best {
        vertex = 8;
    }
    if v23 > best {
        best = v23;
    }
    let v48 = s[2] * -176.74728_f32;
    let v70 = v48 / s[1];
    if v70 >= best {
        vertex = 16;
    }
    if v70 > best {
        best = v70;
    }
    let v14 = s[0] - 0.7582224_f32;
    if v14 >= best {
        vertex = 8;
    }
    if v14 > best {
        best = v14;
    }
    let v45 = s[0] - 0.6354382_f32;
    if v45 >= best {
        vertex = 21;
    }
    if v45 > best {
        best = v45;
    }
    let v4 = s[0] * -107.57004_f32;
    if v4 >= best {
        vertex = 29;
    }
    if v4 > best {
        best = v4;
    }
    let v84 = s[0] * 0.18706028_f32;
    if v84 >= best {
        vertex = 29;
    }
    if v84 > best {
        best = v84;
    }
    vertex
}

/// Where team 31 leads.
fn team_31(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 28;
    if s[2] >= best {
        vertex = 28;
    }
    if s[2] > best {
        best = s[2];
    }
    if 10.629795_f32 >= best {
        vertex = 16;
    }
    if 10.629795_f32 > best {
        best = 10.629795_f32;
    }
    let v24 = ops::max(0.0_f32, s[0]);
    let v25 = s[1] - v24;
    if v25 >= best {
        vertex = 31;
    }
    if v25 > best {
        best = v25;
    }
    let v4 = s[0] * -107.57004_f32;
    if v4 >= best {
        vertex = 29;
    }
    if v4 > best {
        best = v4;
    }
    let v14 = s[0] - 0.7582224_f32;
    if v14 >= best {
        vertex = 28;
    }
    if v14 > best {
        best = v14;
    }
    vertex
}

/// Where team 19 leads.
fn team_19(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 29;
    let v38 = -107.57004_f32 / s[0];
    if v38 >= best {
        vertex = 17;
    }
    if v38 > best {
        best = v38;
    }
    let v16 = s[2] - 0.7582224_f32;
    if v16 >= best {
        vertex = 32;
    }
    if v16 > best {
        best = v16;
    }
    let v57 = -107.57004_f32 * s[1];
    if v57 >= best {
        vertex = 13;
    }
    if v57 > best {
        best = v57;
    }
    let v45 = s[0] - 0.6354382_f32;
    if v45 >= best {
        vertex = 27;
    }
    if v45 > best {
        best = v45;
    }
    let v4 = s[0] * -107.57004_f32;
    if v4 >= best {
        vertex = 24;
    }
    if v4 > best {
        best = v4;
    }
    let v68 = 0.0_f32 - s[0];
    let v69 = 2.710111_f32 / v68;
    if v69 >= best {
        vertex = 29;
    }
    if v69 > best {
        best = v69;
    }
    vertex
}

/// Where team 26 leads.
fn team_26(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 29;
    if 83.54613_f32 >= best {
        vertex = 16;
    }
    if 83.54613_f32 > best {
        best = 83.54613_f32;
    }
    let v14 = s[0] - 0.7582224_f32;
    if v14 >= best {
        vertex = 28;
    }
    if v14 > best {
        best = v14;
    }
    let v4 = s[0] * -107.57004_f32;
    if v4 >= best {
        vertex = 29;
    }
    if v4 > best {
        best = v4;
    }
    let v77 = s[0] * s[2];
    let v78 = v77 - s[0];
    let v79 = 2.710111_f32 / v78;
    if v79 >= best {
        vertex = 29;
    }
    if v79 > best {
        best = v79;
    }
    vertex
}

/// Where team 20 leads.
fn team_20(s: &[f32; 3]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 13;
    let v38 = -107.57004_f32 / s[0];
    if v38 >= best {
        vertex = 17;
    }
    if v38 > best {
        best = v38;
    }
    let v16 = s[2] - 0.7582224_f32;
    if v16 >= best {
        vertex = 28;
    }
    if v16 > best {
        best = v16;
    }
    if 10.629795_f32 >= best {
        vertex = 11;
    }
    if 10.629795_f32 > best {
        best = 10.629795_f32;
    }
    let v20 = s[0] * -79.08088_f32;
    if v20 >= best {
        vertex = 32;
    }
    if v20 > best {
        best = v20;
    }
    let v14 = s[0] - 0.7582224_f32;
    if v14 >= best {
        vertex = 28;
    }
    if v14 > best {
        best = v14;
    }
    let v4 = s[0] * -107.57004_f32;
    if v4 >= best {
        vertex = 6;
    }
    if v4 > best {
        best = v4;
    }
    let v57 = -107.57004_f32 * s[1];
    if v57 >= best {
        vertex = 13;
    }
    if v57 > best {
        best = v57;
    }
    vertex
}
