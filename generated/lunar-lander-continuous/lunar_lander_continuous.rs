//! A policy for LunarLanderContinuous-v3 of Gymnasium, score 284.81 in validation, trained by tpg-train 0.1.0 with seed 1.
//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix lunar_lander_continuous --profile constant-time
//! Graph SHA-256: f233abff0d84f6b23d274ff7e785b3758728cdea4ae76155154ea0fef268d463
//! 1 team, 1 edge, 1 program, 12 distinct operations.
//! A decision takes at most 12 operations.
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
/// - `s[0..1]`: x, -2.5 to 2.5
/// - `s[1..2]`: y, -2.5 to 2.5
/// - `s[2..3]`: vx, -10 to 10
/// - `s[3..4]`: vy, -10 to 10
/// - `s[4..5]`: angle, -6.2831855 to 6.2831855
/// - `s[5..6]`: spin, -10 to 10
/// - `s[6..7]`: left_leg, 0 to 1
/// - `s[7..8]`: right_leg, 0 to 1
///
/// Values outside the ranges are legal, NaN and infinities too. It answers:
/// - `[0]`: main_engine, -1 to 1; 0 for NaN
/// - `[1]`: side_engine, -1 to 1; 0 for NaN
#[derive(Clone, Copy, Debug, Default)]
pub struct LunarLanderContinuous;

impl LunarLanderContinuous {
    /// Values of a state.
    pub const STATE: usize = 8;
    /// Outputs.
    pub const OUTPUTS: usize = 2;
    /// Teams on the longest walk.
    pub const DEPTH: usize = 1;
}

impl Policy for LunarLanderContinuous {
    type State = [f32; 8];
    type Action = [f32; 2];

    fn decide(&self, s: &[f32; 8]) -> [f32; 2] {
        let ct = ConstantTime::<f32>::default();
        let main_engine = -8.037243_f32 * s[1] - 11.026979_f32 * s[3] - 1.8125842_f32;
        let side_engine = -18.706825_f32 * s[0] + 2.1564276_f32 * s[5] + 14.484438_f32 * s[4]
            - 6.0377746_f32 * s[2]
            + 0.24678662_f32;
        [
            ct.clamp(main_engine, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(side_engine, -1.0_f32, 1.0_f32, 0.0_f32),
        ]
    }
}
