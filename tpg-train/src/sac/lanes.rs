//! The arm in parallel lanes: episodes that never stop beginning, and what each decision earns.

use super::config::{Config, Inputs, Retry, Reward};
use super::failures::Failures;
use super::policy::ActorPolicy;
use super::replay::ACTIONS;
use tpg_arm::frame::Frame;
use tpg_arm::kinematics;
use tpg_arm::sac::{Actions, Decision, FEATURES, TRAINED_COARSE, TRAINED_FINE, features};
use tpg_arm::{Arm, Move, Pose, WIDOWX};
use tpg_engine::random::{Purpose, Stream};
use tpg_problems::arm::ik;
use tpg_problems::arm::targets::{Reach, Start};

/// The arm that policies are trained on, in the precision they run in.
pub const ARM: Arm<f32> = WIDOWX.to_f32();

impl Inputs {
    /// How many values an actor sees.
    pub fn count(self) -> usize {
        match self {
            Self::Features => FEATURES,
            Self::PaperFs | Self::PaperRs => 13,
        }
    }

    /// Writes what an actor sees.
    ///
    /// # Panics
    /// If `values` has another length than [`count`](Self::count).
    pub fn observe(self, frame: &Frame<'_, f32>, values: &mut [f32]) {
        match self {
            Self::Features => values.copy_from_slice(&features(frame)),
            Self::PaperFs | Self::PaperRs => {
                let [base, others @ ..] = frame.pose().0.map(f32::from);
                let target = frame.target();
                let hand = frame.plane().hand_in_world(frame.base());
                let difference = kinematics::difference(target, hand);
                let pair = if self == Self::PaperFs { [difference, hand] } else { [hand, difference] };
                let lengths = [target, pair[0], pair[1]].into_iter().flatten().map(|mm| mm / 100.0);
                let motors = others.map(|ticks| ticks / 1024.0 - 2.0);
                let all = lengths.chain([base / 2048.0 - 1.0]).chain(motors);
                assert_eq!(values.len(), 13, "the paper's inputs");
                values.iter_mut().zip(all).for_each(|(slot, value)| *slot = value);
            }
        }
    }
}

/// The decision behind an actor, for either set of actions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Discretiser {
    /// −3..3.
    Fine(Decision<f32, 3>),
    /// −3, 0, 3.
    Coarse(Decision<f32, 1>),
}

impl Discretiser {
    /// The one a configuration asks for.
    pub fn new(actor: &super::config::Actor) -> Self {
        let (mask, may_rest) = (actor.mask, actor.may_rest);
        match actor.actions {
            Actions::Fine => Self::Fine(Decision { steps: TRAINED_FINE, mask, may_rest }),
            Actions::Coarse => Self::Coarse(Decision { steps: TRAINED_COARSE, mask, may_rest }),
        }
    }

    /// The move for preferences before the tanh.
    pub fn decide(&self, preferences: [f32; ACTIONS], pose: Pose) -> Move {
        match self {
            Self::Fine(decision) => decision.decide(preferences, pose, &ARM.ranges),
            Self::Coarse(decision) => decision.decide(preferences, pose, &ARM.ranges),
        }
    }
}

/// One episode under way.
#[derive(Clone, Debug, PartialEq)]
pub struct Lane {
    /// Where the arm is.
    pub pose: Pose,
    /// Where its hand shall go, mm.
    pub target: [f64; 3],
    /// Steps done.
    pub steps: u32,
    /// Poses that solve the task, for a reward that knows them.
    goals: Vec<[i16; ACTIONS]>,
    distance: f32,
    steps_to_goal: f32,
}

/// What a decision led to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Consequence {
    /// The reward.
    pub reward: f32,
    /// Steps that the decision was repeated for.
    pub steps: u32,
    /// How the episode stands.
    pub end: Option<End>,
}

/// Why a training episode is over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// The hand is at its target.
    Reached,
    /// An invalid step.
    Invalid,
    /// Cut off: no failure, the value of what would have come counts.
    Cut,
}

