//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix hopper --profile constant-time
//! Graph SHA-256: 45db48cea868239f6c7da6d4b7ab29f24a36ef767f572bf3ef94bc12a4be3468
//! 1 teams (1 on the longest walk), 1 edges, 1 programs, 63 distinct operations.
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
/// - `s[0..11]`: obs, , 0.8311252593994141 to 1.6484929323196411; -0.15008684992790222 to 0.03464629128575325; -0.8582800626754761 to 0.17889954149723053; -1.170978307723999 to 0.24002330005168915; -1.3404569625854492 to 1.407247543334961; -0.8826094269752502 to 4.4063615798950195; -3.494553804397583 to 3.5332000255584717; -0.6984527111053467 to 0.9729921221733093; -9.856317520141602 to 8.929598808288574; -12.639674186706543 to 11.657586097717285; -15 to 15
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
    pub const WORST_OPERATIONS: usize = 63;
    /// Sines, cosines, logarithms and exponentials among them, at most.
    pub const WORST_MATHS_CALLS: usize = 0;
}

impl Policy for Hopper {
    type State = [f32; 11];
    type Action = [f32; 3];

    fn decide(&self, s: &[f32; 11]) -> [f32; 3] {
        let ct = ConstantTime::<f32>::default();
        let v3 = s[0] * 2.4094844_f32;
        let v4 = 0.0_f32 + v3;
        let v7 = s[1] * -16.831106_f32;
        let v8 = v4 + v7;
        let v11 = s[2] * -0.9726171_f32;
        let v12 = v8 + v11;
        let v15 = s[3] * 1.2704073_f32;
        let v16 = v12 + v15;
        let v19 = s[4] * -0.30623376_f32;
        let v20 = v16 + v19;
        let v23 = s[5] * 0.32980627_f32;
        let v24 = v20 + v23;
        let v27 = s[6] * -0.14272827_f32;
        let v28 = v24 + v27;
        let v31 = s[7] * -0.67063546_f32;
        let v32 = v28 + v31;
        let v35 = s[8] * 0.084569946_f32;
        let v36 = v32 + v35;
        let v39 = s[9] * 0.10996343_f32;
        let v40 = v36 + v39;
        let v43 = s[10] * -0.0139268385_f32;
        let v44 = v40 + v43;
        let v46 = v44 + -4.385427_f32;
        let v48 = s[0] * -0.48055917_f32;
        let v49 = 0.0_f32 + v48;
        let v51 = s[1] * -15.44946_f32;
        let v52 = v49 + v51;
        let v54 = s[2] * 1.6838492_f32;
        let v55 = v52 + v54;
        let v57 = s[3] * -1.7118963_f32;
        let v58 = v55 + v57;
        let v60 = s[4] * -0.05598478_f32;
        let v61 = v58 + v60;
        let v63 = s[6] * 0.3226204_f32;
        let v64 = v61 + v63;
        let v66 = s[7] * -0.8628424_f32;
        let v67 = v64 + v66;
        let v69 = s[8] * -0.12721324_f32;
        let v70 = v67 + v69;
        let v72 = s[9] * -0.0822124_f32;
        let v73 = v70 + v72;
        let v75 = v73 + -1.109722_f32;
        let v77 = s[0] * 3.3940566_f32;
        let v78 = 0.0_f32 + v77;
        let v80 = s[1] * 0.5165295_f32;
        let v81 = v78 + v80;
        let v83 = s[2] * 2.143888_f32;
        let v84 = v81 + v83;
        let v86 = s[3] * -0.25035787_f32;
        let v87 = v84 + v86;
        let v89 = s[5] * -0.83269984_f32;
        let v90 = v87 + v89;
        let v92 = s[6] * 0.02263618_f32;
        let v93 = v90 + v92;
        let v95 = s[7] * 0.46339342_f32;
        let v96 = v93 + v95;
        let v98 = s[8] * 0.13614666_f32;
        let v99 = v96 + v98;
        let v101 = s[9] * -0.039877187_f32;
        let v102 = v99 + v101;
        let v104 = s[10] * -0.0018393787_f32;
        let v105 = v102 + v104;
        let v107 = v105 + -2.0928748_f32;
        [
            ct.clamp(v46, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(v75, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(v107, -1.0_f32, 1.0_f32, 0.0_f32),
        ]
    }
}
