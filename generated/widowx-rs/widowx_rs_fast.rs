//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix widowx_rs_fast --profile fast
//! Graph SHA-256: 4c66c6b65c6c713d5ad1fe31be297b7d3fcebbf6d3d7971a9a27b9132c25b11f
//! 30 teams (16 on the longest walk), 210 edges, 156 programs, 58 distinct operations.
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
/// - `s[0..4]`: stance, ticks, -4095 to 4095
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
    /// Teams on the longest walk.
    pub const DEPTH: usize = 16;
    /// Bids that one decision looks at, at most.
    pub const WORST_BIDS: usize = 118;
    /// Operations of one decision, at most.
    pub const WORST_OPERATIONS: usize = 118;
    /// Sines, cosines, logarithms and exponentials among them, at most.
    pub const WORST_MATHS_CALLS: usize = 0;
    /// The arm's sources that make up a state, in order.
    pub const SOURCES: [Source; 2] = [Source::Stance, Source::Floor];
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
    type State = [f32; 5];
    type Action = ActionId;

    fn decide(&self, s: &[f32; 5]) -> ActionId {
        let mut vertex = 0;
        for _ in 0..Self::DEPTH {
            vertex = match vertex {
                0 => team_0(s),
                1 => team_7(s),
                2 => team_44(s),
                3 => team_5(s),
                4 => team_11(s),
                5 => team_10(s),
                6 => team_13(s),
                7 => team_12(s),
                8 => team_32(s),
                9 => team_45(s),
                10 => team_41(s),
                11 => team_14(s),
                12 => team_22(s),
                13 => team_23(s),
                14 => team_35(s),
                15 => team_16(s),
                16 => team_43(s),
                17 => team_38(s),
                18 => team_33(s),
                19 => team_42(s),
                20 => team_30(s),
                21 => team_37(s),
                22 => team_24(s),
                23 => team_40(s),
                24 => team_39(s),
                25 => team_17(s),
                26 => team_34(s),
                27 => team_31(s),
                28 => team_18(s),
                29 => team_36(s),
                _ => break,
            };
        }
        ActionId(vertex.wrapping_sub(30) as u16)
    }
}

/// Where team 0 leads.
fn team_0(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 32;
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        vertex = 35;
    }
    if v5 > best {
        best = v5;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        vertex = 1;
    }
    if v2 > best {
        best = v2;
    }
    let v6 = s[1] - 9.539528_f32;
    if v6 >= best {
        vertex = 2;
    }
    if v6 > best {
        best = v6;
    }
    let v8 = f32::abs(s[2]);
    if v8 >= best {
        vertex = 3;
    }
    if v8 > best {
        best = v8;
    }
    let v11 = 164.8815_f32 * s[3];
    if v11 >= best {
        vertex = 36;
    }
    if v11 > best {
        best = v11;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 32;
    }
    if zero > best {
        best = zero;
    }
    vertex
}

/// Where team 7 leads.
fn team_7(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 6;
    let v24 = -3.3748567_f32 - s[4];
    if v24 >= best {
        vertex = 36;
    }
    if v24 > best {
        best = v24;
    }
    let v6 = s[1] - 9.539528_f32;
    if v6 >= best {
        vertex = 2;
    }
    if v6 > best {
        best = v6;
    }
    let v26 = -10.533181_f32 - s[4];
    if v26 >= best {
        vertex = 4;
    }
    if v26 > best {
        best = v26;
    }
    let v29 = 0.0_f32 - s[4];
    if v29 >= best {
        vertex = 31;
    }
    if v29 > best {
        best = v29;
    }
    let v22 = ops::max(-161.71835_f32, s[2]);
    if v22 >= best {
        vertex = 34;
    }
    if v22 > best {
        best = v22;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 35;
    }
    if zero > best {
        best = zero;
    }
    let v17 = -3.3748567_f32 - s[0];
    let v30 = v17 * s[4];
    if v30 >= best {
        vertex = 31;
    }
    if v30 > best {
        best = v30;
    }
    let v28 = s[3] * -6.3484564_f32;
    if v28 >= best {
        vertex = 5;
    }
    if v28 > best {
        best = v28;
    }
    let v31 = s[3] / s[4];
    if v31 >= best {
        vertex = 6;
    }
    if v31 > best {
        best = v31;
    }
    vertex
}

