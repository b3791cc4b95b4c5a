//! A policy for cartpole, score 500 in validation, trained by tpg-train 0.1.0 with seed 2.
//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix cartpole --profile constant-time
//! Graph SHA-256: b5cd35e439ef2cb063083c5c6d233008b3172426fbda1ff61d89268cd8839ef5
//! 1 team, 2 edges, 2 programs, 2 distinct operations.
//! A decision takes at most 2 bids and 2 operations.
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
/// - `s[0..1]`: x, m, -4.8 to 4.8
/// - `s[1..2]`: v, m/s, -0.5311109 to 0.55048436
/// - `s[2..3]`: theta, rad, -0.41887903 to 0.41887903
/// - `s[3..4]`: omega, rad/s, -0.5196277 to 0.51121855
///
/// Values outside the ranges are legal, NaN and infinities too. It answers:
/// - 0: left
/// - 1: right
#[derive(Clone, Copy, Debug, Default)]
pub struct Cartpole;

impl Cartpole {
    /// Values of a state.
    pub const STATE: usize = 4;
    /// Actions.
    pub const ACTIONS: usize = 2;
    /// An action.
    pub const LEFT: ActionId = ActionId(0);
    /// An action.
    pub const RIGHT: ActionId = ActionId(1);
    /// Teams on the longest walk.
    pub const DEPTH: usize = 1;
}

impl Policy for Cartpole {
    type State = [f32; 4];
    type Action = ActionId;

    fn decide(&self, s: &[f32; 4]) -> ActionId {
        let ct = ConstantTime::<f32>::default();

        // What is bid, as integers in the same order.
        let bid_0 = ct.order(s[2] + s[3]);
        let bid_1 = ct.order(s[1] / -3.2907495_f32);

        // Where the team leads: the number behind the best bid.
        // Team 0
        let best = (bid_1, 0);
        let best = ct.challenge(best, (bid_0, 1));

        ActionId(best.1 as u16)
    }
}
