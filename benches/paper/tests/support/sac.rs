//! The paper's trained actors, replayed: stochastic episodes whose noise comes from PyTorch's generator, seeded with the
//! row's number.

use super::torch_random::TorchRandom;
use tpg_arm::Move;
use tpg_arm::observation::Observation;
use tpg_paper::actor::RecordedActor;
use tpg_paper::chain::Chain;
use tpg_paper::data::{ByRow, Task};
use tpg_paper::episode::{EndState, Rules};
use tpg_paper::plane;
use tpg_paper::replay::Done;
use tpg_problems::arm::targets::Start;

/// Reward of the step that reaches the target (`bonusSuccess` of the SAC runs).
const REWARD_FOR_SUCCESS: f64 = 100.0;
/// Reward of an invalid step.
const REWARD_FOR_COLLISION: f64 = -10.0;
/// Factor of the distance in the reward of every other step.
const REWARD_PER_MM: f64 = -0.1;

/// The most actions of a recorded episode.
pub(crate) const fn max_actions(start: Start) -> u32 {
    match start {
        Start::Fs => 1000,
        Start::Rs => 2000,
    }
}

/// Runs all tasks with an actor; `is_strict` lets an invalid action end an episode.
pub(crate) fn run(
    chain: &Chain,
    rules: Rules,
    is_strict: bool,
    tasks: &ByRow<Task>,
    actor: &RecordedActor,
) -> ByRow<Done> {
    tasks.iter().map(|(&row, task)| (row, episode(chain, rules, is_strict, row, task, actor))).collect()
}

/// Samples an action as a move: tanh(µ + σ·ε), in steps of three ticks, halves rounded to even.
pub(crate) fn act(actor: &RecordedActor, seen: &Observation<f64>, random: &mut TorchRandom) -> Move {
    let (mean, spread) = actor.forward(&actor.state(seen));
    Move(std::array::from_fn(|joint| {
        let action = (random.normal() * spread[joint] + mean[joint]).tanh();
        // An action of exactly ±1 gives two steps, as in the artifact.
        3 * (action * 3.0 / 2.0).round_ties_even() as i8
    }))
}

fn episode(chain: &Chain, rules: Rules, is_strict: bool, row: u32, task: &Task, actor: &RecordedActor) -> Done {
    let arm = chain.arm();
    let mut random = TorchRandom::new(row.into());
    let mut seen = Observation::new(arm, task.start, chain.hand(task.start), task.target);
    let (mut poses, mut score) = (Vec::new(), 0.0f64);
    loop {
        let wanted = act(actor, &seen, &mut random);
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