/// Where team 44 leads.
fn team_44(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 32;
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        vertex = 31;
    }
    if v17 > best {
        best = v17;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        vertex = 30;
    }
    if v2 > best {
        best = v2;
    }
    if s[4] >= best {
        vertex = 32;
    }
    if s[4] > best {
        best = s[4];
    }
    if 9.506875_f32 >= best {
        vertex = 32;
    }
    if 9.506875_f32 > best {
        best = 9.506875_f32;
    }
    vertex
}

/// Where team 5 leads.
fn team_5(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 36;
    let v28 = s[3] * -6.3484564_f32;
    if v28 >= best {
        vertex = 5;
    }
    if v28 > best {
        best = v28;
    }
    let v34 = ops::max(s[2], -3.385455_f32);
    if v34 >= best {
        vertex = 36;
    }
    if v34 > best {
        best = v34;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        vertex = 1;
    }
    if v2 > best {
        best = v2;
    }
    let v17 = -3.3748567_f32 - s[0];
    let v30 = v17 * s[4];
    if v30 >= best {
        vertex = 31;
    }
    if v30 > best {
        best = v30;
    }
    let v35 = -6.3484564_f32 - s[3];
    if v35 >= best {
        vertex = 5;
    }
    if v35 > best {
        best = v35;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 2;
    }
    if zero > best {
        best = zero;
    }
    let v24 = -3.3748567_f32 - s[4];
    if v24 >= best {
        vertex = 36;
    }
    if v24 > best {
        best = v24;
    }
    let v11 = 164.8815_f32 * s[3];
    if v11 >= best {
        vertex = 36;
    }
    if v11 > best {
        best = v11;
    }
    let v13 = s[1] / 11.184899_f32;
    if v13 >= best {
        vertex = 36;
    }
    if v13 > best {
        best = v13;
    }
    vertex
}

/// Where team 11 leads.
fn team_11(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 37;
    let v13 = s[1] / 11.184899_f32;
    if v13 >= best {
        vertex = 34;
    }
    if v13 > best {
        best = v13;
    }
    let v15 = s[1] / 0.0_f32;
    if v15 >= best {
        vertex = 6;
    }
    if v15 > best {
        best = v15;
    }
    let v11 = 164.8815_f32 * s[3];
    if v11 >= best {
        vertex = 36;
    }
    if v11 > best {
        best = v11;
    }
    if 24.873356_f32 >= best {
        vertex = 7;
    }
    if 24.873356_f32 > best {
        best = 24.873356_f32;
    }
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        vertex = 31;
    }
    if v17 > best {
        best = v17;
    }
    let v20 = 0.0_f32 + s[3];
    if v20 >= best {
        vertex = 37;
    }
    if v20 > best {
        best = v20;
    }
    vertex
}

/// Where team 10 leads.
fn team_10(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 6;
    let v13 = s[1] / 11.184899_f32;
    if v13 >= best {
        vertex = 34;
    }
    if v13 > best {
        best = v13;
    }
    let v63 = s[1] - 9.689877_f32;
    if v63 >= best {
        vertex = 8;
    }
    if v63 > best {
        best = v63;
    }
    if 24.873356_f32 >= best {
        vertex = 7;
    }
    if 24.873356_f32 > best {
        best = 24.873356_f32;
    }
    let v43 = f32::abs(s[4]);
    let v44 = s[0] / v43;
    if v44 >= best {
        vertex = 30;
    }
    if v44 > best {
        best = v44;
    }
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        vertex = 9;
    }
    if v17 > best {
        best = v17;
    }
    let v29 = 0.0_f32 - s[4];
    if v29 >= best {
        vertex = 31;
    }
    if v29 > best {
        best = v29;
    }
    let v15 = s[1] / 0.0_f32;
    if v15 >= best {
        vertex = 6;
    }
    if v15 > best {
        best = v15;
    }
    vertex
}

