//! Gymnasium's CartPole-v1: balance a pole on a cart that is pushed to the left or to the right.

use crate::circle::sincos;
use crate::eights::{ByEight, by_eight};
use crate::physics::physics;
use crate::source;
use core::f64::consts::PI;
use tpg_engine::random::Stream;
use tpg_engine::{ActionSpace, Environment};
use tpg_graph::SourceDocument;
use tpg_runtime::scalar::Scalar;

/// Seconds of one action.
const STEP: f64 = 0.02;
/// The episode ends when the cart is further from the middle than this, m.
const FAR: f64 = 2.4;
/// The episode ends when the pole leans more than this, rad: 12°.
const LEANING: f64 = 12.0 * 2.0 * PI / 360.0;
/// Actions of an episode.
const ACTIONS: u32 = 500;

physics! {
    /// Acceleration of gravity, m/s².
    gravity = 9.8, [0.0, 100.0];
    /// Mass of the cart, kg.
    cart_mass = 1.0, [0.001, 1000.0];
    /// Mass of the pole, kg.
    pole_mass = 0.1, [0.001, 1000.0];
    /// Half the pole's length, m.
    length = 0.5, [0.01, 100.0];
    /// The push of an action, N.
    force = 10.0, [0.0, 1000.0];
    /// Friction of the cart, N for each m/s.
    cart_friction = 0.0, [0.0, 1000.0];
    /// Friction of the pole's axle, N·m for each rad/s.
    pole_friction = 0.0, [0.0, 1000.0];
}

/// A pole on a cart, by the rules of Gymnasium's CartPole-v1.
///
/// The state is the cart's position (m) and velocity (m/s), and the pole's angle from upright (rad) and angular
/// velocity (rad/s). Every action earns 1; the episode ends when the pole leans by more than 12° or the cart leaves
/// ±2.4 m, and after 500 actions at the latest.
///
/// ```
/// use tpg_engine::Environment;
/// use tpg_problems::CartPole;
///
/// assert_eq!(Environment::<f32>::time_limit(&CartPole), 500);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct CartPole;

/// Position, velocity, angle and angular velocity.
type State = [f64; 4];

impl<S: Scalar> Environment<S> for CartPole {
    type Task = State;
    type Episode = State;

    fn sources(&self) -> Vec<SourceDocument> {
        let unknown = [f64::NEG_INFINITY, f64::INFINITY];
        vec![
            source("x", "m", [-2.0 * FAR, 2.0 * FAR]),
            source("v", "m/s", unknown),
            source("theta", "rad", [-2.0 * LEANING, 2.0 * LEANING]),
            source("omega", "rad/s", unknown),
        ]
    }

    fn actions(&self) -> ActionSpace {
        ActionSpace::discrete(["left", "right"])
    }

    fn outcomes(&self) -> &'static [&'static str] {
        &["fallen", "time limit"]
    }

    fn time_limit(&self) -> u32 {
        ACTIONS
    }

    fn draw(&self, stream: &mut Stream) -> State {
        std::array::from_fn(|_| 0.1 * stream.unit() - 0.05)
    }

    fn start(&self, task: &State) -> State {
        *task
    }

    fn task_from(&self, state: &State) -> Option<State> {
        Some(*state)
    }

    /// The larger of the pole's lean and the cart's way from the middle, as a fraction of what ends the episode.
    fn distance(&self, [x, _, theta, _]: &State) -> Option<f64> {
        Some((x.abs() / FAR).max(theta.abs() / LEANING))
    }

    by_eight!(4);
}

impl ByEight<4> for CartPole {
    type Physics = Physics;
    const STANDARD: Physics = Physics::STANDARD;
    const OBSERVED: &[usize] = &[0, 1, 2, 3];
    const ROUNDS: bool = false;

