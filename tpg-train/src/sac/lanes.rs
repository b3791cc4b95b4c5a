//! Parallel training episodes: when one ends, the next begins in its lane.

use super::config::SacConfig;
use super::interface::Interface;
use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{Act, Environment, Rollout, SourceSet, Step};

/// A running episode.
pub(crate) struct Lane<'e, E: Environment<f32>> {
    /// The task that it began with.
    pub(crate) task: E::Task,
    /// The actions so far, one after the other, every component in −1..1. With the task they are the whole episode.
    pub(crate) actions: Vec<f32>,
    rollout: Rollout<'e, f32, E>,
}

/// Parallel episodes.
pub(crate) struct TrainingLanes<'e, E: Environment<f32>> {
    pub(crate) environment: &'e E,
    /// The network's inputs and outputs.
    pub(crate) interface: Interface,
    /// Actions of the environment that a decision lasts.
    lasts: u32,
    /// Discount of each elementary step.
    discount: f32,
    seed: u64,
    /// The lanes.
    pub(crate) lanes: Vec<Lane<'e, E>>,
    /// Episodes ever begun.
    pub(crate) episodes: u64,
    /// Tasks with which some of the episodes begin again.
    pub(crate) failures: Vec<E::Task>,
    retried: f64,
}

impl<'e, E: Environment<f32>> TrainingLanes<'e, E> {
    /// Begins an episode in each lane.
    pub(crate) fn new(environment: &'e E, interface: Interface, config: &SacConfig, seed: u64) -> Self {
        let retried = config.retry.map_or(0.0, |retry| retry.share);
        let (lasts, discount) = (config.learning.decision_lasts, config.learning.discount as f32);
        let (lanes, failures) = (Vec::new(), Vec::new());
        let mut new = Self { environment, interface, lasts, discount, seed, lanes, episodes: 0, failures, retried };
        for _ in 0..config.learning.lanes {
            let lane = new.begin();
            new.lanes.push(lane);
        }
        new
    }

    /// Adds a lane whose episode began with `task` and has had `actions`: they are done again.
    pub(crate) fn resume(&mut self, task: E::Task, actions: &[f32]) {
        let lane = self.lane(task);
        self.lanes.push(lane);
        let last = self.lanes.len() - 1;
        actions.chunks_exact(self.interface.outputs.len()).for_each(|action| _ = self.act(last, action));
    }

    /// Begins the next episode; some begin where the actor failed.
    fn begin(&mut self) -> Lane<'e, E> {
        let mut random = Stream::new(self.seed, self.episodes, Purpose::Reset, 0);
        self.episodes += 1;
        let again = !self.failures.is_empty() && random.chance(self.retried);
        let task = if again { random.pick(&self.failures).clone() } else { self.environment.draw(&mut random) };
        self.lane(task)
    }

    fn lane(&self, task: E::Task) -> Lane<'e, E> {
        Lane { rollout: Rollout::new(self.environment, &task), task, actions: Vec::new() }
    }

    /// Writes the actor's inputs in a lane.
    pub(crate) fn observe(&mut self, lane: usize, inputs: &mut [f32]) {
        self.environment.observe(self.lanes[lane].rollout.episode_mut(), SourceSet::ALL, inputs);
        self.interface.scale(inputs);
    }

    /// Takes an action in a lane, for as long as a decision lasts; the reward is the discounted sum. The episode stays as it
    /// ended; see [`renew`](Self::renew).
    pub(crate) fn act(&mut self, lane: usize, action: &[f32]) -> Step {
        let lane = &mut self.lanes[lane];
        let values = self.interface.values(action.iter().copied());
        lane.actions.extend_from_slice(action);
        let (mut reward, mut whole) = (0.0, Step { reward: 0.0, repeats: 0, end: None });
        for _ in 0..self.lasts {
            let step = lane.rollout.step(Act::Values(&values));
            reward += libm::powf(self.discount, whole.repeats as f32) * step.reward as f32;
            whole.repeats += step.repeats;
            whole.end = step.end;
            if whole.end.is_some() {
                break;
            }
        }
        Step { reward: reward.into(), ..whole }
    }

    /// Begins the next episode in a lane.
    pub(crate) fn renew(&mut self, lane: usize) {
        self.lanes[lane] = self.begin();
    }
}

#[cfg(test)]
mod tests {
    use super::TrainingLanes;
    use crate::configuration::Configuration as _;
    use crate::sac::config::SacConfig;
    use crate::sac::interface::Interface;
    use tpg_problems::Pendulum;

    #[test]
    fn an_episode_that_reaches_the_limit_is_truncated_and_one_resumed_goes_on_as_it_was() {
        let config = SacConfig::preset("general").expect("a preset");
        let interface = Interface::new(&Pendulum, true).expect("a torque");
        let mut lanes = TrainingLanes::new(&Pendulum, interface.clone(), &config, 5);
        for action in 0..199 {
            assert_eq!(lanes.act(0, &[(action as f32).sin()]).end, None);
        }
        let mut again = TrainingLanes::new(&Pendulum, interface, &config, 5);
        again.lanes.clear();
        again.resume(lanes.lanes[0].task, &lanes.lanes[0].actions);
        let (mut here, mut there) = ([0.0; 3], [0.0; 3]);
        lanes.observe(0, &mut here);
        again.observe(0, &mut there);
        assert_eq!(here, there);
        let last = [lanes.act(0, &[0.5]), again.act(0, &[0.5])];
        assert_eq!(last[0], last[1]);
        assert!(last[0].end.is_some_and(|end| end.truncated));
        let task = lanes.lanes[0].task;
        lanes.renew(0);
        assert!(lanes.lanes[0].task != task && lanes.lanes[0].actions.is_empty());
    }

    #[test]
    fn a_decision_that_lasts_pays_the_discounted_sum_and_ends_at_the_limit() {
        let mut config = SacConfig::preset("general").expect("a preset");
        config.learning.discount = 0.5;
        let interface = Interface::new(&Pendulum, true).expect("a torque");
        let mut single = TrainingLanes::new(&Pendulum, interface.clone(), &config, 5);
        config.learning.decision_lasts = 3;
        let mut lasting = TrainingLanes::new(&Pendulum, interface, &config, 5);
        let [a, b, c] = [0, 1, 2].map(|_| single.act(0, &[0.5]).reward as f32);
        let whole = lasting.act(0, &[0.5]);
        assert_eq!((whole.reward as f32, whole.repeats, whole.end), (a + 0.5 * b + 0.25 * c, 3, None));
        // 200 actions are 66 decisions and two actions.
        let last = (1..67).map(|_| lasting.act(0, &[0.5])).last().expect("some");
        assert!(last.repeats == 2 && last.end.is_some_and(|end| end.truncated), "{last:?}");
    }
}