/// Where team 13 leads.
fn team_13(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 31;
    if 22.918602_f32 >= best {
        vertex = 10;
    }
    if 22.918602_f32 > best {
        best = 22.918602_f32;
    }
    let v48 = f32::abs(s[3]);
    if v48 >= best {
        vertex = 8;
    }
    if v48 > best {
        best = v48;
    }
    let v11 = 164.8815_f32 * s[3];
    if v11 >= best {
        vertex = 36;
    }
    if v11 > best {
        best = v11;
    }
    let v36 = s[1] + 9.539528_f32;
    if v36 >= best {
        vertex = 11;
    }
    if v36 > best {
        best = v36;
    }
    let v50 = s[0] / 11.077008_f32;
    if v50 >= best {
        vertex = 12;
    }
    if v50 > best {
        best = v50;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        vertex = 13;
    }
    if v2 > best {
        best = v2;
    }
    let v43 = f32::abs(s[4]);
    let v44 = s[0] / v43;
    if v44 >= best {
        vertex = 14;
    }
    if v44 > best {
        best = v44;
    }
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        vertex = 9;
    }
    if v17 > best {
        best = v17;
    }
    let v37 = ops::min(v17, s[4]);
    if v37 >= best {
        vertex = 31;
    }
    if v37 > best {
        best = v37;
    }
    vertex
}

/// Where team 12 leads.
fn team_12(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 31;
    let v11 = 164.8815_f32 * s[3];
    if v11 >= best {
        vertex = 36;
    }
    if v11 > best {
        best = v11;
    }
    let v15 = s[1] / 0.0_f32;
    if v15 >= best {
        vertex = 15;
    }
    if v15 > best {
        best = v15;
    }
    let v43 = f32::abs(s[4]);
    let v58 = s[1] / v43;
    if v58 >= best {
        vertex = 30;
    }
    if v58 > best {
        best = v58;
    }
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        vertex = 9;
    }
    if v17 > best {
        best = v17;
    }
    let v52 = ops::negate_if_less(s[1], -26.200392_f32);
    if v52 >= best {
        vertex = 33;
    }
    if v52 > best {
        best = v52;
    }
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        vertex = 2;
    }
    if v5 > best {
        best = v5;
    }
    if 11.302588_f32 >= best {
        vertex = 16;
    }
    if 11.302588_f32 > best {
        best = 11.302588_f32;
    }
    let v29 = 0.0_f32 - s[4];
    if v29 >= best {
        vertex = 31;
    }
    if v29 > best {
        best = v29;
    }
    vertex
}

/// Where team 32 leads.
fn team_32(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 2;
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        vertex = 17;
    }
    if v17 > best {
        best = v17;
    }
    if 22.918602_f32 >= best {
        vertex = 37;
    }
    if 22.918602_f32 > best {
        best = 22.918602_f32;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        vertex = 30;
    }
    if v2 > best {
        best = v2;
    }
    let v8 = f32::abs(s[2]);
    if v8 >= best {
        vertex = 18;
    }
    if v8 > best {
        best = v8;
    }
    let v36 = s[1] + 9.539528_f32;
    if v36 >= best {
        vertex = 2;
    }
    if v36 > best {
        best = v36;
    }
    let v57 = s[3] / 15.430052_f32;
    if v57 >= best {
        vertex = 36;
    }
    if v57 > best {
        best = v57;
    }
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        vertex = 2;
    }
    if v5 > best {
        best = v5;
    }
    vertex
}

/// Where team 45 leads.
fn team_45(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 31;
    let v52 = ops::negate_if_less(s[1], -26.200392_f32);
    if v52 >= best {
        vertex = 33;
    }
    if v52 > best {
        best = v52;
    }
    let v53 = ops::max(s[4], s[1]);
    let v54 = ops::max(v53, s[4]);
    if v54 >= best {
        vertex = 31;
    }
    if v54 > best {
        best = v54;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        vertex = 30;
    }
    if v2 > best {
        best = v2;
    }
    let v29 = 0.0_f32 - s[4];
    if v29 >= best {
        vertex = 31;
    }
    if v29 > best {
        best = v29;
    }
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        vertex = 35;
    }
    if v5 > best {
        best = v5;
    }
    if 4.372006_f32 >= best {
        vertex = 31;
    }
    if 4.372006_f32 > best {
        best = 4.372006_f32;
    }
    let v55 = ops::min(s[2], s[3]);
    if v55 >= best {
        vertex = 31;
    }
    if v55 > best {
        best = v55;
    }
    vertex
}

