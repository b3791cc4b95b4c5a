//! One layer: exact sums of products, and the one rule of rounding behind them.

/// A preference of 1 as an integer.
pub const PREFERENCE_ONE: f32 = 2048.0;

/// The conversion of an accumulator to an output: times `factor`/2^`shift`.
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

impl Rescale {
    /// The number m for which [`apply`](Self::apply) is (accumulator · m + 2³¹) >> 32, clipped; `None` where 32 bits do not
    /// hold one: for a factor that is not a multiple of 2^(shift − 32), or a ratio of ½ or more.
    pub const fn multiplier(self) -> Option<i32> {
        let Self { factor, shift } = self;
        if factor < 0 || shift < 1 || shift > 47 {
            return None;
        }
        let factor = factor as i64;
        let multiplier = if shift <= 32 {
            factor << (32 - shift)
        } else if factor % (1 << (shift - 32)) == 0 {
            factor >> (shift - 32)
        } else {
            return None;
        };
        if multiplier <= i32::MAX as i64 { Some(multiplier as i32) } else { None }
    }
}

/// The lower limit of a hidden layer's outputs: its ReLU.
pub const HIDDEN: i16 = 0;
/// The lower limit of the last layer's outputs.
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

    /// Returns true if no input can overflow an accumulator and every rescale is in its range.
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

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn rounding_is_to_nearest_with_halves_upwards_and_clipped() {
        let half = Rescale { factor: 1 << 14, shift: 15 };
        let at = |accumulator| half.apply(accumulator, LAST);
        assert_eq!([at(3), at(-3), at(4), at(-4), at(0)], [2, -1, 2, -2, 0]);
        assert_eq!([at(i32::MAX), at(i32::MIN)], [32767, -32767]);
        assert_eq!([half.apply(-9, HIDDEN), half.apply(9, HIDDEN)], [0, 5]);
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

    proptest! {
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
