//! Tasks: the start of the arm and the target of its hand.
//!
//! Targets are uniform in the reachable space, which is sampled: motor positions are drawn at a resolution of one tick,
//! poses that collide or are inside the base are rejected, and the others are sorted into cubes of 20 mm by the
//! position of the hand. A target is a uniformly chosen cube, then a uniformly chosen pose in it; random starts are
//! drawn in the same way. (The paper's own list of targets is not public; on a grid coarser than one tick a policy can
//! exploit the grid.)
//!
//! Training, validation and test tasks never share a random stream, for any seed: [`Purpose`](Set) is part of the
//! stream's key.

mod file;

pub use file::{parse_csv, read_csv, to_csv};

use serde::{Deserialize, Serialize};
use std::sync::{Arc, Mutex, PoisonError};
use tpg_arm::frame::Clearance;
use tpg_arm::kinematics::{self, Plane};
use tpg_arm::{Arm, Pose};
use tpg_engine::TaskSet;
use tpg_engine::random::{Purpose, Stream};

/// The edge of a cube, mm.
const CUBE: f64 = 20.0;
/// Maximum number of poses kept per cube, the first ones drawn.
const POSES_PER_CUBE: usize = 8;
/// Number of poses drawn to sample the reachable space: about 60 per cube.
const DRAWS: u32 = 2_000_000;
/// Number of samples that are kept.
const KEPT: usize = 4;

/// Purpose of a set of tasks. Sets with different purposes are independent for every seed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Set {
    /// Used for learning.
    Training = 1,
    /// Used to choose between policies.
    Validation = 2,
    /// Used for reports; never read in training or selection.
    Test = 3,
}

impl Set {
    /// Returns the set and the seed of the tasks that the engine asks for; `validation` is the seed of a problem's own.
    pub(super) fn asked(set: TaskSet, seed: u64, validation: u64) -> (Self, u64) {
        match set {
            TaskSet::Validation => (Self::Validation, validation),
            TaskSet::Study => (Self::Validation, seed),
            TaskSet::Calibration => (Self::Training, seed),
            TaskSet::Test => (Self::Test, seed),
        }
    }
}

/// Start of episodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
#[value(rename_all = "lowercase")]
pub enum Start {
    /// Fixed start: the arm's home.
    Fs,
    /// Random start.
    Rs,
}

impl Start {
    /// Returns the number of actions after which an episode ends.
    pub fn max_actions(self) -> u32 {
        match self {
            Self::Fs => 1707,
            Self::Rs => 3414,
        }
    }
}

/// The tolerance of the paper's problems, mm.
pub const TOLERANCE: f64 = 3.0;

/// One task.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Task {
    /// Start of the arm.
    pub start: Pose,
    /// Target of the hand, mm.
    pub target: [f64; 3],
}

/// A sample of the poses that an arm can take, evenly distributed over the positions of the hand.
#[derive(Clone, Debug)]
pub struct ReachableSpace {
    home: Pose,
    arm: Arm<f64>,
    poses: Vec<Pose>,
    /// Offset of each cube's poses in `poses`; one more than there are cubes.
    cubes: Vec<usize>,
}

impl ReachableSpace {
    /// Samples the arm's reachable space in less than a second.
    ///
    /// # Panics
    /// If the arm has no free pose.
    pub fn sample(arm: &Arm<f64>, seed: u64, set: Set) -> Self {
        let mut random = Stream::new(seed, set as u64, Purpose::Reach, 0);
        let links = &arm.links;
        let reach = links.upper_arm + links.elbow_offset + links.forearm + links.hand + links.shoulder_radial;
        let side = (2.0 * reach / CUBE) as usize + 2;
        let cube = |hand: [f64; 3]| {
            let index = |value: f64, low: f64| ((value - low) / CUBE) as usize;
            let [x, y, z] = hand;
            (index(x, -reach) * side + index(y, -reach)) * side + index(z, links.base - reach)
        };
        let mut found: Vec<(u32, u32, Pose)> = Vec::new();
        let mut counts = vec![0u8; side * side * side];
        for draw in 0..DRAWS {
            let pose = Pose(arm.ranges.map(|range| random.between(range.min.into(), range.max.into()) as i16));
            let plane = Plane::at(arm, pose);
            let cube = cube(plane.hand_in_world(kinematics::base_direction(pose)));
            // Most draws fall into a full cube: the collision test, which is the expensive one, comes second.
            if usize::from(counts[cube]) < POSES_PER_CUBE && stands_free(arm, &plane) {
                counts[cube] += 1;
                found.push((cube as u32, draw, pose));
            }
        }
        found.sort_unstable_by_key(|&(cube, draw, _)| (cube, draw));
        let starts = (0..found.len()).filter(|&i| i == 0 || found[i].0 != found[i - 1].0);
        let cubes: Vec<usize> = starts.chain([found.len()]).collect();
        assert!(cubes.len() > 1, "the arm has no free pose");
        Self { home: arm.home, arm: *arm, poses: found.into_iter().map(|(.., pose)| pose).collect(), cubes }
    }

