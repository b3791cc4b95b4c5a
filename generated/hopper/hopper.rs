//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix hopper --profile constant-time
//! Graph SHA-256: 45db48cea868239f6c7da6d4b7ab29f24a36ef767f572bf3ef94bc12a4be3468
//! 1 teams (1 on the longest walk), 1 edges, 1 programs, 60 distinct operations.
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
    pub const WORST_OPERATIONS: usize = 60;
    /// Sines, cosines, logarithms and exponentials among them, at most.
    pub const WORST_MATHS_CALLS: usize = 0;
}

impl Policy for Hopper {
    type State = [f32; 11];
    type Action = [f32; 3];

    fn decide(&self, s: &[f32; 11]) -> [f32; 3] {
        let ct = ConstantTime::<f32>::default();
        let v2 = s[0] * 2.4094844_f32;
        let v5 = s[1] * -16.831106_f32;
        let v6 = v2 + v5;
        let v9 = s[2] * -0.9726171_f32;
        let v10 = v6 + v9;
        let v13 = s[3] * 1.2704073_f32;
        let v14 = v10 + v13;
        let v17 = s[4] * -0.30623376_f32;
        let v18 = v14 + v17;
        let v21 = s[5] * 0.32980627_f32;
        let v22 = v18 + v21;
        let v25 = s[6] * -0.14272827_f32;
        let v26 = v22 + v25;
        let v29 = s[7] * -0.67063546_f32;
        let v30 = v26 + v29;
        let v33 = s[8] * 0.084569946_f32;
        let v34 = v30 + v33;
        let v37 = s[9] * 0.10996343_f32;
        let v38 = v34 + v37;
        let v41 = s[10] * -0.0139268385_f32;
        let v42 = v38 + v41;
        let v44 = v42 + -4.385427_f32;
        let v46 = s[0] * -0.48055917_f32;
        let v48 = s[1] * -15.44946_f32;
        let v49 = v46 + v48;
        let v51 = s[2] * 1.6838492_f32;
        let v52 = v49 + v51;
        let v54 = s[3] * -1.7118963_f32;
        let v55 = v52 + v54;
        let v57 = s[4] * -0.05598478_f32;
        let v58 = v55 + v57;
        let v60 = s[6] * 0.3226204_f32;
        let v61 = v58 + v60;
        let v63 = s[7] * -0.8628424_f32;
        let v64 = v61 + v63;
        let v66 = s[8] * -0.12721324_f32;
        let v67 = v64 + v66;
        let v69 = s[9] * -0.0822124_f32;
        let v70 = v67 + v69;
        let v72 = v70 + -1.109722_f32;
        let v74 = s[0] * 3.3940566_f32;
        let v76 = s[1] * 0.5165295_f32;
        let v77 = v74 + v76;
        let v79 = s[2] * 2.143888_f32;
        let v80 = v77 + v79;
        let v82 = s[3] * -0.25035787_f32;
        let v83 = v80 + v82;
        let v85 = s[5] * -0.83269984_f32;
        let v86 = v83 + v85;
        let v88 = s[6] * 0.02263618_f32;
        let v89 = v86 + v88;
        let v91 = s[7] * 0.46339342_f32;
        let v92 = v89 + v91;
        let v94 = s[8] * 0.13614666_f32;
        let v95 = v92 + v94;
        let v97 = s[9] * -0.039877187_f32;
        let v98 = v95 + v97;
        let v100 = s[10] * -0.0018393787_f32;
        let v101 = v98 + v100;
        let v103 = v101 + -2.0928748_f32;
        [
            ct.clamp(v44, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(v72, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(v103, -1.0_f32, 1.0_f32, 0.0_f32),
        ]
    }
}
