//! The paper's trained actors, replayed: stochastic episodes whose noise comes from PyTorch's generator, seeded with the
//! row's number.

use super::actor::RecordedActor;
use super::chain::Chain;
use super::data::{ByRow, Task};
use super::episode::{EndState, Rules};
use super::plane;
use super::replay::Done;
use super::torch_random::TorchRandom;
use tpg_arm::observation::Observation;

/// Reward of the step that reaches the target (`bonusSuccess` of the SAC runs).
const REWARD_FOR_SUCCESS: f64 = 100.0;
/// Reward of an invalid step.
const REWARD_FOR_COLLISION: f64 = -10.0;
/// Factor of the distance in the reward of every other step.
const REWARD_PER_MM: f64 = -0.1;

/// Runs all tasks with an actor; `is_strict` lets an invalid action end an episode.
pub fn run(chain: &Chain, rules: Rules, is_strict: bool, tasks: &ByRow<Task>, actor: &RecordedActor) -> ByRow<Done> {
    tasks.iter().map(|(&row, task)| (row, episode(chain, rules, is_strict, row, task, actor))).collect()
}

fn episode(chain: &Chain, rules: Rules, is_strict: bool, row: u32, task: &Task, actor: &RecordedActor) -> Done {
    let arm = chain.arm();
    let mut random = TorchRandom::new(row.into());
    let mut seen = Observation::new(arm, task.start, chain.hand(task.start), task.target);
    let (mut poses, mut score) = (Vec::new(), 0.0f64);
    loop {
        let wanted = actor.act(&seen, &mut random);
        let step = arm.step_with(seen.pose, wanted, |pose| plane::collision(arm, pose));
        seen = Observation::new(arm, step.pose, chain.hand(step.pose), task.target);
        poses.push(step.pose);
        let (distance, collision) = (seen.distance(), step.invalid.is_some());
        let success = distance < rules.tolerance;
        score += match (success, collision) {
            (true, _) => REWARD_FOR_SUCCESS,
            (false, false) => REWARD_PER_MM * distance,
            (false, true) if is_strict => REWARD_FOR_COLLISION,
            (false, true) => REWARD_PER_MM * distance + REWARD_FOR_COLLISION,
        };
        let actions = poses.len() as u32;
        if success || (collision && is_strict) || actions >= rules.max_actions {
            return Done { poses, end: EndState::new(score, distance, success, collision, actions) };
        }
    }
}