/// Episodes side by side.
#[derive(Clone, Debug)]
pub struct Lanes {
    seed: u64,
    reach: Reach,
    task: super::config::Task,
    reward: Reward,
    discretiser: Discretiser,
    /// The lanes.
    pub lanes: Vec<Lane>,
    /// Episodes ever begun.
    pub episodes: u64,
    /// Where some of the episodes begin again.
    pub failures: Failures,
    retried: f64,
}

impl Lanes {
    /// Begins an episode in each lane.
    pub fn new(config: &Config, seed: u64, reach: Reach) -> Self {
        let mut lanes = Self::empty(config, seed, reach, 0);
        for _ in 0..config.learning.lanes {
            let lane = lanes.begin();
            lanes.lanes.push(lane);
        }
        lanes
    }

    /// Continues from where lanes stood: pose, target and steps of each, and the episodes begun.
    pub fn resume(config: &Config, seed: u64, reach: Reach, episodes: u64, lanes: &[(Pose, [f64; 3], u32)]) -> Self {
        let mut resumed = Self::empty(config, seed, reach, episodes);
        for &(pose, target, steps) in lanes {
            let lane = resumed.lane(pose, target, steps);
            resumed.lanes.push(lane);
        }
        resumed
    }

    fn empty(config: &Config, seed: u64, reach: Reach, episodes: u64) -> Self {
        let discretiser = Discretiser::new(&config.actor);
        let retried = config.retry.map_or(0.0, |retry| retry.share);
        let (task, reward, failures) = (config.task, config.reward, Failures::default());
        Self { seed, reach, task, reward, discretiser, lanes: Vec::new(), episodes, failures, retried }
    }

    /// A new episode, in part of them where the actor failed. A target for which no goal is known, where the reward needs
    /// one, is drawn again.
    fn begin(&mut self) -> Lane {
        let mut random = Stream::new(self.seed, self.episodes, Purpose::Reset, 0);
        self.episodes += 1;
        if !self.failures.places.is_empty() && random.chance(self.retried) {
            let again = self.failures.draw(&mut random).map(|task| self.lane(task.start, task.target, 0));
            let hard = |lane: &Lane| self.can_begin(lane) && f64::from(lane.distance) > self.task.tolerance;
            if let Some(lane) = again.filter(hard) {
                return lane;
            }
        }
        let start = if random.chance(self.task.fixed_start_share) { Start::Fs } else { Start::Rs };
        loop {
            let task = self.reach.task(start, &mut random);
            let lane = self.lane(task.start, task.target, 0);
            if self.can_begin(&lane) {
                return lane;
            }
        }
    }

    /// Whether a goal is known where the reward needs one.
    fn can_begin(&self, lane: &Lane) -> bool {
        !(self.knows_goals() && lane.goals.is_empty())
    }

    /// Looks where a policy fails; `at` is how far the run has come.
    pub fn look_for_failures(&mut self, policy: &ActorPolicy<'_>, retry: &Retry, at: u64) {
        self.failures.look(policy, &self.reach, retry, self.seed, at);
    }

    fn knows_goals(&self) -> bool {
        self.reward.steps_to_goal != 0.0
    }

    fn lane(&self, pose: Pose, target: [f64; 3], steps: u32) -> Lane {
        let goals = if self.knows_goals() { ik::goals(&WIDOWX, target) } else { Vec::new() };
        let goals: Vec<[i16; ACTIONS]> = goals.into_iter().map(|pose| pose.0).collect();
        let distance = distance(pose, target);
        let steps_to_goal = steps_to_goal(pose, &goals);
        Lane { pose, target, steps, goals, distance, steps_to_goal }
    }

    /// What a lane's actor sees.
    pub fn observe(&self, lane: usize, inputs: Inputs, values: &mut [f32]) {
        let Lane { pose, target, .. } = &self.lanes[lane];
        inputs.observe(&Frame::at(&ARM, *pose, target.map(|mm| mm as f32)), values);
    }