    /// Returns the [sample](Self::sample) of an arm, drawn once in this process.
    pub fn shared(arm: &Arm<f64>, seed: u64, set: Set) -> Arc<Self> {
        static DRAWN: Mutex<Vec<(u64, Set, Arc<ReachableSpace>)>> = Mutex::new(Vec::new());
        let mut drawn = DRAWN.lock().unwrap_or_else(PoisonError::into_inner);
        let is_same = |entry: &&(u64, Set, Arc<Self>)| (entry.0, entry.1) == (seed, set) && entry.2.arm == *arm;
        if let Some((.., space)) = drawn.iter().find(is_same) {
            return Arc::clone(space);
        }
        let space = Arc::new(Self::sample(arm, seed, set));
        drawn.truncate(KEPT - 1);
        drawn.insert(0, (seed, set, Arc::clone(&space)));
        space
    }

    /// Returns the number of cubes that the hand reaches.
    fn cubes(&self) -> usize {
        self.cubes.len() - 1
    }

    /// Draws a pose: uniform over the cubes, then over the cube's poses.
    pub fn pose(&self, random: &mut Stream) -> Pose {
        let cube = random.below(self.cubes());
        let poses = &self.poses[self.cubes[cube]..self.cubes[cube + 1]];
        *random.pick(poses)
    }

    /// Draws a task.
    pub fn task(&self, start: Start, random: &mut Stream) -> Task {
        let target = kinematics::hand(&self.arm, self.pose(random));
        let start = match start {
            Start::Fs => self.home,
            Start::Rs => self.pose(random),
        };
        Task { start, target }
    }
}

/// True if nothing collides and neither hand nor forearm is inside the base (which the collision test misses because it
/// checks only edges).
pub(crate) fn stands_free(arm: &Arm<f64>, plane: &Plane<f64>) -> bool {
    let outside = || {
        let Clearance { hand, forearm } = Clearance::new(plane, &arm.shapes);
        hand > 0.0 && forearm > 0.0
    };
    plane.collision(&arm.shapes).is_none() && outside()
}

/// Returns `count` tasks of a set. A shorter list is a prefix of a longer one.
pub fn tasks(arm: &Arm<f64>, seed: u64, set: Set, start: Start, count: usize) -> Vec<Task> {
    let reach = ReachableSpace::shared(arm, seed, set);
    let stream = |index| Stream::new(seed, (set as u64) << 8 | start as u64, Purpose::Task, index);
    (0..count as u64).map(|index| reach.task(start, &mut stream(index))).collect()
}

/// The seed of the project's committed test tasks, `generated/test-targets/`.
pub const TEST_SEED: u64 = 2024;

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;
    use tpg_arm::WIDOWX;

    #[test]
    fn tasks_are_free_reachable_and_spread() {
        let reach = ReachableSpace::sample(&WIDOWX, 1, Set::Training);
        assert!((30_000..40_000).contains(&reach.cubes()), "{} cubes", reach.cubes());
        let mut random = Stream::new(1, 0, Purpose::Test, 0);
        let mut off_grid = 0;
        for _ in 0..2000 {
            let pose = reach.pose(&mut random);
            assert!(stands_free(&WIDOWX, &Plane::at(&WIDOWX, pose)), "{pose:?}");
            off_grid += u32::from(pose.0.iter().any(|&ticks| ticks % 3 != 2048 % 3));
        }
        assert!(off_grid > 1900, "targets on the action grid can be exploited");
        // Uniform over cubes: about as many targets right as left, and few low ones twice.
        let targets: Vec<_> = (0..2000).map(|_| reach.task(Start::Fs, &mut random).target).collect();
        let right = targets.iter().filter(|target| target[0] > 0.0).count();
        assert!((880..1120).contains(&right), "{right} of 2000 on the right");
        let distinct: BTreeSet<_> = targets.iter().map(|target| target.map(f64::to_bits)).collect();
        assert!(distinct.len() > 1950);
    }

    #[test]
    fn sets_differ_and_a_longer_list_begins_with_the_shorter() {
        let list = |set, count| tasks(&WIDOWX, 7, set, Start::Rs, count);
        let longer = list(Set::Validation, 20);
        assert_eq!(longer[..10], list(Set::Validation, 10)[..]);
        for other in [Set::Training, Set::Test] {
            assert!(list(other, 20).iter().all(|task| !longer.contains(task)));
        }
    }
}
