//! From the network's preferences to a move of the arm.

use crate::arm::{JOINTS, JointRange, Move, Pose};
use tpg_runtime::named;

/// A number that a network answers in: thresholds are compared with its magnitude.
pub trait Magnitude: Copy + PartialOrd {
    /// The distance from zero; the greatest value of the type where that has none.
    fn magnitude(self) -> Self;
    /// Returns true if it lies below zero.
    fn is_negative(self) -> bool;
}

impl Magnitude for f32 {
    fn magnitude(self) -> Self {
        self.abs()
    }
    fn is_negative(self) -> bool {
        self < 0.0
    }
}

impl Magnitude for i32 {
    fn magnitude(self) -> Self {
        self.saturating_abs()
    }
    fn is_negative(self) -> bool {
        self < 0
    }
}

named! {
    /// The moves a policy chooses from, for each joint.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum Actions {
        /// −3, 0 or 3 ticks: the paper's set.
        Coarse = "coarse",
        /// −3 to 3 ticks.
        Fine = "fine",
    }
}

named! {
    /// The moves that a policy refuses by itself. It is part of the policy and named wherever its results are.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum Mask {
        /// None.
        None = "none",
        /// A joint that would leave its range does not move.
        JointLimits = "joint-limits",
    }
}

/// The rule by which preferences become a move: the least magnitude from which a joint moves by that many ticks.
///
/// A preference that reaches no threshold leaves its joint at rest. If that holds for all joints and the arm may not
/// rest, the one with the greatest magnitude moves by the smallest step (the first of equals): a policy that stands
/// still has failed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Decision<T> {
    pub(super) actions: Actions,
    pub(super) mask: Mask,
    pub(super) may_rest: bool,
    /// Threshold and ticks, neither falling.
    pub(super) steps: [(T, i8); 3],
}

impl Decision<f32> {
    /// The decision behind a network before its tanh: round(3.49·tanh p) for fine actions, |tanh p| above a third for coarse ones.
    /// The paper's policies may rest: no joint moves.
    pub const fn new(actions: Actions, mask: Mask, may_rest: bool) -> Self {
        let steps = match actions {
            Actions::Fine => [(0.144_258_92, 1), (0.459_650_64, 2), (0.900_070_9, 3)],
            Actions::Coarse => [(0.346_573_6, 3); 3],
        };
        Self { actions, mask, may_rest, steps }
    }
}

impl<T: Magnitude> Decision<T> {
    /// The move for a pose. A NaN preference leaves its joint at rest.
    #[inline(never)] // once in flash
    pub fn decide(&self, preferences: [T; JOINTS], pose: Pose, ranges: &[JointRange; JOINTS]) -> Move {
        let mut wanted = Move::STOP;
        let mut moves = false;
        // The joint that moves if none reaches a threshold: its index, magnitude and step.
        let mut strongest: Option<(usize, T, i8)> = None;
        // By index: of four arrays zipped, no tool finds the loop's bound.
        for joint in 0..JOINTS {
            let preference = preferences[joint];
            let magnitude = preference.magnitude();
            let signed = |ticks: i8| if preference.is_negative() { -ticks } else { ticks };
            // Thresholds do not fall: the last that is reached decides.
            let step = self.steps.iter().fold(0, |step, &(least, ticks)| if magnitude >= least { ticks } else { step });
            let step = signed(step);
            if self.allows(pose.0[joint], step, &ranges[joint]) {
                wanted.0[joint] = step;
                moves |= step != 0;
            }
            let least = signed(self.steps[0].1);
            // A NaN is not even as great as itself.
            let stronger =
                strongest.map_or(magnitude.partial_cmp(&magnitude).is_some(), |(_, greatest, _)| magnitude > greatest);
            if stronger && self.allows(pose.0[joint], least, &ranges[joint]) {
                strongest = Some((joint, magnitude, least));
            }
        }
        if let (false, Some((index, _, least))) = (moves || self.may_rest, strongest)
            && let Some(delta) = wanted.0.get_mut(index)
        {
            *delta = least;
        }
        wanted
    }

    fn allows(&self, ticks: i16, step: i8, range: &JointRange) -> bool {
        match self.mask {
            Mask::None => true,
            Mask::JointLimits => range.contains(ticks.saturating_add(i16::from(step))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arm::WIDOWX;
    use proptest::prelude::*;

    const FINE: Decision<f32> = Decision::<f32>::new(Actions::Fine, Mask::None, false);
    const COARSE: Decision<f32> = Decision::<f32>::new(Actions::Coarse, Mask::None, false);

    #[test]
    fn nothing_wanted_moves_the_strongest_by_the_smallest_step() {
        let at = |preferences| FINE.decide(preferences, WIDOWX.home, &WIDOWX.ranges);
        assert_eq!(at([0.01, -0.05, 0.05, 0.0]), Move([0, -1, 0, 0]));
        assert_eq!(at([f32::NAN, 0.0, 0.0, 0.1]), Move([0, 0, 0, 1]));
        let resting = Decision { may_rest: true, ..FINE };
        assert_eq!(resting.decide([0.01, -0.05, 0.05, 0.0], WIDOWX.home, &WIDOWX.ranges), Move::STOP);
        assert_eq!(COARSE.decide([0.0, 0.1, -0.2, 0.0], WIDOWX.home, &WIDOWX.ranges), Move([0, 0, -3, 0]));
    }

    #[test]
    fn the_mask_holds_a_joint_at_its_limit_and_lets_the_next_move() {
        let masked = Decision { mask: Mask::JointLimits, ..FINE };
        let pose = Pose([4094, 2048, 2048, 1025]);
        assert_eq!(masked.decide([2.0, 0.0, 0.0, -2.0], pose, &WIDOWX.ranges), Move([0, 1, 0, 0]));
        let near = Pose([4093, 2048, 2048, 1025]);
        assert_eq!(masked.decide([2.0, 0.0, 0.0, -2.0], near, &WIDOWX.ranges), Move([1, 0, 0, 0]));
        assert_eq!(FINE.decide([2.0, 0.0, 0.0, -2.0], pose, &WIDOWX.ranges), Move([3, 0, 0, -3]));
    }

    proptest! {
        #[test]
        fn thresholds_are_the_rounded_tanh(preferences in prop::array::uniform4(-3f32..3.0)) {
            let fine = preferences.map(|p| libm::round(3.49 * libm::tanh(f64::from(p))) as i8);
            let coarse = preferences.map(|p| libm::round(libm::tanh(f64::from(p)) * 1.5) as i8 * 3);
            let margin = |p: f32| FINE.steps.iter().chain(&COARSE.steps).all(|(t, _)| (p.abs() - t).abs() > 1e-5);
            prop_assume!(preferences.into_iter().all(margin));
            if fine != [0; 4] {
                prop_assert_eq!(FINE.decide(preferences, WIDOWX.home, &WIDOWX.ranges), Move(fine));
            }
            if coarse != [0; 4] {
                prop_assert_eq!(COARSE.decide(preferences, WIDOWX.home, &WIDOWX.ranges), Move(coarse));
            }
        }
    }
}
