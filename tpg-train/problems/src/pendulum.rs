//! Gymnasium's Pendulum-v1: swing a pendulum up with a motor that is too weak to lift it directly, and keep it up.

mod lanes;

use crate::eights::Eights;
use crate::physics::physics;
use crate::source;
use crate::varied::{Adjustable, Disturbance};
use core::f64::consts::{PI, TAU};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tpg_engine::random::Stream;
use tpg_engine::{Act, ActionSpace, Environment, Episodes, Output, SourceSet, Step, Training};
use tpg_graph::SourceDocument;
use tpg_runtime::scalar::Scalar;

/// Maximum torque, N·m.
const TORQUE: f64 = 2.0;
/// Maximum angular velocity, rad/s.
const FASTEST: f64 = 8.0;
/// Seconds of one action.
const STEP: f64 = 0.05;
/// Actions of an episode.
const ACTIONS: u32 = 200;

physics! {
    /// Acceleration of gravity, m/s².
    gravity = 10.0, [0.0, 100.0];
    /// Mass of the rod, kg.
    mass = 1.0, [0.001, 1000.0];
    /// Length of the rod, m.
    length = 1.0, [0.01, 100.0];
    /// Friction of the axle, N·m for each rad/s.
    friction = 0.0, [0.0, 1000.0];
}

/// The section `[problem]` of a configuration for the pendulum.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Config {
    /// Number of evenly spaced torques from −2 to 2 N·m, as named actions; by default a graph computes the torque.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub levels: Option<u16>,
    /// The constants of the rules.
    pub physics: Amounts,
    /// Delays, noise and hidden sources.
    pub disturbance: Disturbance,
}

/// A rod of 1 m and 1 kg on an axle with a motor, by the rules of Gymnasium's Pendulum-v1.
///
/// The state is cosine and sine of the angle from upright, and the angular velocity in rad/s; the action is a torque of −2
/// to 2 N·m; the reward is −(angle² + 0.1 velocity² + 0.001 torque²), before the action; an episode has 200 actions.
///
/// ```
/// use tpg_engine::{Act, Environment};
/// use tpg_problems::Pendulum;
///
/// // Hanging down at rest: as far from upright as it can be.
/// let mut swing = Environment::<f32>::start(&Pendulum, &[std::f64::consts::PI, 0.0]);
/// let step = Environment::<f32>::step(&Pendulum, &mut swing, Act::Values(&[0.0]));
/// assert!((step.reward + std::f64::consts::PI.powi(2)).abs() < 1e-9);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Pendulum;

/// A running episode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Swing {
    /// Angle from upright, rad; not wrapped.
    pub(crate) angle: f64,
    /// Angular velocity, rad/s.
    pub(crate) velocity: f64,
    /// Sine of the angle: an observation and a step read it.
    sine: f64,
    /// Cosine of the angle, from the same reduction of the angle.
    cosine: f64,
}

impl Swing {
    pub(crate) fn new(angle: f64, velocity: f64) -> Self {
        // The crate libm instead of the platform's: the same results on every machine.
        let (sine, cosine) = libm::sincos(angle);
        Self { angle, velocity, sine, cosine }
    }
}

impl<S: Scalar> Environment<S> for Pendulum {
    /// Angle from upright, rad, and angular velocity, rad/s.
    type Task = [f64; 2];
    type Episode = Swing;

    fn sources(&self) -> Vec<SourceDocument> {
        vec![
            source("cos_theta", "", [-1.0, 1.0]),
            source("sin_theta", "", [-1.0, 1.0]),
            source("omega", "rad/s", [-FASTEST, FASTEST]),
        ]
    }

    fn actions(&self) -> ActionSpace {
        let (name, unit) = ("torque".to_owned(), "N·m".to_owned());
        ActionSpace::Box(vec![Output { name, unit, min: -TORQUE, max: TORQUE }])
    }

    fn outcomes(&self) -> &'static [&'static str] {
        &["time limit"]
    }

    fn time_limit(&self) -> u32 {
        ACTIONS
    }

    fn draw(&self, stream: &mut Stream) -> [f64; 2] {
        [TAU * stream.unit() - PI, 2.0 * stream.unit() - 1.0]
    }

    fn start(&self, &[angle, velocity]: &[f64; 2]) -> Swing {
        Swing::new(angle, velocity)
    }

    fn training(&self) -> Option<&dyn Training<[f64; 2], Swing>> {
        Some(self)
    }

    fn observe(&self, swing: &mut Swing, _wanted: SourceSet, state: &mut [S]) {
        state.copy_from_slice(&[swing.cosine, swing.sine, swing.velocity].map(S::from_f64));
    }

    fn step(&self, swing: &mut Swing, act: Act<'_, S>) -> Step {
        self.step_under(&Physics::STANDARD, swing, act)
    }

    fn lanes(&self) -> Box<dyn Episodes<S, [f64; 2]> + '_> {
        Box::new(Eights::new::<S>(self))
    }
}

