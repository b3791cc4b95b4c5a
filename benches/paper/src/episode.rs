//! Episodes by the rules of the paper's artifact (`armlearn-wrapper`, `ArmLearnWrapper.cpp`, `doActions`).
//!
//! They differ from the project's own episodes ([`tpg_arm::episode`]): a repeated pose ends the episode only after one
//! more action, the start does not count as visited, and only the hand's final distance decides about success, whatever
//! ended the episode.

use super::chain::Chain;
use super::plane;
use serde::{Deserialize, Deserializer};
use std::collections::HashSet;
use tpg_arm::kinematics::Vector;
use tpg_arm::observation::Observation;
use tpg_arm::{Move, Pose};

/// Score for each remaining action when the target is reached (`coefRewardMultiplication`).
const SCORE_PER_ACTION_LEFT: f64 = 0.01;
/// Score for reaching the target (`bonusSuccess`, which the paper omits).
const SCORE_FOR_SUCCESS: f64 = 10.0;

/// Rules common to all episodes of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rules {
    /// Maximum number of actions.
    pub max_actions: u32,
    /// Distance below which the hand has reached its target, mm.
    pub tolerance: f64,
}

/// End of an episode, in the numbers recorded by the artifact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
pub struct EndState {
    /// 1000 · score, truncated.
    pub score_x1000: i64,
    /// Final distance between hand and target in µm, truncated.
    pub distance_um: i64,
    /// True if the hand ended at its target.
    #[serde(deserialize_with = "flag")]
    pub success: bool,
    /// True if the last action was invalid.
    #[serde(deserialize_with = "flag")]
    pub collision: bool,
    /// Number of actions.
    #[serde(rename = "nb_actions")]
    pub actions: u32,
}

/// Reads 0 or 1.
fn flag<'de, D: Deserializer<'de>>(number: D) -> Result<bool, D::Error> {
    Ok(u8::deserialize(number)? == 1)
}

/// A running episode.
#[derive(Clone, Debug)]
pub struct Episode<'a> {
    chain: &'a Chain,
    rules: Rules,
    observation: Observation<f64>,
    visited: HashSet<Pose>,
    actions: u32,
    moving: bool,
    cycling: bool,
    collided: bool,
}

impl<'a> Episode<'a> {
    /// Starts an episode.
    pub fn new(chain: &'a Chain, rules: Rules, start: Pose, target: Vector<f64>) -> Self {
        Self {
            chain,
            rules,
            observation: Observation::new(chain.arm(), start, chain.hand(start), target),
            visited: HashSet::new(),
            actions: 0,
            moving: true,
            cycling: false,
            collided: false,
        }
    }

    /// Returns the current observation of the policy.
    pub fn observation(&self) -> &Observation<f64> {
        &self.observation
    }

    /// Takes one action; returns true if it was the last one.
    pub fn advance(&mut self, wanted: Move) -> bool {
        let arm = self.chain.arm();
        let step = arm.step_with(self.observation.pose, wanted, |pose| plane::collision(arm, pose));
        self.collided = step.invalid.is_some();
        self.moving = wanted != Move::STOP && !self.collided;
        self.observation = Observation::new(arm, step.pose, self.chain.hand(step.pose), self.observation.target);
        self.actions += 1;
        let over = !self.moving || self.cycling || self.succeeded() || self.actions >= self.rules.max_actions;
        // Detected only now: the action after the one that closes the cycle is still executed.
        self.cycling |= !self.visited.insert(step.pose);
        over
    }

    fn succeeded(&self) -> bool {
        self.observation.distance() < self.rules.tolerance
    }

    /// Returns the current end state.
    pub fn end_state(&self) -> EndState {
        self.rules.end(self.observation.distance(), self.collided, self.actions)
    }
}

impl Rules {
    /// Returns the end state of an episode with the given final distance, mm, and number of actions.
    pub fn end(self, distance: f64, collision: bool, actions: u32) -> EndState {
        let success = distance < self.tolerance;
        let left = f64::from(self.max_actions) - f64::from(actions);
        let score = if success { left * SCORE_PER_ACTION_LEFT + SCORE_FOR_SUCCESS } else { -distance };
        EndState::new(score, distance, success, collision, actions)
    }
}

impl EndState {
    /// Returns the end of an episode with the given final distance, mm, in the artifact's numbers.
    pub fn new(score: f64, distance: f64, success: bool, collision: bool, actions: u32) -> Self {
        // Multiplied by 1000, then truncated towards zero.
        let thousandths = |value: f64| (1000.0 * value) as i64;
        Self { score_x1000: thousandths(score), distance_um: thousandths(distance), success, collision, actions }
    }
}

#[cfg(test)]
mod tests {
    use super::{EndState, Episode, Rules};
    use crate::chain::Chain;
    use tpg_arm::{Joint, Move, WIDOWX};

    const RULES: Rules = Rules { max_actions: 1710, tolerance: 3.0 };
    const FAR: [f64; 3] = [0.0, 0.0, 1000.0];

    fn forwards(joint: u8) -> Move {
        Move::single(Joint(joint), 3)
    }

    fn backwards(joint: u8) -> Move {
        Move::single(Joint(joint), -3)
    }

    /// Takes actions from `moves` until the episode is over.
    fn run(rules: Rules, target: [f64; 3], moves: impl IntoIterator<Item = Move>) -> EndState {
        let chain = Chain::new(WIDOWX);
        let mut episode = Episode::new(&chain, rules, WIDOWX.home, target);
        assert!(moves.into_iter().any(|wanted| episode.advance(wanted)), "the episode is not over");
        episode.end_state()
    }

    #[test]
    fn stopping_ends_it_and_counts() {
        let end = run(RULES, FAR, [forwards(0), Move::STOP]);
        assert_eq!((end.actions, end.success, end.collision), (2, false, false));
        assert_eq!(end.score_x1000, -end.distance_um);
    }

    #[test]
    fn a_joint_limit_ends_it_as_a_collision() {
        // 682 steps of 3 ticks lead from 2048 to 4094 exactly; the next one is refused.
        let end = run(RULES, FAR, std::iter::repeat(forwards(0)));
        assert_eq!((end.actions, end.collision), (683, true));
    }

    #[test]
    fn a_repeat_allows_one_more_action_and_the_start_is_not_remembered() {
        // Back to the start (not remembered), away to the first pose (a repeat), and one more.
        let moves = [forwards(0), backwards(0)].into_iter().cycle();
        assert_eq!(run(RULES, FAR, moves).actions, 4);
    }

    #[test]
    fn time_runs_out() {
        let end = run(Rules { max_actions: 5, ..RULES }, FAR, std::iter::repeat(forwards(0)));
        assert_eq!((end.actions, end.success), (5, false));
    }

    #[test]
    fn a_success_scores_the_actions_left() {
        // The target lies 3.1 mm aside of the hand, and a step of the base moves it by 1.6 mm.
        let end = run(RULES, [-3.1, 346.0, 267.0], [forwards(0)]);
        assert_eq!((end.actions, end.success, end.score_x1000), (1, true, 27_090));
    }
}
