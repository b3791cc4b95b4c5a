//! Where the arm can reach: poses spread evenly over space, not over joint angles.
//!
//! Random poses crowd where the joints' motion is slow. So space is cut into cubes, and a pose is drawn by drawing a
//! cube first. Poses are at single-tick resolution: targets on the policies' own 3-tick grid can be exploited (a policy
//! with 89 % on that grid had 51 % off it).

use crate::random::{Purpose, Stream};
use std::collections::BTreeMap;
use tpg_runtime::arm::{Arm, Pose};
use tpg_runtime::kinematics::{self, Plane, Vector};

/// How densely the reachable space is sampled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampling {
    /// Random poses to try.
    pub draws: usize,
    /// Edge of a cube, mm.
    pub cube: f64,
    /// Poses kept of one cube.
    pub poses_per_cube: usize,
}

impl Default for Sampling {
    fn default() -> Self {
        Self { draws: 2_000_000, cube: 20.0, poses_per_cube: 8 }
    }
}

/// Collision-free poses, by the cube that the hand is in.
#[derive(Clone, Debug)]
pub struct Reachable {
    arm: Arm<f64>,
    cubes: Vec<Vec<Pose>>,
}

impl Reachable {
    /// Samples the space of an arm. The same arm and sampling always give the same poses.
    ///
    /// # Panics
    /// If no pose is free of collisions.
    pub fn new(arm: &Arm<f64>, sampling: Sampling) -> Self {
        let mut stream = Stream::new(0, 0, Purpose::Tasks, 0);
        let mut cubes = BTreeMap::<[i32; 3], Vec<Pose>>::new();
        for _ in 0..sampling.draws {
            let pose =
                Pose(arm.ranges.map(|range| stream.between(i64::from(range.min), i64::from(range.max)) as i16));
            let plane = Plane::at(arm, pose);
            if plane.collision(&arm.shapes).is_some() {
                continue;
            }
            let hand = plane.hand_in_world(kinematics::base_direction(pose));
            let poses = cubes.entry(hand.map(|x| (x / sampling.cube).floor() as i32)).or_default();
            if poses.len() < sampling.poses_per_cube {
                poses.push(pose);
            }
        }
        assert!(!cubes.is_empty(), "every pose of the arm collides");
        Self { arm: *arm, cubes: cubes.into_values().collect() }
    }

    /// How many cubes hold a pose.
    pub fn cubes(&self) -> usize {
        self.cubes.len()
    }

    /// A pose: a cube, every one equally likely, then one of its poses.
    pub fn pose(&self, stream: &mut Stream) -> Pose {
        let cube = stream.pick(&self.cubes);
        *stream.pick(cube)
    }

    /// A point that the hand can be at, mm.
    pub fn target(&self, stream: &mut Stream) -> Vector<f64> {
        kinematics::hand(&self.arm, self.pose(stream))
    }
}

#[cfg(test)]
mod tests {
    use super::{Reachable, Sampling};
    use crate::random::{Purpose, Stream};
    use tpg_runtime::arm::WIDOWX;
    use tpg_runtime::kinematics::Plane;

    #[test]
    fn poses_are_free_off_the_grid_and_evenly_spread() {
        let reachable = Reachable::new(&WIDOWX, Sampling { draws: 200_000, ..Sampling::default() });
        assert!(reachable.cubes() > 15_000, "{} cubes", reachable.cubes());
        let mut stream = Stream::new(1, 0, Purpose::Test, 0);
        let mut on_grid = 0;
        for _ in 0..10_000 {
            let pose = reachable.pose(&mut stream);
            assert!(Plane::at(&WIDOWX, pose).collision(&WIDOWX.shapes).is_none());
            assert!(pose.0.iter().zip(WIDOWX.ranges).all(|(&ticks, range)| range.contains(ticks)));
            on_grid += u32::from(pose.0.iter().all(|ticks| (ticks - 2048) % 3 == 0));
        }
        // One in 81 lies on the 3-tick grid of the home pose by chance.
        assert!((60..200).contains(&on_grid), "{on_grid} of 10000 on the grid");
    }
}
