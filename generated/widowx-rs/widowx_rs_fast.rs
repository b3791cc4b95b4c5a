//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix widowx_rs_fast --profile fast
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
    /// Teams on the longest walk.
    pub const DEPTH: usize = 16;
    /// Bids that one decision looks at, at most.
    pub const WORST_BIDS: usize = 118;
    /// Operations of one decision, at most.
    pub const WORST_OPERATIONS: usize = 118;
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
    let mut way = 6;
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        best = v5;
        way = 1;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        best = v2;
        way = 2;
    }
    let v6 = s[1] - 9.539528_f32;
    if v6 >= best {
        best = v6;
        way = 3;
    }
    let v8 = f32::abs(s[2]);
    if v8 >= best {
        best = v8;
        way = 4;
    }
    let v11 = 164.8815_f32 * s[3];
    if v11 >= best {
        best = v11;
        way = 5;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        best = zero;
        way = 6;
    }
    match way {
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
    let mut way = 8;
    let v23 = -3.3748567_f32 - s[4];
    if v23 >= best {
        best = v23;
        way = 1;
    }
    let v6 = s[1] - 9.539528_f32;
    if v6 >= best {
        best = v6;
        way = 2;
    }
    let v25 = -10.533181_f32 - s[4];
    if v25 >= best {
        best = v25;
        way = 3;
    }
    let v28 = 0.0_f32 - s[4];
    if v28 >= best {
        best = v28;
        way = 6;
    }
    let v21 = ops::max(-161.71835_f32, s[2]);
    if v21 >= best {
        best = v21;
        way = 4;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        best = zero;
        way = 5;
    }
    let v17 = -3.3748567_f32 - s[0];
    let v29 = v17 * s[4];
    if v29 >= best {
        best = v29;
        way = 6;
    }
    let v27 = s[3] * -6.3484564_f32;
    if v27 >= best {
        best = v27;
        way = 7;
    }
    let v30 = s[3] / s[4];
    if v30 >= best {
        best = v30;
        way = 8;
    }
    match way {
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
    let mut way = 3;
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        best = v17;
        way = 1;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        best = v2;
        way = 2;
    }
    if s[4] >= best {
        best = s[4];
        way = 3;
    }
    if 9.506875_f32 >= best {
        best = 9.506875_f32;
        way = 3;
    }
    match way {
        1 => 1,
        2 => 0,
        _ => 2,
    }
}

