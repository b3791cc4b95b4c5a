//! A policy for BipedalWalker-v3 of Gymnasium, score 323.31 in validation, trained by tpg-train 0.1.0 with seed 1.
//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix bipedal_walker --profile constant-time
//! Graph SHA-256: 930bc482e9b2dac7e8b66894e062e74b70c9fa9eb26564bd3db1278638a9bb94
//! 1 team, 1 edge, 1 program, 192 distinct operations.
//! A decision takes at most 192 operations.
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
/// - `s[0..1]`: hull_angle, -3.1415927 to 3.1415927
/// - `s[1..2]`: hull_spin, -5 to 5
/// - `s[2..3]`: vx, -5 to 5
/// - `s[3..4]`: vy, -5 to 5
/// - `s[4..5]`: hip_1_angle, -3.1415927 to 3.1415927
/// - `s[5..6]`: hip_1_speed, -5 to 5
/// - `s[6..7]`: knee_1_angle, -3.1415927 to 3.1415927
/// - `s[7..8]`: knee_1_speed, -5 to 5
/// - `s[8..9]`: contact_1, 0 to 5
/// - `s[9..10]`: hip_2_angle, -3.1415927 to 3.1415927
/// - `s[10..11]`: hip_2_speed, -5 to 5
/// - `s[11..12]`: knee_2_angle, -3.1415927 to 3.1415927
/// - `s[12..13]`: knee_2_speed, -5 to 5
/// - `s[13..14]`: contact_2, 0 to 5
/// - `s[14..15]`: lidar_0, -1 to 1
/// - `s[15..16]`: lidar_1, -1 to 1
/// - `s[16..17]`: lidar_2, -1 to 1
/// - `s[17..18]`: lidar_3, -1 to 1
/// - `s[18..19]`: lidar_4, -1 to 1
/// - `s[19..20]`: lidar_5, -1 to 1
/// - `s[20..21]`: lidar_6, -1 to 1
/// - `s[21..22]`: lidar_7, -1 to 1
/// - `s[22..23]`: lidar_8, -1 to 1
/// - `s[23..24]`: lidar_9, -1 to 1
///
/// Values outside the ranges are legal, NaN and infinities too. It answers:
/// - `[0]`: hip_1, -1 to 1; 0 for NaN
/// - `[1]`: knee_1, -1 to 1; 0 for NaN
/// - `[2]`: hip_2, -1 to 1; 0 for NaN
/// - `[3]`: knee_2, -1 to 1; 0 for NaN
#[derive(Clone, Copy, Debug, Default)]
pub struct BipedalWalker;

impl BipedalWalker {
    /// Values of a state.
    pub const STATE: usize = 24;
    /// Outputs.
    pub const OUTPUTS: usize = 4;
    /// Teams on the longest walk.
    pub const DEPTH: usize = 1;
}

impl Policy for BipedalWalker {
    type State = [f32; 24];
    type Action = [f32; 4];

