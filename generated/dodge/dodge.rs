//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix dodge --profile constant-time
//! Graph SHA-256: db0aaf6f89a54e71dac36cbedbd06aacc0142ac9130db3bacc9a6d5cb6598c4e
//! 1 teams (1 on the longest walk), 2 edges, 2 programs, 1 distinct operations.
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
    /// Teams on the longest walk.
    pub const DEPTH: usize = 1;
    /// Bids that one decision looks at, at most.
    pub const WORST_BIDS: usize = 2;
    /// Operations of one decision, at most.
    pub const WORST_OPERATIONS: usize = 1;
    /// Sines, cosines, logarithms and exponentials among them, at most.
    pub const WORST_MATHS_CALLS: usize = 0;
}

impl Policy for Dodge {
    type State = [f32; 17];
    type Action = ActionId;

    fn decide(&self, s: &[f32; 17]) -> ActionId {
        let ct = ConstantTime::<f32>::default();
        let v3 = ct.min(s[16], s[9]);

        // What is bid, as integers in the same order.
        let k0 = 1098669879_i32; // 31.54649_f32
        let k3 = ct.order(v3);

        // Where the team leads: the number behind the best bid.
        // Team 0
        let best = (k0, 0);
        let best = ct.challenge(best, (k3, 5));

        ActionId(best.1 as u16)
    }
}