    #[inline(always)]
    fn step_many<const L: usize>(
        physics: &Physics,
        states: &mut [[f64; L]; 4],
        acts: &[f64; L],
        rewards: &mut [f64; L],
        ended: &mut [bool; L],
    ) {
        let [sines, cosines] = sincos(&states[2]);
        *rewards = [1.0; L];
        let [xs, vs, thetas, omegas] = states;
        for lane in 0..L {
            let (state, circle) = ([xs[lane], vs[lane], thetas[lane], omegas[lane]], (sines[lane], cosines[lane]));
            let state = moved(physics, state, circle, acts[lane] == 1.0);
            [xs[lane], vs[lane], thetas[lane], omegas[lane]] = state;
            ended[lane] = is_over(&state);
        }
    }
}

/// Returns the state after one action, with sine and cosine of the pole's angle.
#[inline(always)]
fn moved(physics: &Physics, state: State, (sin, cos): (f64, f64), is_right: bool) -> State {
    let Physics { gravity, pole_mass, length, .. } = *physics;
    let total_mass = pole_mass + physics.cart_mass;
    let pole_mass_length = pole_mass * length;
    let [x, v, theta, omega] = state;
    let force = if is_right { physics.force } else { -physics.force } - physics.cart_friction * v;
    let moved = (force + pole_mass_length * (omega * omega) * sin) / total_mass;
    let held = physics.pole_friction * omega / pole_mass_length;
    let turned = (gravity * sin - cos * moved - held) / (length * (4.0 / 3.0 - pole_mass * (cos * cos) / total_mass));
    let pushed = moved - pole_mass_length * turned * cos / total_mass;
    [x + STEP * v, v + STEP * pushed, theta + STEP * omega, omega + STEP * turned]
}

/// True if the cart is too far from the middle or the pole leans too far.
#[inline(always)]
fn is_over(state: &State) -> bool {
    (state[0].abs() > FAR) | (state[2].abs() > LEANING)
}

#[cfg(test)]
mod tests {
    use super::{CartPole, LEANING};
    use crate::tests::lanes::{policy, same_as_one_by_one};
    use tpg_engine::{Act, Environment, Operand};
    use tpg_runtime::ops::Instruction;
    use tpg_runtime::policy::ActionId;

    /// Checks one step of CartPole-v1, computed by hand from its published rules.
    #[test]
    fn the_rules_are_gymnasiums() {
        let mut state = [0.1, -0.2, 0.05, 0.3];
        let step = Environment::<f64>::step(&CartPole, &mut state, Act::Choice(ActionId(1)));
        let temp = (10.0 + 0.05 * 0.09 * 0.05f64.sin()) / 1.1;
        let angular =
            (9.8 * 0.05f64.sin() - 0.05f64.cos() * temp) / (0.5 * (4.0 / 3.0 - 0.1 * 0.05f64.cos().powi(2) / 1.1));
        let linear = temp - 0.05 * angular * 0.05f64.cos() / 1.1;
        let expected = [0.1 - 0.02 * 0.2, -0.2 + 0.02 * linear, 0.05 + 0.02 * 0.3, 0.3 + 0.02 * angular];
        for (found, expected) in state.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-12, "{state:?}");
        }
        assert_eq!((step.reward, step.end), (1.0, None));
    }

    #[test]
    fn a_pole_that_leans_too_far_ends_the_episode_and_still_earns_its_step() {
        let mut state = [0.0, 0.0, LEANING - 0.001, 2.0];
        let step = Environment::<f64>::step(&CartPole, &mut state, Act::Choice(ActionId(0)));
        assert_eq!(step.reward, 1.0);
        assert!(step.end.is_some_and(|end| end.outcome == 0 && !end.truncated));
    }

    #[test]
    fn eight_carts_move_as_one() {
        let [v, theta, omega] = [1, 2, 3].map(Operand::Input);
        let balanced = same_as_one_by_one(CartPole, &policy(Instruction::Add, [theta, omega], 2));
        let fallen = same_as_one_by_one(CartPole, &policy(Instruction::Sub, [v, theta], 2));
        assert!(balanced.iter().any(|ending| ending.outcome == 1) && fallen.iter().all(|ending| ending.outcome == 0));
    }
}
