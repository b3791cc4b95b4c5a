//! A policy for Swimmer-v5 of Gymnasium, score 358.95 in validation, trained by tpg-train 0.1.0 with seed 4.
//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix swimmer --profile constant-time
//! Graph SHA-256: 5f637141a7dc44d91b53d43bb274cbcfc9c048366af102d518443668c2fcf5ea
//! 1 team, 1 edge, 1 program, 28 distinct operations.
//! A decision takes at most 28 operations.
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
/// - `s[0..1]`: angle, -1.1418219 to 1.1901517
/// - `s[1..2]`: angle_1, -1.4240355 to 1.4747826
/// - `s[2..3]`: angle_2, -1.4165218 to 1.3934784
/// - `s[3..4]`: vx, -0.95189816 to 1.731387
/// - `s[4..5]`: vy, -3.4369788 to 3.4301186
/// - `s[5..6]`: spin, -3.7419472 to 3.7548954
/// - `s[6..7]`: speed_1, -5.163806 to 5.125205
/// - `s[7..8]`: speed_2, -8.226473 to 7.8422647
///
/// Values outside the ranges are legal, NaN and infinities too. It answers:
/// - `[0]`: rotor_1, -1 to 1; 0 for NaN
/// - `[1]`: rotor_2, -1 to 1; 0 for NaN
#[derive(Clone, Copy, Debug, Default)]
pub struct Swimmer;

impl Swimmer {
    /// Values of a state.
    pub const STATE: usize = 8;
    /// Outputs.
    pub const OUTPUTS: usize = 2;
    /// Teams on the longest walk.
    pub const DEPTH: usize = 1;
}

impl Policy for Swimmer {
    type State = [f32; 8];
    type Action = [f32; 2];

    fn decide(&self, s: &[f32; 8]) -> [f32; 2] {
        let ct = ConstantTime::<f32>::default();
        let rotor_1 = 0.7118727_f32 * s[0] - 0.11251226_f32 * s[1] - 0.69512516_f32 * s[2]
            + 0.3123265_f32 * s[4]
            - 0.27881774_f32 * s[5]
            + 0.183991_f32 * s[6]
            - 0.12982675_f32 * s[7]
            - 0.023436766_f32;
        let rotor_2 = 0.26692712_f32 * s[1] - 0.65130556_f32 * s[2] - 0.31501192_f32 * s[3]
            + 0.26088122_f32 * s[4]
            - 0.35128272_f32 * s[5]
            + 0.2057382_f32 * s[6]
            + 0.08384997_f32 * s[7]
            + 0.08995213_f32;
        [
            ct.clamp(rotor_1, -1.0_f32, 1.0_f32, 0.0_f32),
            ct.clamp(rotor_2, -1.0_f32, 1.0_f32, 0.0_f32),
        ]
    }
}
