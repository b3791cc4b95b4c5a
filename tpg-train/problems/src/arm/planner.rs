//! Classical baselines: controllers that use the arm's inverse kinematics and learn nothing.

use crate::arm::evaluation::run;
use crate::arm::targets::{TOLERANCE, Task};
use crate::arm::{ArmProblem, ik};
use std::cell::RefCell;
use tpg_arm::dodge::plan::straight;
use tpg_arm::kinematics::{self, Plane};
use tpg_arm::observation::{Observation, Straight};
use tpg_arm::{Arm, JOINTS, Move, Pose};
use tpg_engine::EpisodeResult;
use tpg_runtime::policy::Policy;

/// Rule for choosing among the poses that solve a task.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Choice {
    /// The nearest pose, ignoring obstacles.
    Nearest,
    /// The nearest pose reachable by a straight walk without a collision; else the nearest reachable by moving one
    /// joint after another, in any order of the joints; else the nearest.
    NearestFree,
}

/// Names of the controllers for [`controlled`]: the planner by either rule, and straight to the stance, which fits a
/// microcontroller.
pub(crate) const CONTROLLERS: [&str; 3] = ["planner", "nearest-goal", "closed-form"];

/// Lets a controller do tasks; `None` if there is none of that name.
pub fn controlled(name: &str, arm: &Arm<f64>, problem: &ArmProblem, tasks: &[Task]) -> Option<Vec<EpisodeResult>> {
    let planned = |choice| run(arm, &Planner::within(arm, choice, problem.tolerance), problem, tasks);
    match name {
        "planner" => Some(planned(Choice::NearestFree)),
        "nearest-goal" => Some(planned(Choice::Nearest)),
        "closed-form" => Some(run(arm, &Straight::new(arm), problem, tasks)),
        _ => None,
    }
}

/// Walks to a pose that solves the task, choosing again at every step. Memoryless: its cache depends only on the
/// target.
#[derive(Debug)]
pub struct Planner<'a> {
    arm: &'a Arm<f64>,
    choice: Choice,
    tolerance: f64,
    /// The last target, and the poses that solve it.
    solved: RefCell<([f64; 3], Vec<Pose>)>,
}

/// Number of pitches of the hand that are tried where [`ik::PITCHES`] find no pose.
const FINE_PITCHES: u32 = 2880;

impl<'a> Planner<'a> {
    /// Creates a planner for an arm, and the paper's tolerance.
    pub fn new(arm: &'a Arm<f64>, choice: Choice) -> Self {
        Self::within(arm, choice, TOLERANCE)
    }

    /// Creates a planner for an arm whose hand must come nearer to its target than so many mm.
    pub fn within(arm: &'a Arm<f64>, choice: Choice, tolerance: f64) -> Self {
        Self { arm, choice, tolerance, solved: RefCell::new(([f64::NAN; 3], Vec::new())) }
    }

    fn solve(&self, target: [f64; 3]) -> Vec<Pose> {
        let reaches = |pose: &Pose| {
            // Slightly below the tolerance: episodes may run in single precision.
            kinematics::distance(kinematics::hand(self.arm, *pose), target) < 0.95 * self.tolerance
        };
        let solve = |pitches| -> Vec<Pose> {
            ik::goals_of_pitches(self.arm, target, pitches).into_iter().filter(reaches).collect()
        };
        let goals = solve(ik::PITCHES);
        if goals.is_empty() { solve(FINE_PITCHES) } else { goals }
    }

    /// True if a walk from `pose` to `goal` has only valid steps. (It stays within the ranges because both ends do.)
    fn free(&self, mut pose: Pose, goal: Pose, walk: PlannedWalk) -> bool {
        while pose != goal {
            let Move(deltas) = walk.step(pose, goal);
            pose = Pose(std::array::from_fn(|joint| pose.0[joint] + i16::from(deltas[joint])));
            if Plane::at(self.arm, pose).collision(&self.arm.shapes).is_some() {
                return false;
            }
        }
        true
    }

