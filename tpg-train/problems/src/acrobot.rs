//! Gymnasium's Acrobot-v1: swing two links up by a motor at the joint between them.

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
const STEP: f64 = 0.2;
/// Maximum angular velocity of each joint, rad/s.
const FASTEST: [f64; 2] = [4.0 * PI, 9.0 * PI];
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

/// A running episode: both angles, rad, and angular velocities, rad/s; the sines and then the cosines of both angles, which an
/// observation and a step read.
type Links = [f64; 8];

fn links([angle_1, angle_2, omega_1, omega_2]: State) -> Links {
    // The crate libm instead of the platform's: the same results on every machine.
    let [(sin_1, cos_1), (sin_2, cos_2)] = [angle_1, angle_2].map(libm::sincos);
    [angle_1, angle_2, omega_1, omega_2, sin_1, sin_2, cos_1, cos_2]
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
        links(*task)
    }

    by_eight!(8);
}

impl ByEight<8> for Acrobot {
    type Physics = Physics;
    const STANDARD: Physics = Physics::STANDARD;
    const OBSERVED: &[usize] = &[6, 4, 7, 5, 2, 3];
    const ROUNDS: bool = true;
    const REST: u16 = 1;

    #[inline(always)]
    fn step_many<const L: usize>(
        physics: &Physics,
        numbers: &mut [[f64; L]; 8],
        acts: &[f64; L],
        rewards: &mut [f64; L],
        ended: &mut [bool; L],
    ) {
        let mut torques = *acts;
        torques.iter_mut().for_each(|torque| *torque -= 1.0);
        *ended = moved(physics, numbers, &torques);
        rewards.iter_mut().zip(ended).for_each(|(reward, ended)| *reward = if *ended { 0.0 } else { -1.0 });
    }
}

/// Moves `L` pairs of links for one action, a step of the classical Runge–Kutta method; returns which have come up.
#[inline(always)]
fn moved<const L: usize>(physics: &Physics, links: &mut [[f64; L]; 8], torques: &[f64; L]) -> [bool; L] {
    let [angle_1, angle_2, omega_1, omega_2, _, sin_2, _, cos_2] = *links;
    let start = [angle_1, angle_2, omega_1, omega_2];
    let first = slopes(physics, &start, &[sin_2, cos_2], torques);
    let second = slopes_after(physics, &start, STEP / 2.0, &first, torques);
    let third = slopes_after(physics, &start, STEP / 2.0, &second, torques);
    let fourth = slopes_after(physics, &start, STEP, &third, torques);
    let mut end = start;
    for (place, values) in end.iter_mut().enumerate() {
        for (lane, value) in values.iter_mut().enumerate() {
            let sum = first[place][lane] + 2.0 * second[place][lane] + 2.0 * third[place][lane] + fourth[place][lane];
            *value += STEP / 6.0 * sum;
        }
    }
    let [mut angle_1, mut angle_2, mut omega_1, mut omega_2] = end;
    wrap(&mut angle_1);
    wrap(&mut angle_2);
    for (omegas, fastest) in [&mut omega_1, &mut omega_2].into_iter().zip(FASTEST) {
        omegas.iter_mut().for_each(|omega| *omega = omega.clamp(-fastest, fastest));
    }
    let ([sin_1, cos_1], [sin_2, cos_2]) = (sincos(&angle_1), sincos(&angle_2));
    *links = [angle_1, angle_2, omega_1, omega_2, sin_1, sin_2, cos_1, cos_2];
    let mut angle_12 = angle_2;
    angle_12.iter_mut().zip(&angle_1).for_each(|(angle, angle_1)| *angle += angle_1);
    let [_, cos_12] = sincos(&angle_12);
    let mut are_up = [false; L];
    for (lane, is_up) in are_up.iter_mut().enumerate() {
        *is_up = -cos_1[lane] - cos_12[lane] > 1.0;
    }
    are_up
}