/// What team 5 decides.
fn team_5(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut way = 5;
    let v27 = s[3] * -6.3484564_f32;
    if v27 >= best {
        best = v27;
        way = 3;
    }
    let v33 = ops::max(s[2], -3.385455_f32);
    if v33 >= best {
        best = v33;
        way = 5;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        best = v2;
        way = 1;
    }
    let v17 = -3.3748567_f32 - s[0];
    let v29 = v17 * s[4];
    if v29 >= best {
        best = v29;
        way = 2;
    }
    let v34 = -6.3484564_f32 - s[3];
    if v34 >= best {
        best = v34;
        way = 3;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        best = zero;
        way = 4;
    }
    let v23 = -3.3748567_f32 - s[4];
    if v23 >= best {
        best = v23;
        way = 5;
    }
    let v11 = 164.8815_f32 * s[3];
    if v11 >= best {
        best = v11;
        way = 5;
    }
    let v13 = s[1] / 11.184899_f32;
    if v13 >= best {
        best = v13;
        way = 5;
    }
    match way {
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
    let mut way = 6;
    let v13 = s[1] / 11.184899_f32;
    if v13 >= best {
        best = v13;
        way = 1;
    }
    let v15 = s[1] / 0.0_f32;
    if v15 >= best {
        best = v15;
        way = 2;
    }
    let v11 = 164.8815_f32 * s[3];
    if v11 >= best {
        best = v11;
        way = 3;
    }
    if 24.873356_f32 >= best {
        best = 24.873356_f32;
        way = 4;
    }
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        best = v17;
        way = 5;
    }
    if s[3] >= best {
        best = s[3];
        way = 6;
    }
    match way {
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
    let mut way = 7;
    let v13 = s[1] / 11.184899_f32;
    if v13 >= best {
        best = v13;
        way = 1;
    }
    let v61 = s[1] - 9.689877_f32;
    if v61 >= best {
        best = v61;
        way = 2;
    }
    if 24.873356_f32 >= best {
        best = 24.873356_f32;
        way = 3;
    }
    let v42 = f32::abs(s[4]);
    let v43 = s[0] / v42;
    if v43 >= best {
        best = v43;
        way = 4;
    }
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        best = v17;
        way = 5;
    }
    let v28 = 0.0_f32 - s[4];
    if v28 >= best {
        best = v28;
        way = 6;
    }
    let v15 = s[1] / 0.0_f32;
    if v15 >= best {
        best = v15;
        way = 7;
    }
    match way {
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
    let mut way = 1;
    let v47 = f32::abs(s[3]);
    if v47 >= best {
        best = v47;
        way = 2;
    }
    let v11 = 164.8815_f32 * s[3];
    if v11 >= best {
        best = v11;
        way = 3;
    }
    let v35 = s[1] + 9.539528_f32;
    if v35 >= best {
        best = v35;
        way = 4;
    }
    let v49 = s[0] / 11.077008_f32;
    if v49 >= best {
        best = v49;
        way = 5;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        best = v2;
        way = 6;
    }
    let v42 = f32::abs(s[4]);
    let v43 = s[0] / v42;
    if v43 >= best {
        best = v43;
        way = 7;
    }
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        best = v17;
        way = 8;
    }
    let v36 = ops::min(v17, s[4]);
    if v36 >= best {
        best = v36;
        way = 9;
    }
    match way {
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
    let mut way = 8;
    let v11 = 164.8815_f32 * s[3];
    if v11 >= best {
        best = v11;
        way = 1;
    }
    let v15 = s[1] / 0.0_f32;
    if v15 >= best {
        best = v15;
        way = 2;
    }
    let v42 = f32::abs(s[4]);
    let v56 = s[1] / v42;
    if v56 >= best {
        best = v56;
        way = 3;
    }
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        best = v17;
        way = 4;
    }
    let v51 = ops::negate_if_less(s[1], -26.200392_f32);
    if v51 >= best {
        best = v51;
        way = 5;
    }
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        best = v5;
        way = 6;
    }
    if 11.302588_f32 >= best {
        best = 11.302588_f32;
        way = 7;
    }
    let v28 = 0.0_f32 - s[4];
    if v28 >= best {
        best = v28;
        way = 8;
    }
    match way {
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
    let mut way = 6;
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        best = v17;
        way = 1;
    }
    if 22.918602_f32 >= best {
        best = 22.918602_f32;
        way = 2;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        best = v2;
        way = 3;
    }
    let v8 = f32::abs(s[2]);
    if v8 >= best {
        best = v8;
        way = 4;
    }
    let v35 = s[1] + 9.539528_f32;
    if v35 >= best {
        best = v35;
        way = 6;
    }
    let v55 = s[3] / 15.430052_f32;
    if v55 >= best {
        best = v55;
        way = 5;
    }
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        best = v5;
        way = 6;
    }
    match way {
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
    let mut way = 4;
    let v51 = ops::negate_if_less(s[1], -26.200392_f32);
    if v51 >= best {
        best = v51;
        way = 1;
    }
    let v52 = ops::max(s[1], s[4]);
    if v52 >= best {
        best = v52;
        way = 4;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        best = v2;
        way = 2;
    }
    let v28 = 0.0_f32 - s[4];
    if v28 >= best {
        best = v28;
        way = 4;
    }
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        best = v5;
        way = 3;
    }
    if 4.372006_f32 >= best {
        best = 4.372006_f32;
        way = 4;
    }
    let v53 = ops::min(s[2], s[3]);
    if v53 >= best {
        best = v53;
        way = 4;
    }
    match way {
        1 => 3,
        2 => 0,
        3 => 5,
        _ => 1,
    }
}

