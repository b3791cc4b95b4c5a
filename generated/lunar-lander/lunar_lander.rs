//! A policy for LunarLander-v3 of Gymnasium, score 264.01 in validation, trained by tpg-train 0.1.0 with seed 10.
//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix lunar_lander --profile constant-time
//! Graph SHA-256: ce37c65d5105962339cb88f7c7c4ecd4f1ff21c9a9214bb268d2dbf6d10ddc5c
//! 1 team, 4 edges, 4 programs, 23 distinct operations.
//! A decision takes at most 4 bids and 23 operations.
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
/// - 0: none
/// - 1: left_engine
/// - 2: main_engine
/// - 3: right_engine
#[derive(Clone, Copy, Debug, Default)]
pub struct LunarLander;

impl LunarLander {
    /// Values of a state.
    pub const STATE: usize = 8;
    /// Actions.
    pub const ACTIONS: usize = 4;
    /// An action.
    pub const NONE: ActionId = ActionId(0);
    /// An action.
    pub const LEFT_ENGINE: ActionId = ActionId(1);
    /// An action.
    pub const MAIN_ENGINE: ActionId = ActionId(2);
    /// An action.
    pub const RIGHT_ENGINE: ActionId = ActionId(3);
    /// Teams on the longest walk.
    pub const DEPTH: usize = 1;
}

impl Policy for LunarLander {
    type State = [f32; 8];
    type Action = ActionId;

    fn decide(&self, s: &[f32; 8]) -> ActionId {
        let ct = ConstantTime::<f32>::default();
        let bid_1_value = 0.54824466_f32 * s[0] + 0.41400775_f32 * s[1]
            - 1.3129216_f32 * s[4]
            - 1.5008805_f32 * s[5];
        let bid_2_value = -0.7259825_f32 * s[1] - 2.4281847_f32 * s[3] - 0.2920304_f32;
        let bid_3_value = -0.50036424_f32 * s[0] + 0.32095438_f32 * s[1] - 1.462079_f32 * s[2]
            + 1.0567017_f32 * s[3]
            + 1.1205845_f32 * s[4]
            - 0.700306_f32 * s[7]
            + 0.4441619_f32;

        // What is bid, as integers in the same order.
        let bid_0 = -8388607_i32; // 0.0_f32
        let bid_1 = ct.order(bid_1_value);
        let bid_2 = ct.order(bid_2_value);
        let bid_3 = ct.order(bid_3_value);

        // Where the team leads: the number behind the best bid.
        // Team 0
        let best = (bid_0, 0);
        let best = ct.challenge(best, (bid_1, 1));
        let best = ct.challenge(best, (bid_2, 2));
        let best = ct.challenge(best, (bid_3, 3));

        ActionId(best.1 as u16)
    }
}
