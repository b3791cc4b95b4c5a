//! The rules of a step: the balls move, then the arm, and a hit ends the episode.

use super::BODY;
use super::draw::LIMIT;
use super::scene::Scene;
use super::walk::moved;
use std::sync::Arc;
use tpg_arm::dodge::{Ball, Posture, View};
use tpg_arm::kinematics::{Vector, distance};
use tpg_arm::{Move, Pose};

/// Names of the ways in which an episode ends.
pub(crate) const OUTCOMES: [&str; 3] = ["reached", "hit", "timeout"];

/// An episode that goes on.
#[derive(Clone, Debug)]
pub struct Episode {
    scene: Arc<Scene>,
    goals: Vec<Pose>,
    /// The balls as they are now.
    balls: Vec<Ball>,
    pose: Pose,
    posture: Posture,
    steps: u32,
}

/// The end of an episode, an index of the problem's outcomes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// The hand is at its target.
    Reached = 0,
    /// A ball has met the arm.
    Hit = 1,
    /// The time is over.
    Timeout = 2,
}

impl Episode {
    /// Starts an episode.
    pub fn new(scene: &Scene) -> Self {
        let pose = Pose(scene.start);
        let balls = scene.balls.iter().map(|path| path.observed(0.0)).collect();
        let goals = scene.goals.iter().copied().map(Pose).collect();
        Self { scene: Arc::new(scene.clone()), goals, balls, pose, posture: BODY.at(pose), steps: 0 }
    }

    /// Returns what a controller sees.
    pub fn view(&self) -> View<'_> {
        View::new(&BODY, self.pose, &self.goals, &self.balls)
    }

    /// Returns the pose.
    pub fn pose(&self) -> Pose {
        self.pose
    }

    /// Returns the hand's target, mm.
    pub(super) fn target(&self) -> Vector<f32> {
        self.scene.target
    }

    /// Returns the balls as they are now.
    pub(super) fn balls(&self) -> &[Ball] {
        &self.balls
    }

    /// Returns the number of steps so far.
    pub fn steps(&self) -> u32 {
        self.steps
    }

    /// Returns the distance of the hand from its target, mm.
    pub fn distance(&self) -> f32 {
        distance(self.posture.hand(), self.scene.target)
    }

    /// Takes a step. A move against limits, table or base is refused, which is no failure.
    pub fn step(&mut self, wanted: Move, tolerance: f32) -> Option<End> {
        self.steps += 1;
        let mut to = moved(self.pose, wanted);
        for ((to, from), range) in to.0.iter_mut().zip(self.pose.0).zip(&BODY.arm.ranges) {
            if !range.contains(*to) {
                *to = from;
            }
        }
        if to != self.pose {
            let posture = BODY.at(to);
            if BODY.is_free(&posture) {
                (self.pose, self.posture) = (to, posture);
            }
        }
        let time = self.steps as f32;
        for (ball, path) in self.balls.iter_mut().zip(&self.scene.balls) {
            let at = path.at(time);
            ball.velocity = std::array::from_fn(|axis| at[axis] - ball.at[axis]);
            ball.at = at;
        }
        if BODY.clearance_of_all(&self.posture, &self.balls, 0.0) < 0.0 {
            Some(End::Hit)
        } else if self.distance() < tolerance {
            Some(End::Reached)
        } else if self.steps >= LIMIT {
            Some(End::Timeout)
        } else {
            None
        }
    }
}
