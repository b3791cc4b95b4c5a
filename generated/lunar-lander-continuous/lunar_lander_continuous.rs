//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix lunar_lander_continuous --profile constant-time
//! Graph SHA-256: 21140b6a4c0651fa6f8a83087689cd7d36775e4af62ea92655ec41dd4fa1ed3d
//! 1 teams (1 on the longest walk), 1 edges, 1 programs, 12 distinct operations.
//! Computes in f32 with own maths.
#![forbid(unsafe_code)]
#![allow(
    clippy::all,
    unused_variables,
    unused_assignments,
    reason = "evolved expressions need not make sense"
)]

use tpg_runtime::ops::constant_time::ConstantTime;
use tpg_runtime::policy::Policy;

/// A tangled program graph: a formula.
///
/// It sees, one after another:
/// - `s[0..8]`: obs, , -2.5 to 2.5; -2.5 to 2.5; -10 to 10; -10 to 10; -6.2831854820251465 to 6.2831854820251465; -10 to 10; -0 to 1; -0 to 1
///
/// Values outside the ranges are legal, NaN and infinities too. It answers:
/// - `[0]`: action_0, , -1 to 1; 0 in place of NaN
/// - `[1]`: action_1, , -1 to 1; 0 in place of NaN
#[derive(Clone, Copy, Debug, Default)]
pub struct LunarLanderContinuous;

impl LunarLanderContinuous {
    /// Values of a state.
    pub const STATE: usize = 8;
    /// Outputs.
    pub const OUTPUTS: usize = 2;
    /// Teams on the longest walk.
    pub const DEPTH: usize = 1;
    /// Bids that one decision looks at, at most.
    pub const WORST_BIDS: usize = 0;
    /// Operations of one decision, at most.
    pub const WORST_OPERATIONS: usize = 12;
    /// Sines, cosines, logarithms and exponentials among them, at most.
    pub const WORST_MATHS_CALLS: usize = 0;
}

impl Policy for LunarLanderContinuous {
    type State = [f32; 8];
    type Action = [f32; 2];

    fn decide(&self, s: &[f32; 8]) -> [f32; 2] {
        let ct = ConstantTime::<f32>::default();
        let v2 = s[1] * -8.037243_f32;
        let v5 = s[3] * -11.026979_f32;
        let v6 = v2 + v5;
        let v8 = v6 + -1.8125842_f32;
        let v11 = s[0] * -18.706825_f32;
        let v14 = s[5] * 2.1564276_f32;
        let v15 = v11 + v14;
        let v18 = s[4] * 14.484438_f32;
        let v19 = v15 + v18;
        let v22 = s[2] * -6.0377746_f32;
        let v23 = v19 + v22;
        let v25 = v23 + 0.24678662_f32;
        [
            ct.clamp(v8, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(v25, -1.0_f32, 1.0_f32, 0.0_f32),
        ]
    }
}
