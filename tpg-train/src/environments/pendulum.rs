//! A classic control task: swing a pendulum up with too weak a motor, and keep it up.

use crate::engine::{Ending, Environment, SourceSet};
use crate::random::Stream;
use core::f64::consts::{PI, TAU};
use tpg_graph::{ActionDocument, SourceDocument};
use tpg_runtime::policy::ActionId;
use tpg_runtime::scalar::Scalar;

/// Torques of the actions, N·m: weaker than gravity, which pulls with 9.81 N·m at the horizontal.
const TORQUES: [f64; 5] = [-4.0, -1.0, 0.0, 1.0, 4.0];
/// Seconds of one action.
const STEP: f64 = 0.05;
/// Greatest angular velocity, rad/s.
const FASTEST: f64 = 8.0;

/// A rod of 1 m with 1 kg at its end, on an axle with a motor.
#[derive(Clone, Copy, Debug)]
pub struct Pendulum {
    actions: u32,
}

impl Pendulum {
    /// Episodes of that many actions; the last quarter counts.
    pub fn new(actions: u32) -> Self {
        Self { actions }
    }

    fn hold(self) -> u32 {
        self.actions.div_ceil(4)
    }
}

/// A swing under way.
#[derive(Clone, Copy, Debug)]
pub struct Swing {
    /// From upright, rad, in −π..π.
    angle: f64,
    velocity: f64,
    actions: u32,
    /// Sum of |angle| over the actions that count.
    off: f64,
}

impl<S: Scalar> Environment<S> for Pendulum {
    /// Angle and velocity at the start.
    type Task = [f64; 2];
    type Episode = Swing;

    fn sources(&self) -> Vec<SourceDocument> {
        vec![SourceDocument {
            name: "pendulum".to_owned(),
            length: 2,
            unit: "rad, rad/s".to_owned(),
            ranges: vec![[-PI, PI], [-FASTEST, FASTEST]],
        }]
    }

    fn actions(&self) -> Vec<ActionDocument> {
        let name = |torque: f64| format!("torque_{}{torque}", if torque < 0.0 { "" } else { "+" });
        (0..).zip(TORQUES).map(|(id, torque)| ActionDocument { id, name: name(torque), effect: None }).collect()
    }

    fn outcomes(&self) -> &'static [&'static str] {
        &["upright", "fallen"]
    }

    fn time_limit(&self) -> u32 {
        self.actions
    }

    fn draw(&self, stream: &mut Stream) -> [f64; 2] {
        [TAU * (stream.unit() - 0.5), 2.0 * stream.unit() - 1.0]
    }

    fn start(&self, &[angle, velocity]: &[f64; 2]) -> Swing {
        Swing { angle, velocity, actions: 0, off: 0.0 }
    }

    fn observe(&self, swing: &mut Swing, _wanted: SourceSet, state: &mut [S]) {
        for (slot, value) in state.iter_mut().zip([swing.angle, swing.velocity]) {
            *slot = S::from_f64(value);
        }
    }

    fn step(&self, swing: &mut Swing, action: ActionId) -> Option<Ending> {
        let torque = TORQUES.get(usize::from(action.0)).copied().unwrap_or(0.0);
        // The crate libm, not the system's: the same swing on every machine.
        swing.velocity += STEP * (9.81 * libm::sin(swing.angle) + torque);
        swing.velocity = swing.velocity.clamp(-FASTEST, FASTEST);
        swing.angle = libm::remainder(swing.angle + STEP * swing.velocity, TAU).clamp(-PI, PI);
        swing.actions += 1;
        if swing.actions > self.actions - self.hold() {
            swing.off += swing.angle.abs();
        }
        (swing.actions == self.actions).then(|| {
            let error = swing.off / f64::from(self.hold());
            let success = error < 0.2;
            Ending { outcome: u8::from(!success), success, score: -error, error, actions: self.actions }
        })
    }
}
