//! A policy for HalfCheetah-v5, score 5578.21 in validation, trained by tpg-train 0.1.0 with seed 2.
//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix half_cheetah --profile constant-time
//! Graph SHA-256: 7ef378f3cc5a30791a19fb60e0bce0a2d1d8baa319d08a1c65bdbecc6eddd4bf
//! 1 team, 1 edge, 1 program, 145 distinct operations.
//! A decision takes at most 145 operations.
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
/// - `s[0..1]`: height, -0.2180677 to 0.13543022
/// - `s[1..2]`: pitch, -0.3000606 to 0.21021312
/// - `s[2..3]`: back_thigh_angle, -0.42632464 to 0.9315238
/// - `s[3..4]`: back_shin_angle, -0.97807735 to 1.0510656
/// - `s[4..5]`: back_foot_angle, -0.711283 to 0.893483
/// - `s[5..6]`: front_thigh_angle, -1.4804567 to 0.7836069
/// - `s[6..7]`: front_shin_angle, -0.24051364 to 0.36707708
/// - `s[7..8]`: front_foot_angle, -0.85147554 to 0.9253887
/// - `s[8..9]`: vx, -2.058686 to 9.000914
/// - `s[9..10]`: vz, -1.4764308 to 1.770434
/// - `s[10..11]`: pitch_speed, -6.2114 to 6.08957
/// - `s[11..12]`: back_thigh_speed, -18.8427 to 19.169788
/// - `s[12..13]`: back_shin_speed, -25.648323 to 22.514856
/// - `s[13..14]`: back_foot_speed, -29.572424 to 28.612175
/// - `s[14..15]`: front_thigh_speed, -26.629414 to 29.77206
/// - `s[15..16]`: front_shin_speed, -8.710732 to 8.808882
/// - `s[16..17]`: front_foot_speed, -26.645964 to 26.556257
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
        let term = 0.65299785_f32 * s[0] - 0.30417895_f32 * s[1]
            + 0.08986901_f32 * s[2]
            + 0.1527143_f32 * s[3]
            + 0.10618001_f32 * s[5]
            + 0.2887228_f32 * s[6]
            - 0.042333245_f32 * s[7]
            + 0.030733766_f32 * s[8]
            + 0.3018588_f32 * s[9];
        let back_thigh = term - 0.07872877_f32 * s[10] - 0.065849066_f32 * s[11]
            + 0.00862241_f32 * s[12]
            + 0.02093927_f32 * s[13]
            - 0.035348557_f32 * s[14]
            - 0.032005753_f32 * s[15]
            - 0.0015801959_f32 * s[16]
            + 0.25798228_f32;
        let back_shin = s[14] + 0.024565589_f32;
        let term_2 = -0.6643476_f32 * s[0] + 0.9206936_f32 * s[3] - 0.35221323_f32 * s[4]
            + 0.59571_f32 * s[6]
            - 0.12767485_f32 * s[7]
            - 0.093680136_f32 * s[8]
            + 0.13345654_f32 * s[9]
            - 0.021074038_f32 * s[10]
            + 0.031236362_f32 * s[11];
        let back_foot = term_2 + 0.030699003_f32 * s[13] - 0.03184241_f32 * s[14]
            + 0.011127887_f32 * s[15]
            + 0.021415437_f32 * s[16]
            + 0.0912914_f32;
        let term_3 = -2.4914157_f32 * s[0]
            - 0.42017677_f32 * s[2]
            - 0.4775143_f32 * s[3]
            - 0.15708983_f32 * s[5]
            - 0.91896254_f32 * s[6]
            - 0.8898691_f32 * s[7]
            - 0.025057836_f32 * s[8]
            - 0.24128_f32 * s[9]
            + 0.06779719_f32 * s[10];
        let front_thigh = term_3 + 0.017799746_f32 * s[11]
            - 0.0094479555_f32 * s[12]
            - 0.031343386_f32 * s[13]
            - 0.007135808_f32 * s[14]
            + 0.038320307_f32 * s[15]
            - 0.010964609_f32 * s[16]
            - 0.4173823_f32;
        let term_4 = 0.33716694_f32 * s[0] + 0.32924032_f32 * s[2] - 1.103007_f32 * s[3]
            + 0.716227_f32 * s[4]
            - 0.6825805_f32 * s[5]
            + 1.313297_f32 * s[6]
            - 0.09976387_f32 * s[7]
            - 0.023090838_f32 * s[8]
            + 0.39377627_f32 * s[9];
        let front_shin = term_4 - 0.011995308_f32 * s[10]
            + 0.015915005_f32 * s[11]
            + 0.008061846_f32 * s[12]
            + 0.01730848_f32 * s[14]
            - 0.016408563_f32 * s[15]
            + 0.007713775_f32 * s[16]
            + 0.24237464_f32;
        let term_5 = 1.1094741_f32 * s[0] + 0.0_f32 - 0.1943114_f32 * s[2]
            + 0.30722198_f32 * s[3]
            + 0.13936892_f32 * s[5]
            + 0.31880283_f32 * s[6]
            - 0.7904248_f32 * s[7]
            + 0.09822248_f32 * s[8]
            - 0.16976257_f32 * s[9];
        let front_foot = term_5 - 0.034448557_f32 * s[10]
            + 0.018111259_f32 * s[12]
            + 0.0048697935_f32 * s[13]
            + 0.021317588_f32 * s[14]
            + 0.014080553_f32 * s[16];
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
