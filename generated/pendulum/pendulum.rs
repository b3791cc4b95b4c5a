//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix pendulum --profile constant-time
//! Graph SHA-256: e33cfd6c4cedebe6fe46f165924576a1e0836aa5953a4956b0f39f8d293bb8ba
//! 1 teams (1 on the longest walk), 1 edges, 1 programs, 6 distinct operations.
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
/// - `s[0..1]`: cos_theta, , -1 to 1
/// - `s[1..2]`: sin_theta, , -1 to 1
/// - `s[2..3]`: omega, rad/s, -8 to 8
///
/// Values outside the ranges are legal, NaN and infinities too. It answers:
/// - `[0]`: torque, N·m, -2 to 2; 0 in place of NaN
#[derive(Clone, Copy, Debug, Default)]
pub struct Pendulum;

impl Pendulum {
    /// Values of a state.
    pub const STATE: usize = 3;
    /// Outputs.
    pub const OUTPUTS: usize = 1;
    /// Teams on the longest walk.
    pub const DEPTH: usize = 1;
    /// Bids that one decision looks at, at most.
    pub const WORST_BIDS: usize = 0;
    /// Operations of one decision, at most.
    pub const WORST_OPERATIONS: usize = 6;
    /// Sines, cosines, logarithms and exponentials among them, at most.
    pub const WORST_MATHS_CALLS: usize = 0;
}

impl Policy for Pendulum {
    type State = [f32; 3];
    type Action = [f32; 1];

    fn decide(&self, s: &[f32; 3]) -> [f32; 1] {
        let ct = ConstantTime::<f32>::default();
        let v2 = 3.1135516_f32 * s[1];
        let v3 = s[1] + v2;
        let v5 = v3 + s[2];
        let v8 = 0.12383518_f32 * s[0];
        let v9 = v5 / v8;
        let v10 = s[2] - v9;
        [ct.clamp(v10, -2.0_f32, 2.0_f32, 0.0_f32)]
    }
}
