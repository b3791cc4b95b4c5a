//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix widowx_rs_fast --profile fast
//! Graph SHA-256: e03ca780ae182528e6a99c13b83e6fc72c791b0b352167b3af393d1d05d741ce
//! 28 teams (15 on the longest walk), 214 edges, 163 programs, 55 distinct operations.
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
/// - `s[0..3]`: reach, ticks, -4095 to 4095
/// - `s[3..6]`: reach_excess, ticks, ticks, mm, -1026 to 1026
/// - `s[6..7]`: reach_pitch, ticks, -2049 to 2049
/// - `s[7..11]`: motors_centred, ticks, -2046 to 2046
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
    pub const STATE: usize = 11;
    /// Actions.
    pub const ACTIONS: usize = 8;
    /// Teams on the longest walk.
    pub const DEPTH: usize = 15;
    /// The arm's sources that make up a state, in order.
    pub const SOURCES: [Source; 4] = [
        Source::Reach,
        Source::ReachExcess,
        Source::ReachPitch,
        Source::MotorsCentred,
    ];
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

impl Policy for WidowxRsFast {
    type State = [f32; 11];
    type Action = ActionId;

    fn decide(&self, s: &[f32; 11]) -> ActionId {
        let mut vertex = 0;
        for _ in 0..Self::DEPTH {
            vertex = match vertex {
                0 => team_0(s),
                1 => team_11(s),
                2 => team_15(s),
                3 => team_23(s),
                4 => team_5(s),
                5 => team_1(s),
                6 => team_12(s),
                7 => team_29(s),
                8 => team_21(s),
                9 => team_17(s),
                10 => team_20(s),
                11 => team_16(s),
                12 => team_27(s),
                13 => team_26(s),
                14 => team_25(s),
                15 => team_24(s),
                16 => team_7(s),
                17 => team_9(s),
                18 => team_6(s),
                19 => team_4(s),
                20 => team_10(s),
                21 => team_13(s),
                22 => team_22(s),
                23 => team_18(s),
                24 => team_28(s),
                25 => team_8(s),
                26 => team_14(s),
                27 => team_19(s),
                _ => break,
            };
        }
        ActionId(vertex.wrapping_sub(28) as u16)
    }
}

/// Where team 0 leads.
fn team_0(s: &[f32; 11]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 5;
    let v2 = s[0] * 0.0_f32;
    if v2 >= best {
        vertex = 28;
    }
    if v2 > best {
        best = v2;
    }
    let v7 = f32::abs(s[6]);
    if v7 >= best {
        vertex = 1;
    }
    if v7 > best {
        best = v7;
    }
    let v10 = 104.24504_f32 * s[4];
    if v10 >= best {
        vertex = 2;
    }
    if v10 > best {
        best = v10;
    }
    let v11 = s[3] - s[6];
    if v11 >= best {
        vertex = 3;
    }
    if v11 > best {
        best = v11;
    }
    let v12 = s[2] - s[6];
    if v12 >= best {
        vertex = 4;
    }
    if v12 > best {
        best = v12;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 28;
    }
    if zero > best {
        best = zero;
    }
    let v5 = s[2] * s[3];
    if v5 >= best {
        vertex = 35;
    }
    if v5 > best {
        best = v5;
    }
    let v13 = f32::abs(s[0]);
    if v13 >= best {
        vertex = 29;
    }
    if v13 > best {
        best = v13;
    }
    let v15 = ops::max(s[6], 82.87463_f32);
    let v16 = s[0] * v15;
    if v16 >= best {
        vertex = 5;
    }
    if v16 > best {
        best = v16;
    }
    vertex
}

/// Where team 11 leads.
fn team_11(s: &[f32; 11]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 28;
    let v17 = s[0] - s[6];
    if v17 >= best {
        vertex = 3;
    }
    if v17 > best {
        best = v17;
    }
    let v12 = s[2] - s[6];
    if v12 >= best {
        vertex = 6;
    }
    if v12 > best {
        best = v12;
    }
    let v18 = 0.0_f32 - s[0];
    if v18 >= best {
        vertex = 7;
    }
    if v18 > best {
        best = v18;
    }
    let v20 = ops::max(s[0], s[6]);
    let v21 = ops::min(v20, s[1]);
    if v21 >= best {
        vertex = 30;
    }
    if v21 > best {
        best = v21;
    }
    let v22 = ops::max(s[0], s[2]);
    if v22 >= best {
        vertex = 8;
    }
    if v22 > best {
        best = v22;
    }
    let v25 = s[9] / 99.55378_f32;
    if v25 >= best {
        vertex = 35;
    }
    if v25 > best {
        best = v25;
    }
    let v26 = f32::abs(s[9]);
    let v27 = ops::min(v26, s[1]);
    if v27 >= best {
        vertex = 30;
    }
    if v27 > best {
        best = v27;
    }
    let v30 = ops::negate_if_less(s[2], s[3]);
    let v31 = v30 - s[1];
    if v31 >= best {
        vertex = 3;
    }
    if v31 > best {
        best = v31;
    }
    let v33 = ops::min(81.83404_f32, s[0]);
    if v33 >= best {
        vertex = 28;
    }
    if v33 > best {
        best = v33;
    }
    let v36 = ops::min(s[5], 17.596085_f32);
    if v36 >= best {
        vertex = 9;
    }
    if v36 > best {
        best = v36;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 28;
    }
    if zero > best {
        best = zero;
    }
    vertex
}

