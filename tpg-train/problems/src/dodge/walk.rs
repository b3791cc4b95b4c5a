//! Walks on a plan of any number of legs, checked step by step: how certificates are found and replayed.

use super::BODY;
use crate::arm::ik;
use tpg_arm::dodge::plan::{steps, straight};
use tpg_arm::frame::Clearance;
use tpg_arm::kinematics::{Vector, distance};
use tpg_arm::{JOINTS, Move, Pose, WIDOWX};
use tpg_engine::random::Stream;

/// Most goals of a scene.
pub const GOALS: usize = 4;

/// A leg of a plan: a pose to walk to, and the steps to wait there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Leg {
    /// The pose.
    pub to: Pose,
    /// The steps.
    pub wait: u16,
}

/// Follows legs for at most `limit` steps and returns the steps to the end of the last one; `None` where the table, the base or the
/// limit ends the walk, or a ball nearer than the margin. `clearance` is asked for the least clearance of a posture at a step, mm.
pub fn follow(
    from: Pose,
    legs: &[Leg],
    limit: u32,
    margin: f32,
    mut clearance: impl FnMut(&tpg_arm::dodge::Posture, u32) -> f32,
) -> Option<u32> {
    let (mut pose, mut time) = (from, 0);
    let mut posture = BODY.at(pose);
    for leg in legs {
        let mut waited = 0;
        loop {
            if time >= limit {
                return None;
            }
            if pose == leg.to {
                if waited >= leg.wait {
                    break;
                }
                waited += 1;
            } else {
                pose = moved(pose, straight(pose, leg.to));
                posture = BODY.at(pose);
                if !BODY.is_free(&posture) {
                    return None;
                }
            }
            time += 1;
            if clearance(&posture, time) < margin {
                return None;
            }
        }
    }
    Some(time)
}

/// Adds a move to a pose.
pub fn moved(pose: Pose, by: Move) -> Pose {
    let mut moved = pose;
    for (ticks, by) in moved.0.iter_mut().zip(by.0) {
        *ticks = ticks.saturating_add(by.into());
    }
    moved
}

/// Draws the `index`-th try to get from a pose to one of several goals: six waits first, then one or two poses beside the
/// straight way.
pub fn candidate(index: usize, from: Pose, goals: &[Pose], random: &mut Stream) -> Vec<Leg> {
    const WAITS: [u16; 6] = [0, 30, 60, 120, 200, 320];
    const SPREADS: [f64; 4] = [60.0, 150.0, 350.0, 700.0];
    let fixed = WAITS.get(index);
    let goal = if fixed.is_some() || goals.len() == 1 || random.chance(0.5) { goals[0] } else { *random.pick(goals) };
    let last = Leg { to: goal, wait: 0 };
    match fixed {
        Some(0) => return vec![last],
        Some(&wait) => return vec![Leg { to: from, wait }, last],
        None => {}
    }
    let mut legs = Vec::new();
    for _ in 0..if random.chance(0.3) { 2 } else { 1 } {
        let along = random.unit() * 1.2 - 0.1;
        let spread = SPREADS[random.below(4)];
        let to = std::array::from_fn(|joint| {
            let (from, goal, range) = (f64::from(from.0[joint]), f64::from(goal.0[joint]), WIDOWX.ranges[joint]);
            let ticks = from + along * (goal - from) + spread * random.normal();
            (ticks as i16).clamp(range.min, range.max)
        });
        let wait = if random.chance(0.5) { 0 } else { random.below(200) as u16 };
        legs.push(Leg { to: Pose(to), wait });
    }
    legs.push(last);
    legs
}

/// Returns every pose that solves a task, the one that takes fewest steps first: inverse kinematics for 144 pitches,
/// within 2.7 mm of the target, clear of table and base.
pub(crate) fn solutions(target: Vector<f32>, start: [i16; JOINTS]) -> Vec<Pose> {
    let free = |pose: Pose| {
        let posture = BODY.at(pose);
        let Clearance { hand, forearm } = Clearance::new(&posture.plane(), &BODY.arm.shapes);
        BODY.is_free(&posture) && hand > 0.0 && forearm > 0.0 && distance(posture.hand(), target) < 2.7
    };
    let mut poses: Vec<Pose> =
        ik::goals(&WIDOWX, target.map(f64::from)).into_iter().filter(|&pose| free(pose)).collect();
    poses.sort_by_key(|pose| ik::walk_length(start, pose.0));
    poses
}

/// Returns at most [`GOALS`] goals: the first, then whichever solution is furthest from those chosen, among those that take
/// at most 100 steps more than the first.
pub(crate) fn stances(start: Pose, first: Pose, solutions: &[Pose]) -> Vec<Pose> {
    let near = steps(start, first) + 100;
    let candidates: Vec<Pose> = solutions.iter().copied().filter(|&pose| steps(start, pose) <= near).collect();
    let mut chosen = vec![first];
    while chosen.len() < GOALS {
        let apart = |pose: &Pose| chosen.iter().map(|other| steps(*pose, *other)).min().unwrap_or(0);
        // The first of equals: the order of the solutions is fixed.
        let furthest = candidates.iter().rev().max_by_key(|pose| apart(pose)).filter(|pose| apart(pose) > 20);
        let Some(&furthest) = furthest else { break };
        chosen.push(furthest);
    }
    chosen
}