    /// Lets a lane act on preferences (before the tanh). The episode stays as it ended; see [`renew`](Self::renew).
    pub fn act(&mut self, lane: usize, preferences: [f32; ACTIONS]) -> Consequence {
        let (task, reward) = (self.task, self.reward);
        let lane = &mut self.lanes[lane];
        let repeats = ((lane.distance / task.repeat_per_mm) as u32).clamp(1, task.repeat_most);
        let (distance_before, to_goal_before) = (lane.distance, lane.steps_to_goal);
        let (mut steps, mut end, mut invalid) = (0, None, false);
        while steps < repeats && end.is_none() {
            let wanted = self.discretiser.decide(preferences, lane.pose);
            let wanted = if task.step == 3 { wanted } else { Move(wanted.0.map(|ticks| ticks.signum() * task.step)) };
            let step = ARM.step(lane.pose, wanted);
            lane.pose = step.pose;
            lane.distance = distance(lane.pose, lane.target);
            steps += 1;
            lane.steps += 1;
            invalid = step.invalid.is_some();
            if invalid && task.invalid_ends {
                end = Some(End::Invalid);
            } else if f64::from(lane.distance) < task.tolerance {
                end = Some(End::Reached);
            } else if lane.steps >= task.max_steps {
                end = Some(End::Cut);
            }
        }
        lane.steps_to_goal = steps_to_goal(lane.pose, &lane.goals);
        let remaining = if matches!(end, Some(End::Reached | End::Invalid)) { 0.0 } else { lane.distance };
        let earned = reward.step * steps as f32
            + reward.log_distance * libm::logf((distance_before + 3.0) / (lane.distance + 3.0))
            + reward.distance * (distance_before - lane.distance)
            + reward.steps_to_goal * (to_goal_before - lane.steps_to_goal)
            + reward.remaining_distance * remaining
            + if end == Some(End::Reached) { reward.success } else { 0.0 }
            + if invalid { reward.invalid } else { 0.0 };
        Consequence { reward: reward.scale * earned, steps, end }
    }

    /// Begins the next episode in a lane.
    pub fn renew(&mut self, lane: usize) {
        self.lanes[lane] = self.begin();
    }
}

fn distance(pose: Pose, target: [f64; 3]) -> f32 {
    kinematics::distance(kinematics::hand(&ARM, pose), target.map(|mm| mm as f32))
}

/// The steps to the nearest goal with all motors moving at once: (max + 0.02 Σ of the ticks to go)/3, at most 1000.
fn steps_to_goal(pose: Pose, goals: &[[i16; ACTIONS]]) -> f32 {
    // In hundredths of a tick: whole numbers, which compilers put into vectors.
    let cost = |goal: &[i16; ACTIONS]| {
        let [a, b, c, d] = std::array::from_fn(|joint| i32::from((pose.0[joint] - goal[joint]).abs()));
        100 * a.max(b).max(c.max(d)) + 2 * (a + b + c + d)
    };
    let least = goals.iter().map(cost).min().unwrap_or(0);
    (least as f32 / 300.0).min(1000.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sac::config::Config;
    use tpg_problems::arm::targets::Set;

    #[test]
    fn training_moves_by_the_step_of_its_task() {
        for (preset, ticks) in [("paper-fs", 3), ("paper-rs", 5)] {
            let config = Config::preset(preset).expect("a preset");
            let mut lanes = Lanes::new(&config, 1, Reach::sample(&WIDOWX, 1, Set::Training));
            let before = lanes.lanes[0].pose;
            lanes.act(0, [0.3, -0.4, 0.0, 5.0]); // under a third after the tanh; above; zero; above
            let moved: Vec<i16> =
                lanes.lanes[0].pose.0.iter().zip(before.0).map(|(after, before)| after - before).collect();
            assert_eq!(moved, [0, -ticks, 0, ticks], "{preset}");
        }
    }
}
