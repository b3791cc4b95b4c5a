//! A policy for HalfCheetah-v5, score 4739.82 in validation, trained by tpg-train 0.1.0 with seed 1.
//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix half_cheetah --profile constant-time
//! Graph SHA-256: 909066e89f0f3337d020b7a767128fa97ceedc04b0735efd6eaaa64d4265eb6f
//! 1 team, 1 edge, 1 program, 198 distinct operations.
//! A decision takes at most 198 operations.
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
/// - `s[0..1]`: height, -0.34811118 to 0.32100078
/// - `s[1..2]`: pitch, -0.31290776 to 0.8274705
/// - `s[2..3]`: back_thigh_angle, -0.8690334 to 1.0284743
/// - `s[3..4]`: back_shin_angle, -0.8524031 to 0.8351676
/// - `s[4..5]`: back_foot_angle, -0.7908598 to 1.0157791
/// - `s[5..6]`: front_thigh_angle, -1.45669 to 0.910225
/// - `s[6..7]`: front_shin_angle, -0.5692593 to 0.7971728
/// - `s[7..8]`: front_foot_angle, -0.71902794 to 0.48435938
/// - `s[8..9]`: vx, -2.05449 to 8.979934
/// - `s[9..10]`: vz, -2.1145165 to 2.032654
/// - `s[10..11]`: pitch_speed, -7.227758 to 6.8752904
/// - `s[11..12]`: back_thigh_speed, -20.901438 to 24.91285
/// - `s[12..13]`: back_shin_speed, -23.527529 to 19.608913
/// - `s[13..14]`: back_foot_speed, -24.752438 to 24.158678
/// - `s[14..15]`: front_thigh_speed, -29.509106 to 33.256
/// - `s[15..16]`: front_shin_speed, -19.919209 to 13.197348
/// - `s[16..17]`: front_foot_speed, -12.631708 to 15.106824
///
/// Values outside the ranges are legal, NaN and infinities too. It answers:
/// - `[0]`: back_thigh, -1 to 1; 0 for NaN
/// - `[1]`: back_shin, -1 to 1; 0 for NaN
/// - `[2]`: back_foot, -1 to 1; 0 for NaN
/// - `[3]`: front_thigh, -1 to 1; 0 for NaN
/// - `[4]`: front_shin, -1 to 1; 0 for NaN
/// - `[5]`: front_foot, -1 to 1; 0 for NaN
#[derive(Clone, Copy, Debug, Default)]
pub struct HalfCheetah;

impl HalfCheetah {
    /// Values of a state.
    pub const STATE: usize = 17;
    /// Outputs.
    pub const OUTPUTS: usize = 6;
    /// Teams on the longest walk.
    pub const DEPTH: usize = 1;
}

impl Policy for HalfCheetah {
    type State = [f32; 17];
    type Action = [f32; 6];

