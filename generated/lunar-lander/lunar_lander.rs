//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix lunar_lander --profile constant-time
//! Graph SHA-256: 910b1d6fc757cf446e6fc2403fd0fc3400df4cc0d53c186d4d3bbd9331445690
//! 1 teams (1 on the longest walk), 4 edges, 4 programs, 32 distinct operations.
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
    pub const WORST_OPERATIONS: usize = 32;
    /// Sines, cosines, logarithms and exponentials among them, at most.
    pub const WORST_MATHS_CALLS: usize = 0;
}

impl Policy for LunarLander {
    type State = [f32; 8];
    type Action = ActionId;

    fn decide(&self, s: &[f32; 8]) -> ActionId {
        let ct = ConstantTime::<f32>::default();
        let v3 = s[0] * -0.47196642_f32;
        let v4 = 0.0_f32 + v3;
        let v7 = s[2] * 0.6433384_f32;
        let v8 = v4 + v7;
        let v11 = s[3] * 0.2611211_f32;
        let v12 = v8 + v11;
        let v15 = s[4] * -0.4740189_f32;
        let v16 = v12 + v15;
        let v19 = s[5] * -0.91989505_f32;
        let v20 = v16 + v19;
        let v23 = s[7] * -1.9277327_f32;
        let v24 = v20 + v23;
        let v26 = v24 + 0.34787703_f32;
        let v29 = s[1] * -0.64560854_f32;
        let v30 = 0.0_f32 + v29;
        let v32 = s[3] * -1.561657_f32;
        let v33 = v30 + v32;
        let v36 = s[6] * -0.0707698_f32;
        let v37 = v33 + v36;
        let v39 = s[0] * -1.0220673_f32;
        let v40 = 0.0_f32 + v39;
        let v42 = s[2] * -1.00794_f32;
        let v43 = v40 + v42;
        let v45 = s[3] * -0.056810778_f32;
        let v46 = v43 + v45;
        let v48 = s[4] * 0.87537944_f32;
        let v49 = v46 + v48;
        let v51 = s[5] * 2.077986_f32;
        let v52 = v49 + v51;
        let v54 = s[7] * -0.5768568_f32;
        let v55 = v52 + v54;
        let v57 = v55 + 0.22382003_f32;

        // What is bid, as integers in the same order.
        let k0 = -8388607_i32; // 0.0_f32
        let k26 = ct.order(v26);
        let k37 = ct.order(v37);
        let k57 = ct.order(v57);

        // Where the team leads: the number behind the best bid.
        // Team 0
        let best = (k0, 0);
        let best = ct.challenge(best, (k26, 1));
        let best = ct.challenge(best, (k37, 2));
        let best = ct.challenge(best, (k57, 3));

        ActionId(best.1 as u16)
    }
}
