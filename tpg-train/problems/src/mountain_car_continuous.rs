//! Gymnasium's MountainCarContinuous-v0: drive a weak car out of a valley, with as little force as possible.

use crate::eights::{ByEight, by_eight};
use crate::physics::physics;
use crate::source;
use tpg_engine::random::Stream;
use tpg_engine::{ActionSpace, Environment, Output};
use tpg_graph::SourceDocument;
use tpg_runtime::scalar::Scalar;

/// Greatest force.
const FORCE: f32 = 1.0;
/// Ends of the track.
const TRACK: [f64; 2] = [-1.2, 0.6];
/// Greatest speed, a position each action.
const FASTEST: f64 = 0.07;
/// The goal.
const GOAL: f64 = 0.45;
/// Reward of the goal.
const REWARD: f64 = 100.0;
/// Price of the squared force.
const PRICE: f64 = 0.1;
/// Actions of an episode.
const ACTIONS: u32 = 999;

physics! {
    /// Acceleration of the maximum force in one action.
    power = 0.0015, [0.0, 1.0];
    /// Acceleration of the steepest slope in one action.
    slope = 0.0025, [0.0, 1.0];
    /// Fraction of the velocity that each action loses.
    friction = 0.0, [0.0, 1.0];
}

/// A car in a valley, too weak to drive out directly, by the rules of Gymnasium's MountainCarContinuous-v0.
///
/// The state is position and velocity; the action is a force from −1 to 1. The goal earns 100, and every action costs a
/// tenth of its squared force; an episode ends at the goal, and after 999 actions at the latest. Position and velocity are
/// `f32` values after the first action, as they are in Gymnasium.
///
/// ```
/// use tpg_engine::{Act, Environment};
/// use tpg_problems::MountainCarContinuous;
///
/// let mut car = Environment::<f32>::start(&MountainCarContinuous, &-0.5);
/// let step = Environment::<f32>::step(&MountainCarContinuous, &mut car, Act::Values(&[0.5]));
/// assert!((step.reward + 0.025).abs() < 1e-12 && step.end.is_none());
/// ```
#[derive(Clone, Copy, Debug)]
pub struct MountainCarContinuous;

/// A running episode: position, velocity, and 1 where these have been rounded to `f32`, which is after the first action.
type Drive = [f64; 3];

impl<S: Scalar> Environment<S> for MountainCarContinuous {
    /// The first position.
    type Task = f64;
    type Episode = Drive;

    fn sources(&self) -> Vec<SourceDocument> {
        vec![source("position", "", TRACK), source("velocity", "", [-FASTEST, FASTEST])]
    }

    fn actions(&self) -> ActionSpace {
        let (name, unit, force) = ("force".to_owned(), String::new(), f64::from(FORCE));
        ActionSpace::Box(vec![Output { name, unit, min: -force, max: force }])
    }

    fn outcomes(&self) -> &'static [&'static str] {
        &["goal", "time limit"]
    }

    fn time_limit(&self) -> u32 {
        ACTIONS
    }

    fn draw(&self, stream: &mut Stream) -> f64 {
        -0.6 + 0.2 * stream.unit()
    }

    fn start(&self, &position: &f64) -> Drive {
        [position, 0.0, 0.0]
    }

    by_eight!(3);
}

impl ByEight<3> for MountainCarContinuous {
    type Physics = Physics;
    const STANDARD: Physics = Physics::STANDARD;
    const OBSERVED: &[usize] = &[0, 1];
    const ROUNDS: bool = true;

    #[inline(always)]
    fn step_many<const L: usize>(
        physics: &Physics,
        drives: &mut [[f64; L]; 3],
        forces: &[f64; L],
        rewards: &mut [f64; L],
        ended: &mut [bool; L],
    ) {
        for lane in 0..L {
            let drive = drives.each_ref().map(|numbers| numbers[lane]);
            let (drive, arrived) = moved(physics, drive, forces[lane] as f32);
            drives.iter_mut().zip(drive).for_each(|(numbers, number)| numbers[lane] = number);
            let price = forces[lane] * forces[lane] * PRICE;
            (rewards[lane], ended[lane]) = (if arrived { REWARD - price } else { -price }, arrived);
        }
    }
}

/// Returns the car after an action, and true if it has come to the goal.
#[inline(always)]
fn moved(physics: &Physics, [position, velocity, is_rounded]: Drive, force: f32) -> (Drive, bool) {
    let (power, is_rounded) = (physics.power as f32, is_rounded > 0.0);
    let force = force.clamp(-FORCE, FORCE);
    // NumPy multiplies an f32 by 3 in f32; the first position is an f64. The crate libm instead of the platform's: the
    // same results on every machine.
    let angle = if is_rounded { f64::from(3.0 * position as f32) } else { 3.0 * position };
    let lost = (physics.friction * velocity) as f32;
    let change = force * power - (physics.slope * libm::cos(angle)) as f32 - lost;
    let (mut position, mut velocity) = if is_rounded {
        let velocity = (velocity as f32 + change).clamp(-FASTEST as f32, FASTEST as f32);
        (f64::from(position as f32 + velocity), f64::from(velocity))
    } else {
        let velocity = (velocity + f64::from(change)).clamp(-FASTEST, FASTEST);
        (position + velocity, velocity)
    };
    position = position.clamp(TRACK[0], TRACK[1]);
    if position <= TRACK[0] && velocity < 0.0 {
        velocity = 0.0;
    }
    let arrived = position >= GOAL && velocity >= 0.0;
    ([f64::from(position as f32), f64::from(velocity as f32), 1.0], arrived)
}
#[cfg(test)]
mod tests {
    use super::{Drive, MountainCarContinuous};
    use tpg_engine::{Act, Environment, Step};

    fn step(drive: &mut Drive, force: f64) -> Step {
        Environment::<f64>::step(&MountainCarContinuous, drive, Act::Values(&[force]))
    }

    /// Checks three steps of MountainCarContinuous-v0, computed by hand from its published rules.
    #[test]
    fn the_rules_are_gymnasiums() {
        let mut drive = Environment::<f64>::start(&MountainCarContinuous, &-0.5);
        let first = step(&mut drive, 1.0);
        let velocity = 0.0015 - 0.0025 * (-1.5_f64).cos();
        assert!((first.reward + 0.1).abs() < 1e-12 && first.end.is_none());
        assert!((drive[1] - velocity).abs() < 1e-9 && (drive[0] - (velocity - 0.5)).abs() < 1e-7);
        assert_eq!(f64::from(drive[0] as f32), drive[0]);
        // The left end of the track stops the car, the right end is behind the goal.
        let mut left = [-1.19, -0.07, 1.0];
        step(&mut left, -1.0);
        assert_eq!((left[0] as f32, left[1]), (-1.2, 0.0));
        let mut right = [0.44, 0.05, 1.0];
        let last = step(&mut right, 0.5);
        assert!((last.reward - (100.0 - 0.025)).abs() < 1e-12);
        assert!(last.end.is_some_and(|end| end.outcome == 0 && !end.truncated));
    }
}
