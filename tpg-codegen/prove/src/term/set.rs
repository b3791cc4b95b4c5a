//! Words in sets of numbers. The bits of floats are taken apart only as far as the order of floats goes.

use super::rank::{INFINITY, NEGATIVE_ZERO};
use super::{Arithmetic, Bool, Float, Node, Operator, Terms, Width, Word};
use Node::*;
use Operator::*;

/// The bits of every NaN.
const NANS: [(u64, u64); 2] = [(0x7f80_0001, 0x7fff_ffff), (0xff80_0001, 0xffff_ffff)];

impl Terms {
    /// Tests whether a word is in a set: closed intervals.
    pub fn within(&self, word: Word, width: Width, set: &[(u64, u64)]) -> Bool {
        let (word, set) = self.reduced(word, width, merged(set.to_vec()));
        let mask = width.mask();
        if set.is_empty() {
            return Self::FALSE;
        }
        if set[..] == [(0, mask)] {
            return Self::TRUE;
        }
        match self.of_word(word) {
            WordIf(condition, a, b) => {
                return self.choose(condition, self.within(a, width, &set), self.within(b, width, &set));
            }
            Bits(float) => return self.float_within(float, &set),
            _ if width == Width::W32 && set[..] == NANS => return self.is_nan(self.of_bits(word)),
            _ => {}
        }
        if set[0].0 == 0 {
            let rest = complement(&set, mask);
            return !self.atom(Within(word, rest.into()));
        }
        self.atom(Within(word, set.into()))
    }

    /// The word below operations with constants, and the set that it is in exactly where the whole is in the given set.
    fn reduced(&self, word: Word, width: Width, set: Vec<(u64, u64)>) -> (Word, Vec<(u64, u64)>) {
        let mask = width.mask();
        let Apply(operator, of, a, b) = self.of_word(word) else { return (word, set) };
        if of != width {
            return (word, set);
        }
        let turned = |low: u64, high: u64| if low <= high { vec![(low, high)] } else { vec![(low, mask), (0, high)] };
        let preimage = |map: &dyn Fn(u64, u64) -> Vec<(u64, u64)>| {
            merged(set.iter().flat_map(|&(low, high)| map(low, high)).collect())
        };
        let half = mask / 2 + 1;
        match (operator, self.number_of(a), self.number_of(b)) {
            (Subtract, Some(c), _) => {
                let mirrored = preimage(&|low, high| turned(c.wrapping_sub(high) & mask, c.wrapping_sub(low) & mask));
                self.reduced(b, width, mirrored)
            }
            (Xor, _, Some(c)) if c == mask => {
                self.reduced(a, width, preimage(&|low, high| vec![(!high & mask, !low & mask)]))
            }
            (Add | Xor, _, Some(c)) if operator == Add || c == half => {
                let moved = preimage(&|low, high| turned(low.wrapping_sub(c) & mask, high.wrapping_sub(c) & mask));
                self.reduced(a, width, moved)
            }
            // without its highest bit a number repeats
            (Operator::And, _, Some(c)) if c == half - 1 => {
                let low = set.iter().filter(|&&(low, _)| low < half).map(|&(low, high)| (low, high.min(half - 1)));
                let both = low.flat_map(|(low, high)| [(low, high), (low + half, high + half)]).collect();
                self.reduced(a, width, merged(both))
            }
            (ShiftRight, _, Some(c)) if c < u64::from(width.bits()) => {
                let top = mask >> c;
                let reached = set.iter().filter(|&&(low, _)| low <= top);
                let wider = reached.map(|&(low, high)| (low << c, high.min(top) << c | ((1 << c) - 1))).collect();
                self.reduced(a, width, merged(wider))
            }
            (Operator::And | Or | Xor, ..) if set[..] == [(half, mask)] => {
                let ((first, x), (second, y)) =
                    (self.reduced(a, width, set.clone()), self.reduced(b, width, set.clone()));
                if first != second {
                    return (word, set);
                }
                let without = |x: &[(u64, u64)], y: &[(u64, u64)]| intersection(x, &complement(y, mask));
                let combined = match operator {
                    Operator::And => intersection(&x, &y),
                    Or => merged([x, y].concat()),
                    _ => merged([without(&x, &y), without(&y, &x)].concat()),
                };
                (first, combined)
            }
            _ => (word, set),
        }
    }

