//! Comparisons of floats: all are made of one atom, *ranks at most as high*.

use super::rank::{INFINITY, NAN, is_nan_bits, next_below};
use super::{Bool, Float, Node::*, Terms};

/// Choices of at most so many values are compared value by value.
const PUSHED: usize = 48;

impl Terms {
    /// `a < b` of floats: false with a NaN.
    pub fn less(&self, a: Float, b: Float) -> Bool {
        self.and(!self.at_most(b, a), !self.is_nan(a))
    }

    /// `a <= b` of floats: false with a NaN.
    pub fn less_or_equal(&self, a: Float, b: Float) -> Bool {
        self.and(self.at_most(a, b), !self.is_nan(a))
    }

    /// `a == b` of floats: false with a NaN, and true for zeros of any sign.
    pub fn equal(&self, a: Float, b: Float) -> Bool {
        self.and(self.less_or_equal(a, b), self.less_or_equal(b, a))
    }

    /// Tests for NaN.
    pub fn is_nan(&self, a: Float) -> Bool {
        if self.is_whole(a) { Self::FALSE } else { self.at_most(a, self.constant_bits(NAN)) }
    }

    /// Tests whether `a` ranks at most as high as `b`: `a <= b`, or `a` is NaN.
    pub fn at_most(&self, a: Float, b: Float) -> Bool {
        let (a, b) = (self.zero_free(a), self.zero_free(b));
        if a == b {
            return Self::TRUE;
        }
        if let Some(&known) = self.at_most.borrow().get(&(a, b)) {
            return known;
        }
        let result = self.compared(a, b);
        self.at_most.borrow_mut().insert((a, b), result);
        result
    }

    fn compared(&self, a: Float, b: Float) -> Bool {
        if let Some(known) = self.wholes_at_most(a, b) {
            return known;
        }
        match (self.bits_of(a), self.bits_of(b)) {
            (Some(x), None) if is_nan_bits(x) => return Self::TRUE,
            // c <= b unless b ranks at most as high as what is just below c
            (Some(x), None) => {
                return !self.at_most(b, self.constant_bits(next_below(x)));
            }
            (None, Some(INFINITY)) => return Self::TRUE,
            _ => {}
        }
        if let FloatIf(condition, x, y) = self.of_float(a)
            && self.leaves(a.0).len() <= PUSHED
        {
            return self.choose(condition, self.at_most(x, b), self.at_most(y, b));
        }
        if let FloatIf(condition, x, y) = self.of_float(b)
            && self.leaves(b.0).len() <= PUSHED
        {
            return self.choose(condition, self.at_most(a, x), self.at_most(a, y));
        }
        match (self.of_float(a), self.of_float(b)) {
            (Negative(x), Constant(bits)) if is_nan_bits(bits) => self.is_nan(x),
            (Negative(x), Negative(y)) => self.or(self.is_nan(x), self.and(!self.is_nan(y), self.at_most(y, x))),
            _ => self.atom(AtMost(a, b)),
        }
    }
}
