//! Intervals with NaN: bounds of every term, from the bounds of what it is made of.
//!
//! Rounding to nearest is monotone, so the rounded results at the ends of intervals bound all results between.

use crate::term::{Arithmetic, Float, Node, Terms};
use Arithmetic::*;
use Node::*;
use std::collections::HashMap;

/// What a value can be: a number from `low` to `high`, or NaN if `nan`; no number where `low > high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The lowest number
    pub low: f32,
    /// The highest number
    pub high: f32,
    /// The value can be NaN
    pub nan: bool,
}

const ANY: Interval = Interval { low: f32::NEG_INFINITY, high: f32::INFINITY, nan: true };
const NOTHING: Interval = Interval { low: f32::INFINITY, high: f32::NEG_INFINITY, nan: false };

/// The intervals of terms of one table.
#[derive(Debug, Default)]
pub struct Intervals {
    ranges: Vec<[f32; 2]>,
    known: HashMap<Float, Interval>,
}

impl Intervals {
    /// Intervals with sources that are in ranges and never NaN; those beyond the list can be anything.
    #[must_use]
    pub fn new(ranges: &[[f32; 2]]) -> Self {
        Self { ranges: ranges.to_vec(), known: HashMap::new() }
    }

    /// The interval of a term.
    pub fn interval(&mut self, terms: &Terms, term: Float) -> Interval {
        let bounds = self.bounds(terms, term);
        if bounds.low > bounds.high && !bounds.nan { ANY } else { bounds }
    }

    fn bounds(&mut self, terms: &Terms, term: Float) -> Interval {
        if let Some(&known) = self.known.get(&term) {
            return known;
        }
        let result = match terms.of_float(term) {
            Constant(bits) => {
                let value = f32::from_bits(bits);
                if value.is_nan() {
                    Interval { nan: true, ..NOTHING }
                } else {
                    Interval { low: value, high: value, nan: false }
                }
            }
            Source(index) => match self.ranges.get(index as usize) {
                Some(&[low, high]) => Interval { low, high, nan: false },
                None => ANY,
            },
            Node::Arithmetic(operation, a, b) => combined(operation, self.bounds(terms, a), self.bounds(terms, b)),
            Negative(a) => {
                let a = self.bounds(terms, a);
                Interval { low: -a.high, high: -a.low, nan: a.nan }
            }
            Magnitude(a) => {
                let Interval { low, high, nan } = self.bounds(terms, a);
                if low > high {
                    Interval { nan, ..NOTHING }
                } else {
                    let least = if low <= 0.0 && high >= 0.0 { 0.0 } else { low.abs().min(high.abs()) };
                    Interval { low: least, high: low.abs().max(high.abs()), nan }
                }
            }
            FloatIf(_, a, b) => {
                let (a, b) = (self.bounds(terms, a), self.bounds(terms, b));
                Interval { low: a.low.min(b.low), high: a.high.max(b.high), nan: a.nan || b.nan }
            }
            _ => ANY,
        };
        self.known.insert(term, result);
        result
    }
}

fn combined(operation: Arithmetic, a: Interval, b: Interval) -> Interval {
    let nan = a.nan || b.nan;
    if a.low > a.high || b.low > b.high {
        return Interval { nan, ..NOTHING };
    }
    let zero = |x: Interval| x.low <= 0.0 && x.high >= 0.0;
    let infinite = |x: Interval| x.low.is_infinite() || x.high.is_infinite();
    let corners = |f: fn(f32, f32) -> f32| [f(a.low, b.low), f(a.low, b.high), f(a.high, b.low), f(a.high, b.high)];
    let (corners, undefined) = match operation {
        Add => {
            let clash = a.low == f32::NEG_INFINITY && b.high == f32::INFINITY
                || a.high == f32::INFINITY && b.low == f32::NEG_INFINITY;
            let (low, high) = (a.low + b.low, a.high + b.high);
            // the lowest sum is only NaN where infinities of both signs meet
            ([low, low, high, high], clash)
        }
        Multiply => (corners(|x, y| x * y), zero(a) && infinite(b) || zero(b) && infinite(a)),
        Divide if zero(b) || infinite(b) => {
            return Interval { nan: nan || zero(a) && zero(b) || infinite(a) && infinite(b), ..ANY };
        }
        Divide => (corners(|x, y| x / y), false),
        Remainder => return ANY,
    };
    if undefined && operation == Multiply || corners.iter().any(|corner| corner.is_nan()) {
        return Interval { nan: nan || undefined, ..ANY };
    }
    let [low, high] =
        [f32::min as fn(f32, f32) -> f32, f32::max].map(|f| corners.into_iter().reduce(f).unwrap_or(f32::NAN));
    Interval { low, high, nan: nan || undefined }
}

#[cfg(test)]
mod tests {
    use super::Intervals;
    use crate::term::Terms;

    #[test]
    fn bounds_hold_what_can_be() {
        let terms = Terms::new();
        let (x, y, one) = (terms.source(0), terms.source(1), terms.constant(1.0));
        let mut intervals = Intervals::new(&[[-2.0, 3.0]]);
        let square = terms.multiply(x, x);
        let bounds = intervals.interval(&terms, square);
        assert_eq!((bounds.low, bounds.high, bounds.nan), (-6.0, 9.0, false));
        let larger = terms.maximum(one, y);
        assert!(intervals.interval(&terms, larger).nan, "a NaN that is second is the result");
        let any = terms.add(y, y);
        assert!(intervals.interval(&terms, any).nan);
    }
}
