//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix hopper --profile constant-time
//! Graph SHA-256: fb10bab75b353452c0f7ee6bdd8a9c4e3c9c4e8b9c699923ea61c53a75923706
//! 1 teams (1 on the longest walk), 1 edges, 1 programs, 67 distinct operations.
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
/// - `s[0..11]`: obs, , 0.9885297417640686 to 1.7001316547393799; -0.22649134695529938 to 0.20725364983081818; -0.6324189901351929 to 0.1609724909067154; -1.0293190479278564 to 0.2524624168872833; -1.3216780424118042 to 1.2777830362319946; -0.7767627835273743 to 3.8771281242370605; -3.8018062114715576 to 3.816553831100464; -5.869260787963867 to 5.131644248962402; -7.1290507316589355 to 7.402948379516602; -10.13048267364502 to 8.481813430786133; -15 to 15
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
    pub const WORST_OPERATIONS: usize = 67;
    /// Sines, cosines, logarithms and exponentials among them, at most.
    pub const WORST_MATHS_CALLS: usize = 0;
}

impl Policy for Hopper {
    type State = [f32; 11];
    type Action = [f32; 3];

    fn decide(&self, s: &[f32; 11]) -> [f32; 3] {
        let ct = ConstantTime::<f32>::default();
        let v3 = s[0] * 17.223093_f32;
        let v4 = 0.0_f32 + v3;
        let v7 = s[1] * -57.310635_f32;
        let v8 = v4 + v7;
        let v11 = s[2] * -2.666162_f32;
        let v12 = v8 + v11;
        let v15 = s[3] * 38.50292_f32;
        let v16 = v12 + v15;
        let v19 = s[4] * -3.6437075_f32;
        let v20 = v16 + v19;
        let v23 = s[5] * -4.3315954_f32;
        let v24 = v20 + v23;
        let v27 = s[6] * 10.520559_f32;
        let v28 = v24 + v27;
        let v31 = s[8] * -4.0487485_f32;
        let v32 = v28 + v31;
        let v35 = s[9] * 2.2844436_f32;
        let v36 = v32 + v35;
        let v39 = s[10] * -0.93529904_f32;
        let v40 = v36 + v39;
        let v42 = v40 + -0.40775383_f32;
        let v44 = s[0] * 1.3736471_f32;
        let v45 = 0.0_f32 + v44;
        let v47 = s[1] * -18.891891_f32;
        let v48 = v45 + v47;
        let v50 = s[2] * -7.4346485_f32;
        let v51 = v48 + v50;
        let v53 = s[3] * -15.671401_f32;
        let v54 = v51 + v53;
        let v56 = s[4] * -1.4999967_f32;
        let v57 = v54 + v56;
        let v59 = s[5] * -1.8972312_f32;
        let v60 = v57 + v59;
        let v62 = s[6] * -3.5186489_f32;
        let v63 = v60 + v62;
        let v66 = s[7] * -5.763084_f32;
        let v67 = v63 + v66;
        let v69 = s[8] * 1.0130048_f32;
        let v70 = v67 + v69;
        let v72 = s[9] * -2.2987392_f32;
        let v73 = v70 + v72;
        let v75 = s[10] * 1.3076066_f32;
        let v76 = v73 + v75;
        let v78 = v76 + -1.099076_f32;
        let v80 = s[0] * 10.411505_f32;
        let v81 = 0.0_f32 + v80;
        let v83 = s[1] * -5.8839245_f32;
        let v84 = v81 + v83;
        let v86 = s[2] * 50.929966_f32;
        let v87 = v84 + v86;
        let v89 = s[3] * -2.9071462_f32;
        let v90 = v87 + v89;
        let v92 = s[4] * -5.4191236_f32;
        let v93 = v90 + v92;
        let v95 = s[5] * -3.7370574_f32;
        let v96 = v93 + v95;
        let v98 = s[6] * -6.636422_f32;
        let v99 = v96 + v98;
        let v101 = s[7] * -0.2007767_f32;
        let v102 = v99 + v101;
        let v104 = s[8] * -0.35769776_f32;
        let v105 = v102 + v104;
        let v107 = s[9] * 3.292033_f32;
        let v108 = v105 + v107;
        let v110 = s[10] * -2.2646153_f32;
        let v111 = v108 + v110;
        let v113 = v111 + -2.010129_f32;
        [
            ct.clamp(v42, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(v78, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(v113, -1.0_f32, 1.0_f32, 0.0_f32),
        ]
    }
}