    fn decide(&self, s: &[f32; 24]) -> [f32; 4] {
        let ct = ConstantTime::<f32>::default();
        let term = 0.43313652_f32 * s[0] + 0.006045125_f32 * s[1] - 0.9406402_f32 * s[2]
            + 1.1379249_f32 * s[3]
            - 0.27293232_f32 * s[4]
            - 1.2722539_f32 * s[5]
            + 0.99190795_f32 * s[6]
            - 0.46254736_f32 * s[7]
            - 0.36908358_f32 * s[8];
        let term_2 = term + 0.42084303_f32 * s[9] + 0.23321724_f32 * s[10] - 0.11389011_f32 * s[11]
            + 0.43208057_f32 * s[12]
            - 0.010095447_f32 * s[13]
            + 4.4875813_f32 * s[14]
            - 9.051807_f32 * s[15]
            - 1.3506355_f32 * s[16];
        let hip_1 = term_2 + 8.500628_f32 * s[17] - 6.9748583_f32 * s[18] - 0.7869225_f32 * s[19]
            + 7.8863435_f32 * s[20]
            - 3.1613417_f32 * s[21]
            + 0.09573793_f32 * s[22]
            - 6.447783_f32 * s[23]
            + 5.9709144_f32;
        let term_3 = -0.6784458_f32 * s[0] + 2.167693_f32 * s[1] + 3.1354392_f32 * s[2]
            - 5.378494_f32 * s[3]
            - 0.7907029_f32 * s[4]
            + 0.15056907_f32 * s[5]
            - 2.3365674_f32 * s[6]
            - 0.04153449_f32 * s[7]
            + 0.29449865_f32 * s[8];
        let term_4 = term_3
            + 0.37659582_f32 * s[9]
            + 0.058632873_f32 * s[10]
            + 2.3247058_f32 * s[11]
            + 0.3777262_f32 * s[12]
            - 0.011592703_f32 * s[13]
            + 10.344545_f32 * s[14]
            - 7.4077225_f32 * s[15]
            + 2.2106109_f32 * s[16];
        let knee_1 = term_4 - 9.954698_f32 * s[17] - 1.1742669_f32 * s[18] - 8.619116_f32 * s[19]
            + 1.6254114_f32 * s[20]
            + 1.084647_f32 * s[21]
            - 0.3101107_f32 * s[22]
            + 18.147518_f32 * s[23]
            - 13.862106_f32;
        let term_5 = 2.1542137_f32 * s[0] - 2.1436977_f32 * s[1] + 1.353505_f32 * s[2]
            - 1.4395895_f32 * s[3]
            + 1.4794261_f32 * s[4]
            + 0.19376321_f32 * s[5]
            + 0.22323757_f32 * s[6]
            + 0.19982354_f32 * s[7]
            + 0.14311513_f32 * s[8];
        let term_6 = term_5 - 0.81286705_f32 * s[9] - 0.44202605_f32 * s[10]
            + 0.28939056_f32 * s[11]
            + 0.08988224_f32 * s[12]
            - 0.035194054_f32 * s[13]
            - 1.4962751_f32 * s[14]
            - 2.571821_f32 * s[15]
            + 7.4698043_f32 * s[16];
        let hip_2 = term_6 - 4.813802_f32 * s[17]
            + 0.45718148_f32 * s[18]
            + 8.570346_f32 * s[19]
            + 0.043355696_f32 * s[20]
            - 1.7338103_f32 * s[21]
            - 0.52388465_f32 * s[22]
            + 1.151409_f32 * s[23]
            - 2.5815685_f32;
        let term_7 = -1.0676469_f32 * s[0]
            - 1.2909809_f32 * s[1]
            - 0.8371953_f32 * s[2]
            - 2.8452365_f32 * s[3]
            + 0.021685855_f32 * s[4]
            - 0.06468743_f32 * s[5]
            - 0.13105504_f32 * s[6]
            + 0.0043608746_f32 * s[7]
            - 0.018771987_f32 * s[8];
        let term_8 = term_7 + 0.17987023_f32 * s[9]
            - 0.24441965_f32 * s[10]
            - 1.5290816_f32 * s[11]
            - 0.3734259_f32 * s[12]
            - 0.023268756_f32 * s[13]
            + 0.32405788_f32 * s[14]
            + 5.7792134_f32 * s[15]
            - 7.545338_f32 * s[16];
        let knee_2 = term_8 + 1.5639713_f32 * s[17] - 4.1553626_f32 * s[18] + 4.670011_f32 * s[19]
            - 5.031331_f32 * s[20]
            + 2.1768126_f32 * s[21]
            - 0.6732741_f32 * s[22]
            - 8.497251_f32 * s[23]
            + 9.79428_f32;
        [
            ct.clamp(hip_1, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(knee_1, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(hip_2, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(knee_2, -1.0_f32, 1.0_f32, 0.0_f32),
        ]
    }
}
