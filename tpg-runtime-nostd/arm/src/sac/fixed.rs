//! The network in integers: `i8` weights, `i16` activations, `i32` accumulators.
//!
//! One layer's output o is, for inputs x:
//!
//! acc = bias\[o\] + Σ weights\[o\]\[i\]·x\[i\], exactly, in `i32`;
//! y = (acc·factor\[o\] + 2^(shift\[o\] − 1)) >> shift\[o\] in `i64`: rounded to nearest, halves upwards;
//! then clipped to 0..=32767 behind a hidden layer (its ReLU) and to −32767..=32767 behind the last one.
//!
//! That is the whole arithmetic, and every kernel that computes it gives the same bits. [`Layer::is_sound`] proves at
//! build time that no accumulator can overflow, for any input at all.
//!
//! Features enter as whole multiples of 1/4096 ([`quantise`]), preferences leave as multiples of 1/2048.

use super::{Actions, Decision, FEATURES, Mask, TRAINED_COARSE, TRAINED_FINE, features};
use crate::arm::{Arm, JOINTS, Move};
use crate::frame::Frame;
use crate::observation::Observation;
use tpg_runtime::policy::Policy;

/// A feature of 1 as an integer.
pub const FEATURE_ONE: f32 = 4096.0;

/// A preference of 1 as an integer.
pub const PREFERENCE_ONE: f32 = 2048.0;

/// How an accumulator becomes an output: times `factor`/2^`shift`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rescale {
    /// 0..=32767.
    pub factor: i16,
    /// 1..=47; what lies outside counts as the nearer end.
    pub shift: u8,
}

impl Rescale {
    /// Rounded to nearest, halves upwards; clipped to `low`..=32767.
    #[inline(always)]
    pub const fn apply(self, accumulator: i32, low: i16) -> i16 {
        let shift = match self.shift {
            0 => 1,
            shift @ 1..=47 => shift as u32,
            _ => 47,
        };
        // 31 + 15 bits and a half: i64 has room.
        let value = (accumulator as i64 * self.factor as i64 + (1 << (shift - 1))) >> shift;
        if value > i16::MAX as i64 {
            i16::MAX
        } else if value < low as i64 {
            low
        } else {
            value as i16
        }
    }
}

/// What a layer's outputs are clipped to from below: a hidden layer's ReLU.
pub const HIDDEN: i16 = 0;
/// What the last layer's outputs are clipped to from below.
pub const LAST: i16 = -i16::MAX;

/// The exact sum of products of one row. It wraps where a row is not [sound](Layer::is_sound).
#[inline]
pub fn accumulate<W: Copy + Into<i32>>(bias: i32, weights: &[W], inputs: &[i16]) -> i32 {
    let products = weights.iter().zip(inputs).map(|(&weight, &input)| weight.into().wrapping_mul(i32::from(input)));
    products.fold(bias, i32::wrapping_add)
}

/// The greatest magnitude that a row's accumulator can take, for any inputs.
pub const fn worst_accumulator(bias: i32, weights: &[i8]) -> i64 {
    let mut worst = bias.unsigned_abs() as i64;
    let mut i = 0;
    while i < weights.len() {
        worst += weights[i].unsigned_abs() as i64 * 32_768;
        i += 1;
    }
    worst
}

/// A layer of `I` inputs and `O` outputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layer<const I: usize, const O: usize> {
    /// Row by row.
    pub weights: [[i8; I]; O],
    /// In units of the accumulators.
    pub bias: [i32; O],
    /// Row by row.
    pub rescale: [Rescale; O],
}

impl<const I: usize, const O: usize> Layer<I, O> {
    /// The outputs, clipped to `low` from below.
    pub fn forward(&self, inputs: &[i16; I], low: i16) -> [i16; O] {
        let mut outputs = [0; O];
        let rows = self.weights.iter().zip(&self.bias).zip(&self.rescale);
        for (output, ((weights, &bias), rescale)) in outputs.iter_mut().zip(rows) {
            *output = rescale.apply(accumulate(bias, weights, inputs), low);
        }
        outputs
    }

    /// Whether no input can overflow an accumulator and every rescale is in its range.
    ///
    /// Generated code asserts it in a `const`: an unsound network does not compile.
    pub const fn is_sound(&self) -> bool {
        let mut o = 0;
        while o < O {
            let Rescale { factor, shift } = self.rescale[o];
            if worst_accumulator(self.bias[o], &self.weights[o]) > i32::MAX as i64
                || factor < 0
                || shift < 1
                || shift > 47
            {
                return false;
            }
            o += 1;
        }
        true
    }
}

