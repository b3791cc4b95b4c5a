//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix acrobot --profile constant-time
//! Graph SHA-256: 486d480a7f0df81ee65b7b7d4fe67c9bc9f77bdc5afe7da89a4412e919009bf9
//! 1 teams (1 on the longest walk), 6 edges, 6 programs, 6 distinct operations.
//! Computes in f32 with own maths.
#![forbid(unsafe_code)]
#![allow(
    clippy::all,
    unused_variables,
    unused_assignments,
    reason = "evolved expressions need not make sense"
)]

use tpg_runtime::ops::constant_time::ConstantTime;
use tpg_runtime::policy::{ActionId, Policy};

/// A tangled program graph: branch-free, the same time for every state.
///
/// It sees, one after another:
/// - `s[0..1]`: cos_theta_1, , -1 to 1
/// - `s[1..2]`: sin_theta_1, , -1 to 1
/// - `s[2..3]`: cos_theta_2, , -1 to 1
/// - `s[3..4]`: sin_theta_2, , -1 to 1
/// - `s[4..5]`: omega_1, rad/s, -12.566370964050293 to 12.566370964050293
/// - `s[5..6]`: omega_2, rad/s, -28.274333953857422 to 28.274333953857422
///
/// Values outside the ranges are legal, NaN and infinities too. It answers:
/// - 0: torque -1
/// - 1: torque 0
/// - 2: torque 1
#[derive(Clone, Copy, Debug, Default)]
pub struct Acrobot;

impl Acrobot {
    /// Values of a state.
    pub const STATE: usize = 6;
    /// Actions.
    pub const ACTIONS: usize = 3;
    /// Teams on the longest walk.
    pub const DEPTH: usize = 1;
    /// Bids that one decision looks at, at most.
    pub const WORST_BIDS: usize = 6;
    /// Operations of one decision, at most.
    pub const WORST_OPERATIONS: usize = 6;
    /// Sines, cosines, logarithms and exponentials among them, at most.
    pub const WORST_MATHS_CALLS: usize = 0;
}

impl Policy for Acrobot {
    type State = [f32; 6];
    type Action = ActionId;

    fn decide(&self, s: &[f32; 6]) -> ActionId {
        let ct = ConstantTime::<f32>::default();
        let v2 = ct.negate_if_less(s[5], 100.03832_f32);
        let v5 = 0.11001676_f32 / s[0];
        let v8 = s[4] - s[2];
        let v10 = -0.7933136_f32 / s[0];
        let v11 = s[5] * s[0];
        let v12 = ct.min(s[4], s[2]);

        // What is bid, as integers in the same order.
        let k2 = ct.order(v2);
        let k5 = ct.order(v5);
        let k8 = ct.order(v8);
        let k10 = ct.order(v10);
        let k11 = ct.order(v11);
        let k12 = ct.order(v12);

        // Where the team leads: the number behind the best bid.
        // Team 0
        let best = (k2, 0);
        let best = ct.challenge(best, (k5, 2));
        let best = ct.challenge(best, (k8, 0));
        let best = ct.challenge(best, (k10, 2));
        let best = ct.challenge(best, (k11, 2));
        let best = ct.challenge(best, (k12, 0));

        ActionId(best.1 as u16)
    }
}
