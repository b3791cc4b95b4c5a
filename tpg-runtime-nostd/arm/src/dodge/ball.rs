//! Balls: the obstacles, as they are observed.

use crate::kinematics::Vector;

/// A ball at the moment of an observation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ball {
    /// Its centre, mm.
    pub at: Vector<f32>,
    /// Its displacement in the last step, mm a step.
    pub velocity: Vector<f32>,
    /// Its radius, mm.
    pub radius: f32,
}

impl Ball {
    /// Returns the centre after a number of steps, if the velocity stays as it is.
    #[inline]
    pub fn after(&self, steps: f32) -> Vector<f32> {
        let [x, y, z] = self.at;
        let [dx, dy, dz] = self.velocity;
        [x + dx * steps, y + dy * steps, z + dz * steps]
    }

    /// Returns an upper bound of the speed, mm a step: the sum of the components' magnitudes.
    #[inline]
    pub fn speed_bound(&self) -> f32 {
        let [dx, dy, dz] = self.velocity.map(f32::abs);
        dx + dy + dz
    }
}
