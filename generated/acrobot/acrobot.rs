//! A policy for acrobot, score -71.88 in validation, trained by tpg-train 0.1.0 with seed 11.
//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix acrobot --profile constant-time
//! Graph SHA-256: c746bc981049f428c5e9cd92b39b159c476562abde6afb37fa55ace167b590d0
//! 1 team, 4 edges, 4 programs, 26 distinct operations.
//! A decision takes at most 4 bids and 26 operations.
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
/// - `s[0..1]`: cos_theta_1, -1 to 1
/// - `s[1..2]`: sin_theta_1, -1 to 1
/// - `s[2..3]`: cos_theta_2, -1 to 1
/// - `s[3..4]`: sin_theta_2, -1 to 1
/// - `s[4..5]`: omega_1, rad/s, -12.566371 to 12.566371
/// - `s[5..6]`: omega_2, rad/s, -28.274334 to 28.274334
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
    /// An action.
    pub const TORQUE_MINUS_1: ActionId = ActionId(0);
    /// An action.
    pub const TORQUE_0: ActionId = ActionId(1);
    /// An action.
    pub const TORQUE_1: ActionId = ActionId(2);
    /// Teams on the longest walk.
    pub const DEPTH: usize = 1;
}

impl Policy for Acrobot {
    type State = [f32; 6];
    type Action = ActionId;

    fn decide(&self, s: &[f32; 6]) -> ActionId {
        let ct = ConstantTime::<f32>::default();
        let bid_0_value = -2.7205236_f32 * s[0] - 1.2175102_f32 * s[3] - 0.49445456_f32 * s[4]
            + 0.22029561_f32 * s[5]
            + 2.3143518_f32;
        let term = -3.3904653_f32 * s[0] - 0.12505245_f32 * s[1] + 0.27461419_f32 * s[2]
            - 0.4058117_f32 * s[4];
        let bid_5_value = -2.6076918_f32 * s[0] - 0.080515005_f32 * s[5] - 1.831776_f32 * s[3]
            + 0.10326636_f32 * s[2]
            + 2.957902_f32 * s[1]
            - 0.69571906_f32;

        // What is bid, as integers in the same order.
        let bid_4 = -8388607_i32; // 0.0_f32
        let bid_0 = ct.order(bid_0_value);
        let bid_3 = ct.order(term / 2.6443782_f32);
        let bid_5 = ct.order(bid_5_value);

        // Where the team leads: the number behind the best bid.
        // Team 0
        let best = (bid_0, 2);
        let best = ct.challenge(best, (bid_3, 2));
        let best = ct.challenge(best, (bid_4, 0));
        let best = ct.challenge(best, (bid_5, 0));

        ActionId(best.1 as u16)
    }
}