/// What team 41 decides.
fn team_41(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut way = 5;
    let v37 = ops::max(s[2], s[4]);
    if v37 >= best {
        best = v37;
        way = 2;
    }
    let v38 = ops::max(s[4], 0.0_f32);
    if v38 >= best {
        best = v38;
        way = 1;
    }
    let v39 = s[4] / 0.0_f32;
    let v41 = v39 * -72.49379_f32;
    if v41 >= best {
        best = v41;
        way = 2;
    }
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        best = v5;
        way = 3;
    }
    let v42 = f32::abs(s[4]);
    let v43 = s[0] / v42;
    if v43 >= best {
        best = v43;
        way = 5;
    }
    if 10.948133_f32 >= best {
        best = 10.948133_f32;
        way = 4;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        best = v2;
        way = 5;
    }
    match way {
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
    let mut way = 5;
    let v13 = s[1] / 11.184899_f32;
    if v13 >= best {
        best = v13;
        way = 1;
    }
    if 11.302588_f32 >= best {
        best = 11.302588_f32;
        way = 2;
    }
    let v28 = 0.0_f32 - s[4];
    if v28 >= best {
        best = v28;
        way = 3;
    }
    let v73 = -3.5602038_f32 - s[0];
    if v73 >= best {
        best = v73;
        way = 3;
    }
    let v45 = s[1] * s[4];
    if v45 >= best {
        best = v45;
        way = 3;
    }
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        best = v17;
        way = 3;
    }
    let v11 = 164.8815_f32 * s[3];
    if v11 >= best {
        best = v11;
        way = 4;
    }
    let v15 = s[1] / 0.0_f32;
    if v15 >= best {
        best = v15;
        way = 5;
    }
    match way {
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
    let mut way = 8;
    let v17 = -3.3748567_f32 - s[0];
    let v36 = ops::min(v17, s[4]);
    if v36 >= best {
        best = v36;
        way = 3;
    }
    let v8 = f32::abs(s[2]);
    if v8 >= best {
        best = v8;
        way = 1;
    }
    let v74 = s[4] * s[4];
    if v74 >= best {
        best = v74;
        way = 2;
    }
    if v17 >= best {
        best = v17;
        way = 3;
    }
    let v39 = s[4] / 0.0_f32;
    let v41 = v39 * -72.49379_f32;
    if v41 >= best {
        best = v41;
        way = 4;
    }
    if 22.918602_f32 >= best {
        best = 22.918602_f32;
        way = 7;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        best = v2;
        way = 5;
    }
    let v11 = 164.8815_f32 * s[3];
    if v11 >= best {
        best = v11;
        way = 6;
    }
    let v77 = s[0] + s[4];
    let v78 = v77 / 9.539528_f32;
    if v78 >= best {
        best = v78;
        way = 7;
    }
    let v69 = s[1] - s[4];
    if v69 >= best {
        best = v69;
        way = 8;
    }
    match way {
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
    let mut way = 7;
    let v71 = s[1] / 6.928064_f32;
    if v71 >= best {
        best = v71;
        way = 1;
    }
    let v55 = s[3] / 15.430052_f32;
    if v55 >= best {
        best = v55;
        way = 2;
    }
    let v42 = f32::abs(s[4]);
    let v43 = s[0] / v42;
    if v43 >= best {
        best = v43;
        way = 3;
    }
    let v8 = f32::abs(s[2]);
    if v8 >= best {
        best = v8;
        way = 4;
    }
    if 22.918602_f32 >= best {
        best = 22.918602_f32;
        way = 5;
    }
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        best = v5;
        way = 6;
    }
    let v21 = ops::max(-161.71835_f32, s[2]);
    if v21 >= best {
        best = v21;
        way = 7;
    }
    match way {
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
    let mut way = 6;
    let v17 = -3.3748567_f32 - s[0];
    let v36 = ops::min(v17, s[4]);
    if v36 >= best {
        best = v36;
        way = 1;
    }
    let v79 = ops::negate_if_less(-3.3748567_f32, s[0]);
    if v79 >= best {
        best = v79;
        way = 1;
    }
    let v65 = s[2] + s[2];
    if v65 >= best {
        best = v65;
        way = 2;
    }
    let v8 = f32::abs(s[2]);
    if v8 >= best {
        best = v8;
        way = 3;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        best = v2;
        way = 4;
    }
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        best = v5;
        way = 5;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        best = zero;
        way = 6;
    }
    match way {
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
    let mut way = 8;
    let v42 = f32::abs(s[4]);
    if v42 >= best {
        best = v42;
        way = 1;
    }
    let v39 = s[4] / 0.0_f32;
    let v41 = v39 * -72.49379_f32;
    if v41 >= best {
        best = v41;
        way = 2;
    }
    let v69 = s[1] - s[4];
    if v69 >= best {
        best = v69;
        way = 3;
    }
    if 22.918602_f32 >= best {
        best = 22.918602_f32;
        way = 4;
    }
    let v45 = s[1] * s[4];
    if v45 >= best {
        best = v45;
        way = 5;
    }
    let v8 = f32::abs(s[2]);
    if v8 >= best {
        best = v8;
        way = 6;
    }
    let v11 = 164.8815_f32 * s[3];
    if v11 >= best {
        best = v11;
        way = 7;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        best = v2;
        way = 8;
    }
    match way {
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
    let mut way = 4;
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        best = v5;
        way = 1;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        best = v2;
        way = 2;
    }
    let v53 = ops::min(s[2], s[3]);
    if v53 >= best {
        best = v53;
        way = 3;
    }
    let v68 = ops::max(s[0], 0.0_f32);
    if v68 >= best {
        best = v68;
        way = 4;
    }
    match way {
        1 => 5,
        2 => 0,
        3 => 1,
        _ => 3,
    }
}

/// What team 38 decides.
fn team_38(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut way = 7;
    let v65 = s[2] + s[2];
    if v65 >= best {
        best = v65;
        way = 1;
    }
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        best = v5;
        way = 7;
    }
    let v47 = f32::abs(s[3]);
    if v47 >= best {
        best = v47;
        way = 2;
    }
    let v67 = ops::min(s[2], 213.59233_f32);
    if v67 >= best {
        best = v67;
        way = 3;
    }
    let v42 = f32::abs(s[4]);
    let v56 = s[1] / v42;
    if v56 >= best {
        best = v56;
        way = 4;
    }
    if 4.372006_f32 >= best {
        best = 4.372006_f32;
        way = 5;
    }
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        best = v17;
        way = 5;
    }
    let v8 = f32::abs(s[2]);
    if v8 >= best {
        best = v8;
        way = 6;
    }
    let v35 = s[1] + 9.539528_f32;
    if v35 >= best {
        best = v35;
        way = 7;
    }
    match way {
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
    let mut way = 5;
    let v42 = f32::abs(s[4]);
    let v80 = s[2] / v42;
    if v80 >= best {
        best = v80;
        way = 1;
    }
    let v81 = s[4] - -22.172918_f32;
    let v82 = 9.539528_f32 + v81;
    if v82 >= best {
        best = v82;
        way = 2;
    }
    let v83 = ops::max(s[2], 99.64715_f32);
    if v83 >= best {
        best = v83;
        way = 3;
    }
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        best = v17;
        way = 4;
    }
    let v85 = -72.89382_f32 / s[4];
    if v85 >= best {
        best = v85;
        way = 5;
    }
    match way {
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
    let mut way = 5;
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        best = v2;
        way = 1;
    }
    let v53 = ops::min(s[2], s[3]);
    if v53 >= best {
        best = v53;
        way = 2;
    }
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        best = v17;
        way = 2;
    }
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        best = v5;
        way = 3;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        best = zero;
        way = 4;
    }
    let v8 = f32::abs(s[2]);
    if v8 >= best {
        best = v8;
        way = 5;
    }
    match way {
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
    let mut way = 9;
    let v42 = f32::abs(s[4]);
    let v43 = s[0] / v42;
    if v43 >= best {
        best = v43;
        way = 4;
    }
    let v77 = s[0] + s[4];
    let v78 = v77 / 9.539528_f32;
    if v78 >= best {
        best = v78;
        way = 1;
    }
    let v89 = s[1] / s[4];
    if v89 >= best {
        best = v89;
        way = 2;
    }
    let v64 = s[2] - 99.64715_f32;
    if v64 >= best {
        best = v64;
        way = 3;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        best = v2;
        way = 4;
    }
    let v8 = f32::abs(s[2]);
    if v8 >= best {
        best = v8;
        way = 5;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        best = zero;
        way = 6;
    }
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        best = v17;
        way = 7;
    }
    let v39 = s[4] / 0.0_f32;
    let v41 = v39 * -72.49379_f32;
    if v41 >= best {
        best = v41;
        way = 8;
    }
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        best = v5;
        way = 9;
    }
    match way {
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
    let mut way = 3;
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        best = v2;
        way = 1;
    }
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        best = v5;
        way = 2;
    }
    if 4.372006_f32 >= best {
        best = 4.372006_f32;
        way = 3;
    }
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        best = v17;
        way = 3;
    }
    match way {
        1 => 0,
        2 => team_44(s),
        _ => 1,
    }
}