    /// Tests whether the bits of a float are in a set.
    fn float_within(&self, float: Float, set: &[(u64, u64)]) -> Bool {
        let (infinity, sign) = (u64::from(INFINITY), u64::from(NEGATIVE_ZERO));
        // the part of the set between two numbers
        let part = |low: u64, high: u64| -> Vec<(u64, u64)> {
            let cut = set.iter().map(|&(from, to)| (from.max(low), to.min(high)));
            cut.filter(|(from, to)| from <= to).collect()
        };
        let (positive_nan, negative_nan) =
            (part(infinity + 1, sign - 1), part(sign + infinity + 1, u64::from(u32::MAX)));
        let whole = |part: &[(u64, u64)], low: u64, high: u64| part == [(low, high)];
        let all_positive = whole(&positive_nan, infinity + 1, sign - 1);
        let all_negative = whole(&negative_nan, sign + infinity + 1, u64::from(u32::MAX));
        if !(all_positive || positive_nan.is_empty()) || !(all_negative || negative_nan.is_empty()) {
            // a matter of payloads
            let word = self.word(Bits(float));
            return self.atom(Within(word, set.into()));
        }
        let mut cases = Vec::new();
        if all_positive || all_negative {
            let nan = self.is_nan(float);
            let which = if all_positive && all_negative {
                Self::TRUE
            } else {
                let negative = self.atom(IsNegativeNan(float));
                if all_negative { negative } else { !negative }
            };
            cases.push(self.and(nan, which));
        }
        for (low, high) in part(1, infinity) {
            cases.push(self.between(float, low as u32, high as u32));
        }
        for (low, high) in part(sign + 1, sign + infinity) {
            cases.push(self.between(float, high as u32, low as u32));
        }
        let (plus, minus) = (!part(0, 0).is_empty(), !part(sign, sign).is_empty());
        if plus || minus {
            let zero = self.between(float, 0, 0);
            let which = if plus && minus {
                Self::TRUE
            } else {
                let negative = self.is_negative_zero(float);
                if minus { negative } else { !negative }
            };
            cases.push(self.and(zero, which));
        }
        self.any(cases)
    }

    /// `low <= float <= high`, for bounds other than NaN
    fn between(&self, float: Float, low: u32, high: u32) -> Bool {
        if low == 1 && high == INFINITY || low == INFINITY | NEGATIVE_ZERO && high == NEGATIVE_ZERO | 1 {
            // the sign of a difference
            let (small, large) = match self.of_float(float) {
                Node::Arithmetic(Arithmetic::Add, a, b) => (self.negate(b), a),
                _ => (self.constant(0.0), float),
            };
            if !matches!(self.of_float(small), Constant(_)) {
                self.uses("x - y > 0 exactly where x > y");
            }
            return if low == 1 { self.less(small, large) } else { self.less(large, small) };
        }
        self.and(
            self.less_or_equal(self.constant_bits(low), float),
            self.less_or_equal(float, self.constant_bits(high)),
        )
    }

    /// Tests for minus zero.
    fn is_negative_zero(&self, float: Float) -> Bool {
        match self.of_float(float) {
            // a sum is minus zero only if both are
            Node::Arithmetic(Arithmetic::Add, a, b) => {
                self.uses("x + y = -0 only where x and y are");
                self.and(self.is_negative_zero(a), self.is_negative_zero(b))
            }
            _ => self.atom(IsNegativeZero(float)),
        }
    }
}

/// Intervals, sorted, with neighbours joined.
fn merged(mut set: Vec<(u64, u64)>) -> Vec<(u64, u64)> {
    set.sort_unstable();
    let mut merged: Vec<(u64, u64)> = Vec::new();
    for (low, high) in set {
        match merged.last_mut() {
            Some(last) if low <= last.1.saturating_add(1) => last.1 = last.1.max(high),
            _ => merged.push((low, high)),
        }
    }
    merged
}

/// The numbers up to a largest that are not in a set.
fn complement(set: &[(u64, u64)], largest: u64) -> Vec<(u64, u64)> {
    let mut rest = Vec::new();
    let mut next = Some(0);
    for &(low, high) in set {
        if let Some(from) = next
            && from < low
        {
            rest.push((from, low - 1));
        }
        next = (high < largest).then(|| high + 1);
    }
    rest.extend(next.map(|from| (from, largest)));
    rest
}

/// The numbers that two sets share.
fn intersection(a: &[(u64, u64)], b: &[(u64, u64)]) -> Vec<(u64, u64)> {
    let pairs = a.iter().flat_map(|x| b.iter().map(move |y| (x.0.max(y.0), x.1.min(y.1))));
    merged(pairs.filter(|(low, high)| low <= high).collect())
}

/// Tests whether a set holds a number.
pub(super) fn holds(set: &[(u64, u64)], number: u64) -> bool {
    set.iter().any(|&(low, high)| (low..=high).contains(&number))
}
