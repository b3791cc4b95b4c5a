//! Gymnasium's Pendulum-v1: swing a pendulum up with a motor that is too weak to lift it directly, and keep it up.

use crate::circle::sincos;
use crate::eights::{ByEight, by_eight};
use crate::physics::physics;
use crate::source;
use crate::varied::{Disturbance, Varied};
use core::f64::consts::{PI, TAU};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tpg_engine::random::Stream;
use tpg_engine::{ActionSpace, Environment, Output};
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
pub struct PendulumConfig {
    /// Number of evenly spaced torques from −2 to 2 N·m, as named actions; by default a graph computes the torque.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub levels: Option<u16>,
    /// The constants of the rules.
    pub physics: Amounts,
    /// Delays, noise and hidden sources.
    pub disturbance: Disturbance,
}

impl PendulumConfig {
    /// Puts the pendulum under these settings.
    pub(crate) fn environment(&self) -> Varied<Pendulum, Amounts> {
        Varied::new(Pendulum, self.physics, self.disturbance.clone())
    }
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

/// A running episode: angle from upright, rad, not wrapped; angular velocity, rad/s; sine and cosine of the angle, which an
/// observation and a step read.
type Swing = [f64; 4];

fn swing([angle, velocity]: [f64; 2]) -> Swing {
    // The crate libm instead of the platform's: the same results on every machine.
    let (sine, cosine) = libm::sincos(angle);
    [angle, velocity, sine, cosine]
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

    fn start(&self, task: &[f64; 2]) -> Swing {
        swing(*task)
    }

    fn task_from(&self, &[angle, velocity, ..]: &Swing) -> Option<[f64; 2]> {
        Some([angle, velocity])
    }

    by_eight!(4);
}

impl ByEight<4> for Pendulum {
    type Physics = Physics;
    const STANDARD: Physics = Physics::STANDARD;
    const OBSERVED: &[usize] = &[3, 2, 1];
    const ROUNDS: bool = false;

    #[inline(always)]
    fn step_many<const L: usize>(
        physics: &Physics,
        numbers: &mut [[f64; L]; 4],
        torques: &[f64; L],
        rewards: &mut [f64; L],
        _ended: &mut [bool; L],
    ) {
        let [angle, velocity, sine, cosine] = numbers;
        let mut off = [0.0; L];
        wrap(angle, &mut off);
        let moments = angle.iter_mut().zip(velocity).zip(&*sine).zip(off).zip(torques).zip(rewards);
        for (((((angle, velocity), &sine), off), &torque), reward) in moments {
            let cost;
            (cost, *angle, *velocity) = moved(physics, (*angle, *velocity, sine), off, torque as f32);
            *reward = -cost;
        }
        [*sine, *cosine] = sincos(angle);
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

/// A turn in two parts: times a whole number below 2048, each is exact.
const TAU_HIGH: f64 = f64::from_bits(TAU.to_bits() & !0x7ff);
const TAU_LOW: f64 = TAU - TAU_HIGH;

/// Writes what [`wrapped`] makes of each angle.
///
/// Below 2048 the remainder is exact: whole turns are taken off in two parts, both differences are multiples of 2⁻⁵⁰ below 8,
/// and where the quotient was rounded up to a whole number, the turn too many is put back.
#[inline(always)]
fn wrap<const L: usize>(angles: &[f64; L], off: &mut [f64; L]) {
    let mut any_is_far = false;
    for (off, &angle) in off.iter_mut().zip(angles) {
        let turned = angle + PI;
        any_is_far |= (turned.abs() >= 2048.0) | turned.is_nan();
        let turns = (turned / TAU).trunc();
        let rest = (turned - turns * TAU_HIGH) - turns * TAU_LOW;
        *off = if rest < 0.0 { rest + TAU } else { rest } - PI;
    }
    if any_is_far {
        off.iter_mut().zip(angles).for_each(|(off, &angle)| *off = wrapped(angle));
    }
}

/// Wraps the angle to −π..π, with every bit of NumPy's remainder.
fn wrapped(angle: f64) -> f64 {
    (angle + PI).rem_euclid(TAU) - PI
}

#[cfg(test)]
mod tests {
    use super::{Pendulum, Swing, swing, wrap, wrapped};
    use crate::tests::lanes::{policy, same_as_one_by_one};
    use core::f64::consts::PI;
    use tpg_engine::{Act, Environment, Operand, SourceSet};
    use tpg_runtime::ops::Instruction;

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
        let mut moving = swing([0.5, -1.0]);
        let reward = step(&mut moving, 1.5);
        // The torque's part is an f32.
        assert!((reward + (0.25 + 0.1 + 0.001 * 2.25)).abs() < 1e-9);
        let velocity = -1.0 + (15.0 * 0.5f64.sin() + 4.5) * 0.05;
        assert!((moving[1] - velocity).abs() < 1e-12 && (moving[0] - (0.5 + 0.05 * velocity)).abs() < 1e-12);
        // Torques beyond the limit are clamped, in motion and in cost.
        let (mut a, mut b) = (moving, moving);
        assert_eq!((step(&mut a, 9.0), a), (step(&mut b, 2.0), b));
        // No velocity beyond 8 rad/s.
        let mut fast = swing([PI / 2.0, 7.9]);
        step(&mut fast, 2.0);
        assert_eq!(fast[1], 8.0);
    }

    /// Small angles, where the functions take short cuts, and large ones, where they reduce the angle.
    #[test]
    fn sine_and_cosine_together_are_those_of_either_function() {
        let exponents = (-60..=12).map(|exponent| f64::from(exponent).exp2());
        let angles = exponents.flat_map(|scale| (0..2000).map(move |step| scale * (1.0 + f64::from(step) / 2000.0)));
        for angle in angles.flat_map(|angle| [angle, -angle]) {
            let [.., sine, cosine] = swing([angle, 0.0]);
            let bits = [sine, cosine].map(f64::to_bits);
            assert_eq!(bits, [libm::sin(angle), libm::cos(angle)].map(f64::to_bits), "{angle}");
        }
    }

    #[test]
    fn the_state_is_gymnasiums_observation() {
        let mut state = [0f32; 3];
        let mut moving = swing([PI / 2.0, -3.0]);
        Environment::<f32>::observe(&Pendulum, &mut moving, SourceSet::ALL, &mut state);
        assert!(state[0].abs() < 1e-7 && state[1] == 1.0 && state[2] == -3.0);
    }

    #[test]
    fn eight_angles_are_wrapped_as_one() {
        let turns = (-400..400).map(|turn| f64::from(turn) * PI);
        let near = |angle: f64| (0..50).map(move |bit| f64::from_bits(angle.to_bits() ^ 1 << bit));
        let angles: Vec<f64> = turns.flat_map(near).chain((-9000..9000).map(|step| f64::from(step) * 0.37)).collect();
        for eight in angles.as_chunks::<8>().0 {
            let mut off = [0.0; 8];
            wrap(eight, &mut off);
            assert_eq!(off.map(f64::to_bits), eight.map(|angle| wrapped(angle).to_bits()), "{eight:?}");
        }
    }

    #[test]
    fn eight_at_once_swing_as_one() {
        let [cosine, sine, velocity] = [0, 1, 2].map(Operand::Input);
        // The first goes round and round.
        same_as_one_by_one(Pendulum, &policy(Instruction::Add, [velocity, Operand::Constant(2.0)], 0));
        same_as_one_by_one(Pendulum, &policy(Instruction::Sub, [sine, velocity], 0));
        same_as_one_by_one(Pendulum, &policy(Instruction::Mul, [cosine, velocity], 0));
    }
}