/// Returns the derivatives of states that have followed the given derivatives for some seconds.
#[inline(always)]
fn slopes_after<const L: usize>(
    physics: &Physics,
    start: &[[f64; L]; 4],
    seconds: f64,
    slopes_before: &[[f64; L]; 4],
    torques: &[f64; L],
) -> [[f64; L]; 4] {
    let mut states = *start;
    for (values, slopes) in states.iter_mut().zip(slopes_before) {
        values.iter_mut().zip(slopes).for_each(|(value, slope)| *value += seconds * slope);
    }
    slopes(physics, &states, &sincos(&states[1]), torques)
}

/// Returns the derivatives of states, with sines and cosines of the second angles.
#[inline(always)]
fn slopes<const L: usize>(
    physics: &Physics,
    [angle_1, angle_2, omega_1, omega_2]: &[[f64; L]; 4],
    [sin_2, cos_2]: &[[f64; L]; 2],
    torques: &[f64; L],
) -> [[f64; L]; 4] {
    let (mut behind_1, mut behind_12) = (*angle_1, *angle_1);
    for (lane, (behind_1, behind_12)) in behind_1.iter_mut().zip(&mut behind_12).enumerate() {
        *behind_1 -= PI / 2.0;
        *behind_12 = angle_1[lane] + angle_2[lane] - PI / 2.0;
    }
    let ([_, cos_1], [_, cos_12]) = (sincos(&behind_1), sincos(&behind_12));
    let mut faster = [[0.0; L]; 2];
    for lane in 0..L {
        let (omegas, circle_2) = ([omega_1[lane], omega_2[lane]], [sin_2[lane], cos_2[lane]]);
        let [faster_1, faster_2] = accelerations(physics, omegas, circle_2, [cos_1[lane], cos_12[lane]], torques[lane]);
        (faster[0][lane], faster[1][lane]) = (faster_1, faster_2);
    }
    [*omega_1, *omega_2, faster[0], faster[1]]
}

/// Returns the accelerations of both joints, rad/s²: the equations of Sutton and Barto's book, in Gymnasium's order of operations.
/// `cos_1` and `cos_12` are of angles a quarter of a turn behind the upper link and the lower one.
#[inline(always)]
fn accelerations(
    physics: &Physics,
    [omega_1, omega_2]: [f64; 2],
    [sin_2, cos_2]: [f64; 2],
    [cos_1, cos_12]: [f64; 2],
    torque: f64,
) -> [f64; 2] {
    let Physics { gravity, mass_1, mass_2, length_1, length_2, inertia, friction } = *physics;
    let (centre_1, centre_2) = (0.5 * length_1, 0.5 * length_2);
    let around = length_1 * length_1 + centre_2 * centre_2 + 2.0 * length_1 * centre_2 * cos_2;
    let d1 = mass_1 * (centre_1 * centre_1) + mass_2 * around + inertia + inertia;
    let d2 = mass_2 * (centre_2 * centre_2 + length_1 * centre_2 * cos_2) + inertia;
    let phi2 = mass_2 * centre_2 * gravity * cos_12;
    let phi1 = -mass_2 * length_1 * centre_2 * (omega_2 * omega_2) * sin_2
        - 2.0 * mass_2 * length_1 * centre_2 * omega_2 * omega_1 * sin_2
        + (mass_1 * centre_1 + mass_2 * length_1) * gravity * cos_1
        + phi2
        + friction * omega_1;
    let driven = torque - friction * omega_2;
    let faster_2 = (driven + d2 / d1 * phi1 - mass_2 * length_1 * centre_2 * (omega_1 * omega_1) * sin_2 - phi2)
        / (mass_2 * (centre_2 * centre_2) + inertia - d2 * d2 / d1);
    let faster_1 = -(d2 * faster_2 + phi1) / d1;
    [faster_1, faster_2]
}

/// Wraps angles to −π..π; one within it stays as it is.
#[inline(always)]
fn wrap<const L: usize>(angles: &mut [f64; L]) {
    let (far, mut any_is_far) = (*angles, false);
    for angle in &mut *angles {
        let (less, more) = (*angle - 2.0 * PI, *angle + 2.0 * PI);
        *angle = if *angle > PI { less } else { *angle };
        *angle = if *angle < -PI { more } else { *angle };
        any_is_far |= (*angle > PI) | (*angle < -PI);
    }
    // Few are further away than one turn.
    if any_is_far {
        angles.iter_mut().zip(far).for_each(|(angle, far)| *angle = wrapped(far));
    }
}

