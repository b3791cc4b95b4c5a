//! The arm's network in integers, without its layers: [`features`](super::features()) enter as whole multiples of 1/4096
//! ([`quantise`]), preferences leave as multiples of 1/2048 and are [decided](Decision) on.

use super::{Actions, Decision, FEATURE_CONTRACT, FEATURES, Mask};
use tpg_runtime::net::{Meaning, OutputKind, PREFERENCE_ONE, integer};

/// Features as integers: rounded to nearest, halves away from zero, clipped to `i16`; NaN becomes 0.
#[inline(never)] // its loop is not its caller's: a static bound multiplies nested ones
pub fn quantise(features: &[f32; FEATURES]) -> [i16; FEATURES] {
    features.map(integer)
}

impl Decision<i32> {
    /// The decision behind a network in integers: the thresholds of training, rounded upwards to multiples of 1/2048.
    pub const fn new(actions: Actions, mask: Mask, may_rest: bool) -> Self {
        const fn threshold((preference, ticks): (f32, i8)) -> (i32, i8) {
            let scaled = preference * PREFERENCE_ONE;
            let floor = scaled as i32;
            (if (floor as f32) < scaled { floor + 1 } else { floor }, ticks)
        }
        let Decision { steps: [one, two, three], .. } = Decision::<f32>::new(actions, mask, may_rest);
        Self { actions, mask, may_rest, steps: [threshold(one), threshold(two), threshold(three)] }
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
        let limits = matches!(self.mask, Mask::JointLimits) as u8;
        let flags = limits | ((self.may_rest as u8) << 1) | (matches!(self.actions, Actions::Fine) as u8) << 2;
        Meaning { contract: FEATURE_CONTRACT, inputs: &[], answer: OutputKind::Preferences { flags }, values: &[] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arm::{Arm, Move, Pose, WIDOWX};
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
            let decision = Decision::<i32>::new(Actions::Fine, Mask::JointLimits, false);
            let Move(deltas) = decision.decide(preferences, Pose(pose), &ARM.ranges);
            prop_assert!(deltas.iter().all(|delta| delta.abs() <= 3));
        }
    }
}
