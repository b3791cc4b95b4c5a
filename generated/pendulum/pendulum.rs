//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix pendulum --profile constant-time
//! Graph SHA-256: c034b28dcf32060bad568b03a753a01658350865786d56eddbd7ad5488a83f29
//! 1 teams (1 on the longest walk), 2 edges, 2 programs, 11 distinct operations.
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

/// A tangled program graph: branch-free, the same time for every state.
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
    pub const WORST_BIDS: usize = 2;
    /// Operations of one decision, at most.
    pub const WORST_OPERATIONS: usize = 11;
    /// Sines, cosines, logarithms and exponentials among them, at most.
    pub const WORST_MATHS_CALLS: usize = 0;
}

impl Policy for Pendulum {
    type State = [f32; 3];
    type Action = [f32; 1];

    fn decide(&self, s: &[f32; 3]) -> [f32; 1] {
        let ct = ConstantTime::<f32>::default();
        let v3 = ct.negate_if_less(-0.28330687_f32, s[0]);

        // What is bid, as integers in the same order.
        let k0 = -8388607_i32; // 0.0_f32
        let k3 = ct.order(v3);

        // Where the team leads: the number behind the best bid.
        // Team 0
        let best = (k0, 1);
        let best = ct.challenge(best, (k3, 0));

        let leaf = best.1;
        // Every leaf's values, and the choice among them.
        let v6 = s[1] / -0.11899939_f32;
        let v9 = -0.03674821_f32 - s[2];
        let v10 = v6 + v9;
        let v11 = v10 - s[2];
        let v12 = v11 / s[0];
        let v13 = s[1] / s[0];
        let v15 = -0.023996977_f32 - s[2];
        let v16 = v13 + v15;
        let v17 = v16 - s[2];
        let v18 = v17 / s[0];
        let out0 = v12;
        let out0 = ct.if_equal(leaf, 1, v18, out0);
        [ct.clamp(out0, -2.0_f32, 2.0_f32, 0.0_f32)]
    }
}