/// Where team 41 leads.
fn team_41(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 30;
    let v38 = ops::max(s[2], s[4]);
    if v38 >= best {
        vertex = 31;
    }
    if v38 > best {
        best = v38;
    }
    let v39 = ops::max(s[4], 0.0_f32);
    if v39 >= best {
        vertex = 19;
    }
    if v39 > best {
        best = v39;
    }
    let v40 = s[4] / 0.0_f32;
    let v42 = v40 * -72.49379_f32;
    if v42 >= best {
        vertex = 31;
    }
    if v42 > best {
        best = v42;
    }
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        vertex = 2;
    }
    if v5 > best {
        best = v5;
    }
    let v43 = f32::abs(s[4]);
    let v44 = s[0] / v43;
    if v44 >= best {
        vertex = 30;
    }
    if v44 > best {
        best = v44;
    }
    if 10.948133_f32 >= best {
        vertex = 16;
    }
    if 10.948133_f32 > best {
        best = 10.948133_f32;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        vertex = 30;
    }
    if v2 > best {
        best = v2;
    }
    vertex
}

/// Where team 14 leads.
fn team_14(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 15;
    let v13 = s[1] / 11.184899_f32;
    if v13 >= best {
        vertex = 34;
    }
    if v13 > best {
        best = v13;
    }
    if 11.302588_f32 >= best {
        vertex = 16;
    }
    if 11.302588_f32 > best {
        best = 11.302588_f32;
    }
    let v29 = 0.0_f32 - s[4];
    if v29 >= best {
        vertex = 31;
    }
    if v29 > best {
        best = v29;
    }
    let v75 = -3.5602038_f32 - s[0];
    if v75 >= best {
        vertex = 31;
    }
    if v75 > best {
        best = v75;
    }
    let v46 = s[1] * s[4];
    if v46 >= best {
        vertex = 31;
    }
    if v46 > best {
        best = v46;
    }
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        vertex = 31;
    }
    if v17 > best {
        best = v17;
    }
    let v11 = 164.8815_f32 * s[3];
    if v11 >= best {
        vertex = 36;
    }
    if v11 > best {
        best = v11;
    }
    let v15 = s[1] / 0.0_f32;
    if v15 >= best {
        vertex = 15;
    }
    if v15 > best {
        best = v15;
    }
    vertex
}

/// Where team 22 leads.
fn team_22(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 35;
    let v17 = -3.3748567_f32 - s[0];
    let v37 = ops::min(v17, s[4]);
    if v37 >= best {
        vertex = 31;
    }
    if v37 > best {
        best = v37;
    }
    let v8 = f32::abs(s[2]);
    if v8 >= best {
        vertex = 20;
    }
    if v8 > best {
        best = v8;
    }
    let v76 = s[4] * s[4];
    if v76 >= best {
        vertex = 8;
    }
    if v76 > best {
        best = v76;
    }
    if v17 >= best {
        vertex = 31;
    }
    if v17 > best {
        best = v17;
    }
    let v40 = s[4] / 0.0_f32;
    let v42 = v40 * -72.49379_f32;
    if v42 >= best {
        vertex = 33;
    }
    if v42 > best {
        best = v42;
    }
    if 22.918602_f32 >= best {
        vertex = 37;
    }
    if 22.918602_f32 > best {
        best = 22.918602_f32;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        vertex = 13;
    }
    if v2 > best {
        best = v2;
    }
    let v11 = 164.8815_f32 * s[3];
    if v11 >= best {
        vertex = 36;
    }
    if v11 > best {
        best = v11;
    }
    let v79 = s[0] + s[4];
    let v80 = v79 / 9.539528_f32;
    if v80 >= best {
        vertex = 37;
    }
    if v80 > best {
        best = v80;
    }
    let v71 = s[1] - s[4];
    if v71 >= best {
        vertex = 35;
    }
    if v71 > best {
        best = v71;
    }
    vertex
}