    /// Returns the first step of the first free walk to one of `goals`.
    fn free_step(&self, pose: Pose, goals: &[Pose]) -> Option<Move> {
        let straight = nearest_first(pose, goals).map(|goal| (goal, PlannedWalk::Straight));
        let in_order =
            nearest_first(pose, goals).flat_map(|goal| orders().map(move |order| (goal, PlannedWalk::InOrder(order))));
        let mut walks = straight.chain(in_order);
        walks.find(|&(goal, walk)| self.free(pose, goal, walk)).map(|(goal, walk)| walk.step(pose, goal))
    }
}

/// A way to walk between two poses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum PlannedWalk {
    /// All motors move at once, up to three ticks per step, until each has arrived.
    Straight,
    /// One motor moves after another.
    InOrder([usize; JOINTS]),
}

impl PlannedWalk {
    fn step(self, pose: Pose, goal: Pose) -> Move {
        let all = straight(pose, goal);
        let Self::InOrder(order) = self else { return all };
        let next = order.into_iter().find(|&joint| all.0[joint] != 0);
        Move(std::array::from_fn(|joint| if Some(joint) == next { all.0[joint] } else { 0 }))
    }
}

/// Returns the 24 orders of four joints.
fn orders() -> impl Iterator<Item = [usize; JOINTS]> {
    (0..JOINTS.pow(JOINTS as u32)).filter_map(|code| {
        let order: [usize; JOINTS] = std::array::from_fn(|place| code / JOINTS.pow(place as u32) % JOINTS);
        (0..JOINTS).all(|joint| order.contains(&joint)).then_some(order)
    })
}

/// Returns the goals, the one that costs least first. Each is found when it is asked for: most often one is enough.
fn nearest_first(pose: Pose, goals: &[Pose]) -> impl Iterator<Item = Pose> {
    let mut left = goals.to_vec();
    std::iter::from_fn(move || {
        let nearest = (0..left.len()).min_by_key(|&place| (ik::walk_length(pose.0, left[place].0), left[place]))?;
        Some(left.swap_remove(nearest))
    })
}

impl Policy for Planner<'_> {
    type State = Observation<f64>;
    type Action = Move;

    fn decide(&self, seen: &Observation<f64>) -> Move {
        let mut solved = self.solved.borrow_mut();
        if solved.0 != seen.target {
            *solved = (seen.target, self.solve(seen.target));
        }
        let goals = &solved.1;
        let nearest = || nearest_first(seen.pose, goals).next().map(|goal| PlannedWalk::Straight.step(seen.pose, goal));
        let step = match self.choice {
            Choice::Nearest => nearest(),
            Choice::NearestFree => self.free_step(seen.pose, goals).or_else(nearest),
        };
        step.unwrap_or(Move::STOP)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arm::evaluation::ReachStatistics;
    use crate::arm::targets::{Set, Start, tasks};
    use tpg_arm::WIDOWX;
    use tpg_arm::observation::Straight;

    #[test]
    fn there_are_as_many_orders_as_permutations() {
        let all: std::collections::BTreeSet<_> = orders().collect();
        assert_eq!((orders().count(), all.len()), (24, 24));
    }

    #[test]
    fn planning_solves_nearly_everything_and_looking_ahead_helps() {
        for start in [Start::Fs, Start::Rs] {
            let tasks = tasks(&WIDOWX, 4, Set::Validation, start, 100);
            let rate = |endings: Vec<_>| ReachStatistics::new(&endings).success_rate;
            let success = |choice| rate(run(&WIDOWX, &Planner::new(&WIDOWX, choice), &start.into(), &tasks));
            let (nearest, free) = (success(Choice::Nearest), success(Choice::NearestFree));
            assert!(free >= 0.97 && free >= nearest && nearest >= 0.9, "{start:?}: {nearest} {free}");
            // The variant that fits a microcontroller looks at only four poses.
            let stance = rate(run(&WIDOWX, &Straight::new(&WIDOWX), &start.into(), &tasks));
            assert!(nearest >= stance && stance >= 0.85, "{start:?}: {stance}");
        }
    }
}