/// Wraps an angle as [`wrap`] does, however far it is.
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
    use super::{Acrobot, Physics, accelerations, links, wrap, wrapped};
    use crate::tests::lanes::{policy, same_as_one_by_one};
    use core::f64::consts::PI;
    use tpg_engine::{Act, Environment, Operand};
    use tpg_runtime::ops::Instruction;
    use tpg_runtime::policy::ActionId;

    /// Hanging: the lower link straight below the upper one, both cosines of a quarter of a turn.
    fn hanging(physics: &Physics, omegas: [f64; 2], torque: f64) -> [f64; 2] {
        accelerations(physics, omegas, [0.0, 1.0], [0.0; 2], torque)
    }

    #[test]
    fn hanging_at_rest_only_a_torque_moves() {
        let physics = Physics::STANDARD;
        assert_eq!(hanging(&physics, [0.0; 2], 0.0), [0.0; 2]);
        // d1 = 1/4 + (1 + 1/4 + 1) + 2 = 4.5 and d2 = 1/4 + 1/2 + 1 = 1.75, so link 2 turns by 1/(1.25 − d2²/d1).
        let [upper, lower] = hanging(&physics, [0.0; 2], 1.0);
        let turned = 1.0 / (1.25 - 1.75 * 1.75 / 4.5);
        assert!((lower - turned).abs() < 1e-12 && (upper + 1.75 / 4.5 * turned).abs() < 1e-12, "{upper} {lower}");
    }

    #[test]
    fn friction_takes_energy_and_angles_are_wrapped() {
        let slowed = hanging(&Physics { friction: 1.0, ..Physics::STANDARD }, [1.0, 0.0], 0.0);
        let free = hanging(&Physics::STANDARD, [1.0, 0.0], 0.0);
        assert!(slowed[0] < free[0]);
        assert!((wrapped(3.0 * PI + 0.1) - (0.1 - PI)).abs() < 1e-12);
        assert_eq!(wrapped(1.0), 1.0);
    }

    #[test]
    fn upright_is_the_end() {
        let mut upright = links([PI - 0.01, 0.0, 0.0, 0.0]);
        let step = Environment::<f64>::step(&Acrobot, &mut upright, Act::Choice(ActionId(1)));
        assert!(step.reward == 0.0 && step.end.is_some_and(|end| end.outcome == 0));
    }

    #[test]
    fn eight_angles_are_wrapped_as_one() {
        let turns = (-9..=9).map(|half| f64::from(half) * PI);
        let near = |angle: f64| (0..50).map(move |bit| f64::from_bits(angle.to_bits() ^ 1 << bit));
        let angles: Vec<f64> = turns.flat_map(near).chain((-900..900).map(|step| f64::from(step) * 0.0137)).collect();
        for eight in angles.as_chunks::<8>().0.iter().chain(&[[f64::NAN, 0.0, -0.0, 1.0, -1.0, 4.0, -4.0, 0.5]]) {
            let bits = |angles: [f64; 8]| angles.map(|angle| if angle.is_nan() { 0 } else { angle.to_bits() });
            let mut near = *eight;
            wrap(&mut near);
            assert_eq!(bits(near), bits(eight.map(wrapped)), "{eight:?}");
        }
    }

    #[test]
    fn eight_pairs_swing_as_one() {
        let [sin_2, omega_1, omega_2] = [3, 4, 5].map(Operand::Input);
        let mut ends = Vec::new();
        for operands in [[omega_1, omega_2], [omega_2, sin_2], [sin_2, Operand::Constant(0.1)]] {
            ends.extend(same_as_one_by_one(Acrobot, &policy(Instruction::Sub, operands, 3)));
        }
        ends.extend(same_as_one_by_one(Acrobot, &policy(Instruction::Mul, [omega_1, Operand::Constant(1.0)], 3)));
        assert!(ends.iter().any(|ending| ending.outcome == 0) && ends.iter().any(|ending| ending.outcome == 1));
    }
}
