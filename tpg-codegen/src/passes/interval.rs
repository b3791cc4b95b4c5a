//! Interval analysis, with NaN.
//!
//! Rounding to nearest is monotone, so the ends of a sum, difference, product or quotient are the rounded results on the
//! ends of its operands, computed in the graph's own scalar type: no widening is needed. Results of transcendental functions
//! depend on the provider; those are widened by more than any provider is off.

use super::arithmetic::Arithmetic;
use crate::ir::{Module, Node};
use Instruction::*;
use tpg_graph::ScalarType;
use tpg_runtime::ops::Instruction;

/// Every value lies in `low..=high` or is NaN, and NaN only where `nan` says so.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Interval {
    /// The lowest value.
    pub low: f64,
    /// The highest value.
    pub high: f64,
    /// The value can be NaN.
    pub nan: bool,
}

impl Interval {
    /// Anything at all.
    pub(crate) const ANYTHING: Self = Self { low: f64::NEG_INFINITY, high: f64::INFINITY, nan: true };

    /// One value.
    pub(crate) fn exactly(value: f64) -> Self {
        if value.is_nan() { Self::ANYTHING } else { Self { low: value, high: value, nan: false } }
    }

    /// The greatest magnitude.
    pub(crate) fn magnitude(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    /// The bid it is certain to reach: a NaN counts as −∞.
    pub(crate) fn certain_bid(self) -> f64 {
        if self.nan { f64::NEG_INFINITY } else { self.low }
    }

    fn contains_zero(self) -> bool {
        self.low <= 0.0 && self.high >= 0.0
    }

    fn has_infinity(self) -> bool {
        self.magnitude() == f64::INFINITY
    }

    fn hull(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high), nan: self.nan || other.nan }
    }
}

/// The interval of every node, for any state.
pub(crate) fn analyse(module: &Module<'_>) -> Vec<Interval> {
    let arithmetic = Arithmetic::new(module.graph);
    let mut intervals: Vec<Interval> = Vec::with_capacity(module.nodes.len());
    for node in &module.nodes {
        intervals.push(match *node {
            Node::Constant(bits) => Interval::exactly(f64::from_bits(bits)),
            Node::Operation(instruction, operands) => {
                let [a, b] = operands.map(|operand| intervals[operand.index()]);
                let square = instruction == Mul && operands[0] == operands[1];
                let interval = apply(arithmetic, instruction, a, b);
                // No square is negative.
                if square { Interval { low: interval.low.max(0.0), ..interval } } else { interval }
            }
            Node::Input(_) | Node::Upper(..) => Interval::ANYTHING,
        });
    }
    intervals
}

