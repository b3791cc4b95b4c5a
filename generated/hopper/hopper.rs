//! A policy for Hopper-v5 of Gymnasium, score 2393.91 in validation, trained by tpg-train 0.1.0 with seed 3.
//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix hopper --profile constant-time
//! Graph SHA-256: 7eb551e1a4ae94a14031d271c973bb4a4dd0a017a738c426437aa239fa7b9ce4
//! 1 team, 1 edge, 1 program, 60 distinct operations.
//! A decision takes at most 60 operations.
//! Computes in f32 with own maths.
#![forbid(unsafe_code)]
#![allow(
    clippy::all,
    unused_variables,
    unused_assignments,
    reason = "evolved expressions need not make sense"
)]

use tpg_runtime::ops::constant_time::ConstantTime;
use tpg_runtime::policy::Policy;

/// A tangled program graph: a formula.
///
/// It sees, one after another:
/// - `s[0..1]`: height, 0.83112526 to 1.6484929
/// - `s[1..2]`: pitch, -0.15008685 to 0.03464629
/// - `s[2..3]`: thigh_angle, -0.85828006 to 0.17889954
/// - `s[3..4]`: leg_angle, -1.1709783 to 0.2400233
/// - `s[4..5]`: foot_angle, -1.340457 to 1.4072475
/// - `s[5..6]`: vx, -0.8826094 to 4.4063616
/// - `s[6..7]`: vz, -3.4945538 to 3.5332
/// - `s[7..8]`: pitch_speed, -0.6984527 to 0.9729921
/// - `s[8..9]`: thigh_speed, -9.8563175 to 8.929599
/// - `s[9..10]`: leg_speed, -12.639674 to 11.657586
/// - `s[10..11]`: foot_speed, -15 to 15
///
/// Values outside the ranges are legal, NaN and infinities too. It answers:
/// - `[0]`: thigh, -1 to 1; 0 for NaN
/// - `[1]`: leg, -1 to 1; 0 for NaN
/// - `[2]`: foot, -1 to 1; 0 for NaN
#[derive(Clone, Copy, Debug, Default)]
pub struct Hopper;

impl Hopper {
    /// Values of a state.
    pub const STATE: usize = 11;
    /// Outputs.
    pub const OUTPUTS: usize = 3;
    /// Teams on the longest walk.
    pub const DEPTH: usize = 1;
}

impl Policy for Hopper {
    type State = [f32; 11];
    type Action = [f32; 3];

    fn decide(&self, s: &[f32; 11]) -> [f32; 3] {
        let ct = ConstantTime::<f32>::default();
        let term = 2.4094844_f32 * s[0] - 16.831106_f32 * s[1] - 0.9726171_f32 * s[2]
            + 1.2704073_f32 * s[3]
            - 0.30623376_f32 * s[4]
            + 0.32980627_f32 * s[5]
            - 0.14272827_f32 * s[6]
            - 0.67063546_f32 * s[7]
            + 0.084569946_f32 * s[8];
        let thigh = term + 0.10996343_f32 * s[9] - 0.0139268385_f32 * s[10] - 4.385427_f32;
        let term_2 = -0.48055917_f32 * s[0] - 15.44946_f32 * s[1] + 1.6838492_f32 * s[2]
            - 1.7118963_f32 * s[3]
            - 0.05598478_f32 * s[4]
            + 0.3226204_f32 * s[6]
            - 0.8628424_f32 * s[7]
            - 0.12721324_f32 * s[8]
            - 0.0822124_f32 * s[9];
        let leg = term_2 - 1.109722_f32;
        let term_3 = 3.3940566_f32 * s[0] + 0.5165295_f32 * s[1] + 2.143888_f32 * s[2]
            - 0.25035787_f32 * s[3]
            - 0.83269984_f32 * s[5]
            + 0.02263618_f32 * s[6]
            + 0.46339342_f32 * s[7]
            + 0.13614666_f32 * s[8]
            - 0.039877187_f32 * s[9];
        let foot = term_3 - 0.0018393787_f32 * s[10] - 2.0928748_f32;
        [
            ct.clamp(thigh, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(leg, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(foot, -1.0_f32, 1.0_f32, 0.0_f32),
        ]
    }
}