/// Where team 15 leads.
fn team_15(s: &[f32; 11]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 8;
    let v12 = s[2] - s[6];
    if v12 >= best {
        vertex = 8;
    }
    if v12 > best {
        best = v12;
    }
    let v18 = 0.0_f32 - s[0];
    if v18 >= best {
        vertex = 10;
    }
    if v18 > best {
        best = v18;
    }
    let v37 = ops::min(s[6], 17.596085_f32);
    if v37 >= best {
        vertex = 9;
    }
    if v37 > best {
        best = v37;
    }
    let v17 = s[0] - s[6];
    if v17 >= best {
        vertex = 3;
    }
    if v17 > best {
        best = v17;
    }
    let v39 = ops::min(71.53701_f32, s[1]);
    if v39 >= best {
        vertex = 30;
    }
    if v39 > best {
        best = v39;
    }
    let v36 = ops::min(s[5], 17.596085_f32);
    if v36 >= best {
        vertex = 9;
    }
    if v36 > best {
        best = v36;
    }
    let v41 = s[0] - 9.366141_f32;
    if v41 >= best {
        vertex = 11;
    }
    if v41 > best {
        best = v41;
    }
    if s[0] >= best {
        vertex = 28;
    }
    if s[0] > best {
        best = s[0];
    }
    let v25 = s[9] / 99.55378_f32;
    if v25 >= best {
        vertex = 12;
    }
    if v25 > best {
        best = v25;
    }
    let v22 = ops::max(s[0], s[2]);
    if v22 >= best {
        vertex = 8;
    }
    if v22 > best {
        best = v22;
    }
    vertex
}

/// Where team 23 leads.
fn team_23(s: &[f32; 11]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 15;
    let v12 = s[2] - s[6];
    if v12 >= best {
        vertex = 12;
    }
    if v12 > best {
        best = v12;
    }
    if s[0] >= best {
        vertex = 13;
    }
    if s[0] > best {
        best = s[0];
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 28;
    }
    if zero > best {
        best = zero;
    }
    let v25 = s[9] / 99.55378_f32;
    if v25 >= best {
        vertex = 35;
    }
    if v25 > best {
        best = v25;
    }
    let v42 = ops::min(0.0_f32, s[4]);
    if v42 >= best {
        vertex = 14;
    }
    if v42 > best {
        best = v42;
    }
    let v39 = ops::min(71.53701_f32, s[1]);
    if v39 >= best {
        vertex = 30;
    }
    if v39 > best {
        best = v39;
    }
    let v44 = ops::negate_if_less(2.633784_f32, s[0]);
    let v45 = ops::negate_if_less(s[6], v44);
    if v45 >= best {
        vertex = 15;
    }
    if v45 > best {
        best = v45;
    }
    vertex
}

