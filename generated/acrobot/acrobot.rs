//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix acrobot --profile constant-time
//! Graph SHA-256: c746bc981049f428c5e9cd92b39b159c476562abde6afb37fa55ace167b590d0
//! 1 teams (1 on the longest walk), 4 edges, 4 programs, 26 distinct operations.
//! Computes in f32 with own maths.
#![forbid(unsafe_code)]
#![allow(
    clippy::all,
    unused_variables,
    unused_assignments,
    reason = "evolved expressions need not make sense"
)]

use tpg_runtime::ops::constant_time::ConstantTime;
use tpg_runtime::policy::{ActionId, Policy};

/// A tangled program graph: branch-free, the same time for every state.
///
/// It sees, one after another:
/// - `s[0..1]`: cos_theta_1, , -1 to 1
/// - `s[1..2]`: sin_theta_1, , -1 to 1
/// - `s[2..3]`: cos_theta_2, , -1 to 1
/// - `s[3..4]`: sin_theta_2, , -1 to 1
/// - `s[4..5]`: omega_1, rad/s, -12.566370964050293 to 12.566370964050293
/// - `s[5..6]`: omega_2, rad/s, -28.274333953857422 to 28.274333953857422
///
/// Values outside the ranges are legal, NaN and infinities too. It answers:
/// - 0: torque -1
/// - 1: torque 0
/// - 2: torque 1
#[derive(Clone, Copy, Debug, Default)]
pub struct Acrobot;

impl Acrobot {
    /// Values of a state.
    pub const STATE: usize = 6;
    /// Actions.
    pub const ACTIONS: usize = 3;
    /// Teams on the longest walk.
    pub const DEPTH: usize = 1;
    /// Bids that one decision looks at, at most.
    pub const WORST_BIDS: usize = 4;
    /// Operations of one decision, at most.
    pub const WORST_OPERATIONS: usize = 26;
    /// Sines, cosines, logarithms and exponentials among them, at most.
    pub const WORST_MATHS_CALLS: usize = 0;
}

impl Policy for Acrobot {
    type State = [f32; 6];
    type Action = ActionId;

    fn decide(&self, s: &[f32; 6]) -> ActionId {
        let ct = ConstantTime::<f32>::default();
        let v3 = s[0] * -2.7205236_f32;
        let v6 = s[3] * -1.2175102_f32;
        let v7 = v3 + v6;
        let v10 = s[4] * -0.49445456_f32;
        let v11 = v7 + v10;
        let v14 = s[5] * 0.22029561_f32;
        let v15 = v11 + v14;
        let v17 = v15 + 2.3143518_f32;
        let v19 = s[0] * -3.3904653_f32;
        let v22 = s[1] * -0.12505245_f32;
        let v23 = v19 + v22;
        let v26 = s[2] * 0.27461419_f32;
        let v27 = v23 + v26;
        let v29 = s[4] * -0.4058117_f32;
        let v30 = v27 + v29;
        let v32 = v30 / 2.6443782_f32;
        let v34 = s[0] * -2.6076918_f32;
        let v36 = s[5] * -0.080515005_f32;
        let v37 = v34 + v36;
        let v39 = s[3] * -1.831776_f32;
        let v40 = v37 + v39;
        let v42 = s[2] * 0.10326636_f32;
        let v43 = v40 + v42;
        let v45 = s[1] * 2.957902_f32;
        let v46 = v43 + v45;
        let v48 = v46 + -0.69571906_f32;

        // What is bid, as integers in the same order.
        let k2 = -8388607_i32; // 0.0_f32
        let k17 = ct.order(v17);
        let k32 = ct.order(v32);
        let k48 = ct.order(v48);

        // Where the team leads: the number behind the best bid.
        // Team 0
        let best = (k17, 2);
        let best = ct.challenge(best, (k32, 2));
        let best = ct.challenge(best, (k2, 0));
        let best = ct.challenge(best, (k48, 0));

        ActionId(best.1 as u16)
    }
}
