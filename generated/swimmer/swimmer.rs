//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix swimmer --profile constant-time
//! Graph SHA-256: 35a11094e952120a0c89ca943b4ff1134c6ba90081ecb5709019d335cc6126a5
//! 1 teams (1 on the longest walk), 1 edges, 1 programs, 28 distinct operations.
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
/// - `s[0..8]`: obs, , -1.128920078277588 to 1.205222249031067; -1.5363115072250366 to 1.4535622596740723; -1.4418669939041138 to 1.4989898204803467; -0.955388069152832 to 1.7334280014038086; -3.4727089405059814 to 3.456476926803589; -3.7571308612823486 to 3.777353048324585; -5.308562278747559 to 5.238750457763672; -8.187785148620605 to 7.8623270988464355
///
/// Values outside the ranges are legal, NaN and infinities too. It answers:
/// - `[0]`: action_0, , -1 to 1; 0 in place of NaN
/// - `[1]`: action_1, , -1 to 1; 0 in place of NaN
#[derive(Clone, Copy, Debug, Default)]
pub struct Swimmer;

impl Swimmer {
    /// Values of a state.
    pub const STATE: usize = 8;
    /// Outputs.
    pub const OUTPUTS: usize = 2;
    /// Teams on the longest walk.
    pub const DEPTH: usize = 1;
    /// Bids that one decision looks at, at most.
    pub const WORST_BIDS: usize = 0;
    /// Operations of one decision, at most.
    pub const WORST_OPERATIONS: usize = 28;
    /// Sines, cosines, logarithms and exponentials among them, at most.
    pub const WORST_MATHS_CALLS: usize = 0;
}

impl Policy for Swimmer {
    type State = [f32; 8];
    type Action = [f32; 2];

    fn decide(&self, s: &[f32; 8]) -> [f32; 2] {
        let ct = ConstantTime::<f32>::default();
        let v2 = s[0] * 1.0105755_f32;
        let v5 = s[1] * -0.16823284_f32;
        let v6 = v2 + v5;
        let v9 = s[2] * -0.66660637_f32;
        let v10 = v6 + v9;
        let v13 = s[3] * -0.016324192_f32;
        let v14 = v10 + v13;
        let v17 = s[4] * 0.29036057_f32;
        let v18 = v14 + v17;
        let v21 = s[5] * -0.20999737_f32;
        let v22 = v18 + v21;
        let v25 = s[6] * 0.25208098_f32;
        let v26 = v22 + v25;
        let v29 = s[7] * -0.055112995_f32;
        let v30 = v26 + v29;
        let v32 = v30 + 0.0054187076_f32;
        let v34 = s[1] * 0.5448633_f32;
        let v36 = s[2] * -0.86861455_f32;
        let v37 = v34 + v36;
        let v39 = s[3] * -0.15368144_f32;
        let v40 = v37 + v39;
        let v42 = s[4] * 0.3506624_f32;
        let v43 = v40 + v42;
        let v45 = s[5] * -0.31806582_f32;
        let v46 = v43 + v45;
        let v48 = s[7] * 0.007038943_f32;
        let v49 = v46 + v48;
        let v51 = v49 + 0.056389466_f32;
        [
            ct.clamp(v32, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(v51, -1.0_f32, 1.0_f32, 0.0_f32),
        ]
    }
}