/// What team 24 decides.
fn team_24(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut way = 6;
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        best = v17;
        way = 1;
    }
    if 22.918602_f32 >= best {
        best = 22.918602_f32;
        way = 2;
    }
    let v8 = f32::abs(s[2]);
    if v8 >= best {
        best = v8;
        way = 3;
    }
    let v55 = s[3] / 15.430052_f32;
    if v55 >= best {
        best = v55;
        way = 4;
    }
    let v35 = s[1] + 9.539528_f32;
    if v35 >= best {
        best = v35;
        way = 5;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        best = v2;
        way = 6;
    }
    match way {
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
    let mut way = 4;
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        best = v5;
        way = 1;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        best = v2;
        way = 2;
    }
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        best = v17;
        way = 3;
    }
    let v88 = f32::abs(s[0]);
    if v88 >= best {
        best = v88;
        way = 3;
    }
    let v53 = ops::min(s[2], s[3]);
    if v53 >= best {
        best = v53;
        way = 3;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        best = zero;
        way = 4;
    }
    match way {
        1 => 5,
        2 => 0,
        3 => 1,
        _ => 3,
    }
}

/// What team 39 decides.
fn team_39(s: &[f32; 5]) -> u16 {
    let mut best = f32::MIN;
    let mut way = 5;
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        best = v5;
        way = 1;
    }
    let v17 = -3.3748567_f32 - s[0];
    if v17 >= best {
        best = v17;
        way = 2;
    }
    let v58 = s[0] / 17.709658_f32;
    if v58 >= best {
        best = v58;
        way = 5;
    }
    let v53 = ops::min(s[2], s[3]);
    if v53 >= best {
        best = v53;
        way = 2;
    }
    let v59 = 0.0_f32 * s[2];
    if v59 >= best {
        best = v59;
        way = 3;
    }
    let v8 = f32::abs(s[2]);
    if v8 >= best {
        best = v8;
        way = 4;
    }
    let v42 = f32::abs(s[4]);
    let v43 = s[0] / v42;
    if v43 >= best {
        best = v43;
        way = 5;
    }
    match way {
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
    let mut way = 7;
    let v8 = f32::abs(s[2]);
    if v8 >= best {
        best = v8;
        way = 1;
    }
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        best = v5;
        way = 2;
    }
    let v17 = -3.3748567_f32 - s[0];
    let v36 = ops::min(v17, s[4]);
    if v36 >= best {
        best = v36;
        way = 6;
    }
    if 22.918602_f32 >= best {
        best = 22.918602_f32;
        way = 3;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        best = v2;
        way = 4;
    }
    let v74 = s[4] * s[4];
    if v74 >= best {
        best = v74;
        way = 5;
    }
    let v53 = ops::min(s[2], s[3]);
    if v53 >= best {
        best = v53;
        way = 6;
    }
    let v76 = s[1] / -9.539528_f32;
    if v76 >= best {
        best = v76;
        way = 7;
    }
    match way {
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
    let mut way = 5;
    let v87 = s[4] * -4.136917_f32;
    if v87 >= best {
        best = v87;
        way = 3;
    }
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        best = v5;
        way = 4;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        best = zero;
        way = 1;
    }
    let v39 = s[4] / 0.0_f32;
    let v41 = v39 * -72.49379_f32;
    if v41 >= best {
        best = v41;
        way = 1;
    }
    let v42 = f32::abs(s[4]);
    if v42 >= best {
        best = v42;
        way = 2;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        best = v2;
        way = 3;
    }
    let v35 = s[1] + 9.539528_f32;
    if v35 >= best {
        best = v35;
        way = 4;
    }
    let v43 = s[0] / v42;
    if v43 >= best {
        best = v43;
        way = 5;
    }
    match way {
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
    let mut way = 1;
    let v8 = f32::abs(s[2]);
    if v8 >= best {
        best = v8;
        way = 2;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        best = v2;
        way = 3;
    }
    let v35 = s[1] + 9.539528_f32;
    if v35 >= best {
        best = v35;
        way = 4;
    }
    match way {
        1 => 5,
        2 => team_38(s),
        3 => 0,
        _ => team_34(s),
    }
}

