//! The arm's network in integers: two hidden layers between the [`features`](super::features()) and four preferences.
//!
//! Features enter as whole multiples of 1/4096 ([`quantise`]), preferences leave as multiples of 1/2048. The arithmetic is
//! [`tpg_runtime::net`]'s.

use super::{Actions, Decision, FEATURE_CONTRACT, FEATURES, Mask, TRAINED_COARSE, TRAINED_FINE, features};
use crate::arm::{Arm, JOINTS, Move};
use crate::frame::Frame;
use crate::observation::Observation;
use tpg_runtime::net::{HIDDEN, LAST, Layer, Meaning, OutputKind, PREFERENCE_ONE, integer};
use tpg_runtime::policy::Policy;

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

/// A network of two hidden layers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Network<const A: usize, const B: usize> {
    /// Features to the first hidden layer.
    pub first: Layer<FEATURES, A>,
    /// First to second hidden layer.
    pub second: Layer<A, B>,
    /// Second hidden layer to the preferences.
    pub last: Layer<B, JOINTS>,
}

impl<const A: usize, const B: usize> Network<A, B> {
    /// Returns true if every layer [is sound](Layer::is_sound).
    pub const fn is_sound(&self) -> bool {
        self.first.is_sound() && self.second.is_sound() && self.last.is_sound()
    }

    /// The preferences, in multiples of 1/2048.
    pub fn preferences(&self, features: &[i16; FEATURES]) -> [i32; JOINTS] {
        let first = self.first.forward(features, HIDDEN);
        let second = self.second.forward(&first, HIDDEN);
        self.last.forward(&second, LAST).map(i32::from)
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

/// A network in integers as a policy of an arm.
#[derive(Clone, Copy, Debug)]
pub struct FixedPolicy<'a, const A: usize, const B: usize> {
    /// The arm whose geometry the features know.
    pub arm: &'a Arm<f32>,
    /// The network.
    pub network: &'a Network<A, B>,
    /// The decision that follows the network.
    pub decision: FixedDecision,
}

impl<const A: usize, const B: usize> Policy for FixedPolicy<'_, A, B> {
    type State = Observation<f32>;
    type Action = Move;

    fn decide(&self, seen: &Observation<f32>) -> Move {
        let features = quantise(&features(&Frame::new(self.arm, seen)));
        self.decision.decide(self.network.preferences(&features), seen.pose, &self.arm.ranges)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arm::WIDOWX;
    use proptest::prelude::*;
    use tpg_runtime::net::Rescale;

    const ARM: Arm<f32> = WIDOWX.to_f32();

    fn network() -> impl Strategy<Value = Network<5, 3>> {
        fn layer<const I: usize, const O: usize>() -> impl Strategy<Value = Layer<I, O>> {
            let weights = prop::collection::vec(prop_oneof![Just(-128i8), Just(127), any::<i8>()], I * O);
            let bias = prop::collection::vec(any::<i32>(), O);
            let rescale = prop::collection::vec((any::<i16>(), any::<u8>()), O);
            (weights, bias, rescale).prop_map(|(weights, bias, rescale)| Layer {
                weights: core::array::from_fn(|o| core::array::from_fn(|i| weights[o * I + i])),
                bias: core::array::from_fn(|o| bias[o]),
                rescale: core::array::from_fn(|o| Rescale { factor: rescale[o].0, shift: rescale[o].1 }),
            })
        }
        (layer(), layer(), layer()).prop_map(|(first, second, last)| Network { first, second, last })
    }

    proptest! {
        #[test]
        fn nothing_panics_whatever_weights_and_observation_hold(
            network in network(),
            pose in prop::array::uniform4(any::<i16>()),
            target in prop::array::uniform3(any::<f32>()),
        ) {
            let decision = FixedDecision::new(Actions::Fine, Mask::JointLimits, false);
            let policy = FixedPolicy { arm: &ARM, network: &network, decision };
            let seen = Observation::at(&ARM, crate::arm::Pose(pose), target);
            let Move(deltas) = policy.decide(&seen);
            prop_assert!(deltas.iter().all(|delta| delta.abs() <= 3));
        }
    }
}
