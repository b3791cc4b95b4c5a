//! A trained actor as a policy of the arm.

use crate::sac::config::{Actor, Decides};
use std::cell::RefCell;
use tpg_arm::episode::Summary;
use tpg_arm::frame::Frame;
use tpg_arm::observation::Observation;
use tpg_arm::{Arm, JOINTS, Move, Pose};
use tpg_engine::random::{Purpose, Stream};
use tpg_nn::{Gaussian, Mlp, Samples, Tape};
use tpg_problems::arm::ArmProblem;
use tpg_problems::arm::motors::{Config, Discretiser, Inputs};
use tpg_problems::arm::targets::Task;
use tpg_problems::arm::trial::{self, Trial};
use tpg_runtime::policy::Policy;

/// An actor, in `f32`: the same on every machine, and the same as in its training. As a [`Policy`] it decides by its mean.
#[derive(Debug)]
pub struct ActorPolicy<'a> {
    network: &'a Mlp<f32>,
    arm: Arm<f32>,
    inputs: Inputs,
    discretiser: Discretiser,
    gaussian: Gaussian,
    decides: Decides,
    tape: RefCell<Tape<f32>>,
}

impl<'a> ActorPolicy<'a> {
    /// The policy of a network that was trained under these settings.
    ///
    /// # Panics
    /// If the network's input or output is not the configuration's.
    pub fn new(network: &'a Mlp<f32>, motors: &Config, actor: &Actor) -> Self {
        assert_eq!(network.shape().inputs, motors.inputs.count(), "an actor of other inputs");
        assert!(network.shape().outputs >= JOINTS, "an actor of other outputs");
        let tape = RefCell::new(Tape::new(network.shape(), 1));
        let gaussian = Gaussian { actions: JOINTS, spread: actor.spread };
        let discretiser = Discretiser::new(motors);
        Self {
            network,
            arm: motors.arm().to_f32(),
            inputs: motors.inputs,
            discretiser,
            gaussian,
            decides: actor.decides,
            tape,
        }
    }

    /// One episode of each task, decided as the actor does outside of training.
    ///
    /// # Panics
    /// If it draws its actions and its network answers no spread.
    pub fn trial(&self, problem: impl Into<ArmProblem>, tasks: &[Task]) -> Trial {
        let problem = problem.into();
        let episode = |(place, task)| self.watch(&problem, place, task, |_pose| ());
        let summaries: Vec<_> = tasks.iter().enumerate().map(episode).collect();
        trial::summarise(problem, &summaries)
    }

    /// The episode at that place of a list; `each` sees the pose after every action.
    ///
    /// # Panics
    /// As [`trial`](Self::trial).
    pub fn watch(&self, problem: &ArmProblem, place: usize, task: &Task, each: impl FnMut(Pose)) -> Summary<f32> {
        match self.decides {
            Decides::ByMean => trial::watch(&self.arm, self, problem, task, each),
            Decides::ByDraw => {
                let mut random = Stream::new(0, place as u64, Purpose::Draws, 0);
                trial::watch_drawn(&self.arm, |seen| self.draw(seen, &mut random), problem, task, each)
            }
        }
    }

    fn draw(&self, seen: &Observation<f32>, random: &mut Stream) -> Move {
        let mut tape = self.tape.borrow_mut();
        self.inputs.observe(&Frame::of(&self.arm, seen), tape.input_mut());
        self.network.forward(&mut tape);
        let (mut noise, mut samples) = ([0.0; JOINTS], Samples::default());
        random.normals(&mut noise);
        self.gaussian.sample(tape.output(), &noise, &mut samples);
        let preferences = std::array::from_fn(|joint| libm::atanhf(samples.actions[joint]));
        self.discretiser.decide(preferences, seen.pose, &self.arm.ranges)
    }

    /// The means before the tanh.
    pub fn preferences(&self, frame: &Frame<'_, f32>) -> [f32; JOINTS] {
        let mut tape = self.tape.borrow_mut();
        self.inputs.observe(frame, tape.input_mut());
        self.network.forward(&mut tape);
        std::array::from_fn(|joint| tape.output()[joint])
    }
}

impl Policy for ActorPolicy<'_> {
    type State = Observation<f32>;
    type Action = Move;

    fn decide(&self, seen: &Observation<f32>) -> Move {
        self.discretiser.decide(self.preferences(&Frame::of(&self.arm, seen)), seen.pose, &self.arm.ranges)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sac::presets;
    use tpg_arm::WIDOWX;
    use tpg_arm::sac::{Actions, Mask};
    use tpg_nn::Shape;
    use tpg_problems::arm::targets::{Set, Start, tasks};

    #[test]
    fn a_policy_that_draws_is_not_stopped_by_rest_and_draws_the_same_again() {
        let mut actor = presets::config(presets::find("paper-fs").expect("a preset")).expect("it is accepted").actor;
        let motors = Config {
            inputs: Inputs::PaperFs,
            actions: Actions::Coarse,
            mask: Mask::None,
            may_rest: true,
            ..Config::default()
        };
        let shape = Shape { inputs: 13, hidden: vec![8], outputs: 2 * JOINTS, norm: false };
        let mut random = Stream::new(3, 0, Purpose::Test, 0);
        let network = Mlp::random(shape, || random.unit());
        let tasks = tasks(&WIDOWX, 3, Set::Validation, Start::Fs, 8);
        let trial = |actor: &Actor| ActorPolicy::new(&network, &motors, actor).trial(Start::Fs, &tasks);
        let drawn = trial(&actor);
        assert_eq!(drawn, trial(&actor));
        assert_eq!((drawn.failures.stop, drawn.failures.cycle), (0, 0));
        actor.decides = Decides::ByMean;
        let by_mean = trial(&actor);
        assert_eq!(
            by_mean,
            trial::run(&WIDOWX.to_f32(), &ActorPolicy::new(&network, &motors, &actor), Start::Fs, &tasks)
        );
        assert!(by_mean.failures.stop > 0, "a network that has not learned rests somewhere: {by_mean:?}");
        assert!(drawn.mean_actions > by_mean.mean_actions);
    }
}
