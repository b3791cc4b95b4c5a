//! Gymnasium's Acrobot-v1: swing two links up by a motor at the joint between them.

use crate::physics::physics;
use crate::source;
use crate::varied::{Adjustable, Settings};
use core::f64::consts::PI;
use tpg_engine::random::Stream;
use tpg_engine::{Act, ActionSpace, End, Environment, SourceSet, Step};
use tpg_graph::SourceDocument;
use tpg_runtime::scalar::Scalar;

/// Seconds of one action.
const STEP: f64 = 0.2;
/// Maximum angular velocity of each joint, rad/s.
const FASTEST: [f64; 2] = [4.0 * PI, 9.0 * PI];
/// The torque of an action, N·m.
const TORQUES: [f64; 3] = [-1.0, 0.0, 1.0];
/// Actions of an episode.
const ACTIONS: u32 = 500;

physics! {
    /// Acceleration of gravity, m/s².
    gravity = 9.8, [0.0, 100.0];
    /// Mass of the upper link, kg.
    mass_1 = 1.0, [0.001, 1000.0];
    /// Mass of the lower link, kg.
    mass_2 = 1.0, [0.001, 1000.0];
    /// Length of the upper link, m; its centre of mass is in the middle.
    length_1 = 1.0, [0.01, 100.0];
    /// Length of the lower link, m; its centre of mass is in the middle.
    length_2 = 1.0, [0.01, 100.0];
    /// Moment of inertia of a link, kg·m².
    inertia = 1.0, [0.001, 1000.0];
    /// Friction of each joint, N·m for each rad/s.
    friction = 0.0, [0.0, 1000.0];
}

/// The section `[problem]` of a configuration for the two links.
pub type Config = Settings<Amounts>;

/// Two links that hang from an axle, with a motor at the joint between them, by the rules of Gymnasium's Acrobot-v1.
///
/// The state is cosine and sine of the upper link's angle from hanging and of the lower link's angle from the upper one,
/// and both angular velocities in rad/s. Every action costs 1, except the last: an episode ends when the lower end is one
/// link above the axle, and after 500 actions at the latest.
///
/// ```
/// use tpg_engine::{Act, Environment};
/// use tpg_problems::Acrobot;
/// use tpg_runtime::policy::ActionId;
///
/// let mut links = Environment::<f32>::start(&Acrobot, &[0.0; 4]);
/// let step = Environment::<f32>::step(&Acrobot, &mut links, Act::Choice(ActionId(2)));
/// assert!(step.reward == -1.0 && step.end.is_none());
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Acrobot;

/// Two angles, rad, and two angular velocities, rad/s.
type State = [f64; 4];

/// A running episode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Links {
    pub(crate) state: State,
    /// Sine and cosine of both angles: an observation and a step read them.
    sincos: [(f64, f64); 2],
}

impl Links {
    pub(crate) fn new(state: State) -> Self {
        // The crate libm instead of the platform's: the same results on every machine.
        Self { state, sincos: [libm::sincos(state[0]), libm::sincos(state[1])] }
    }
}

impl<S: Scalar> Environment<S> for Acrobot {
    type Task = State;
    type Episode = Links;

    fn sources(&self) -> Vec<SourceDocument> {
        vec![
            source("cos_theta_1", "", [-1.0, 1.0]),
            source("sin_theta_1", "", [-1.0, 1.0]),
            source("cos_theta_2", "", [-1.0, 1.0]),
            source("sin_theta_2", "", [-1.0, 1.0]),
            source("omega_1", "rad/s", [-FASTEST[0], FASTEST[0]]),
            source("omega_2", "rad/s", [-FASTEST[1], FASTEST[1]]),
        ]
    }

    fn actions(&self) -> ActionSpace {
        ActionSpace::discrete(["torque -1", "torque 0", "torque 1"])
    }

    fn outcomes(&self) -> &'static [&'static str] {
        &["up", "time limit"]
    }

    fn time_limit(&self) -> u32 {
        ACTIONS
    }

    fn draw(&self, stream: &mut Stream) -> State {
        std::array::from_fn(|_| f64::from((0.2 * stream.unit() - 0.1) as f32))
    }

    fn start(&self, task: &State) -> Links {
        Links::new(*task)
    }

    fn task_from(&self, links: &Links) -> Option<State> {
        Some(links.state)
    }

    fn observe(&self, links: &mut Links, _wanted: SourceSet, values: &mut [S]) {
        let [(sin_1, cos_1), (sin_2, cos_2)] = links.sincos;
        let state = [cos_1, sin_1, cos_2, sin_2, links.state[2], links.state[3]];
        values.iter_mut().zip(state).for_each(|(slot, value)| *slot = S::from_f64(f64::from(value as f32)));
    }

    fn step(&self, links: &mut Links, act: Act<'_, S>) -> Step {
        self.step_under(&Physics::STANDARD, links, act)
    }
}

impl<S: Scalar> Adjustable<S> for Acrobot {
    type Physics = Physics;

    const REST: u16 = 1;