    fn decide(&self, s: &[f32; 17]) -> [f32; 6] {
        let ct = ConstantTime::<f32>::default();
        let term = 1.4008873_f32 * s[0] + 0.09387724_f32 * s[1]
            - 0.18976228_f32 * s[2]
            - 0.12725973_f32 * s[3]
            - 1.6832566_f32 * s[4]
            + 0.38527772_f32 * s[5]
            + 0.4094602_f32 * s[6]
            + 0.08500024_f32 * s[8]
            - 0.10341745_f32 * s[9];
        let back_thigh = term
            - 0.15919156_f32 * s[10]
            - 0.022208741_f32 * s[11]
            - 0.026848406_f32 * s[12]
            - 0.022946933_f32 * s[13]
            + 0.018442832_f32 * s[14]
            - 0.02791334_f32 * s[15]
            - 0.021624371_f32 * s[16]
            + 0.0508656_f32;
        let term_2 = -1.1853826_f32 * s[0] - 0.3723432_f32 * s[1]
            + 0.042402733_f32 * s[2]
            + 0.33647406_f32 * s[3]
            + 0.1202205_f32 * s[4]
            - 0.12960166_f32 * s[5]
            - 0.043244623_f32 * s[6]
            + 0.40792063_f32 * s[7]
            - 0.0307495_f32 * s[8];
        let term_3 = term_2 - 0.093859464_f32 * s[9] + 0.0531134_f32 * s[10]
            - 0.04513471_f32 * s[11]
            - 0.002819547_f32 * s[12]
            - 0.029158877_f32 * s[13]
            + 0.013162317_f32 * s[14]
            - 0.017216053_f32 * s[15]
            + 0.039490286_f32 * s[16];
        let back_shin = term_3 + 0.054933626_f32;
        let term_4 = 0.12277543_f32 * s[0] + 0.051600974_f32 * s[1] + 1.2118318_f32 * s[2]
            - 0.4268653_f32 * s[3]
            - 0.40210655_f32 * s[4]
            + 0.47833714_f32 * s[5]
            + 0.8851195_f32 * s[6]
            + 0.11428689_f32 * s[7]
            + 0.07447019_f32 * s[8];
        let term_5 = term_4 + 0.4652907_f32 * s[9]
            - 0.01510865_f32 * s[10]
            - 0.012634864_f32 * s[11]
            - 0.004542586_f32 * s[12]
            - 0.010618708_f32 * s[13]
            + 0.023100879_f32 * s[14]
            + 0.022929158_f32 * s[15]
            - 0.016002292_f32 * s[16];
        let back_foot = term_5 - 0.16678137_f32;
        let term_6 = -1.418642_f32 * s[0] + 0.43121094_f32 * s[1] + 0.056831904_f32 * s[2]
            - 0.11759443_f32 * s[3]
            + 0.38178843_f32 * s[4]
            - 0.2822201_f32 * s[5]
            - 0.8116351_f32 * s[6]
            + 0.62498_f32 * s[7]
            - 0.11484541_f32 * s[8];
        let term_7 = term_6 - 0.05127445_f32 * s[9] + 0.14062005_f32 * s[10]
            - 0.012118952_f32 * s[11]
            + 0.009986786_f32 * s[12]
            - 0.038676754_f32 * s[13]
            + 0.0007840264_f32 * s[14]
            + 0.004478204_f32 * s[15]
            + 0.005064627_f32 * s[16];
        let front_thigh = term_7 + 0.0014363579_f32;
        let term_8 = -0.11193159_f32 * s[0] + 0.3165_f32 * s[1] + 0.46301544_f32 * s[2]
            - 0.224833_f32 * s[3]
            + 0.45676583_f32 * s[4]
            - 0.35732824_f32 * s[5]
            + 0.73909867_f32 * s[7]
            + 0.0034187804_f32 * s[8]
            - 0.026946642_f32 * s[9];
        let front_shin = term_8 - 0.008634697_f32 * s[10] - 0.0042703478_f32 * s[11]
            + 0.009634706_f32 * s[12]
            - 0.020781748_f32 * s[13]
            - 0.021359142_f32 * s[14]
            - 0.045049116_f32 * s[15]
            + 0.021782797_f32 * s[16]
            - 0.12608574_f32;
        let term_9 = 0.93854785_f32 * s[0]
            + 0.05506858_f32 * s[1]
            + 0.17329441_f32 * s[3]
            + 0.11109171_f32 * s[4]
            - 0.494372_f32 * s[5]
            + 0.8358307_f32 * s[6]
            + 0.09513146_f32 * s[7]
            - 0.13991123_f32 * s[8]
            + 0.30567983_f32 * s[9];
        let front_foot = term_9 + 0.10073735_f32 * s[10] - 0.01967937_f32 * s[11]
            + 0.045426693_f32 * s[12]
            + 0.0011335313_f32 * s[13]
            + 0.0071149385_f32 * s[14]
            + 0.0075003016_f32 * s[15]
            - 0.049951147_f32 * s[16]
            + 0.5277141_f32;
        [
            ct.clamp(back_thigh, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(back_shin, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(back_foot, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(front_thigh, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(front_shin, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(front_foot, -1.0_f32, 1.0_f32, 0.0_f32),
        ]
    }
}