/// Where team 23 leads.
fn team_23(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 34;
    let v73 = s[1] / 6.928064_f32;
    if v73 >= best {
        vertex = 21;
    }
    if v73 > best {
        best = v73;
    }
    let v57 = s[3] / 15.430052_f32;
    if v57 >= best {
        vertex = 33;
    }
    if v57 > best {
        best = v57;
    }
    let v43 = f32::abs(s[4]);
    let v44 = s[0] / v43;
    if v44 >= best {
        vertex = 30;
    }
    if v44 > best {
        best = v44;
    }
    let v8 = f32::abs(s[2]);
    if v8 >= best {
        vertex = 22;
    }
    if v8 > best {
        best = v8;
    }
    if 22.918602_f32 >= best {
        vertex = 37;
    }
    if 22.918602_f32 > best {
        best = 22.918602_f32;
    }
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        vertex = 2;
    }
    if v5 > best {
        best = v5;
    }
    let v22 = ops::max(-161.71835_f32, s[2]);
    if v22 >= best {
        vertex = 34;
    }
    if v22 > best {
        best = v22;
    }
    vertex
}

/// Where team 35 leads.
fn team_35(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 35;
    let v17 = -3.3748567_f32 - s[0];
    let v37 = ops::min(v17, s[4]);
    if v37 >= best {
        vertex = 31;
    }
    if v37 > best {
        best = v37;
    }
    let v81 = ops::negate_if_less(-3.3748567_f32, s[0]);
    if v81 >= best {
        vertex = 31;
    }
    if v81 > best {
        best = v81;
    }
    let v67 = s[2] + s[2];
    if v67 >= best {
        vertex = 23;
    }
    if v67 > best {
        best = v67;
    }
    let v8 = f32::abs(s[2]);
    if v8 >= best {
        vertex = 24;
    }
    if v8 > best {
        best = v8;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        vertex = 30;
    }
    if v2 > best {
        best = v2;
    }
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        vertex = 2;
    }
    if v5 > best {
        best = v5;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 35;
    }
    if zero > best {
        best = zero;
    }
    vertex
}

/// Where team 16 leads.
fn team_16(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 25;
    let v43 = f32::abs(s[4]);
    if v43 >= best {
        vertex = 19;
    }
    if v43 > best {
        best = v43;
    }
    let v40 = s[4] / 0.0_f32;
    let v42 = v40 * -72.49379_f32;
    if v42 >= best {
        vertex = 33;
    }
    if v42 > best {
        best = v42;
    }
    let v71 = s[1] - s[4];
    if v71 >= best {
        vertex = 35;
    }
    if v71 > best {
        best = v71;
    }
    if 22.918602_f32 >= best {
        vertex = 10;
    }
    if 22.918602_f32 > best {
        best = 22.918602_f32;
    }
    let v46 = s[1] * s[4];
    if v46 >= best {
        vertex = 8;
    }
    if v46 > best {
        best = v46;
    }
    let v8 = f32::abs(s[2]);
    if v8 >= best {
        vertex = 20;
    }
    if v8 > best {
        best = v8;
    }
    let v11 = 164.8815_f32 * s[3];
    if v11 >= best {
        vertex = 36;
    }
    if v11 > best {
        best = v11;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        vertex = 25;
    }
    if v2 > best {
        best = v2;
    }
    vertex
}

/// Where team 43 leads.
fn team_43(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 33;
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        vertex = 35;
    }
    if v5 > best {
        best = v5;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        vertex = 30;
    }
    if v2 > best {
        best = v2;
    }
    let v55 = ops::min(s[2], s[3]);
    if v55 >= best {
        vertex = 31;
    }
    if v55 > best {
        best = v55;
    }
    let v70 = ops::max(s[0], 0.0_f32);
    if v70 >= best {
        vertex = 33;
    }
    if v70 > best {
        best = v70;
    }
    vertex
}