/// The interval of an instruction's result.
pub(crate) fn apply(arithmetic: Arithmetic, instruction: Instruction, a: Interval, b: Interval) -> Interval {
    let infinite = f64::INFINITY;
    let ends = |x: f64, y: f64| arithmetic.exact(instruction, x, y);
    let nan = a.nan || b.nan;
    match instruction {
        Add => {
            let opposite = (a.low == -infinite && b.high == infinite) || (a.high == infinite && b.low == -infinite);
            ordered(ends(a.low, b.low), ends(a.high, b.high), nan || opposite)
        }
        Sub => {
            let like = (a.low == -infinite && b.low == -infinite) || (a.high == infinite && b.high == infinite);
            ordered(ends(a.low, b.high), ends(a.high, b.low), nan || like)
        }
        Mul => {
            let zero_times_infinity =
                (a.contains_zero() && b.has_infinity()) || (b.contains_zero() && a.has_infinity());
            corners(ends, a, b, nan || zero_times_infinity, zero_times_infinity)
        }
        Div | Quotient if b.contains_zero() => Interval { low: -infinite, high: infinite, nan: true },
        Div | Quotient => {
            let infinite_quotient = a.has_infinity() && b.has_infinity();
            corners(ends, a, b, nan || infinite_quotient, infinite_quotient)
        }
        NegateIfLess => {
            let magnitude = a.magnitude();
            let whole = Interval { low: -magnitude, high: magnitude, nan: a.nan };
            // Where a is never below b it is itself; where it always is (and b no NaN), its negative.
            if a.low >= b.high {
                Interval { low: a.low, high: a.high, nan: a.nan }
            } else if a.high < b.low && !b.nan {
                Interval { low: -a.high, high: -a.low, nan: a.nan }
            } else {
                whole
            }
        }
        Cos | Sin => Interval { low: -1.0, high: 1.0, nan: a.nan || a.has_infinity() },
        Tan => Interval { low: -infinite, high: infinite, nan: a.nan || a.has_infinity() },
        // Not beyond either operand, and with the sign of the first.
        Fmod => {
            let magnitude = a.magnitude().min(b.magnitude());
            let low = if a.low < 0.0 { -magnitude } else { 0.0 };
            let high = if a.high > 0.0 { magnitude } else { 0.0 };
            Interval { low, high, nan: nan || a.has_infinity() || b.contains_zero() }
        }
        Gate if !b.contains_zero() => a,
        Gate => Interval { low: a.low.min(0.0), high: a.high.max(0.0), nan: a.nan },
        Ln => {
            let low = if a.low > 0.0 { widened_down(arithmetic, a.low.ln()) } else { -infinite };
            let high = if a.high > 0.0 { widened_up(arithmetic, a.high.ln()) } else { -infinite };
            Interval { low, high, nan: a.nan || a.low < 0.0 }
        }
        Exp => {
            let low = widened_down(arithmetic, a.low.exp().min(arithmetic.greatest())).max(0.0);
            let high = widened_up(arithmetic, a.high.exp());
            Interval { low, high: if high > arithmetic.greatest() { infinite } else { high }, nan: a.nan }
        }
        Sqrt => {
            let root = |end: f64| if end > 0.0 { arithmetic.exact(instruction, end, end) } else { 0.0 };
            Interval { low: root(a.low), high: root(a.high), nan: a.nan || a.low < 0.0 }
        }
        Atan => Interval {
            low: widened_down(arithmetic, a.low.atan()),
            high: widened_up(arithmetic, a.high.atan()),
            nan: a.nan,
        },
        Tanh => Interval {
            low: widened_down(arithmetic, a.low.tanh()).max(-1.0),
            high: widened_up(arithmetic, a.high.tanh()).min(1.0),
            nan: a.nan,
        },
        Abs => {
            let low = if a.contains_zero() { 0.0 } else { a.low.abs().min(a.high.abs()) };
            Interval { low, high: a.magnitude(), nan: a.nan }
        }
        // With a NaN on either side they give b, whatever it is.
        Min => {
            let least = Interval { low: a.low.min(b.low), high: a.high.min(b.high), nan: b.nan };
            if a.nan { least.hull(b) } else { least }
        }
        Max => {
            let greatest = Interval { low: a.low.max(b.low), high: a.high.max(b.high), nan: b.nan };
            if a.nan { greatest.hull(b) } else { greatest }
        }
    }
}

/// An end that is NaN (∞ − ∞) says nothing.
fn ordered(low: f64, high: f64, nan: bool) -> Interval {
    Interval {
        low: if low.is_nan() { f64::NEG_INFINITY } else { low },
        high: if high.is_nan() { f64::INFINITY } else { high },
        nan,
    }
}

/// The hull of the results at the four corners, unless one of them need not be an extreme.
fn corners(ends: impl Fn(f64, f64) -> f64, a: Interval, b: Interval, nan: bool, unbounded: bool) -> Interval {
    let results = [ends(a.low, b.low), ends(a.low, b.high), ends(a.high, b.low), ends(a.high, b.high)];
    if unbounded || results.iter().any(|result| result.is_nan()) {
        return Interval { low: f64::NEG_INFINITY, high: f64::INFINITY, nan };
    }
    Interval {
        low: results.iter().copied().fold(f64::INFINITY, f64::min),
        high: results.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        nan,
    }
}

/// More than any provider of maths is off: a hundred thousand ulp of an `f64`, a hundred of an `f32`, and as much of 1,
/// for logarithms of numbers near 1.
fn slack(arithmetic: Arithmetic) -> f64 {
    match arithmetic.scalar {
        ScalarType::F32 => 1e-5,
        ScalarType::F64 => 1e-11,
    }
}

fn widened_up(arithmetic: Arithmetic, value: f64) -> f64 {
    if value.is_infinite() { value } else { value + (value.abs() + 1.0) * slack(arithmetic) }
}

