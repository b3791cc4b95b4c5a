//! Exact intervals of whole numbers.

use Instruction::*;
use tpg_runtime::ops::{BY_ZERO, Instruction, ZERO_BY_ZERO};

/// Every value is a whole number from `low` to `high`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Whole {
    /// The lowest value.
    pub low: i64,
    /// The highest value.
    pub high: i64,
}

/// The reason that a result is not known to be a whole number that an `f64` holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Unfit {
    /// A fraction is possible.
    NotWhole,
    /// The magnitude can reach this.
    TooGreat(u128),
    /// A division by 0 without a defined result.
    ByZero,
}

impl Whole {
    /// From here on an `f64` does not hold every whole number.
    pub(crate) const MOST: i64 = 1 << 53;

    /// The integers of a type of so many bits.
    pub(crate) const fn of_bits(bits: u32) -> Self {
        Self { low: -1 << (bits - 1), high: (1 << (bits - 1)) - 1 }
    }

    /// A number, if it is whole.
    ///
    /// # Errors
    /// A fraction, or a number that is too great.
    pub(crate) fn exactly(value: f64) -> Result<Self, Unfit> {
        if !value.is_finite() {
            return Err(Unfit::ByZero);
        }
        if value.fract() != 0.0 {
            return Err(Unfit::NotWhole);
        }
        Self::hull([value as i128; 1])
    }

    /// The numbers between the ends of a range, which are whole.
    ///
    /// # Errors
    /// As [`exactly`](Self::exactly).
    pub(crate) fn between(low: f64, high: f64) -> Result<Self, Unfit> {
        Ok(Self { low: Self::exactly(low)?.low, high: Self::exactly(high)?.high })
    }

    /// The greatest magnitude.
    pub(crate) fn magnitude(self) -> u64 {
        self.low.unsigned_abs().max(self.high.unsigned_abs())
    }

    /// Tests for integers that a type of so many bits holds.
    pub(crate) fn fits(self, bits: u32) -> bool {
        let Self { low, high } = Self::of_bits(bits);
        low <= self.low && self.high <= high
    }

    /// Tests for a possible value.
    pub(crate) fn contains(self, value: i64) -> bool {
        self.low <= value && value <= self.high
    }

    /// The smallest interval with some numbers.
    fn hull<const N: usize>(values: [i128; N]) -> Result<Self, Unfit> {
        let (low, high) = values.iter().fold((i128::MAX, i128::MIN), |(low, high), &v| (low.min(v), high.max(v)));
        let most = low.unsigned_abs().max(high.unsigned_abs());
        let fits = |end: i128| i64::try_from(end).ok().filter(|end| end.unsigned_abs() <= Self::MOST.unsigned_abs());
        match (fits(low), fits(high)) {
            (Some(low), Some(high)) => Ok(Self { low, high }),
            _ => Err(Unfit::TooGreat(most)),
        }
    }

    fn joined(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// The values within limits, if there are any.
    fn cut(self, low: i64, high: i64) -> Option<Self> {
        let cut = Self { low: self.low.max(low), high: self.high.min(high) };
        (cut.low <= cut.high).then_some(cut)
    }

    fn negated(self) -> Self {
        Self { low: -self.high, high: -self.low }
    }

    /// The values of an instruction.
    ///
    /// # Errors
    /// If a result may be a fraction, or of a magnitude above [`MOST`](Self::MOST).
    pub(crate) fn apply(instruction: Instruction, a: Self, b: Self) -> Result<Self, Unfit> {
        let corners = |f: fn(i128, i128) -> i128| {
            let [[p, q], [r, s]] = [[a.low, a.high], [b.low, b.high]].map(|ends| ends.map(i128::from));
            Self::hull([f(p, r), f(p, s), f(q, r), f(q, s)])
        };
        match instruction {
            Add => corners(|a, b| a + b),
            Sub => corners(|a, b| a - b),
            Mul => corners(|a, b| a * b),
            Min => Ok(Self { low: a.low.min(b.low), high: a.high.min(b.high) }),
            Max => Ok(Self { low: a.low.max(b.low), high: a.high.max(b.high) }),
            Abs if a.low >= 0 => Ok(a),
            Abs if a.high <= 0 => Ok(a.negated()),
            Abs => Ok(Self { low: 0, high: a.high.max(-a.low) }),
            NegateIfLess => {
                let kept = a.cut(b.low, i64::MAX);
                let negated = a.cut(i64::MIN, b.high - 1).map(Self::negated);
                Ok(either(kept, negated).unwrap_or(a))
            }
            Gate if !b.contains(0) => Ok(a),
            Gate => Ok(a.joined(Self { low: 0, high: 0 })),
            Fmod if b.contains(0) => Err(Unfit::ByZero),
            // Nearer to 0 than the divisor, not beyond the dividend, and with its sign.
            Fmod => {
                let most = i64::try_from(b.magnitude()).unwrap_or(i64::MAX) - 1;
                Ok(Self { low: a.low.clamp(-most, 0), high: a.high.clamp(0, most) })
            }
            Quotient => quotients(a, b),
            Div | Cos | Sin | Tan | Ln | Exp | Sqrt | Atan | Tanh => Err(Unfit::NotWhole),
        }
    }
}

fn either(a: Option<Whole>, b: Option<Whole>) -> Option<Whole> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a.joined(b)),
        (a, b) => a.or(b),
    }
}