impl Training<[f64; 2], Swing> for Pendulum {
    fn task_from(&self, swing: &Swing) -> Option<[f64; 2]> {
        Some([swing.angle, swing.velocity])
    }
}

impl<S: Scalar> Adjustable<S> for Pendulum {
    type Physics = Physics;

    const REST: u16 = 0;

    #[inline]
    fn step_under(&self, physics: &Physics, swing: &mut Swing, act: Act<'_, S>) -> Step {
        let Swing { angle, velocity, sine, .. } = *swing;
        let torque = act.values()[0].to_f64() as f32;
        let (cost, angle, velocity) = moved(physics, (angle, velocity, sine), wrapped(angle), torque);
        *swing = Swing::new(angle, velocity);
        Step::reward(-cost)
    }
}

/// Returns the cost of a moment, given by angle, velocity and sine, and the next angle and velocity; `off` is the angle, wrapped.
#[inline(always)]
fn moved(physics: &Physics, (angle, velocity, sine): (f64, f64, f64), off: f64, torque: f32) -> (f64, f64, f64) {
    let Physics { gravity, mass, length, friction } = *physics;
    // A torque is an f32, and NumPy multiplies an f32 in f32.
    let torque = torque.clamp(-TORQUE as f32, TORQUE as f32);
    let cost = off * off + 0.1 * (velocity * velocity) + f64::from(0.001 * (torque * torque));
    let eased = 3.0 / (mass * (length * length));
    let pushed = f64::from(eased as f32 * torque) - eased * friction * velocity;
    let faster = velocity + (3.0 * gravity / (2.0 * length) * sine + pushed) * STEP;
    let velocity = faster.clamp(-FASTEST, FASTEST);
    (cost, angle + velocity * STEP, velocity)
}

/// Wraps the angle to −π..π, with every bit of NumPy's remainder.
fn wrapped(angle: f64) -> f64 {
    let turned = angle + PI;
    // A remainder is slow; within one turn it is exact without one.
    let rest = if (0.0..TAU).contains(&turned) { turned } else { turned.rem_euclid(TAU) };
    rest - PI
}

#[cfg(test)]
mod tests {
    use super::{Pendulum, Swing, wrapped};
    use core::f64::consts::PI;
    use tpg_engine::{Act, Environment, SourceSet};

    fn step(swing: &mut Swing, torque: f64) -> f64 {
        Environment::<f64>::step(&Pendulum, swing, Act::Values(&[torque])).reward
    }

    #[test]
    fn angles_are_wrapped_into_half_a_turn_each_way() {
        for (angle, expected) in
            [(0.5, 0.5), (PI + 0.25, 0.25 - PI), (-PI - 0.25, PI - 0.25), (7.0 * PI + 0.1, 0.1 - PI)]
        {
            assert!((wrapped(angle) - expected).abs() < 1e-12, "{angle}");
        }
    }

    /// Checks three steps of Pendulum-v1, computed by hand from its published rules.
    #[test]
    fn the_rules_are_gymnasiums() {
        let mut swing = Swing::new(0.5, -1.0);
        let reward = step(&mut swing, 1.5);
        // The torque's part is an f32.
        assert!((reward + (0.25 + 0.1 + 0.001 * 2.25)).abs() < 1e-9);
        let velocity = -1.0 + (15.0 * 0.5f64.sin() + 4.5) * 0.05;
        assert!((swing.velocity - velocity).abs() < 1e-12 && (swing.angle - (0.5 + 0.05 * velocity)).abs() < 1e-12);
        // Torques beyond the limit are clamped, in motion and in cost.
        let (mut a, mut b) = (swing, swing);
        assert_eq!((step(&mut a, 9.0), a), (step(&mut b, 2.0), b));
        // No velocity beyond 8 rad/s.
        let mut fast = Swing::new(PI / 2.0, 7.9);
        step(&mut fast, 2.0);
        assert_eq!(fast.velocity, 8.0);
    }

    /// Small angles, where the functions take short cuts, and large ones, where they reduce the angle.
    #[test]
    fn sine_and_cosine_together_are_those_of_either_function() {
        let exponents = (-60..=12).map(|exponent| f64::from(exponent).exp2());
        let angles = exponents.flat_map(|scale| (0..2000).map(move |step| scale * (1.0 + f64::from(step) / 2000.0)));
        for angle in angles.flat_map(|angle| [angle, -angle]) {
            let swing = Swing::new(angle, 0.0);
            let bits = [swing.sine, swing.cosine].map(f64::to_bits);
            assert_eq!(bits, [libm::sin(angle), libm::cos(angle)].map(f64::to_bits), "{angle}");
        }
    }

    #[test]
    fn the_state_is_gymnasiums_observation() {
        let mut state = [0f32; 3];
        let mut swing = Swing::new(PI / 2.0, -3.0);
        Environment::<f32>::observe(&Pendulum, &mut swing, SourceSet::ALL, &mut state);
        assert!(state[0].abs() < 1e-7 && state[1] == 1.0 && state[2] == -3.0);
    }
}