    #[inline]
    fn step_under(&self, physics: &Physics, links: &mut Links, act: Act<'_, S>) -> Step {
        let torque = TORQUES[act.choice().min(2)];
        let [angle_1, angle_2, omega_1, omega_2] = runge_kutta(physics, links, torque);
        *links = Links::new([
            wrapped(angle_1),
            wrapped(angle_2),
            omega_1.clamp(-FASTEST[0], FASTEST[0]),
            omega_2.clamp(-FASTEST[1], FASTEST[1]),
        ]);
        let [angle_1, angle_2, ..] = links.state;
        let cos_1 = links.sincos[0].1;
        if -cos_1 - libm::cos(angle_2 + angle_1) > 1.0 {
            Step::reward(0.0).ending(End::new(0))
        } else {
            Step::reward(-1.0)
        }
    }
}

/// Returns the state after one action: a step of the classical Runge–Kutta method.
#[inline]
fn runge_kutta(physics: &Physics, links: &Links, torque: f64) -> State {
    let start = links.state;
    let after = |part: f64, slope: State| -> State { std::array::from_fn(|place| start[place] + part * slope[place]) };
    let slope = |state: State| derivative(physics, state, libm::sincos(state[1]), torque);
    let first = derivative(physics, start, links.sincos[1], torque);
    let second = slope(after(STEP / 2.0, first));
    let third = slope(after(STEP / 2.0, second));
    let fourth = slope(after(STEP, third));
    let sum = |place: usize| first[place] + 2.0 * second[place] + 2.0 * third[place] + fourth[place];
    std::array::from_fn(|place| start[place] + STEP / 6.0 * sum(place))
}

/// Returns the derivative of the state: the equations of Sutton and Barto's book. Gymnasium's order of operations.
#[inline]
fn derivative(physics: &Physics, state: State, (sin_2, cos_2): (f64, f64), torque: f64) -> State {
    let Physics { gravity, mass_1, mass_2, length_1, length_2, inertia, friction } = *physics;
    let (centre_1, centre_2) = (0.5 * length_1, 0.5 * length_2);
    let [angle_1, angle_2, omega_1, omega_2] = state;
    let around = length_1 * length_1 + centre_2 * centre_2 + 2.0 * length_1 * centre_2 * cos_2;
    let d1 = mass_1 * (centre_1 * centre_1) + mass_2 * around + inertia + inertia;
    let d2 = mass_2 * (centre_2 * centre_2 + length_1 * centre_2 * cos_2) + inertia;
    let phi2 = mass_2 * centre_2 * gravity * libm::cos(angle_1 + angle_2 - PI / 2.0);
    let phi1 = -mass_2 * length_1 * centre_2 * (omega_2 * omega_2) * sin_2
        - 2.0 * mass_2 * length_1 * centre_2 * omega_2 * omega_1 * sin_2
        + (mass_1 * centre_1 + mass_2 * length_1) * gravity * libm::cos(angle_1 - PI / 2.0)
        + phi2
        + friction * omega_1;
    let driven = torque - friction * omega_2;
    let faster_2 = (driven + d2 / d1 * phi1 - mass_2 * length_1 * centre_2 * (omega_1 * omega_1) * sin_2 - phi2)
        / (mass_2 * (centre_2 * centre_2) + inertia - d2 * d2 / d1);
    let faster_1 = -(d2 * faster_2 + phi1) / d1;
    [omega_1, omega_2, faster_1, faster_2]
}

/// Wraps an angle to −π..π; an angle within it stays as it is.
fn wrapped(mut angle: f64) -> f64 {
    while angle > PI {
        angle -= 2.0 * PI;
    }
    while angle < -PI {
        angle += 2.0 * PI;
    }
    angle
}

#[cfg(test)]
mod tests {
    use super::{Acrobot, Links, Physics, derivative, wrapped};
    use core::f64::consts::PI;
    use tpg_engine::{Act, Environment};
    use tpg_runtime::policy::ActionId;

    #[test]
    fn hanging_at_rest_only_a_torque_moves() {
        let physics = Physics::STANDARD;
        let still = derivative(&physics, [0.0; 4], (0.0, 1.0), 0.0);
        assert!(still.iter().all(|value| value.abs() < 1e-14), "{still:?}");
        // d1 = 1/4 + (1 + 1/4 + 1) + 2 = 4.5 and d2 = 1/4 + 1/2 + 1 = 1.75, so link 2 turns by 1/(1.25 − d2²/d1).
        let pushed = derivative(&physics, [0.0; 4], (0.0, 1.0), 1.0);
        let turned = 1.0 / (1.25 - 1.75 * 1.75 / 4.5);
        assert!((pushed[3] - turned).abs() < 1e-12 && (pushed[2] + 1.75 / 4.5 * turned).abs() < 1e-12, "{pushed:?}");
    }

    #[test]
    fn friction_takes_energy_and_angles_are_wrapped() {
        let slowed = derivative(&Physics { friction: 1.0, ..Physics::STANDARD }, [0.0, 0.0, 1.0, 0.0], (0.0, 1.0), 0.0);
        let free = derivative(&Physics::STANDARD, [0.0, 0.0, 1.0, 0.0], (0.0, 1.0), 0.0);
        assert!(slowed[2] < free[2]);
        assert!((wrapped(3.0 * PI + 0.1) - (0.1 - PI)).abs() < 1e-12);
        assert_eq!(wrapped(1.0), 1.0);
    }

    #[test]
    fn upright_is_the_end() {
        let mut links = Links::new([PI - 0.01, 0.0, 0.0, 0.0]);
        let step = Environment::<f64>::step(&Acrobot, &mut links, Act::Choice(ActionId(1)));
        assert!(step.reward == 0.0 && step.end.is_some_and(|end| end.outcome == 0));
    }
}
