//! Gymnasium's MountainCar-v0: drive a weak car out of a valley by pushes to either side, as fast as possible.

use crate::circle::sincos;
use crate::eights::{ByEight, by_eight};
use crate::physics::physics;
use crate::source;
use tpg_engine::random::Stream;
use tpg_engine::{ActionSpace, Environment};
use tpg_graph::SourceDocument;
use tpg_runtime::scalar::Scalar;

/// Ends of the track.
const TRACK: [f64; 2] = [-1.2, 0.6];
/// Greatest speed, a position each action.
const FASTEST: f64 = 0.07;
/// The goal.
const GOAL: f64 = 0.5;
/// Actions of an episode.
const ACTIONS: u32 = 200;

physics! {
    /// Acceleration of a push.
    force = 0.001, [0.0, 1.0];
    /// Acceleration of the steepest slope in one action.
    slope = 0.0025, [0.0, 1.0];
    /// Fraction of the velocity that each action loses.
    friction = 0.0, [0.0, 1.0];
}

/// A car in a valley, too weak to drive out directly, by the rules of Gymnasium's MountainCar-v0.
///
/// The state is position and velocity; the car is pushed to the left, to the right, or not at all. Every action costs 1;
/// an episode ends at the goal, and after 200 actions at the latest.
///
/// ```
/// use tpg_engine::{Act, Environment};
/// use tpg_problems::MountainCar;
/// use tpg_runtime::policy::ActionId;
///
/// let mut car = Environment::<f32>::start(&MountainCar, &[-0.5, 0.0]);
/// let step = Environment::<f32>::step(&MountainCar, &mut car, Act::Choice(ActionId(2)));
/// assert!(step.reward == -1.0 && step.end.is_none() && car[1] > 0.0);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct MountainCar;

/// Position and velocity.
type State = [f64; 2];

impl<S: Scalar> Environment<S> for MountainCar {
    type Task = State;
    type Episode = State;

    fn sources(&self) -> Vec<SourceDocument> {
        vec![source("position", "", TRACK), source("velocity", "", [-FASTEST, FASTEST])]
    }

    fn actions(&self) -> ActionSpace {
        ActionSpace::discrete(["left", "none", "right"])
    }

    fn outcomes(&self) -> &'static [&'static str] {
        &["goal", "time limit"]
    }

    fn time_limit(&self) -> u32 {
        ACTIONS
    }

    fn draw(&self, stream: &mut Stream) -> State {
        [-0.6 + 0.2 * stream.unit(), 0.0]
    }

    fn start(&self, task: &State) -> State {
        *task
    }

    fn task_from(&self, state: &State) -> Option<State> {
        Some(*state)
    }

    by_eight!(2);
}

impl ByEight<2> for MountainCar {
    type Physics = Physics;
    const STANDARD: Physics = Physics::STANDARD;
    const OBSERVED: &[usize] = &[0, 1];
    const ROUNDS: bool = true;
    const REST: u16 = 1;

    #[inline(always)]
    fn step_many<const L: usize>(
        physics: &Physics,
        states: &mut [[f64; L]; 2],
        acts: &[f64; L],
        rewards: &mut [f64; L],
        ended: &mut [bool; L],
    ) {
        let [positions, velocities] = states;
        let mut angles = *positions;
        angles.iter_mut().for_each(|angle| *angle *= 3.0);
        let [_, cosines] = sincos(&angles);
        *rewards = [-1.0; L];
        for lane in 0..L {
            let state = moved(physics, [positions[lane], velocities[lane]], cosines[lane], acts[lane]);
            [positions[lane], velocities[lane]] = state;
            ended[lane] = is_there(state);
        }
    }
}

/// Returns the state after an action, given by its number, on a slope that the cosine describes.
#[inline(always)]
fn moved(physics: &Physics, [position, velocity]: State, cosine: f64, action: f64) -> State {
    let Physics { force, slope, friction } = *physics;
    let push = (action - 1.0) * force;
    let faster = velocity + (push + cosine * -slope) - friction * velocity;
    let velocity = faster.clamp(-FASTEST, FASTEST);
    let position = (position + velocity).clamp(TRACK[0], TRACK[1]);
    let is_stopped = (position <= TRACK[0]) & (velocity < 0.0);
    [position, if is_stopped { 0.0 } else { velocity }]
}

/// True if the car is at the goal and does not roll back.
#[inline(always)]
fn is_there([position, velocity]: State) -> bool {
    (position >= GOAL) & (velocity >= 0.0)
}

#[cfg(test)]
mod tests {
    use super::MountainCar;
    use crate::tests::lanes::{policy, same_as_one_by_one};
    use tpg_engine::{Act, Environment, Operand, Step};
    use tpg_runtime::ops::Instruction;
    use tpg_runtime::policy::ActionId;

    fn step(state: &mut [f64; 2], action: u16) -> Step {
        Environment::<f64>::step(&MountainCar, state, Act::Choice(ActionId(action)))
    }

    /// Checks three steps of MountainCar-v0, computed by hand from its published rules.
    #[test]
    fn the_rules_are_gymnasiums() {
        let mut state = [-0.5, 0.01];
        let first = step(&mut state, 2);
        let velocity = 0.01 + 0.001 - 0.0025 * (-1.5_f64).cos();
        assert!((state[1] - velocity).abs() < 1e-15 && (state[0] - (velocity - 0.5)).abs() < 1e-15);
        assert!(first.reward == -1.0 && first.end.is_none());
        // The left end of the track stops the car, the right end is behind the goal.
        let mut left = [-1.19, -0.07];
        step(&mut left, 0);
        assert_eq!(left, [-1.2, 0.0]);
        let mut right = [0.49, 0.02];
        assert!(step(&mut right, 1).end.is_some_and(|end| end.outcome == 0 && !end.truncated));
    }

    #[test]
    fn eight_cars_drive_as_one() {
        let [position, velocity] = [0, 1].map(Operand::Input);
        let arrived = same_as_one_by_one(MountainCar, &policy(Instruction::Add, [velocity, Operand::Constant(0.0)], 3));
        let late = same_as_one_by_one(MountainCar, &policy(Instruction::Mul, [position, velocity], 3));
        assert!(arrived.iter().any(|ending| ending.outcome == 0) && late.iter().any(|ending| ending.outcome == 1));
    }
}
