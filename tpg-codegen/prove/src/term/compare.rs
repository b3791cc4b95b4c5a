//! Comparisons of floats: all are made of one atom, *ranks at most as high*.

use super::rank::{INFINITY, NAN, NEGATIVE_ZERO, is_nan_bits, next_below, rank};
use super::{Bool, Float, Node::*, Terms};

/// Choices of at most so many values are compared value by value.
const PUSHED: usize = 48;

impl Terms {
    /// `a < b` of floats: false with a NaN.
    pub fn less(&mut self, a: Float, b: Float) -> Bool {
        let (reaches, nan) = (self.at_most(b, a), self.is_nan(a));
        self.and(!reaches, !nan)
    }

    /// `a <= b` of floats: false with a NaN.
    pub fn less_or_equal(&mut self, a: Float, b: Float) -> Bool {
        let (at_most, nan) = (self.at_most(a, b), self.is_nan(a));
        self.and(at_most, !nan)
    }

    /// `a == b` of floats: false with a NaN, and true for zeros of any sign.
    pub fn equal(&mut self, a: Float, b: Float) -> Bool {
        let (up, down) = (self.less_or_equal(a, b), self.less_or_equal(b, a));
        self.and(up, down)
    }

    /// Tests for NaN.
    pub fn is_nan(&mut self, a: Float) -> Bool {
        let nan = self.constant_bits(NAN);
        self.at_most(a, nan)
    }

    /// Tests whether `a` ranks at most as high as `b`: `a <= b`, or `a` is NaN.
    pub fn at_most(&mut self, a: Float, b: Float) -> Bool {
        let (a, b) = (self.zero_free(a), self.zero_free(b));
        if a == b {
            return Self::TRUE;
        }
        if let Some(&known) = self.at_most.get(&(a, b)) {
            return known;
        }
        let result = self.compared(a, b);
        self.at_most.insert((a, b), result);
        result
    }

    fn compared(&mut self, a: Float, b: Float) -> Bool {
        match (self.bits_of(a), self.bits_of(b)) {
            (Some(x), Some(y)) => return Self::known(rank(x) <= rank(y)),
            (Some(x), None) if is_nan_bits(x) => return Self::TRUE,
            // c <= b unless b ranks at most as high as what is just below c
            (Some(x), None) => {
                let below = self.constant_bits(next_below(x));
                return !self.at_most(b, below);
            }
            (None, Some(INFINITY)) => return Self::TRUE,
            _ => {}
        }
        if let &FloatIf(condition, x, y) = self.of_float(a)
            && self.leaves(a.0).len() <= PUSHED
        {
            let (x, y) = (self.at_most(x, b), self.at_most(y, b));
            return self.choose(condition, x, y);
        }
        if let &FloatIf(condition, x, y) = self.of_float(b)
            && self.leaves(b.0).len() <= PUSHED
        {
            let (x, y) = (self.at_most(a, x), self.at_most(a, y));
            return self.choose(condition, x, y);
        }
        match (self.of_float(a).clone(), self.of_float(b).clone()) {
            (Negative(x), Constant(bits)) if is_nan_bits(bits) => self.is_nan(x),
            (Magnitude(x), Constant(bits)) if is_nan_bits(bits) => self.is_nan(x),
            // -x <= c where -c <= x
            (Negative(x), Constant(bits)) => {
                let mirrored = self.constant_bits(bits ^ NEGATIVE_ZERO);
                let (nan, above) = (self.is_nan(x), self.at_most(mirrored, x));
                self.or(nan, above)
            }
            (Negative(x), Negative(y)) => {
                let (nan_x, nan_y, above) = (self.is_nan(x), self.is_nan(y), self.at_most(y, x));
                let numbers = self.and(!nan_y, above);
                self.or(nan_x, numbers)
            }
            (Magnitude(x), _) => {
                let (zero, negated) = (self.constant(0.0), self.negate(x));
                let (negative, mirrored, same) = (self.at_most(x, zero), self.at_most(negated, b), self.at_most(x, b));
                self.choose(negative, mirrored, same)
            }
            (_, Magnitude(y)) => {
                let (zero, negated) = (self.constant(0.0), self.negate(y));
                let (negative, mirrored, same) = (self.at_most(y, zero), self.at_most(a, negated), self.at_most(a, y));
                self.choose(negative, mirrored, same)
            }
            _ => self.atom(AtMost(a, b)),
        }
    }
}