/// What team 18 decides.
fn team_18(s: &[f32; 5]) -> u16 {
    let mut best = 22.918602_f32;
    let mut way = 1;
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        best = v5;
        way = 2;
    }
    let v17 = -3.3748567_f32 - s[0];
    let v36 = ops::min(v17, s[4]);
    if v36 >= best {
        best = v36;
        way = 8;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        best = v2;
        way = 3;
    }
    let v74 = s[4] * s[4];
    if v74 >= best {
        best = v74;
        way = 4;
    }
    let v53 = ops::min(s[2], s[3]);
    if v53 >= best {
        best = v53;
        way = 8;
    }
    let v76 = s[1] / -9.539528_f32;
    if v76 >= best {
        best = v76;
        way = 5;
    }
    let v42 = f32::abs(s[4]);
    let v43 = s[0] / v42;
    if v43 >= best {
        best = v43;
        way = 6;
    }
    let v8 = f32::abs(s[2]);
    if v8 >= best {
        best = v8;
        way = 7;
    }
    if v17 >= best {
        best = v17;
        way = 8;
    }
    match way {
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
    let mut way = 4;
    let v5 = s[1] / 9.539528_f32;
    if v5 >= best {
        best = v5;
        way = 1;
    }
    let zero = core::hint::black_box(0.0_f32);
    if zero >= best {
        best = zero;
        way = 2;
    }
    let v2 = s[0] / 0.0_f32;
    if v2 >= best {
        best = v2;
        way = 3;
    }
    let v53 = ops::min(s[2], s[3]);
    if v53 >= best {
        best = v53;
        way = 4;
    }
    match way {
        1 => 5,
        2 => 3,
        3 => 0,
        _ => 1,
    }
}