fn widened_down(arithmetic: Arithmetic, value: f64) -> f64 {
    if value.is_infinite() { value } else { value - (value.abs() + 1.0) * slack(arithmetic) }
}

#[cfg(test)]
mod tests {
    use super::{Interval, apply};
    use crate::passes::arithmetic::Arithmetic;
    use proptest::prelude::*;
    use tpg_graph::{MathsProvider, ScalarType};
    use tpg_runtime::ops::Instruction;

    fn end() -> impl Strategy<Value = f64> {
        prop_oneof![
            4 => -50.0..50.0_f64,
            2 => Just(0.0),
            2 => prop_oneof![Just(f64::INFINITY), Just(f64::NEG_INFINITY)],
            1 => prop_oneof![Just(1e30), Just(-1e30), Just(3e38), Just(-3e38), Just(1e-40)],
            1 => prop_oneof![Just(1.0), Just(-1.0), Just(88.5), Just(709.5)],
            1 => any::<f32>().prop_filter("a number", |x| !x.is_nan()).prop_map(f64::from),
        ]
    }

    fn interval() -> impl Strategy<Value = Interval> {
        (end(), end(), any::<bool>()).prop_map(|(x, y, nan)| {
            let [x, y] = [x, y].map(|value| ScalarType::F32.round(value));
            Interval { low: x.min(y), high: x.max(y), nan }
        })
    }

    /// A value of an interval, exact in f32.
    fn pick(interval: Interval, choice: u8, unit: f64) -> f64 {
        let Interval { low, high, nan } = interval;
        match choice % 5 {
            0 if nan => f64::NAN,
            1 => low,
            2 => high,
            3 if low <= 0.0 && high >= 0.0 => 0.0,
            _ => {
                let (low, high) = (low.clamp(-3.4e38, 3.4e38), high.clamp(-3.4e38, 3.4e38));
                ScalarType::F32.round(low + unit * (high - low)).clamp(interval.low, interval.high)
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]
        #[test]
        fn results_lie_in_the_interval(
            a in interval(), b in interval(), which in 0..Instruction::ALL.len(),
            choices in any::<[u8; 2]>(), units in [0.0..1.0_f64, 0.0..1.0_f64], single in any::<bool>(),
        ) {
            let scalar = if single { ScalarType::F32 } else { ScalarType::F64 };
            let arithmetic = Arithmetic { scalar, maths: MathsProvider::Own };
            let instruction = Instruction::ALL[which];
            let (x, y) = (pick(a, choices[0], units[0]), pick(b, choices[1], units[1]));
            let (b, y) = if instruction.arity() == 1 { (a, x) } else { (b, y) };
            let result = arithmetic.evaluate(instruction, x, y).expect("own maths");
            let found = apply(arithmetic, instruction, a, b);
            if result.is_nan() {
                prop_assert!(found.nan, "{instruction:?} {x} {y} is NaN, but {a:?} {b:?} give {found:?}");
            } else {
                prop_assert!(
                    found.low <= result && result <= found.high,
                    "{instruction:?} {x} {y} is {result}, but {a:?} {b:?} give {found:?}"
                );
            }
        }
    }

    #[test]
    fn known_bounds_are_tight() {
        let arithmetic = Arithmetic { scalar: ScalarType::F64, maths: MathsProvider::System };
        let between = |low, high| Interval { low, high, nan: false };
        let motor = between(0.0, 4095.0);
        assert_eq!(apply(arithmetic, Instruction::Cos, motor, motor), between(-1.0, 1.0));
        assert_eq!(apply(arithmetic, Instruction::Sub, motor, between(-600.0, 600.0)), between(-600.0, 4695.0));
        assert_eq!(apply(arithmetic, Instruction::Mul, motor, between(-2.0, 1.0)), between(-8190.0, 4095.0));
        let ln = apply(arithmetic, Instruction::Ln, motor, motor);
        assert!(ln.low == f64::NEG_INFINITY && (8.3..8.4).contains(&ln.high) && !ln.nan, "{ln:?}");
        assert_eq!(apply(arithmetic, Instruction::NegateIfLess, motor, between(-5.0, -1.0)), motor);
    }
}
