//! Where the actor as it stands fails: training episodes begin there again.
//!
//! Failures are rare, so episodes drawn at random hardly ever show them; and most are cycles, which the noise of training
//! leaves and the actor without noise does not: the critics hardly see what is wrong with them. Now and then the actor
//! is put to fresh training tasks, as it decides outside of training, and three places of each failed episode are remembered:
//! its start, its middle and the last place but one (in a cycle: within it; before an invalid action: just before).

use super::config::Retry;
use super::policy::ActorPolicy;
use tpg_arm::Pose;
use tpg_arm::episode::Outcome;
use tpg_engine::random::{Purpose, Stream};
use tpg_problems::arm::targets::{Reach, Start, Task};

/// The places of the latest failures, oldest first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Failures {
    /// Where to begin, and where the hand shall go.
    pub places: Vec<Task>,
}

impl Failures {
    /// Puts a policy to fresh tasks and remembers where it fails. `at` tells one search of a run from another.
    pub fn look(&mut self, policy: &ActorPolicy<'_>, reach: &Reach, retry: &Retry, seed: u64, at: u64) {
        let mut random = Stream::new(seed, at, Purpose::Retry, 0);
        for (start, count) in [(Start::Rs, retry.random_starts), (Start::Fs, retry.fixed_starts)] {
            for place in 0..count {
                let task = reach.task(start, &mut random);
                let mut poses = vec![task.start];
                let summary = policy.watch(start, place, &task, |pose| poses.push(pose));
                if summary.outcome != Outcome::Reached {
                    self.remember(&poses, task.target);
                }
            }
        }
        let most = self.places.len().saturating_sub(retry.remembered);
        self.places.drain(..most);
    }

    fn remember(&mut self, poses: &[Pose], target: [f64; 3]) {
        let last = poses.len() - 1;
        let mut places = vec![0, last / 2, last.saturating_sub(1)];
        places.dedup();
        self.places.extend(places.into_iter().map(|place| Task { start: poses[place], target }));
    }

    /// One of the places; `None` where there is none.
    pub fn draw(&self, random: &mut Stream) -> Option<Task> {
        (!self.places.is_empty()).then(|| *random.pick(&self.places))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sac::config::Config;
    use crate::sac::lanes::Lanes;
    use tpg_arm::WIDOWX;
    use tpg_nn::{Mlp, Shape};
    use tpg_problems::arm::targets::Set;

    const RETRY: Retry = Retry { share: 1.0, every: 1, fixed_starts: 5, random_starts: 9, remembered: 20 };

    /// What two looks at a network that has learned nothing find.
    fn found(config: &Config, reach: &Reach) -> Failures {
        let shape = Shape { inputs: config.actor.inputs.count(), hidden: vec![8], outputs: 8, norm: false };
        let mut random = Stream::new(3, 0, Purpose::Test, 0);
        let network = Mlp::random(shape, || random.unit());
        let policy = ActorPolicy::new(&network, &config.actor);
        let mut failures = Failures::default();
        for at in [100, 200] {
            failures.look(&policy, reach, &RETRY, 7, at);
            for Task { start, target } in &failures.places {
                // Whoever begins there fails again: an actor has no memory.
                let task = Task { start: *start, target: *target };
                assert_ne!(policy.watch(Start::Rs, 0, &task, |_pose| ()).outcome, Outcome::Reached);
            }
        }
        failures
    }

    #[test]
    fn the_latest_failures_are_remembered_and_episodes_begin_there() {
        let mut config = Config::preset("best-rs").expect("a preset");
        config.retry = Some(RETRY);
        let reach = Reach::sample(&WIDOWX, 7, Set::Training);
        let failures = found(&config, &reach);
        assert_eq!(
            failures.places.len(),
            RETRY.remembered,
            "14 episodes fail twice, and leave up to three places each"
        );
        assert_eq!(failures, found(&config, &reach));

        let mut lanes = Lanes::new(&config, 7, reach);
        let begins = |lanes: &Lanes, lane: usize| {
            let begun = &lanes.lanes[lane];
            failures.places.contains(&Task { start: begun.pose, target: begun.target })
        };
        assert!((0..config.learning.lanes).all(|lane| !begins(&lanes, lane)), "no failure is known yet");
        lanes.failures = failures.clone();
        (0..config.learning.lanes).for_each(|lane| lanes.renew(lane));
        let again = (0..config.learning.lanes).filter(|&lane| begins(&lanes, lane)).count();
        assert!(again * 2 > config.learning.lanes, "all, but for targets that no goal is known for: {again}");
    }

    #[test]
    fn episodes_leave_their_start_middle_and_last_place_but_one() {
        let mut failures = Failures::default();
        let pose = |ticks| Pose([ticks, 0, 0, 0]);
        for (length, expected) in [(1, vec![0]), (2, vec![0]), (3, vec![0, 1]), (10, vec![0, 4, 8])] {
            failures.places.clear();
            failures.remember(&(0..length).map(pose).collect::<Vec<_>>(), [1.0, 2.0, 3.0]);
            let places: Vec<i16> = failures.places.iter().map(|task| task.start.0[0]).collect();
            assert_eq!(places, expected, "of {length}");
        }
    }
}
