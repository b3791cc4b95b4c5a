//! A policy for pendulum, score -151.98 in validation, trained by tpg-train 0.1.0 with seed 1.
//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix pendulum --profile constant-time
//! Graph SHA-256: e371857f5f2d98485533a900f5b0c18626fc44af90b3ad69194605f6c7bd3e14
//! 1 team, 2 edges, 2 programs, 14 distinct operations.
//! A decision takes at most 2 bids and 14 operations.
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
/// - `s[0..1]`: cos_theta, -1 to 1
/// - `s[1..2]`: sin_theta, -1 to 1
/// - `s[2..3]`: omega, rad/s, -8 to 8
///
/// Values outside the ranges are legal, NaN and infinities too. It answers:
/// - `[0]`: torque, N·m, -2 to 2; 0 for NaN
#[derive(Clone, Copy, Debug, Default)]
pub struct Pendulum;

impl Pendulum {
    /// Values of a state.
    pub const STATE: usize = 3;
    /// Outputs.
    pub const OUTPUTS: usize = 1;
    /// Teams on the longest walk.
    pub const DEPTH: usize = 1;
}

impl Policy for Pendulum {
    type State = [f32; 3];
    type Action = [f32; 1];

    fn decide(&self, s: &[f32; 3]) -> [f32; 1] {
        let ct = ConstantTime::<f32>::default();

        // What is bid, as integers in the same order.
        let bid_0 = ct.order(ct.min(s[0], s[1]));
        let bid_1 = ct.order(4.407756_f32 * s[0]);

        // Where the team leads: the number behind the best bid.
        // Team 0
        let best = (bid_0, 0);
        let best = ct.challenge(best, (bid_1, 1));

        let leaf = best.1;
        // Every leaf's values, and the choice among them.
        let torque_0 = (-22.268024_f32 * s[0] - 0.38278264_f32)
            * (6.6331344_f32 * s[1] + 0.0_f32 + 2.6018698_f32 * s[2]);
        let torque_1 = -1.6007409_f32 * (9.448936_f32 * s[1] + 0.0_f32 + 1.7750591_f32 * s[2]);
        let torque = torque_0;
        let torque = ct.if_equal(leaf, 1, torque_1, torque);
        [ct.clamp(torque, -2.0_f32, 2.0_f32, 0.0_f32)]
    }
}
