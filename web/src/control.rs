//! CartPole, Pendulum and MountainCar, driven by their generated code, under constants that a page may change.
//!
//! The dynamics are those of `tpg-problems`, which training and evaluation step, too.

use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{Decision, Environment, SourceSet};
use tpg_generated::{cartpole::Cartpole, mountain_car::MountainCar as CarPolicy, pendulum::Pendulum as PendulumPolicy};
use tpg_problems::eights::{ByEight, number};
use tpg_problems::{CartPole, MountainCar, Pendulum, cartpole, mountain_car, pendulum};
use tpg_runtime::policy::Policy;

/// The greatest number of values of a state.
pub const STATE: usize = 4;

/// A problem as a page reads it; the same layout in JavaScript.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ControlView {
    /// Position and velocity, angle and angular velocity: whatever an episode can begin with.
    pub state: [f64; STATE],
    /// The number of the last action, or the last torque.
    pub action: f64,
    /// The sum of rewards since the last time limit.
    pub score: f64,
    /// The sum of rewards of the last whole episode; NaN before there is one.
    pub last_score: f64,
    /// The state that the policy saw at the last action, from which the page computes the bids.
    pub seen: [f32; STATE],
    /// Actions since the last time limit.
    pub actions: u32,
    /// 1 where the episode has ended: fallen, or at the goal.
    pub ended: u32,
}

/// A problem under way.
pub trait Rig {
    /// Begins an episode, drawn by a seed.
    fn restart(&mut self, seed: u32);
    /// Lets the policy act once; nothing changes behind the end of an episode. The time limit does not end one here.
    fn act(&mut self);
    /// Adds to one value of the state: a push from outside.
    fn push(&mut self, value: usize, by: f64);
    /// Sets a constant of the rules, by its number in the problem's list; an unknown number changes nothing.
    fn set(&mut self, constant: usize, to: f64);
    /// Shows it.
    fn view(&self) -> &ControlView;
}

/// An environment with the policy that drives it.
struct Driven<E: ByEight<M>, const N: usize, const M: usize> {
    environment: E,
    policy: fn(&[f32; N]) -> Decision<f32>,
    physics: E::Physics,
    /// The constants that a page may change, in its order.
    constants: fn(&mut E::Physics) -> [&mut f64; 2],
    episode: [f64; M],
    view: ControlView,
}

impl<E, const N: usize, const M: usize> Driven<E, N, M>
where
    E: ByEight<M> + Environment<f32, Episode = [f64; M], Task: AsRef<[f64]> + AsMut<[f64]>>,
{
    fn new(
        environment: E,
        policy: fn(&[f32; N]) -> Decision<f32>,
        physics: E::Physics,
        constants: fn(&mut E::Physics) -> [&mut f64; 2],
    ) -> Self {
        let task = environment.draw(&mut Stream::new(1, 0, Purpose::Test, 0));
        let view = ControlView { last_score: f64::NAN, ..ControlView::default() };
        let episode = environment.start(&task);
        let mut driven = Self { environment, policy, physics, constants, episode, view };
        driven.show();
        driven
    }

    fn show(&mut self) {
        if let Some(task) = self.environment.task_from(&self.episode) {
            self.view.state.iter_mut().zip(task.as_ref()).for_each(|(slot, &value)| *slot = value);
        }
    }
}

impl<E, const N: usize, const M: usize> Rig for Driven<E, N, M>
where
    E: ByEight<M> + Environment<f32, Episode = [f64; M], Task: AsRef<[f64]> + AsMut<[f64]>>,
{
    fn restart(&mut self, seed: u32) {
        let task = self.environment.draw(&mut Stream::new(u64::from(seed), 0, Purpose::Test, 0));
        self.episode = self.environment.start(&task);
        (self.view.score, self.view.actions, self.view.ended) = (0.0, 0, 0);
        self.show();
    }

    fn act(&mut self) {
        if self.view.ended != 0 {
            return;
        }
        let mut seen = [0.0; N];
        self.environment.observe(&mut self.episode, SourceSet::ALL, &mut seen);
        let answer = (self.policy)(&seen);
        let step = E::step_under(&self.physics, &mut self.episode, number(answer.act()));
        let view = &mut self.view;
        view.seen[..N].copy_from_slice(&seen);
        view.action = match answer {
            Decision::Choice(action) => action.0.into(),
            Decision::Values(values) => values.first().copied().map_or(0.0, f64::from),
        };
        view.score += step.reward;
        view.actions += 1;
        view.ended = u32::from(step.end.is_some());
        if view.actions == self.environment.time_limit() || step.end.is_some() {
            view.last_score = view.score;
        }
        if view.actions == self.environment.time_limit() && step.end.is_none() {
            (view.score, view.actions) = (0.0, 0);
        }
        self.show();
    }

    fn push(&mut self, value: usize, by: f64) {
        let Some(mut task) = self.environment.task_from(&self.episode) else { return };
        if let Some(value) = task.as_mut().get_mut(value).filter(|_| by.is_finite()) {
            *value += by;
            self.episode = self.environment.start(&task);
            self.show();
        }
    }

    fn set(&mut self, constant: usize, to: f64) {
        if let Some(constant) = (self.constants)(&mut self.physics).into_iter().nth(constant).filter(|_| to.is_finite())
        {
            *constant = to;
        }
    }

    fn view(&self) -> &ControlView {
        &self.view
    }
}

/// The problems in the page's order, each with the constants that a page may change.
pub fn rigs() -> [Box<dyn Rig>; 3] {
    [
        Box::new(Driven::new(
            CartPole,
            |seen| Decision::Choice(Cartpole.decide(seen)),
            cartpole::Physics::STANDARD,
            |physics| [&mut physics.length, &mut physics.force],
        )),
        Box::new(Driven::new(
            Pendulum,
            |seen| Decision::Values(PendulumPolicy.decide(seen).to_vec()),
            pendulum::Physics::STANDARD,
            |physics| [&mut physics.mass, &mut physics.length],
        )),
        Box::new(Driven::new(
            MountainCar,
            |seen| Decision::Choice(CarPolicy.decide(seen)),
            mountain_car::Physics::STANDARD,
            |physics| [&mut physics.force, &mut physics.slope],
        )),
    ]
}
