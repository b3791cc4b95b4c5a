//! The finite range of every value of every source, from the arm's own lengths and limits.

use super::Source;
use crate::arm::{Arm, JointRange, TICKS_PER_TURN};
use tpg_runtime::scalar::Scalar as _;

/// Added to every length, mm, and angle, ticks: `f32` rounds, and a bound must hold all the same.
const SLACK: f64 = 1.0;

impl Source {
    /// The lowest and the highest value at `index`, for every collision-free pose of the arm and every target that such a
    /// pose reaches; `[0, 0]` past the [`length`](Self::length).
    pub fn range(self, arm: &Arm<f64>, index: usize) -> [f64; 2] {
        if index >= self.length() {
            return [0.0, 0.0];
        }
        let links = &arm.links;
        let reach = arm.reach() + SLACK;
        let around = |bound: f64| [-bound, bound];
        // The tip of a free arm is never below the table.
        let height = [0.0, links.base + reach];
        let joint = |index: usize| {
            let JointRange { min, max } = arm.ranges.get(index).copied().unwrap_or(JointRange { min: 0, max: 0 });
            [f64::from(min), f64::from(max)]
        };
        let less = |[min, max]: [f64; 2], by: [f64; 2]| [min - by[1], max - by[0]];
        // A goal of the inverse kinematics: within half a turn of the middle.
        let goal = [-SLACK, f64::from(TICKS_PER_TURN) + SLACK];
        match (self, index) {
            (Self::Target | Self::Hand, 2) => height,
            (Self::Target | Self::Hand, _) => around(reach),
            (Self::Difference, 2) => around(height[1]),
            (Self::Difference, _) => around(2.0 * reach),
            (Self::Motors, _) | (Self::Servos, 0..=3) => joint(index),
            (Self::Servos, _) => {
                let servo = f64::from(arm.fixed_servos.get(index - 4).copied().unwrap_or(0));
                [servo, servo]
            }
            (Self::Polar, _) => around(reach),
            (Self::Stance, 3) => {
                let [min, max] = joint(3);
                [min - max, max - min]
            }
            (Self::Stance, _) => less(goal, joint(index)),
            (Self::Floor, _) => [0.0, links.base + reach + corner_reach(arm)],
        }
    }
}

/// The greatest distance of the hand's corners from its tip, mm.
fn corner_reach(arm: &Arm<f64>) -> f64 {
    let ahead = arm.shapes.hand_length - arm.links.hand;
    let [a, b] = arm.shapes.hand_edges;
    let aside = if a.abs() > b.abs() { a } else { b };
    (ahead * ahead + aside * aside).square_root()
}
