//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix inverted_double_pendulum --profile constant-time
//! Graph SHA-256: c2a4564156a88eb4a1801ee60afdb589122425609075ccfdd0cb96b607b2ae6f
//! 1 teams (1 on the longest walk), 1 edges, 1 programs, 14 distinct operations.
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
/// - `s[0..9]`: obs, , -0.16463087499141693 to 0.29684537649154663; -0.14117883145809174 to 0.11996287107467651; -0.14263926446437836 to 0.12101449817419052; 0.9940253496170044 to 1.001194953918457; 0.9938969016075134 to 1.001220703125; -0.3205852508544922 to 0.24939168989658356; -0.3906712830066681 to 0.2939753234386444; -0.31223034858703613 to 0.38351622223854065; -0.0002500000118743628 to 0.0002500000118743628
///
/// Values outside the ranges are legal, NaN and infinities too. It answers:
/// - `[0]`: action, , -1 to 1; 0 in place of NaN
#[derive(Clone, Copy, Debug, Default)]
pub struct InvertedDoublePendulum;

impl InvertedDoublePendulum {
    /// Values of a state.
    pub const STATE: usize = 9;
    /// Outputs.
    pub const OUTPUTS: usize = 1;
    /// Teams on the longest walk.
    pub const DEPTH: usize = 1;
    /// Bids that one decision looks at, at most.
    pub const WORST_BIDS: usize = 0;
    /// Operations of one decision, at most.
    pub const WORST_OPERATIONS: usize = 14;
    /// Sines, cosines, logarithms and exponentials among them, at most.
    pub const WORST_MATHS_CALLS: usize = 0;
}

impl Policy for InvertedDoublePendulum {
    type State = [f32; 9];
    type Action = [f32; 1];

    fn decide(&self, s: &[f32; 9]) -> [f32; 1] {
        let ct = ConstantTime::<f32>::default();
        let v2 = s[0] * -0.48305112_f32;
        let v5 = s[1] * -2.4732687_f32;
        let v6 = v2 + v5;
        let v9 = s[2] * -6.5629725_f32;
        let v10 = v6 + v9;
        let v13 = s[4] * -0.45679966_f32;
        let v14 = v10 + v13;
        let v17 = s[5] * -0.2828851_f32;
        let v18 = v14 + v17;
        let v21 = s[6] * -0.9611906_f32;
        let v22 = v18 + v21;
        let v25 = s[7] * -0.9364736_f32;
        let v26 = v22 + v25;
        let v28 = v26 + 0.44827595_f32;
        [ct.clamp(v28, -1.0_f32, 1.0_f32, 0.0_f32)]
    }
}