/// Quotients are extreme at the ends of each sign of the divisor.
fn quotients(a: Whole, b: Whole) -> Result<Whole, Unfit> {
    let floor = |a: i64, b: i64| i128::from(a.div_euclid(b) - i64::from(b < 0 && a.rem_euclid(b) != 0));
    let of_sign = |b: Option<Whole>| {
        b.map(|b| Whole::hull([floor(a.low, b.low), floor(a.low, b.high), floor(a.high, b.low), floor(a.high, b.high)]))
            .transpose()
    };
    let mut all = either(of_sign(b.cut(i64::MIN, -1))?, of_sign(b.cut(1, i64::MAX))?);
    if b.contains(0) {
        let most = i64::from(BY_ZERO);
        for (possible, value) in [(a.high > 0, most), (a.low < 0, -most), (a.contains(0), i64::from(ZERO_BY_ZERO))] {
            all = either(all, possible.then_some(Whole { low: value, high: value }));
        }
    }
    all.ok_or(Unfit::ByZero)
}

#[cfg(test)]
mod tests {
    use super::{Unfit, Whole};
    use proptest::prelude::*;
    use tpg_runtime::ops::{Instruction, Own};

    const WORDS: [Instruction; 10] = [
        Instruction::Add,
        Instruction::Sub,
        Instruction::Mul,
        Instruction::Min,
        Instruction::Max,
        Instruction::Abs,
        Instruction::NegateIfLess,
        Instruction::Gate,
        Instruction::Fmod,
        Instruction::Quotient,
    ];

    fn interval() -> impl Strategy<Value = Whole> {
        let end = prop_oneof![-4_i64..5, any::<i32>().prop_map(i64::from), Just(0), Just(1), Just(-1)];
        (end.clone(), end).prop_map(|(a, b)| Whole { low: a.min(b), high: a.max(b) })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]
        #[test]
        fn results_are_whole_and_in_the_interval(
            a in interval(), b in interval(), which in 0..WORDS.len(), units in [0.0..=1.0_f64, 0.0..=1.0_f64],
        ) {
            let pick = |Whole { low, high }: Whole, unit: f64| (low + ((high - low) as f64 * unit) as i64).min(high);
            let (x, y) = (pick(a, units[0]), pick(b, units[1]));
            if let Ok(found) = Whole::apply(WORDS[which], a, b) {
                let value = WORDS[which].apply::<f64, Own>(x as f64, y as f64);
                prop_assert!(value.fract() == 0.0 && found.contains(value as i64), "{:?} {x} {y}: {value} {found:?}", WORDS[which]);
            }
        }
    }

    #[test]
    fn ends_are_reached() {
        let between = |low, high| Whole { low, high };
        let apply = Whole::apply;
        assert_eq!(apply(Instruction::Quotient, between(-7, 7), between(2, 3)), Ok(between(-4, 3)));
        assert_eq!(apply(Instruction::Quotient, between(5, 7), between(0, 0)), Ok(between(2147483647, 2147483647)));
        assert_eq!(apply(Instruction::Quotient, between(0, 7), between(-1, 1)), Ok(between(-2147483648, 2147483647)));
        assert_eq!(apply(Instruction::NegateIfLess, between(-5, 3), between(0, 0)), Ok(between(0, 5)));
        assert_eq!(apply(Instruction::Mul, between(0, 1 << 40), between(0, 1 << 40)), Err(Unfit::TooGreat(1 << 80)));
        assert_eq!(apply(Instruction::Div, between(1, 2), between(1, 1)), Err(Unfit::NotWhole));
        assert_eq!(apply(Instruction::Fmod, between(1, 2), between(0, 1)), Err(Unfit::ByZero));
        assert_eq!(Whole::exactly(0.5), Err(Unfit::NotWhole));
        assert_eq!(Whole::exactly(f64::INFINITY), Err(Unfit::ByZero));
        assert_eq!((Whole::of_bits(16).low, Whole::of_bits(16).high), (-32768, 32767));
    }
}