/// Features as integers: rounded to nearest, halves away from zero, clipped to `i16`; NaN becomes 0.
#[inline(never)] // its loop is not its caller's: a static bound multiplies nested ones
pub fn quantise(features: &[f32; FEATURES]) -> [i16; FEATURES] {
    features.map(|value| {
        let scaled = value * FEATURE_ONE;
        let half = f32::from_bits(0.5f32.to_bits() | (scaled.to_bits() & (-0.0f32).to_bits()));
        // By way of i32, which an FPU converts to and saturates at: `as i16` costs three comparisons.
        ((scaled + half) as i32).clamp(i32::from(i16::MIN), i32::from(i16::MAX)) as i16
    })
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
    /// Whether every layer [is sound](Layer::is_sound).
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

    /// The move for preferences in multiples of 1/2048.
    #[inline(never)] // as `quantise`
    pub fn decide(
        &self,
        preferences: [i32; JOINTS],
        pose: crate::arm::Pose,
        ranges: &[crate::arm::JointRange; JOINTS],
    ) -> Move {
        match self {
            Self::Fine(decision) => decision.decide(preferences, pose, ranges),
            Self::Coarse(decision) => decision.decide(preferences, pose, ranges),
        }
    }
}

/// A network in integers as a policy of an arm.
#[derive(Clone, Copy, Debug)]
pub struct FixedPolicy<'a, const A: usize, const B: usize> {
    /// The arm whose geometry the features know.
    pub arm: &'a Arm<f32>,
    /// The network.
    pub network: &'a Network<A, B>,
    /// What stands behind it.
    pub decision: FixedDecision,
}

impl<const A: usize, const B: usize> Policy for FixedPolicy<'_, A, B> {
    type State = Observation<f32>;
    type Action = Move;

    fn decide(&self, seen: &Observation<f32>) -> Move {
        let features = quantise(&features(&Frame::of(self.arm, seen)));
        self.decision.decide(self.network.preferences(&features), seen.pose, &self.arm.ranges)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arm::WIDOWX;
    use proptest::prelude::*;

    const ARM: Arm<f32> = WIDOWX.to_f32();

    #[test]
    fn rounding_is_to_nearest_with_halves_upwards_and_clipped() {
        let half = Rescale { factor: 1 << 14, shift: 15 };
        let at = |accumulator| half.apply(accumulator, LAST);
        assert_eq!([at(3), at(-3), at(4), at(-4), at(0)], [2, -1, 2, -2, 0]);
        assert_eq!([at(i32::MAX), at(i32::MIN)], [32767, -32767]);
        assert_eq!([half.apply(-9, HIDDEN), half.apply(9, HIDDEN)], [0, 5]);
    }

    #[test]
    fn features_are_rounded_and_clipped() {
        let nearest = |value: f32| {
            let scaled = value * FEATURE_ONE;
            (scaled + if scaled < 0.0 { -0.5 } else { 0.5 }) as i16
        };
        let special =
            [0.0, -0.0, f32::NAN, -f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, f32::MIN, 7.99, -8.0];
        let halves = (-40_000..40_000).map(|n| n as f32 / 8192.0);
        let any = (0..1_000_000u32).map(|n| f32::from_bits(n.wrapping_mul(2_654_435_761)));
        for value in special.into_iter().chain(halves).chain(any) {
            let mut features = [0.0; FEATURES];
            features[3] = value;
            assert_eq!(quantise(&features)[3], nearest(value), "{value}");
        }
    }

    #[test]
    fn soundness_is_decided_by_the_worst_input() {
        let layer = |weight: i8, bias: i32| Layer::<512, 1> {
            weights: [[weight; 512]; 1],
            bias: [bias],
            rescale: [Rescale { factor: 1, shift: 1 }],
        };
        // 512·127·32768 = 2,130,706,432; i32::MAX is 16,777,215 more.
        assert!(layer(127, 16_777_215).is_sound() && layer(-127, -16_777_215).is_sound());
        assert!(!layer(127, 16_777_216).is_sound() && !layer(-128, 0).is_sound());
        let bad = Layer { rescale: [Rescale { factor: 1, shift: 0 }], ..layer(1, 1) };
        assert!(!bad.is_sound());
    }

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

        #[test]
        fn a_sound_row_never_wraps(
            weights in prop::collection::vec(any::<i8>(), 40),
            inputs in prop::collection::vec(prop_oneof![Just(i16::MIN), Just(i16::MAX), any::<i16>()], 40),
            bias in -1_000_000_000i32..1_000_000_000,
        ) {
            let exact = weights.iter().zip(&inputs).map(|(&w, &x)| i64::from(w) * i64::from(x)).sum::<i64>() + i64::from(bias);
            prop_assert!(exact.abs() <= worst_accumulator(bias, &weights));
            prop_assert_eq!(i64::from(accumulate(bias, &weights, &inputs)), exact);
        }
    }
}
