//! A policy for mountain-car, score -98.59 in validation, trained by tpg-train 0.1.0 with seed 3.
//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix mountain_car --profile constant-time
//! Graph SHA-256: 619c5b1aa69f78a0619c4a681268039cf054605380d24d4a3f9d9b1441495474
//! 2 teams (2 on the longest walk), 7 edges, 6 programs, 11 distinct operations.
//! A decision takes at most 7 bids and 11 operations.
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
/// - `s[0..1]`: position, -1.2 to 0.6
/// - `s[1..2]`: velocity, -0.07 to 0.07
///
/// Values outside the ranges are legal, NaN and infinities too. It answers:
/// - 0: left
/// - 1: none
/// - 2: right
#[derive(Clone, Copy, Debug, Default)]
pub struct MountainCar;

impl MountainCar {
    /// Values of a state.
    pub const STATE: usize = 2;
    /// Actions.
    pub const ACTIONS: usize = 3;
    /// An action.
    pub const LEFT: ActionId = ActionId(0);
    /// An action.
    pub const NONE: ActionId = ActionId(1);
    /// An action.
    pub const RIGHT: ActionId = ActionId(2);
    /// Teams on the longest walk.
    pub const DEPTH: usize = 2;
}

impl Policy for MountainCar {
    type State = [f32; 2];
    type Action = ActionId;

    fn decide(&self, s: &[f32; 2]) -> ActionId {
        let ct = ConstantTime::<f32>::default();
        let bid_3_value = 2.3253112_f32 * s[0] + 96.694336_f32 * s[1] - 1.0729886_f32;
        let bid_10_value = -2.1966188_f32 * s[0] + 99.67122_f32 * s[1] - 1.033289_f32;

        // What is bid, as integers in the same order.
        let bid_7 = -8388607_i32; // 0.0_f32
        let bid_2 = ct.order(-2.5000443_f32 * s[0] - 1.089072_f32);
        let bid_3 = ct.order(bid_3_value);
        let bid_4 = ct.order(s[1] - 1.0512869_f32);
        let bid_10 = ct.order(bid_10_value);

        // Where each team leads: teams are numbered from 0, the root, and the actions follow them.
        // Team 0
        let best = (bid_2, 1);
        let best = ct.challenge(best, (bid_3, 4));
        let best = ct.challenge(best, (bid_4, 1));
        let best = ct.challenge(best, (bid_7, 2));
        let t0 = best.1 as u8;
        // Team 1
        let best = (bid_3, 4);
        let best = ct.challenge(best, (bid_10, 4));
        let best = ct.challenge(best, (bid_7, 2));
        let t1 = best.1 as u8;

        // An action leads to itself, and so does what fills the array up to a power of two: it is never come to.
        let next: [u8; 8] = [t0, t1, 2, 3, 4, 5, 6, 7];
        // The longest walk decides 2 times; a shorter one waits at its action. No loop, and no end to check.
        let vertex = next[0];
        let vertex = next[(vertex & 7) as usize];
        ActionId(vertex.wrapping_sub(2) as u16)
    }
}
