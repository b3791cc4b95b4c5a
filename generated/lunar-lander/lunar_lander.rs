//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix lunar_lander --profile constant-time
//! Graph SHA-256: 4860121d1ea3ffdf89e9ada410cfbcba3eec3d600e5fe2f31f6c9ab863872977
//! 1 teams (1 on the longest walk), 4 edges, 4 programs, 23 distinct operations.
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
    pub const WORST_OPERATIONS: usize = 23;
    /// Sines, cosines, logarithms and exponentials among them, at most.
    pub const WORST_MATHS_CALLS: usize = 0;
}

impl Policy for LunarLander {
    type State = [f32; 8];
    type Action = ActionId;

    fn decide(&self, s: &[f32; 8]) -> ActionId {
        let ct = ConstantTime::<f32>::default();
        let v3 = s[0] * 0.54824466_f32;
        let v6 = s[1] * 0.41400775_f32;
        let v7 = v3 + v6;
        let v10 = s[4] * -1.3129216_f32;
        let v11 = v7 + v10;
        let v14 = s[5] * -1.5008805_f32;
        let v15 = v11 + v14;
        let v17 = s[1] * -0.7259825_f32;
        let v20 = s[3] * -2.4281847_f32;
        let v21 = v17 + v20;
        let v23 = v21 + -0.2920304_f32;
        let v25 = s[0] * -0.50036424_f32;
        let v27 = s[1] * 0.32095438_f32;
        let v28 = v25 + v27;
        let v31 = s[2] * -1.462079_f32;
        let v32 = v28 + v31;
        let v34 = s[3] * 1.0567017_f32;
        let v35 = v32 + v34;
        let v37 = s[4] * 1.1205845_f32;
        let v38 = v35 + v37;
        let v41 = s[7] * -0.700306_f32;
        let v42 = v38 + v41;
        let v44 = v42 + 0.4441619_f32;

        // What is bid, as integers in the same order.
        let k0 = -8388607_i32; // 0.0_f32
        let k15 = ct.order(v15);
        let k23 = ct.order(v23);
        let k44 = ct.order(v44);

        // Where the team leads: the number behind the best bid.
        // Team 0
        let best = (k0, 0);
        let best = ct.challenge(best, (k15, 1));
        let best = ct.challenge(best, (k23, 2));
        let best = ct.challenge(best, (k44, 3));

        ActionId(best.1 as u16)
    }
}
