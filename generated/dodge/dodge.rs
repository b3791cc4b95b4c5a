//! A policy for dodge, score 11.39 in validation, trained by tpg-train 0.1.0 with seed 3.
//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix dodge --profile constant-time
//! Graph SHA-256: cdea7daabca328e27e33a768eb228f4f6759f7262ab7fd254d28e16436a5fda2
//! 2 teams (2 on the longest walk), 13 edges, 12 programs, 9 distinct operations.
//! A decision takes at most 13 bids and 9 operations.
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
/// - `s[0..4]`: left, ticks, -4096 to 4096
/// - `s[4..10]`: near, mm, mm/step, mm/rad, -100 to 1000; -4 to 4; -700 to 700; -700 to 700; -700 to 700; -700 to 700
/// - `s[10..12]`: second, mm, mm/step, -100 to 1000; -4 to 4
/// - `s[12..15]`: ahead, steps, 0 to 160; 0 to 160; 0 to 1000
/// - `s[15..16]`: progress, steps, 0 to 255
/// - `s[16..17]`: detour, steps, 0 to 1000
///
/// Values outside the ranges are legal, NaN and infinities too. It answers:
/// - 0: plan
/// - 1: straight
/// - 2: hold
/// - 3: away
/// - 4: field
/// - 5: field_plan
/// - 6: upright
/// - 7: field_base_up
/// - 8: field_base_down
/// - 9: field_shoulder_up
/// - 10: field_shoulder_down
/// - 11: field_elbow_up
/// - 12: field_elbow_down
/// - 13: field_wrist_up
/// - 14: field_wrist_down
#[derive(Clone, Copy, Debug, Default)]
pub struct Dodge;

impl Dodge {
    /// Values of a state.
    pub const STATE: usize = 17;
    /// Actions.
    pub const ACTIONS: usize = 15;
    /// An action.
    pub const PLAN: ActionId = ActionId(0);
    /// An action.
    pub const STRAIGHT: ActionId = ActionId(1);
    /// An action.
    pub const HOLD: ActionId = ActionId(2);
    /// An action.
    pub const AWAY: ActionId = ActionId(3);
    /// An action.
    pub const FIELD: ActionId = ActionId(4);
    /// An action.
    pub const FIELD_PLAN: ActionId = ActionId(5);
    /// An action.
    pub const UPRIGHT: ActionId = ActionId(6);
    /// An action.
    pub const FIELD_BASE_UP: ActionId = ActionId(7);
    /// An action.
    pub const FIELD_BASE_DOWN: ActionId = ActionId(8);
    /// An action.
    pub const FIELD_SHOULDER_UP: ActionId = ActionId(9);
    /// An action.
    pub const FIELD_SHOULDER_DOWN: ActionId = ActionId(10);
    /// An action.
    pub const FIELD_ELBOW_UP: ActionId = ActionId(11);
    /// An action.
    pub const FIELD_ELBOW_DOWN: ActionId = ActionId(12);
    /// An action.
    pub const FIELD_WRIST_UP: ActionId = ActionId(13);
    /// An action.
    pub const FIELD_WRIST_DOWN: ActionId = ActionId(14);
    /// Teams on the longest walk.
    pub const DEPTH: usize = 2;
}

impl Policy for Dodge {
    type State = [f32; 17];
    type Action = ActionId;

    fn decide(&self, s: &[f32; 17]) -> ActionId {
        let ct = ConstantTime::<f32>::default();

        // What is bid, as integers in the same order.
        let bid_0 = ct.order(f32::abs(s[11]));
        let bid_5 = -8388607_i32; // 0.0_f32
        let bid_2 = ct.order(s[16] - s[10]);
        let bid_3 = ct.order(f32::abs(s[14]));
        let bid_7 = ct.order(ct.negate_if_less(s[12], s[7]));
        let bid_6 = ct.order(634.5653_f32 / s[7]);
        let bid_9 = ct.order(634.5653_f32 / s[16]);
        let bid_10 = ct.order(ct.max(s[12], s[7]));
        let bid_11 = ct.order(s[3] - s[10]);
        let bid_13 = ct.order(s[12] - s[7]);

        // Where each team leads: teams are numbered from 0, the root, and the actions follow them.
        // Team 0
        let best = (bid_2, 9);
        let best = ct.challenge(best, (bid_3, 2));
        let best = ct.challenge(best, (bid_5, 9));
        let best = ct.challenge(best, (bid_6, 1));
        let best = ct.challenge(best, (bid_0, 10));
        let best = ct.challenge(best, (bid_7, 2));
        let best = ct.challenge(best, (bid_9, 2));
        let best = ct.challenge(best, (bid_10, 2));
        let t0 = best.1 as u8;
        // Team 1
        let best = (bid_9, 2);
        let best = ct.challenge(best, (bid_7, 2));
        let best = ct.challenge(best, (bid_11, 15));
        let best = ct.challenge(best, (bid_10, 2));
        let best = ct.challenge(best, (bid_13, 2));
        let t1 = best.1 as u8;

        // An action leads to itself, and so does what fills the array up to a power of two: it is never come to.
        let next: [u8; 32] = [
            t0, t1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23,
            24, 25, 26, 27, 28, 29, 30, 31,
        ];
        // The longest walk decides 2 times; a shorter one waits at its action. No loop, and no end to check.
        let vertex = next[0];
        let vertex = next[(vertex & 31) as usize];
        ActionId(vertex.wrapping_sub(2) as u16)
    }
}
