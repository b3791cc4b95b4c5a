//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix hopper --profile constant-time
//! Graph SHA-256: d294bc47b0222a94abc7c3659d8c794cb0ec1da057122320417bd26ad0a90e67
//! 1 teams (1 on the longest walk), 1 edges, 1 programs, 61 distinct operations.
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
/// - `s[0..11]`: obs, , 0.8571456074714661 to 1.8482515811920166; -0.1802159696817398 to 0.056546762585639954; -0.8256809711456299 to 0.17060135304927826; -0.0061248913407325745 to 0.0070526134222745895; -1.3546653985977173 to 1.4163367748260498; -0.7724487781524658 to 3.855558156967163; -4.0611138343811035 to 4.108202934265137; -1.3541887998580933 to 1.7314413785934448; -3.2942798137664795 to 3.2574009895324707; -0.07190670818090439 to 0.0784301832318306; -15 to 15
///
/// Values outside the ranges are legal, NaN and infinities too. It answers:
/// - `[0]`: action_0, , -1 to 1; 0 in place of NaN
/// - `[1]`: action_1, , -1 to 1; 0 in place of NaN
/// - `[2]`: action_2, , -1 to 1; 0 in place of NaN
#[derive(Clone, Copy, Debug, Default)]
pub struct Hopper;

impl Hopper {
    /// Values of a state.
    pub const STATE: usize = 11;
    /// Outputs.
    pub const OUTPUTS: usize = 3;
    /// Teams on the longest walk.
    pub const DEPTH: usize = 1;
    /// Bids that one decision looks at, at most.
    pub const WORST_BIDS: usize = 0;
    /// Operations of one decision, at most.
    pub const WORST_OPERATIONS: usize = 61;
    /// Sines, cosines, logarithms and exponentials among them, at most.
    pub const WORST_MATHS_CALLS: usize = 0;
}

impl Policy for Hopper {
    type State = [f32; 11];
    type Action = [f32; 3];

    fn decide(&self, s: &[f32; 11]) -> [f32; 3] {
        let ct = ConstantTime::<f32>::default();
        let v3 = s[0] * 0.91893643_f32;
        let v4 = 0.0_f32 + v3;
        let v7 = s[1] * -6.9197044_f32;
        let v8 = v4 + v7;
        let v11 = s[2] * -1.281848_f32;
        let v12 = v8 + v11;
        let v15 = s[3] * 1.7175211_f32;
        let v16 = v12 + v15;
        let v19 = s[4] * -0.54383606_f32;
        let v20 = v16 + v19;
        let v23 = s[5] * -0.33684945_f32;
        let v24 = v20 + v23;
        let v27 = s[6] * 0.27482417_f32;
        let v28 = v24 + v27;
        let v31 = s[7] * -1.0601645_f32;
        let v32 = v28 + v31;
        let v35 = s[8] * -0.4680834_f32;
        let v36 = v32 + v35;
        let v39 = s[9] * -0.8199166_f32;
        let v40 = v36 + v39;
        let v42 = v40 + -1.4247644_f32;
        let v44 = s[0] * 2.0718632_f32;
        let v45 = 0.0_f32 + v44;
        let v47 = s[1] * -15.372457_f32;
        let v48 = v45 + v47;
        let v50 = s[2] * -2.2944324_f32;
        let v51 = v48 + v50;
        let v53 = s[3] * 8.713481_f32;
        let v54 = v51 + v53;
        let v56 = s[4] * 1.3414459_f32;
        let v57 = v54 + v56;
        let v59 = s[5] * -0.6442023_f32;
        let v60 = v57 + v59;
        let v62 = s[6] * 0.116932996_f32;
        let v63 = v60 + v62;
        let v65 = s[7] * 0.8644801_f32;
        let v66 = v63 + v65;
        let v68 = s[8] * 0.35530937_f32;
        let v69 = v66 + v68;
        let v71 = s[9] * -0.674285_f32;
        let v72 = v69 + v71;
        let v75 = s[10] * 0.07043329_f32;
        let v76 = v72 + v75;
        let v78 = v76 + -1.887191_f32;
        let v80 = s[0] * 6.816188_f32;
        let v81 = 0.0_f32 + v80;
        let v83 = s[1] * 7.027345_f32;
        let v84 = v81 + v83;
        let v86 = s[2] * 1.1816889_f32;
        let v87 = v84 + v86;
        let v89 = s[3] * 9.409367_f32;
        let v90 = v87 + v89;
        let v92 = s[5] * -0.81106883_f32;
        let v93 = v90 + v92;
        let v95 = s[6] * -0.30011207_f32;
        let v96 = v93 + v95;
        let v98 = s[8] * 0.12846981_f32;
        let v99 = v96 + v98;
        let v101 = s[10] * -0.043976225_f32;
        let v102 = v99 + v101;
        let v104 = v102 + -6.7089043_f32;
        [
            ct.clamp(v42, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(v78, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(v104, -1.0_f32, 1.0_f32, 0.0_f32),
        ]
    }
}
