//! Scenes: a task for the arm among balls, and where the balls are at any time.

use serde::{Deserialize, Serialize};
use tpg_arm::JOINTS;
use tpg_arm::dodge::Ball;
use tpg_arm::kinematics::Vector;

/// The seed of the project's scenes.
pub const SEED: u64 = 2026;

/// A ball that goes back and forth between two points, or stays.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Path {
    /// One end, mm.
    pub from: Vector<f32>,
    /// The other end, mm.
    pub to: Vector<f32>,
    /// Radius, mm.
    pub radius: f32,
    /// Steps there and back; 0 for a ball that stays.
    pub period: f32,
    /// Part of the period, 0 to 1, that has passed at step 0.
    pub phase: f32,
    /// True for a sinusoidal motion, false for one at constant speed.
    pub sine: bool,
}

impl Path {
    /// Returns the centre at a time in steps, mm.
    #[inline]
    pub fn at(&self, time: f32) -> Vector<f32> {
        let place = self.place(time);
        std::array::from_fn(|axis| self.from[axis] + (self.to[axis] - self.from[axis]) * place)
    }

    /// The place between the ends, 0 to 1.
    fn place(&self, time: f32) -> f32 {
        if self.period == 0.0 {
            return 0.0;
        }
        let turns = time / self.period + self.phase;
        let turn = turns - libm::floorf(turns);
        if self.sine { 0.5 - 0.5 * libm::cosf(std::f32::consts::TAU * turn) } else { 1.0 - (2.0 * turn - 1.0).abs() }
    }

    /// Returns the ball as it is observed at a time: where it is, and how far it went in the last step.
    #[inline]
    pub fn observed(&self, time: f32) -> Ball {
        let (at, before) = (self.at(time), self.at(time - 1.0));
        Ball { at, velocity: std::array::from_fn(|axis| at[axis] - before[axis]), radius: self.radius }
    }

    /// Returns the greatest speed, mm a step.
    pub fn speed(&self) -> f32 {
        if self.period == 0.0 {
            return 0.0;
        }
        let length = tpg_arm::kinematics::distance(self.from, self.to);
        length * if self.sine { std::f32::consts::PI } else { 2.0 } / self.period
    }
}

/// A task: a start, a target, poses that solve it, and the balls.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Scene {
    /// The arm's first pose, ticks.
    pub start: [i16; JOINTS],
    /// The hand's target, mm.
    pub target: Vector<f32>,
    /// Poses that solve the task, ticks; the first is the nearest that a straight walk reaches, the others lie apart from
    /// it and from each other.
    pub goals: Vec<[i16; JOINTS]>,
    /// One to three balls.
    pub balls: Vec<Path>,
}