/// Where team 5 leads.
fn team_5(s: &[f32; 11]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 33;
    let v15 = ops::max(s[6], 82.87463_f32);
    let v16 = s[0] * v15;
    if v16 >= best {
        vertex = 28;
    }
    if v16 > best {
        best = v16;
    }
    let v39 = ops::min(71.53701_f32, s[1]);
    if v39 >= best {
        vertex = 30;
    }
    if v39 > best {
        best = v39;
    }
    let v26 = f32::abs(s[9]);
    let v27 = ops::min(v26, s[1]);
    if v27 >= best {
        vertex = 30;
    }
    if v27 > best {
        best = v27;
    }
    let v25 = s[9] / 99.55378_f32;
    if v25 >= best {
        vertex = 16;
    }
    if v25 > best {
        best = v25;
    }
    let v13 = f32::abs(s[0]);
    if v13 >= best {
        vertex = 29;
    }
    if v13 > best {
        best = v13;
    }
    let v18 = 0.0_f32 - s[0];
    if v18 >= best {
        vertex = 7;
    }
    if v18 > best {
        best = v18;
    }
    let v30 = ops::negate_if_less(s[2], s[3]);
    let v31 = v30 - s[1];
    if v31 >= best {
        vertex = 17;
    }
    if v31 > best {
        best = v31;
    }
    let v22 = ops::max(s[0], s[2]);
    if v22 >= best {
        vertex = 18;
    }
    if v22 > best {
        best = v22;
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

/// Where team 1 leads.
fn team_1(s: &[f32; 11]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 4;
    let v5 = s[2] * s[3];
    if v5 >= best {
        vertex = 35;
    }
    if v5 > best {
        best = v5;
    }
    let v46 = s[2] * s[4];
    if v46 >= best {
        vertex = 8;
    }
    if v46 > best {
        best = v46;
    }
    let v18 = 0.0_f32 - s[0];
    if v18 >= best {
        vertex = 7;
    }
    if v18 > best {
        best = v18;
    }
    let v15 = ops::max(s[6], 82.87463_f32);
    let v16 = s[0] * v15;
    if v16 >= best {
        vertex = 19;
    }
    if v16 > best {
        best = v16;
    }
    let v48 = ops::max(s[6], 59.26271_f32);
    if v48 >= best {
        vertex = 1;
    }
    if v48 > best {
        best = v48;
    }
    let v25 = s[9] / 99.55378_f32;
    if v25 >= best {
        vertex = 20;
    }
    if v25 > best {
        best = v25;
    }
    let v12 = s[2] - s[6];
    if v12 >= best {
        vertex = 4;
    }
    if v12 > best {
        best = v12;
    }
    vertex
}

/// Where team 12 leads.
fn team_12(s: &[f32; 11]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 13;
    let v20 = ops::max(s[0], s[6]);
    if v20 >= best {
        vertex = 21;
    }
    if v20 > best {
        best = v20;
    }
    let v50 = s[6] - 5.2186666_f32;
    if v50 >= best {
        vertex = 28;
    }
    if v50 > best {
        best = v50;
    }
    let v18 = 0.0_f32 - s[0];
    if v18 >= best {
        vertex = 7;
    }
    if v18 > best {
        best = v18;
    }
    let v15 = ops::max(s[6], 82.87463_f32);
    let v16 = s[0] * v15;
    if v16 >= best {
        vertex = 28;
    }
    if v16 > best {
        best = v16;
    }
    let v25 = s[9] / 99.55378_f32;
    if v25 >= best {
        vertex = 8;
    }
    if v25 > best {
        best = v25;
    }
    let v33 = ops::min(81.83404_f32, s[0]);
    if v33 >= best {
        vertex = 28;
    }
    if v33 > best {
        best = v33;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 14;
    }
    if zero > best {
        best = zero;
    }
    let v39 = ops::min(71.53701_f32, s[1]);
    if v39 >= best {
        vertex = 30;
    }
    if v39 > best {
        best = v39;
    }
    let v22 = ops::max(s[0], s[2]);
    if v22 >= best {
        vertex = 32;
    }
    if v22 > best {
        best = v22;
    }
    let v51 = s[5] / 17.596085_f32;
    if v51 >= best {
        vertex = 9;
    }
    if v51 > best {
        best = v51;
    }
    if s[0] >= best {
        vertex = 13;
    }
    if s[0] > best {
        best = s[0];
    }
    vertex
}

/// Where team 29 leads.
fn team_29(s: &[f32; 11]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 29;
    let v52 = s[0] / s[5];
    if v52 >= best {
        vertex = 35;
    }
    if v52 > best {
        best = v52;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 29;
    }
    if zero > best {
        best = zero;
    }
    vertex
}

/// Where team 21 leads.
fn team_21(s: &[f32; 11]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 34;
    let v54 = s[0] - 7.9593115_f32;
    if v54 >= best {
        vertex = 28;
    }
    if v54 > best {
        best = v54;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 33;
    }
    if zero > best {
        best = zero;
    }
    let v39 = ops::min(71.53701_f32, s[1]);
    if v39 >= best {
        vertex = 30;
    }
    if v39 > best {
        best = v39;
    }
    let v48 = ops::max(s[6], 59.26271_f32);
    let v55 = s[0] - v48;
    if v55 >= best {
        vertex = 28;
    }
    if v55 > best {
        best = v55;
    }
    let v56 = ops::negate_if_less(s[0], 0.0_f32);
    if v56 >= best {
        vertex = 22;
    }
    if v56 > best {
        best = v56;
    }
    let v25 = s[9] / 99.55378_f32;
    if v25 >= best {
        vertex = 12;
    }
    if v25 > best {
        best = v25;
    }
    let v58 = ops::min(77.8404_f32, s[0]);
    if v58 >= best {
        vertex = 28;
    }
    if v58 > best {
        best = v58;
    }
    let v18 = 0.0_f32 - s[0];
    if v18 >= best {
        vertex = 7;
    }
    if v18 > best {
        best = v18;
    }
    let v59 = s[2] + s[6];
    if v59 >= best {
        vertex = 34;
    }
    if v59 > best {
        best = v59;
    }
    vertex
}

/// Where team 17 leads.
fn team_17(s: &[f32; 11]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 29;
    let v44 = ops::negate_if_less(2.633784_f32, s[0]);
    let v45 = ops::negate_if_less(s[6], v44);
    if v45 >= best {
        vertex = 15;
    }
    if v45 > best {
        best = v45;
    }
    let v25 = s[9] / 99.55378_f32;
    if v25 >= best {
        vertex = 35;
    }
    if v25 > best {
        best = v25;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 28;
    }
    if zero > best {
        best = zero;
    }
    if s[0] >= best {
        vertex = 23;
    }
    if s[0] > best {
        best = s[0];
    }
    let v48 = ops::max(s[6], 59.26271_f32);
    let v60 = s[0] * v48;
    if v60 >= best {
        vertex = 28;
    }
    if v60 > best {
        best = v60;
    }
    let v13 = f32::abs(s[0]);
    if v13 >= best {
        vertex = 29;
    }
    if v13 > best {
        best = v13;
    }
    vertex
}

/// Where team 20 leads.
fn team_20(s: &[f32; 11]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 28;
    let v48 = ops::max(s[6], 59.26271_f32);
    let v55 = s[0] - v48;
    if v55 >= best {
        vertex = 28;
    }
    if v55 > best {
        best = v55;
    }
    let v18 = 0.0_f32 - s[0];
    if v18 >= best {
        vertex = 7;
    }
    if v18 > best {
        best = v18;
    }
    let v60 = s[0] * v48;
    if v60 >= best {
        vertex = 28;
    }
    if v60 > best {
        best = v60;
    }
    let v25 = s[9] / 99.55378_f32;
    if v25 >= best {
        vertex = 12;
    }
    if v25 > best {
        best = v25;
    }
    let v58 = ops::min(77.8404_f32, s[0]);
    if v58 >= best {
        vertex = 28;
    }
    if v58 > best {
        best = v58;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 28;
    }
    if zero > best {
        best = zero;
    }
    vertex
}

/// Where team 16 leads.
fn team_16(s: &[f32; 11]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 30;
    let v25 = s[9] / 99.55378_f32;
    if v25 >= best {
        vertex = 12;
    }
    if v25 > best {
        best = v25;
    }
    let v12 = s[2] - s[6];
    if v12 >= best {
        vertex = 8;
    }
    if v12 > best {
        best = v12;
    }
    let v37 = ops::min(s[6], 17.596085_f32);
    if v37 >= best {
        vertex = 9;
    }
    if v37 > best {
        best = v37;
    }
    let v61 = s[3] - s[0];
    if v61 >= best {
        vertex = 7;
    }
    if v61 > best {
        best = v61;
    }
    let v48 = ops::max(s[6], 59.26271_f32);
    let v63 = s[4] / s[10];
    let v64 = v48 - v63;
    let v65 = s[0] * v64;
    if v65 >= best {
        vertex = 8;
    }
    if v65 > best {
        best = v65;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 29;
    }
    if zero > best {
        best = zero;
    }
    let v22 = ops::max(s[0], s[2]);
    if v22 >= best {
        vertex = 8;
    }
    if v22 > best {
        best = v22;
    }
    let v39 = ops::min(71.53701_f32, s[1]);
    if v39 >= best {
        vertex = 30;
    }
    if v39 > best {
        best = v39;
    }
    vertex
}

/// Where team 27 leads.
fn team_27(s: &[f32; 11]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 24;
    if s[0] >= best {
        vertex = 28;
    }
    if s[0] > best {
        best = s[0];
    }
    let v18 = 0.0_f32 - s[0];
    if v18 >= best {
        vertex = 7;
    }
    if v18 > best {
        best = v18;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 29;
    }
    if zero > best {
        best = zero;
    }
    let v25 = s[9] / 99.55378_f32;
    if v25 >= best {
        vertex = 35;
    }
    if v25 > best {
        best = v25;
    }
    let v67 = s[0] + s[8];
    if v67 >= best {
        vertex = 24;
    }
    if v67 > best {
        best = v67;
    }
    vertex
}

/// Where team 26 leads.
fn team_26(s: &[f32; 11]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 12;
    let v54 = s[0] - 7.9593115_f32;
    if v54 >= best {
        vertex = 28;
    }
    if v54 > best {
        best = v54;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 33;
    }
    if zero > best {
        best = zero;
    }
    let v39 = ops::min(71.53701_f32, s[1]);
    if v39 >= best {
        vertex = 30;
    }
    if v39 > best {
        best = v39;
    }
    if s[0] >= best {
        vertex = 28;
    }
    if s[0] > best {
        best = s[0];
    }
    let v33 = ops::min(81.83404_f32, s[0]);
    if v33 >= best {
        vertex = 28;
    }
    if v33 > best {
        best = v33;
    }
    let v48 = ops::max(s[6], 59.26271_f32);
    let v60 = s[0] * v48;
    if v60 >= best {
        vertex = 28;
    }
    if v60 > best {
        best = v60;
    }
    let v30 = ops::negate_if_less(s[2], s[3]);
    if v30 >= best {
        vertex = 12;
    }
    if v30 > best {
        best = v30;
    }
    let v25 = s[9] / 99.55378_f32;
    if v25 >= best {
        vertex = 12;
    }
    if v25 > best {
        best = v25;
    }
    vertex
}

/// Where team 25 leads.
fn team_25(s: &[f32; 11]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 34;
    let v13 = f32::abs(s[0]);
    if v13 >= best {
        vertex = 29;
    }
    if v13 > best {
        best = v13;
    }
    if s[0] >= best {
        vertex = 28;
    }
    if s[0] > best {
        best = s[0];
    }
    let v68 = s[1] + s[1];
    if v68 >= best {
        vertex = 33;
    }
    if v68 > best {
        best = v68;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 35;
    }
    if zero > best {
        best = zero;
    }
    let v59 = s[2] + s[6];
    if v59 >= best {
        vertex = 34;
    }
    if v59 > best {
        best = v59;
    }
    vertex
}

/// Where team 24 leads.
fn team_24(s: &[f32; 11]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 31;
    let v68 = s[1] + s[1];
    if v68 >= best {
        vertex = 33;
    }
    if v68 > best {
        best = v68;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 31;
    }
    if zero > best {
        best = zero;
    }
    vertex
}

/// Where team 7 leads.
fn team_7(s: &[f32; 11]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 29;
    let v39 = ops::min(71.53701_f32, s[1]);
    if v39 >= best {
        vertex = 30;
    }
    if v39 > best {
        best = v39;
    }
    let v25 = s[9] / 99.55378_f32;
    if v25 >= best {
        vertex = 20;
    }
    if v25 > best {
        best = v25;
    }
    let v20 = ops::max(s[0], s[6]);
    if v20 >= best {
        vertex = 21;
    }
    if v20 > best {
        best = v20;
    }
    let v70 = ops::max(s[10], -52.018345_f32);
    if v70 >= best {
        vertex = 25;
    }
    if v70 > best {
        best = v70;
    }
    let v15 = ops::max(s[6], 82.87463_f32);
    let v16 = s[0] * v15;
    if v16 >= best {
        vertex = 28;
    }
    if v16 > best {
        best = v16;
    }
    let v58 = ops::min(77.8404_f32, s[0]);
    if v58 >= best {
        vertex = 28;
    }
    if v58 > best {
        best = v58;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 33;
    }
    if zero > best {
        best = zero;
    }
    let v18 = 0.0_f32 - s[0];
    if v18 >= best {
        vertex = 7;
    }
    if v18 > best {
        best = v18;
    }
    let v59 = s[2] + s[6];
    if v59 >= best {
        vertex = 34;
    }
    if v59 > best {
        best = v59;
    }
    let v13 = f32::abs(s[0]);
    if v13 >= best {
        vertex = 29;
    }
    if v13 > best {
        best = v13;
    }
    vertex
}

/// Where team 9 leads.
fn team_9(s: &[f32; 11]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 30;
    let v17 = s[0] - s[6];
    if v17 >= best {
        vertex = 3;
    }
    if v17 > best {
        best = v17;
    }
    let v71 = s[2] - s[3];
    if v71 >= best {
        vertex = 8;
    }
    if v71 > best {
        best = v71;
    }
    let v12 = s[2] - s[6];
    if v12 >= best {
        vertex = 6;
    }
    if v12 > best {
        best = v12;
    }
    let v18 = 0.0_f32 - s[0];
    if v18 >= best {
        vertex = 7;
    }
    if v18 > best {
        best = v18;
    }
    let v26 = f32::abs(s[9]);
    let v27 = ops::min(v26, s[1]);
    if v27 >= best {
        vertex = 30;
    }
    if v27 > best {
        best = v27;
    }
    let v22 = ops::max(s[0], s[2]);
    if v22 >= best {
        vertex = 8;
    }
    if v22 > best {
        best = v22;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 28;
    }
    if zero > best {
        best = zero;
    }
    let v25 = s[9] / 99.55378_f32;
    if v25 >= best {
        vertex = 35;
    }
    if v25 > best {
        best = v25;
    }
    let v39 = ops::min(71.53701_f32, s[1]);
    if v39 >= best {
        vertex = 30;
    }
    if v39 > best {
        best = v39;
    }
    let v37 = ops::min(s[6], 17.596085_f32);
    if v37 >= best {
        vertex = 9;
    }
    if v37 > best {
        best = v37;
    }
    let v73 = ops::min(36.712555_f32, s[1]);
    if v73 >= best {
        vertex = 30;
    }
    if v73 > best {
        best = v73;
    }
    vertex
}

/// Where team 6 leads.
fn team_6(s: &[f32; 11]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 3;
    let v25 = s[9] / 99.55378_f32;
    if v25 >= best {
        vertex = 30;
    }
    if v25 > best {
        best = v25;
    }
    let v71 = s[2] - s[3];
    if v71 >= best {
        vertex = 8;
    }
    if v71 > best {
        best = v71;
    }
    let v12 = s[2] - s[6];
    if v12 >= best {
        vertex = 32;
    }
    if v12 > best {
        best = v12;
    }
    let v18 = 0.0_f32 - s[0];
    if v18 >= best {
        vertex = 7;
    }
    if v18 > best {
        best = v18;
    }
    let v73 = ops::min(36.712555_f32, s[1]);
    if v73 >= best {
        vertex = 30;
    }
    if v73 > best {
        best = v73;
    }
    let v26 = f32::abs(s[9]);
    let v27 = ops::min(v26, s[1]);
    if v27 >= best {
        vertex = 30;
    }
    if v27 > best {
        best = v27;
    }
    let v22 = ops::max(s[0], s[2]);
    if v22 >= best {
        vertex = 8;
    }
    if v22 > best {
        best = v22;
    }
    let v29 = ops::min(s[2], -12.947205_f32);
    if v29 >= best {
        vertex = 9;
    }
    if v29 > best {
        best = v29;
    }
    let v36 = ops::min(s[5], 17.596085_f32);
    if v36 >= best {
        vertex = 9;
    }
    if v36 > best {
        best = v36;
    }
    let v37 = ops::min(s[6], 17.596085_f32);
    if v37 >= best {
        vertex = 9;
    }
    if v37 > best {
        best = v37;
    }
    let v17 = s[0] - s[6];
    if v17 >= best {
        vertex = 3;
    }
    if v17 > best {
        best = v17;
    }
    vertex
}

/// Where team 4 leads.
fn team_4(s: &[f32; 11]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 28;
    let v12 = s[2] - s[6];
    if v12 >= best {
        vertex = 4;
    }
    if v12 > best {
        best = v12;
    }
    let v15 = ops::max(s[6], 82.87463_f32);
    let v16 = s[0] * v15;
    if v16 >= best {
        vertex = 28;
    }
    if v16 > best {
        best = v16;
    }
    let v5 = s[2] * s[3];
    if v5 >= best {
        vertex = 35;
    }
    if v5 > best {
        best = v5;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 1;
    }
    if zero > best {
        best = zero;
    }
    let v20 = ops::max(s[0], s[6]);
    let v75 = ops::min(v20, 5.95553_f32);
    if v75 >= best {
        vertex = 30;
    }
    if v75 > best {
        best = v75;
    }
    let v48 = ops::max(s[6], 59.26271_f32);
    let v60 = s[0] * v48;
    if v60 >= best {
        vertex = 28;
    }
    if v60 > best {
        best = v60;
    }
    let v50 = s[6] - 5.2186666_f32;
    if v50 >= best {
        vertex = 28;
    }
    if v50 > best {
        best = v50;
    }
    if s[0] >= best {
        vertex = 28;
    }
    if s[0] > best {
        best = s[0];
    }
    let v7 = f32::abs(s[6]);
    if v7 >= best {
        vertex = 1;
    }
    if v7 > best {
        best = v7;
    }
    let v18 = 0.0_f32 - s[0];
    if v18 >= best {
        vertex = 7;
    }
    if v18 > best {
        best = v18;
    }
    let v2 = s[0] * 0.0_f32;
    if v2 >= best {
        vertex = 28;
    }
    if v2 > best {
        best = v2;
    }
    vertex
}

/// Where team 10 leads.
fn team_10(s: &[f32; 11]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 24;
    let v54 = s[0] - 7.9593115_f32;
    if v54 >= best {
        vertex = 28;
    }
    if v54 > best {
        best = v54;
    }
    if s[0] >= best {
        vertex = 28;
    }
    if s[0] > best {
        best = s[0];
    }
    let v48 = ops::max(s[6], 59.26271_f32);
    let v60 = s[0] * v48;
    if v60 >= best {
        vertex = 28;
    }
    if v60 > best {
        best = v60;
    }
    let v25 = s[9] / 99.55378_f32;
    if v25 >= best {
        vertex = 12;
    }
    if v25 > best {
        best = v25;
    }
    let v18 = 0.0_f32 - s[0];
    if v18 >= best {
        vertex = 7;
    }
    if v18 > best {
        best = v18;
    }
    let v39 = ops::min(71.53701_f32, s[1]);
    if v39 >= best {
        vertex = 30;
    }
    if v39 > best {
        best = v39;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 24;
    }
    if zero > best {
        best = zero;
    }
    vertex
}

/// Where team 13 leads.
fn team_13(s: &[f32; 11]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 28;
    let v41 = s[0] - 9.366141_f32;
    if v41 >= best {
        vertex = 2;
    }
    if v41 > best {
        best = v41;
    }
    let v37 = ops::min(s[6], 17.596085_f32);
    if v37 >= best {
        vertex = 9;
    }
    if v37 > best {
        best = v37;
    }
    let v18 = 0.0_f32 - s[0];
    if v18 >= best {
        vertex = 7;
    }
    if v18 > best {
        best = v18;
    }
    let v22 = ops::max(s[0], s[2]);
    if v22 >= best {
        vertex = 8;
    }
    if v22 > best {
        best = v22;
    }
    let v39 = ops::min(71.53701_f32, s[1]);
    if v39 >= best {
        vertex = 30;
    }
    if v39 > best {
        best = v39;
    }
    let v17 = s[0] - s[6];
    if v17 >= best {
        vertex = 3;
    }
    if v17 > best {
        best = v17;
    }
    if s[0] >= best {
        vertex = 13;
    }
    if s[0] > best {
        best = s[0];
    }
    let v25 = s[9] / 99.55378_f32;
    if v25 >= best {
        vertex = 26;
    }
    if v25 > best {
        best = v25;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 29;
    }
    if zero > best {
        best = zero;
    }
    let v12 = s[2] - s[6];
    if v12 >= best {
        vertex = 8;
    }
    if v12 > best {
        best = v12;
    }
    let v15 = ops::max(s[6], 82.87463_f32);
    let v16 = s[0] * v15;
    if v16 >= best {
        vertex = 28;
    }
    if v16 > best {
        best = v16;
    }
    vertex
}

/// Where team 22 leads.
fn team_22(s: &[f32; 11]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 28;
    let v48 = ops::max(s[6], 59.26271_f32);
    let v55 = s[0] - v48;
    if v55 >= best {
        vertex = 28;
    }
    if v55 > best {
        best = v55;
    }
    let v13 = f32::abs(s[0]);
    if v13 >= best {
        vertex = 29;
    }
    if v13 > best {
        best = v13;
    }
    let v60 = s[0] * v48;
    if v60 >= best {
        vertex = 28;
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
    let v25 = s[9] / 99.55378_f32;
    if v25 >= best {
        vertex = 12;
    }
    if v25 > best {
        best = v25;
    }
    let v33 = ops::min(81.83404_f32, s[0]);
    if v33 >= best {
        vertex = 28;
    }
    if v33 > best {
        best = v33;
    }
    let v44 = ops::negate_if_less(2.633784_f32, s[0]);
    let v45 = ops::negate_if_less(s[6], v44);
    if v45 >= best {
        vertex = 15;
    }
    if v45 > best {
        best = v45;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 28;
    }
    if zero > best {
        best = zero;
    }
    vertex
}

/// Where team 18 leads.
fn team_18(s: &[f32; 11]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 28;
    let v18 = 0.0_f32 - s[0];
    if v18 >= best {
        vertex = 7;
    }
    if v18 > best {
        best = v18;
    }
    let v58 = ops::min(77.8404_f32, s[0]);
    if v58 >= best {
        vertex = 28;
    }
    if v58 > best {
        best = v58;
    }
    if s[0] >= best {
        vertex = 28;
    }
    if s[0] > best {
        best = s[0];
    }
    let v77 = -190.21367_f32 - s[6];
    if v77 >= best {
        vertex = 34;
    }
    if v77 > best {
        best = v77;
    }
    let v67 = s[0] + s[8];
    if v67 >= best {
        vertex = 24;
    }
    if v67 > best {
        best = v67;
    }
    let v78 = ops::min(s[0], s[8]);
    if v78 >= best {
        vertex = 27;
    }
    if v78 > best {
        best = v78;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 28;
    }
    if zero > best {
        best = zero;
    }
    vertex
}

/// Where team 28 leads.
fn team_28(s: &[f32; 11]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 28;
    let v79 = s[6] - s[9];
    if v79 >= best {
        vertex = 35;
    }
    if v79 > best {
        best = v79;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 34;
    }
    if zero > best {
        best = zero;
    }
    if s[0] >= best {
        vertex = 28;
    }
    if s[0] > best {
        best = s[0];
    }
    vertex
}

/// Where team 8 leads.
fn team_8(s: &[f32; 11]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 7;
    let v50 = s[6] - 5.2186666_f32;
    if v50 >= best {
        vertex = 28;
    }
    if v50 > best {
        best = v50;
    }
    let v25 = s[9] / 99.55378_f32;
    if v25 >= best {
        vertex = 35;
    }
    if v25 > best {
        best = v25;
    }
    let v30 = ops::negate_if_less(s[2], s[3]);
    let v31 = v30 - s[1];
    if v31 >= best {
        vertex = 17;
    }
    if v31 > best {
        best = v31;
    }
    let v39 = ops::min(71.53701_f32, s[1]);
    if v39 >= best {
        vertex = 30;
    }
    if v39 > best {
        best = v39;
    }
    let v37 = ops::min(s[6], 17.596085_f32);
    if v37 >= best {
        vertex = 9;
    }
    if v37 > best {
        best = v37;
    }
    if 0.05277237_f32 >= best {
        vertex = 35;
    }
    if 0.05277237_f32 > best {
        best = 0.05277237_f32;
    }
    let v20 = ops::max(s[0], s[6]);
    if v20 >= best {
        vertex = 21;
    }
    if v20 > best {
        best = v20;
    }
    let v81 = ops::min(s[3], s[8]);
    let v82 = v81 - s[0];
    if v82 >= best {
        vertex = 7;
    }
    if v82 > best {
        best = v82;
    }
    let v58 = ops::min(77.8404_f32, s[0]);
    if v58 >= best {
        vertex = 28;
    }
    if v58 > best {
        best = v58;
    }
    let v18 = 0.0_f32 - s[0];
    if v18 >= best {
        vertex = 7;
    }
    if v18 > best {
        best = v18;
    }
    vertex
}

/// Where team 14 leads.
fn team_14(s: &[f32; 11]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 8;
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 33;
    }
    if zero > best {
        best = zero;
    }
    let v25 = s[9] / 99.55378_f32;
    if v25 >= best {
        vertex = 35;
    }
    if v25 > best {
        best = v25;
    }
    let v39 = ops::min(71.53701_f32, s[1]);
    if v39 >= best {
        vertex = 30;
    }
    if v39 > best {
        best = v39;
    }
    let v83 = s[0] * s[6];
    if v83 >= best {
        vertex = 8;
    }
    if v83 > best {
        best = v83;
    }
    let v18 = 0.0_f32 - s[0];
    if v18 >= best {
        vertex = 7;
    }
    if v18 > best {
        best = v18;
    }
    let v37 = ops::min(s[6], 17.596085_f32);
    if v37 >= best {
        vertex = 9;
    }
    if v37 > best {
        best = v37;
    }
    let v12 = s[2] - s[6];
    if v12 >= best {
        vertex = 8;
    }
    if v12 > best {
        best = v12;
    }
    vertex
}

/// Where team 19 leads.
fn team_19(s: &[f32; 11]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 30;
    let v13 = f32::abs(s[0]);
    if v13 >= best {
        vertex = 29;
    }
    if v13 > best {
        best = v13;
    }
    if s[0] >= best {
        vertex = 28;
    }
    if s[0] > best {
        best = s[0];
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 30;
    }
    if zero > best {
        best = zero;
    }
    vertex
}