/// Where team 38 leads.
fn team_38(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 2;
    let v67 = s[2] + s[2];
    if v67 >= best {
        vertex = 23;
    }
    if v67 > best {
        best = v67;
    }
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        vertex = 2;
    }
    if v5 > best {
        best = v5;
    }
    let v48 = f32::abs(s[3]);
    if v48 >= best {
        vertex = 24;
    }
    if v48 > best {
        best = v48;
    }
    let v69 = ops::min(s[2], 213.59233_f32);
    if v69 >= best {
        vertex = 37;
    }
    if v69 > best {
        best = v69;
    }
    let v43 = f32::abs(s[4]);
    let v58 = s[1] / v43;
    if v58 >= best {
        vertex = 30;
    }
    if v58 > best {
        best = v58;
    }
    if 4.372006_f32 >= best {
        vertex = 31;
    }
    if 4.372006_f32 > best {
        best = 4.372006_f32;
    }
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        vertex = 31;
    }
    if v17 > best {
        best = v17;
    }
    let v8 = f32::abs(s[2]);
    if v8 >= best {
        vertex = 16;
    }
    if v8 > best {
        best = v8;
    }
    let v36 = s[1] + 9.539528_f32;
    if v36 >= best {
        vertex = 2;
    }
    if v36 > best {
        best = v36;
    }
    vertex
}

/// Where team 33 leads.
fn team_33(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 35;
    let v43 = f32::abs(s[4]);
    let v82 = s[2] / v43;
    if v82 >= best {
        vertex = 30;
    }
    if v82 > best {
        best = v82;
    }
    let v83 = s[4] - -22.172918_f32;
    let v84 = 9.539528_f32 + v83;
    if v84 >= best {
        vertex = 26;
    }
    if v84 > best {
        best = v84;
    }
    let v85 = ops::max(s[2], 99.64715_f32);
    if v85 >= best {
        vertex = 10;
    }
    if v85 > best {
        best = v85;
    }
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        vertex = 9;
    }
    if v17 > best {
        best = v17;
    }
    let v87 = -72.89382_f32 / s[4];
    if v87 >= best {
        vertex = 35;
    }
    if v87 > best {
        best = v87;
    }
    vertex
}

/// Where team 42 leads.
fn team_42(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 16;
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        vertex = 30;
    }
    if v2 > best {
        best = v2;
    }
    let v55 = ops::min(s[2], s[3]);
    if v55 >= best {
        vertex = 31;
    }
    if v55 > best {
        best = v55;
    }
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        vertex = 31;
    }
    if v17 > best {
        best = v17;
    }
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        vertex = 2;
    }
    if v5 > best {
        best = v5;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 37;
    }
    if zero > best {
        best = zero;
    }
    let v8 = f32::abs(s[2]);
    if v8 >= best {
        vertex = 16;
    }
    if v8 > best {
        best = v8;
    }
    vertex
}

/// Where team 30 leads.
fn team_30(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 2;
    let v43 = f32::abs(s[4]);
    let v44 = s[0] / v43;
    if v44 >= best {
        vertex = 30;
    }
    if v44 > best {
        best = v44;
    }
    let v79 = s[0] + s[4];
    let v80 = v79 / 9.539528_f32;
    if v80 >= best {
        vertex = 37;
    }
    if v80 > best {
        best = v80;
    }
    let v91 = s[1] / s[4];
    if v91 >= best {
        vertex = 21;
    }
    if v91 > best {
        best = v91;
    }
    let v66 = s[2] - 99.64715_f32;
    if v66 >= best {
        vertex = 17;
    }
    if v66 > best {
        best = v66;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        vertex = 30;
    }
    if v2 > best {
        best = v2;
    }
    let v8 = f32::abs(s[2]);
    if v8 >= best {
        vertex = 18;
    }
    if v8 > best {
        best = v8;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 35;
    }
    if zero > best {
        best = zero;
    }
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        vertex = 9;
    }
    if v17 > best {
        best = v17;
    }
    let v40 = s[4] / 0.0_f32;
    let v42 = v40 * -72.49379_f32;
    if v42 >= best {
        vertex = 27;
    }
    if v42 > best {
        best = v42;
    }
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        vertex = 2;
    }
    if v5 > best {
        best = v5;
    }
    vertex
}

