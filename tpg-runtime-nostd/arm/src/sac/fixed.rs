//! The arm's network in integers, without its layers: [`features`](super::features()) enter as whole multiples of 1/4096
//! ([`quantise`]), preferences leave as multiples of 1/2048 and are [decided](FixedDecision) on.

use super::{Actions, Decision, FEATURE_CONTRACT, FEATURES, Mask, TRAINED_COARSE, TRAINED_FINE};
use crate::arm::{JOINTS, Move};
use tpg_runtime::net::{Meaning, OutputKind, PREFERENCE_ONE, integer};

/// Features as integers: rounded to nearest, halves away from zero, clipped to `i16`; NaN becomes 0.
#[inline]
pub fn quantise(features: &[f32; FEATURES]) -> [i16; FEATURES] {
    let mut integers = [0; FEATURES];
    quantise_into(features, &mut integers);
    integers
}

/// [`quantise`] in place, which copies nothing.
#[inline(never)] // its loop is not its caller's: a static bound multiplies nested ones
pub(super) fn quantise_into(features: &[f32; FEATURES], integers: &mut [i16; FEATURES]) {
    for (to, &feature) in integers.iter_mut().zip(features) {
        *to = integer(feature);
    }
}

/// The decision behind a network in integers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FixedDecision {
    /// −3 to 3 ticks.
    Fine(Decision<i32, 3>),
    /// −3, 0 or 3 ticks.
    Coarse(Decision<i32, 1>),
}

impl FixedDecision {
    /// Of that set of actions: the thresholds of training, rounded upwards to multiples of 1/2048.
    pub const fn new(actions: Actions, mask: Mask, may_rest: bool) -> Self {
        const fn threshold((preference, ticks): (f32, i8)) -> (i32, i8) {
            let scaled = preference * PREFERENCE_ONE;
            let floor = scaled as i32;
            (if (floor as f32) < scaled { floor + 1 } else { floor }, ticks)
        }
        match actions {
            Actions::Fine => {
                let [one, two, three] = TRAINED_FINE;
                Self::Fine(Decision { steps: [threshold(one), threshold(two), threshold(three)], mask, may_rest })
            }
            Actions::Coarse => {
                let [three] = TRAINED_COARSE;
                Self::Coarse(Decision { steps: [threshold(three)], mask, may_rest })
            }
        }
    }

    /// The decision that a network's flags name: 1 for joints that stop at their limits, 2 where the arm may rest, 4 for
    /// fine actions.
    pub const fn from_flags(flags: u8) -> Self {
        let mask = if flags & 1 == 0 { Mask::None } else { Mask::JointLimits };
        let actions = if flags & 4 == 0 { Actions::Coarse } else { Actions::Fine };
        Self::new(actions, mask, flags & 2 != 0)
    }

    /// The meaning of a network of the arm with this decision behind it.
    pub const fn meaning(&self) -> Meaning<'static> {
        let (fine, mask, may_rest) = match self {
            Self::Fine(decision) => (true, decision.mask, decision.may_rest),
            Self::Coarse(decision) => (false, decision.mask, decision.may_rest),
        };
        let flags = matches!(mask, Mask::JointLimits) as u8 | ((may_rest as u8) << 1) | ((fine as u8) << 2);
        Meaning { contract: FEATURE_CONTRACT, inputs: &[], answer: OutputKind::Preferences { flags }, values: &[] }
    }

    /// The move for preferences in multiples of 1/2048.
    #[inline(never)] // as `quantise`
    pub fn decide(
        &self,
        preferences: [i32; JOINTS],
        pose: crate::arm::Pose,
        ranges: &[crate::arm::JointRange; JOINTS],
    ) -> Move {
        // One function for both: it is long, and flash is short. A step three times is the same as once.
        let widened;
        let decision = match self {
            Self::Fine(decision) => decision,
            Self::Coarse(Decision { steps: [step], mask, may_rest }) => {
                widened = Decision { steps: [*step; 3], mask: *mask, may_rest: *may_rest };
                &widened
            }
        };
        decision.decide(preferences, pose, ranges)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arm::{Arm, Pose, WIDOWX};
    use crate::frame::Frame;
    use crate::sac::features;
    use proptest::prelude::*;

    const ARM: Arm<f32> = WIDOWX.to_f32();

    proptest! {
        #[test]
        fn nothing_panics_whatever_observation_and_preferences_hold(
            pose in prop::array::uniform4(any::<i16>()),
            target in prop::array::uniform3(any::<f32>()),
            preferences in prop::array::uniform4(any::<i32>()),
        ) {
            quantise(&features(&Frame::at(&ARM, Pose(pose), target)));
            let decision = FixedDecision::new(Actions::Fine, Mask::JointLimits, false);
            let Move(deltas) = decision.decide(preferences, Pose(pose), &ARM.ranges);
            prop_assert!(deltas.iter().all(|delta| delta.abs() <= 3));
        }
    }
}
