//! Balls whose places are seen late and with noise, and whose velocities are not seen at all.

use super::ball::Ball;
use crate::kinematics::Vector;

/// Part of what a place is off its prediction that corrects the place, and that corrects the velocity: an α-β filter, which forgets
/// errors without swinging, and leaves 44 % of a place's noise.
const PLACE: f32 = 0.25;
const VELOCITY: f32 = 0.036;

/// Estimates where a ball is and how it moves from one place after another.
///
/// ```
/// use tpg_arm::dodge::Tracker;
///
/// let mut tracker = Tracker::new([0.0, 200.0, 300.0], 40.0);
/// for step in 1..=200 {
///     tracker.see([step as f32, 200.0, 300.0]);
/// }
/// // What was seen is two steps old.
/// let ball = tracker.ball(2.0);
/// assert!((ball.velocity[0] - 1.0).abs() < 1e-3 && (ball.at[0] - 202.0).abs() < 0.1);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tracker {
    ball: Ball,
}

impl Tracker {
    /// Begins with the first place, mm, of a ball of this radius.
    pub const fn new(at: Vector<f32>, radius: f32) -> Self {
        Self { ball: Ball { at, velocity: [0.0; 3], radius } }
    }

    /// Takes the place of the next step.
    pub fn see(&mut self, place: Vector<f32>) {
        self.ball.at = self.ball.after(1.0);
        for ((at, velocity), seen) in self.ball.at.iter_mut().zip(&mut self.ball.velocity).zip(place) {
            let off = seen - *at;
            *at += PLACE * off;
            *velocity += VELOCITY * off;
        }
    }

    /// Returns the ball as it is now, `delay` steps after its place was seen.
    pub fn ball(&self, delay: f32) -> Ball {
        Ball { at: self.ball.after(delay), ..self.ball }
    }
}