/// Where team 37 leads.
fn team_37(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 31;
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        vertex = 30;
    }
    if v2 > best {
        best = v2;
    }
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        vertex = 2;
    }
    if v5 > best {
        best = v5;
    }
    if 4.372006_f32 >= best {
        vertex = 31;
    }
    if 4.372006_f32 > best {
        best = 4.372006_f32;
    }
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        vertex = 31;
    }
    if v17 > best {
        best = v17;
    }
    vertex
}

/// Where team 24 leads.
fn team_24(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 30;
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        vertex = 17;
    }
    if v17 > best {
        best = v17;
    }
    if 22.918602_f32 >= best {
        vertex = 37;
    }
    if 22.918602_f32 > best {
        best = 22.918602_f32;
    }
    let v8 = f32::abs(s[2]);
    if v8 >= best {
        vertex = 18;
    }
    if v8 > best {
        best = v8;
    }
    let v57 = s[3] / 15.430052_f32;
    if v57 >= best {
        vertex = 33;
    }
    if v57 > best {
        best = v57;
    }
    let v36 = s[1] + 9.539528_f32;
    if v36 >= best {
        vertex = 2;
    }
    if v36 > best {
        best = v36;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        vertex = 30;
    }
    if v2 > best {
        best = v2;
    }
    vertex
}

/// Where team 40 leads.
fn team_40(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 33;
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        vertex = 35;
    }
    if v5 > best {
        best = v5;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        vertex = 30;
    }
    if v2 > best {
        best = v2;
    }
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        vertex = 31;
    }
    if v17 > best {
        best = v17;
    }
    let v90 = f32::abs(s[0]);
    if v90 >= best {
        vertex = 31;
    }
    if v90 > best {
        best = v90;
    }
    let v55 = ops::min(s[2], s[3]);
    if v55 >= best {
        vertex = 31;
    }
    if v55 > best {
        best = v55;
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

/// Where team 39 leads.
fn team_39(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 30;
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        vertex = 35;
    }
    if v5 > best {
        best = v5;
    }
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        vertex = 31;
    }
    if v17 > best {
        best = v17;
    }
    let v60 = s[0] / 17.709658_f32;
    if v60 >= best {
        vertex = 30;
    }
    if v60 > best {
        best = v60;
    }
    let v55 = ops::min(s[2], s[3]);
    if v55 >= best {
        vertex = 31;
    }
    if v55 > best {
        best = v55;
    }
    let v61 = 0.0_f32 * s[2];
    if v61 >= best {
        vertex = 32;
    }
    if v61 > best {
        best = v61;
    }
    let v8 = f32::abs(s[2]);
    if v8 >= best {
        vertex = 16;
    }
    if v8 > best {
        best = v8;
    }
    let v43 = f32::abs(s[4]);
    let v44 = s[0] / v43;
    if v44 >= best {
        vertex = 30;
    }
    if v44 > best {
        best = v44;
    }
    vertex
}

/// Where team 17 leads.
fn team_17(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 2;
    let v8 = f32::abs(s[2]);
    if v8 >= best {
        vertex = 14;
    }
    if v8 > best {
        best = v8;
    }
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        vertex = 35;
    }
    if v5 > best {
        best = v5;
    }
    let v17 = -3.3748567_f32 - s[0];
    let v37 = ops::min(v17, s[4]);
    if v37 >= best {
        vertex = 31;
    }
    if v37 > best {
        best = v37;
    }
    if 22.918602_f32 >= best {
        vertex = 37;
    }
    if 22.918602_f32 > best {
        best = 22.918602_f32;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        vertex = 13;
    }
    if v2 > best {
        best = v2;
    }
    let v76 = s[4] * s[4];
    if v76 >= best {
        vertex = 28;
    }
    if v76 > best {
        best = v76;
    }
    let v55 = ops::min(s[2], s[3]);
    if v55 >= best {
        vertex = 31;
    }
    if v55 > best {
        best = v55;
    }
    let v78 = s[1] / -9.539528_f32;
    if v78 >= best {
        vertex = 2;
    }
    if v78 > best {
        best = v78;
    }
    vertex
}

