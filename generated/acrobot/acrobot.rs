//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix acrobot --profile constant-time
//! Graph SHA-256: 76fc771d5267ee311a634b8cfb4c597fa640545ee5137236151c992fc9fabdc5
//! 1 teams (1 on the longest walk), 7 edges, 7 programs, 6 distinct operations.
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
    pub const WORST_BIDS: usize = 7;
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
        let v2 = ct.min(s[1], 0.0_f32);
        let v6 = -0.60431343_f32 - s[4];
        let v8 = ct.min(2.254559_f32, s[5]);
        let v10 = s[5] - s[0];
        let v12 = -0.38341922_f32 - s[4];
        let v14 = s[4] - s[2];

        // What is bid, as integers in the same order.
        let k1 = -8388607_i32; // 0.0_f32
        let k2 = ct.order(v2);
        let k6 = ct.order(v6);
        let k8 = ct.order(v8);
        let k10 = ct.order(v10);
        let k12 = ct.order(v12);
        let k14 = ct.order(v14);

        // Where the team leads: the number behind the best bid.
        // Team 0
        let best = (k2, 0);
        let best = ct.challenge(best, (k6, 2));
        let best = ct.challenge(best, (k8, 2));
        let best = ct.challenge(best, (k10, 2));
        let best = ct.challenge(best, (k12, 2));
        let best = ct.challenge(best, (k1, 0));
        let best = ct.challenge(best, (k14, 0));

        ActionId(best.1 as u16)
    }
}
