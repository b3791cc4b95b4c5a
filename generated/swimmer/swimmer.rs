//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix swimmer --profile constant-time
//! Graph SHA-256: f1fcd16d87e2426656b1d181341ac3b7f4221d042e81bf124407e8cab858f394
//! 1 teams (1 on the longest walk), 1 edges, 1 programs, 26 distinct operations.
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
/// - `s[0..8]`: obs, , -1.3432261943817139 to 1.0754176378250122; -1.6053855419158936 to 1.6728030443191528; -1.6147688627243042 to 1.5566096305847168; -1.4070086479187012 to 2.155215263366699; -3.5542614459991455 to 3.5728280544281006; -3.827202796936035 to 3.846395492553711; -6.324155807495117 to 6.35818338394165; -9.29275894165039 to 9.288382530212402
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
    pub const WORST_OPERATIONS: usize = 26;
    /// Sines, cosines, logarithms and exponentials among them, at most.
    pub const WORST_MATHS_CALLS: usize = 0;
}

impl Policy for Swimmer {
    type State = [f32; 8];
    type Action = [f32; 2];

    fn decide(&self, s: &[f32; 8]) -> [f32; 2] {
        let ct = ConstantTime::<f32>::default();
        let v3 = s[1] * 0.52979016_f32;
        let v4 = 0.0_f32 + v3;
        let v7 = s[2] * -5.974702_f32;
        let v8 = v4 + v7;
        let v10 = v8 * s[3];
        let v11 = v8 + v10;
        let v14 = s[4] * 10.418471_f32;
        let v15 = v11 + v14;
        let v18 = s[5] * 1.5990511_f32;
        let v19 = v15 + v18;
        let v22 = s[6] * 4.344058_f32;
        let v23 = v19 + v22;
        let v26 = s[7] * -6.256689_f32;
        let v27 = v23 + v26;
        let v29 = v27 + 1.4570708_f32;
        let v31 = s[1] * 3.828739_f32;
        let v32 = 0.0_f32 + v31;
        let v34 = s[4] * 3.323152_f32;
        let v35 = v32 + v34;
        let v37 = s[5] * -3.6907132_f32;
        let v38 = v35 + v37;
        let v40 = s[6] * 2.7172828_f32;
        let v41 = v38 + v40;
        let v43 = s[7] * 1.6195582_f32;
        let v44 = v41 + v43;
        let v46 = v44 + -0.8324088_f32;
        [
            ct.clamp(v29, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(v46, -1.0_f32, 1.0_f32, 0.0_f32),
        ]
    }
}
