//! A policy for InvertedDoublePendulum-v5 of Gymnasium, score 9359.83 in validation, trained by tpg-train 0.1.0 with seed 1.
//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix inverted_double_pendulum --profile constant-time
//! Graph SHA-256: 23d21c6ffc354225d2aca850c679caec7d888893b4bcea35fcb70a647fa62729
//! 1 team, 1 edge, 1 program, 14 distinct operations.
//! A decision takes at most 14 operations.
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
/// - `s[0..1]`: x, -0.16463087 to 0.29684538
/// - `s[1..2]`: sin_1, -0.14117883 to 0.11996287
/// - `s[2..3]`: sin_2, -0.14263926 to 0.1210145
/// - `s[3..4]`: cos_1, 0.99402535 to 1.001195
/// - `s[4..5]`: cos_2, 0.9938969 to 1.0012207
/// - `s[5..6]`: v, -0.32058525 to 0.24939169
/// - `s[6..7]`: omega_1, -0.39067128 to 0.29397532
/// - `s[7..8]`: omega_2, -0.31223035 to 0.38351622
/// - `s[8..9]`: constraint, -0.00025 to 0.00025
///
/// Values outside the ranges are legal, NaN and infinities too. It answers:
/// - `[0]`: force, -1 to 1; 0 for NaN
#[derive(Clone, Copy, Debug, Default)]
pub struct InvertedDoublePendulum;

impl InvertedDoublePendulum {
    /// Values of a state.
    pub const STATE: usize = 9;
    /// Outputs.
    pub const OUTPUTS: usize = 1;
    /// Teams on the longest walk.
    pub const DEPTH: usize = 1;
}

impl Policy for InvertedDoublePendulum {
    type State = [f32; 9];
    type Action = [f32; 1];

    fn decide(&self, s: &[f32; 9]) -> [f32; 1] {
        let ct = ConstantTime::<f32>::default();
        let force = -0.48305112_f32 * s[0]
            - 2.4732687_f32 * s[1]
            - 6.5629725_f32 * s[2]
            - 0.45679966_f32 * s[4]
            - 0.2828851_f32 * s[5]
            - 0.9611906_f32 * s[6]
            - 0.9364736_f32 * s[7]
            + 0.44827595_f32;
        [ct.clamp(force, -1.0_f32, 1.0_f32, 0.0_f32)]
    }
}
