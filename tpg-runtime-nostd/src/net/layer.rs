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

/// The exact sum of products of one row. It wraps where a row is not sound ([`LayerRows::worst_accumulator`](super::LayerRows::worst_accumulator)).
#[inline]
pub fn accumulate<W: Copy + Into<i32>>(bias: i32, weights: &[W], inputs: &[i16]) -> i32 {
    let products = weights.iter().zip(inputs).map(|(&weight, &input)| weight.into().wrapping_mul(i32::from(input)));
    products.fold(bias, i32::wrapping_add)
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

    proptest! {
        #[test]
        fn sums_are_exact(
            weights in prop::collection::vec(any::<i8>(), 40),
            inputs in prop::collection::vec(prop_oneof![Just(i16::MIN), Just(i16::MAX), any::<i16>()], 40),
            bias in -1_000_000_000i32..1_000_000_000,
        ) {
            let exact = weights.iter().zip(&inputs).map(|(&w, &x)| i64::from(w) * i64::from(x)).sum::<i64>() + i64::from(bias);
            prop_assume!(i32::try_from(exact).is_ok());
            prop_assert_eq!(i64::from(accumulate(bias, &weights, &inputs)), exact);
        }
    }
}
