//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix lunar_lander --profile constant-time
//! Graph SHA-256: c5d781b19e6db96e9189b52ea5da29d69ffb299c5a96bc384c1ffb985bc2b9ff
//! 1 teams (1 on the longest walk), 4 edges, 4 programs, 27 distinct operations.
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
/// - `s[0..8]`: obs, , -2.5 to 2.5; -2.5 to 2.5; -10 to 10; -10 to 10; -6.2831854820251465 to 6.2831854820251465; -10 to 10; -0 to 1; -0 to 1
///
/// Values outside the ranges are legal, NaN and infinities too. It answers:
/// - 0: a0
/// - 1: a1
/// - 2: a2
/// - 3: a3
#[derive(Clone, Copy, Debug, Default)]
pub struct LunarLander;

impl LunarLander {
    /// Values of a state.
    pub const STATE: usize = 8;
    /// Actions.
    pub const ACTIONS: usize = 4;
    /// Teams on the longest walk.
    pub const DEPTH: usize = 1;
    /// Bids that one decision looks at, at most.
    pub const WORST_BIDS: usize = 4;
    /// Operations of one decision, at most.
    pub const WORST_OPERATIONS: usize = 27;
    /// Sines, cosines, logarithms and exponentials among them, at most.
    pub const WORST_MATHS_CALLS: usize = 0;
}

impl Policy for LunarLander {
    type State = [f32; 8];
    type Action = ActionId;

    fn decide(&self, s: &[f32; 8]) -> ActionId {
        let ct = ConstantTime::<f32>::default();
        let v3 = s[0] * 40.444534_f32;
        let v4 = 0.0_f32 + v3;
        let v7 = s[1] * 11.248273_f32;
        let v8 = v4 + v7;
        let v11 = s[3] * 11.407757_f32;
        let v12 = v8 + v11;
        let v15 = s[4] * -38.641365_f32;
        let v16 = v12 + v15;
        let v18 = s[1] * -7.14187_f32;
        let v19 = 0.0_f32 + v18;
        let v21 = s[3] * -25.41661_f32;
        let v22 = v19 + v21;
        let v24 = v22 * s[6];
        let v25 = v22 + v24;
        let v27 = v25 + -4.097343_f32;
        let v30 = s[2] * -10.781047_f32;
        let v31 = 0.0_f32 + v30;
        let v34 = s[5] * 16.250267_f32;
        let v35 = v31 + v34;
        let v37 = s[4] * 7.2615485_f32;
        let v38 = v35 + v37;
        let v40 = s[3] * -5.052873_f32;
        let v41 = v38 + v40;
        let v43 = s[6] * -7.9200935_f32;
        let v44 = v41 + v43;
        let v47 = s[7] * -4.2033114_f32;
        let v48 = v44 + v47;

        // What is bid, as integers in the same order.
        let k0 = -8388607_i32; // 0.0_f32
        let k16 = ct.order(v16);
        let k27 = ct.order(v27);
        let k48 = ct.order(v48);

        // Where the team leads: the number behind the best bid.
        // Team 0
        let best = (k0, 0);
        let best = ct.challenge(best, (k16, 1));
        let best = ct.challenge(best, (k27, 2));
        let best = ct.challenge(best, (k48, 3));

        ActionId(best.1 as u16)
    }
}
