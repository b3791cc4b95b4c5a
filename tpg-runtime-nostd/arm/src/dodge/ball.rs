//! Balls: the obstacles, as they are observed.

use crate::kinematics::Vector;

/// Speed below which a ball stays, mm a step.
const STILL: f32 = 0.01;

/// A ball at the moment of an observation.
///
/// Its fields lie in this order, as they come from C.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
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
    pub(crate) fn speed_bound(&self) -> f32 {
        let [dx, dy, dz] = self.velocity.map(f32::abs);
        dx + dy + dz
    }

    /// Returns true if the ball stays where it is: then it is known where it will be at any time.
    #[inline]
    pub fn stays(&self) -> bool {
        self.speed_bound() < STILL
    }

    /// Returns true if a ball can be so: every number finite, the centre within 100 m, at most 1 m a step, a radius above 0 and at
    /// most 1 m.
    #[inline]
    pub fn is_sound(&self) -> bool {
        let [x, y, z] = self.at.map(f32::abs);
        // Every comparison is false for a NaN.
        x + y + z <= 1e5 && self.speed_bound() <= 1e3 && self.radius > 0.0 && self.radius <= 1e3
    }
}
