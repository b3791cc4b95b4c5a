//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix lunar_lander_continuous --profile constant-time
//! Graph SHA-256: 8d92aee034785833c57310fdf420c919dfb2aea7db8877dd08cef053e74095de
//! 1 teams (1 on the longest walk), 1 edges, 1 programs, 10 distinct operations.
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
    pub const WORST_OPERATIONS: usize = 10;
    /// Sines, cosines, logarithms and exponentials among them, at most.
    pub const WORST_MATHS_CALLS: usize = 0;
}

impl Policy for LunarLanderContinuous {
    type State = [f32; 8];
    type Action = [f32; 2];

    fn decide(&self, s: &[f32; 8]) -> [f32; 2] {
        let ct = ConstantTime::<f32>::default();
        let v3 = s[1] * -2.9189487_f32;
        let v6 = s[3] * -3.7557209_f32;
        let v7 = v3 + v6;
        let v9 = v7 + -0.50095105_f32;
        let v12 = s[2] * -3.9983425_f32;
        let v13 = 0.0_f32 + v12;
        let v16 = s[4] * 2.3448007_f32;
        let v17 = v13 + v16;
        let v20 = s[5] * 5.9345937_f32;
        let v21 = v17 + v20;
        [
            ct.clamp(v9, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(v21, -1.0_f32, 1.0_f32, 0.0_f32),
        ]
    }
}
