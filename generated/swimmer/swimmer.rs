//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix swimmer --profile constant-time
//! Graph SHA-256: 67b166ee4a50b89decc98f05d051db452a31b90cf0a8686482eef25ad207213a
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
/// - `s[0..8]`: obs, , -1.1418218612670898 to 1.1901516914367676; -1.4240355491638184 to 1.4747825860977173; -1.4165217876434326 to 1.3934783935546875; -0.9518981575965881 to 1.7313870191574097; -3.436978816986084 to 3.4301185607910156; -3.7419471740722656 to 3.7548954486846924; -5.163805961608887 to 5.125205039978027; -8.226472854614258 to 7.842264652252197
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
        let v2 = s[0] * 0.7118727_f32;
        let v5 = s[1] * -0.11251226_f32;
        let v6 = v2 + v5;
        let v9 = s[2] * -0.69512516_f32;
        let v10 = v6 + v9;
        let v13 = s[4] * 0.3123265_f32;
        let v14 = v10 + v13;
        let v17 = s[5] * -0.27881774_f32;
        let v18 = v14 + v17;
        let v21 = s[6] * 0.183991_f32;
        let v22 = v18 + v21;
        let v25 = s[7] * -0.12982675_f32;
        let v26 = v22 + v25;
        let v28 = v26 + -0.023436766_f32;
        let v30 = s[1] * 0.26692712_f32;
        let v32 = s[2] * -0.65130556_f32;
        let v33 = v30 + v32;
        let v36 = s[3] * -0.31501192_f32;
        let v37 = v33 + v36;
        let v39 = s[4] * 0.26088122_f32;
        let v40 = v37 + v39;
        let v42 = s[5] * -0.35128272_f32;
        let v43 = v40 + v42;
        let v45 = s[6] * 0.2057382_f32;
        let v46 = v43 + v45;
        let v48 = s[7] * 0.08384997_f32;
        let v49 = v46 + v48;
        let v51 = v49 + 0.08995213_f32;
        [
            ct.clamp(v28, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(v51, -1.0_f32, 1.0_f32, 0.0_f32),
        ]
    }
}