/// Where team 34 leads.
fn team_34(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 14;
    let v89 = s[4] * -4.136917_f32;
    if v89 >= best {
        vertex = 30;
    }
    if v89 > best {
        best = v89;
    }
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        vertex = 2;
    }
    if v5 > best {
        best = v5;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 31;
    }
    if zero > best {
        best = zero;
    }
    let v40 = s[4] / 0.0_f32;
    let v42 = v40 * -72.49379_f32;
    if v42 >= best {
        vertex = 31;
    }
    if v42 > best {
        best = v42;
    }
    let v43 = f32::abs(s[4]);
    if v43 >= best {
        vertex = 29;
    }
    if v43 > best {
        best = v43;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        vertex = 30;
    }
    if v2 > best {
        best = v2;
    }
    let v36 = s[1] + 9.539528_f32;
    if v36 >= best {
        vertex = 2;
    }
    if v36 > best {
        best = v36;
    }
    let v44 = s[0] / v43;
    if v44 >= best {
        vertex = 14;
    }
    if v44 > best {
        best = v44;
    }
    vertex
}

/// Where team 31 leads.
fn team_31(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 26;
    if 7.3802834_f32 >= best {
        vertex = 35;
    }
    if 7.3802834_f32 > best {
        best = 7.3802834_f32;
    }
    let v8 = f32::abs(s[2]);
    if v8 >= best {
        vertex = 17;
    }
    if v8 > best {
        best = v8;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        vertex = 30;
    }
    if v2 > best {
        best = v2;
    }
    let v36 = s[1] + 9.539528_f32;
    if v36 >= best {
        vertex = 26;
    }
    if v36 > best {
        best = v36;
    }
    vertex
}

/// Where team 18 leads.
fn team_18(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 31;
    if 22.918602_f32 >= best {
        vertex = 37;
    }
    if 22.918602_f32 > best {
        best = 22.918602_f32;
    }
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        vertex = 33;
    }
    if v5 > best {
        best = v5;
    }
    let v17 = -3.3748567_f32 - s[0];
    let v37 = ops::min(v17, s[4]);
    if v37 >= best {
        vertex = 31;
    }
    if v37 > best {
        best = v37;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        vertex = 13;
    }
    if v2 > best {
        best = v2;
    }
    let v76 = s[4] * s[4];
    if v76 >= best {
        vertex = 8;
    }
    if v76 > best {
        best = v76;
    }
    let v55 = ops::min(s[2], s[3]);
    if v55 >= best {
        vertex = 31;
    }
    if v55 > best {
        best = v55;
    }
    let v78 = s[1] / -9.539528_f32;
    if v78 >= best {
        vertex = 2;
    }
    if v78 > best {
        best = v78;
    }
    let v43 = f32::abs(s[4]);
    let v44 = s[0] / v43;
    if v44 >= best {
        vertex = 18;
    }
    if v44 > best {
        best = v44;
    }
    let v8 = f32::abs(s[2]);
    if v8 >= best {
        vertex = 20;
    }
    if v8 > best {
        best = v8;
    }
    if v17 >= best {
        vertex = 31;
    }
    if v17 > best {
        best = v17;
    }
    vertex
}

/// Where team 36 leads.
fn team_36(s: &[f32; 5]) -> u8 {
    let mut best = f32::MIN;
    let mut vertex = 31;
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        vertex = 35;
    }
    if v5 > best {
        best = v5;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        vertex = 33;
    }
    if zero > best {
        best = zero;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        vertex = 30;
    }
    if v2 > best {
        best = v2;
    }
    let v55 = ops::min(s[2], s[3]);
    if v55 >= best {
        vertex = 31;
    }
    if v55 > best {
        best = v55;
    }
    vertex
}
