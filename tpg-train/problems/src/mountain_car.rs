//! Gymnasium's MountainCar-v0: drive a weak car out of a valley by pushes to either side, as fast as possible.

use crate::physics::physics;
use crate::source;
use crate::varied::{Adjustable, Settings};
use tpg_engine::random::Stream;
use tpg_engine::{Act, ActionSpace, End, Environment, SourceSet, Step};
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

/// The section `[problem]` of a configuration for the car.
pub type Config = Settings<Amounts>;

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

    fn observe(&self, state: &mut State, _wanted: SourceSet, values: &mut [S]) {
        let state = state.map(|value| f64::from(value as f32));
        values.iter_mut().zip(state).for_each(|(slot, value)| *slot = S::from_f64(value));
    }

    fn step(&self, state: &mut State, act: Act<'_, S>) -> Step {
        self.step_under(&Physics::STANDARD, state, act)
    }
}

impl<S: Scalar> Adjustable<S> for MountainCar {
    type Physics = Physics;

    const REST: u16 = 1;

    #[inline]
    fn step_under(&self, physics: &Physics, state: &mut State, act: Act<'_, S>) -> Step {
        let Physics { force, slope, friction } = *physics;
        let [position, velocity] = *state;
        let push = (act.choice() as f64 - 1.0) * force;
        // The crate libm instead of the platform's: the same results on every machine.
        let faster = velocity + (push + libm::cos(3.0 * position) * -slope) - friction * velocity;
        let mut velocity = faster.clamp(-FASTEST, FASTEST);
        let position = (position + velocity).clamp(TRACK[0], TRACK[1]);
        if position <= TRACK[0] && velocity < 0.0 {
            velocity = 0.0;
        }
        *state = [position, velocity];
        let step = Step::reward(-1.0);
        if position >= GOAL && velocity >= 0.0 { step.ending(End::new(0)) } else { step }
    }
}

#[cfg(test)]
mod tests {
    use super::MountainCar;
    use tpg_engine::{Act, Environment, Step};
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
}
