//! The meaning of a network's numbers: how a state becomes inputs, and outputs an answer.

use super::tanh;

/// A fraction of 1 as an integer.
pub const FRACTION_ONE: i32 = 16_384;

/// The scale of an input: the network sees (value − offset)·scale, which must lie within ±8 not to be clipped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scaling {
    /// Subtracted first.
    pub offset: f32,
    /// Multiplied with then.
    pub scale: f32,
}

/// The kind of answer that outputs are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum OutputKind {
    /// Preferences in multiples of 1/2048, with flags. What both mean is the problem's: thresholds of a move, say.
    Preferences {
        /// The problem's.
        flags: u8,
    },
    /// A [`Value`] each.
    Values,
    /// The number of the greatest output, of equals the first.
    Argmax,
}

/// The way from an output to a fraction of half its range, from −1 to 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Squash {
    /// The hyperbolic tangent: the mean of a tanh-squashed Gaussian.
    Tanh,
    /// The number itself, clipped.
    Clamp,
}

/// An output that becomes a value from `min` to `max`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Value {
    /// The lowest value.
    pub min: f32,
    /// The highest value.
    pub max: f32,
    /// From an output to a fraction of half the range.
    pub squash: Squash,
    /// Outputs are multiples of 2^−exponent: up to 11 behind [`Squash::Tanh`], up to 14 behind [`Squash::Clamp`].
    pub exponent: u8,
}

impl Value {
    /// Returns true if the range is finite and not empty, and the exponent in its range.
    pub const fn is_sound(&self) -> bool {
        let span = self.max - self.min;
        self.min.is_finite() && self.max.is_finite() && span.is_finite() && span >= 0.0 && self.exponent <= self.most()
    }

    const fn most(&self) -> u8 {
        match self.squash {
            Squash::Tanh => 11,
            Squash::Clamp => 14,
        }
    }

    /// The fraction of half the range that an output is, from −16384 to 16384; exact integer arithmetic.
    pub fn fraction(&self, output: i32) -> i32 {
        let output = output.clamp(-i32::from(i16::MAX), i32::from(i16::MAX));
        // 15 + 14 bits: i32 has room.
        let finest = output << self.most().saturating_sub(self.exponent);
        match self.squash {
            Squash::Tanh => tanh::fraction(finest),
            Squash::Clamp => finest.clamp(-FRACTION_ONE, FRACTION_ONE),
        }
    }

    /// The value that an output is: `min` + (`max` − `min`)·(fraction + 1)/2 in `f32`, exactly `min` and `max` at the ends.
    pub fn of(&self, output: i32) -> f32 {
        let fraction = self.fraction(output);
        if fraction >= FRACTION_ONE {
            return self.max;
        }
        // Exact: up to 2¹⁵ times a power of two.
        let part = (fraction + FRACTION_ONE) as f32 * (0.5 / FRACTION_ONE as f32);
        let value = self.min + (self.max - self.min) * part;
        if value > self.max { self.max } else { value }
    }
}

/// Everything about a network but its layers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meaning<'a> {
    /// A checksum of the inputs' names ([`contract`](super::contract)), for those who must know that they feed the right
    /// network.
    pub contract: u32,
    /// The inputs' scales; none where the caller gives inputs in multiples of 1/4096, or values that are so scaled.
    pub inputs: &'a [Scaling],
    /// The kind of answer.
    pub answer: OutputKind,
    /// The values that outputs become; none but for [`OutputKind::Values`].
    pub values: &'a [Value],
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ends_are_exact_and_nothing_leaves_the_range() {
        for (min, max) in [(-2.0f32, 2.0), (0.1, 0.3), (-1e30, 1.0), (5.0, 5.0), (-0.7, -0.1)] {
            for (squash, exponent) in [(Squash::Tanh, 11), (Squash::Clamp, 14), (Squash::Tanh, 3), (Squash::Clamp, 0)] {
                let value = Value { min, max, squash, exponent };
                assert!(value.is_sound());
                assert_eq!([value.of(i32::MIN), value.of(i32::MAX)], [min, max]);
                let mut before = min;
                for output in (-32_767..=32_767).step_by(13) {
                    let now = value.of(output);
                    assert!(now >= before && now <= max, "{value:?} at {output}: {now}");
                    before = now;
                }
            }
        }
        assert!(!Value { min: 1.0, max: 0.0, squash: Squash::Tanh, exponent: 0 }.is_sound());
        assert!(!Value { min: f32::MIN, max: f32::MAX, squash: Squash::Tanh, exponent: 0 }.is_sound());
        assert!(!Value { min: 0.0, max: 1.0, squash: Squash::Tanh, exponent: 12 }.is_sound());
    }
}
