//! Machine words. Those that hold few numbers are choices of constants; the bits of floats are taken apart only as far as the order
//! of floats goes.

use super::rank::{NAN, NEGATIVE_ZERO};
use super::{Bool, Float, Node::*, Operator, Terms, Width, Word};
use std::rc::Rc;

/// Operations of two choices of constants go into both if there are at most so many pairs.
const PAIRS: usize = 4096;

impl Width {
    /// The number of bits.
    #[must_use]
    pub const fn bits(self) -> u32 {
        match self {
            Self::W32 => 32,
            Self::W64 => 64,
        }
    }

    /// The largest number.
    #[must_use]
    pub const fn mask(self) -> u64 {
        match self {
            Self::W32 => 0xffff_ffff,
            Self::W64 => u64::MAX,
        }
    }

    pub(crate) const fn signed(self, number: u64) -> i64 {
        match self {
            Self::W32 => number as u32 as i32 as i64,
            Self::W64 => number as i64,
        }
    }
}

/// An operation on numbers.
pub(crate) fn computed(operator: Operator, width: Width, a: u64, b: u64) -> u64 {
    let wide = b >= u64::from(width.bits());
    let result = match operator {
        Operator::Add => a.wrapping_add(b),
        Operator::Subtract => a.wrapping_sub(b),
        Operator::Multiply => a.wrapping_mul(b),
        Operator::And => a & b,
        Operator::Or => a | b,
        Operator::Xor => a ^ b,
        Operator::ShiftLeft => {
            if wide {
                0
            } else {
                a << b
            }
        }
        Operator::ShiftRight => {
            if wide {
                0
            } else {
                (a & width.mask()) >> b
            }
        }
        Operator::ShiftArithmetic => (width.signed(a) >> b.min(u64::from(width.bits()) - 1)) as u64,
    };
    result & width.mask()
}

impl Terms {
    /// A constant word.
    pub fn number(&self, number: u64) -> Word {
        self.word(Number(number))
    }

    /// The number of a constant word.
    #[must_use]
    pub fn number_of(&self, word: Word) -> Option<u64> {
        match self.of_word(word) {
            Number(number) => Some(number),
            _ => None,
        }
    }

    /// 1 where the condition holds, else 0.
    pub fn word_of(&self, condition: Bool) -> Word {
        self.choose_word(condition, self.number(1), self.number(0))
    }

    /// A choice between two words.
    pub fn choose_word(&self, condition: Bool, a: Word, b: Word) -> Word {
        Word(self.chosen(condition, a.0, b.0, |condition, a, b| WordIf(condition, Word(a), Word(b))))
    }

    /// The numbers that a word can be, if it is a constant or a choice of constants. Sorted.
    #[must_use]
    pub fn numbers(&self, word: Word) -> Option<Vec<u64>> {
        let leaves = self.leaves(word.0);
        let mut numbers = leaves.iter().map(|&leaf| self.number_of(Word(leaf))).collect::<Option<Vec<_>>>()?;
        numbers.sort_unstable();
        numbers.dedup();
        Some(numbers)
    }

    /// A number that a word is at most.
    #[must_use]
    pub fn largest(&self, word: Word) -> u64 {
        match self.of_word(word) {
            Number(number) => number,
            WordIf(_, a, b) => self.largest(a).max(self.largest(b)),
            Apply(Operator::And, _, a, b) => self.largest(a).min(self.largest(b)),
            Apply(Operator::ShiftRight, width, a, b) => match self.number_of(b) {
                Some(by) => computed(Operator::ShiftRight, width, self.largest(a), by),
                None => width.mask(),
            },
            Apply(_, width, ..) => width.mask(),
            Bits(_) => Width::W32.mask(),
            _ => Width::W64.mask(),
        }
    }

    /// The bits of a float.
    pub fn bits(&self, float: Float) -> Word {
        match self.of_float(float) {
            OfBits(word) => word,
            FloatIf(condition, a, b) => self.choose_word(condition, self.bits(a), self.bits(b)),
            _ => self.word(Bits(float)),
        }
    }

    /// The float with these bits, of 32.
    pub fn of_bits(&self, word: Word) -> Float {
        match self.of_word(word) {
            Bits(float) => float,
            WordIf(condition, a, b) => self.choose_float(condition, self.of_bits(a), self.of_bits(b)),
            // the sign turned, and the sign taken off
            Apply(Operator::Xor, Width::W32, a, b) if self.number_of(b) == Some(u64::from(NEGATIVE_ZERO)) => {
                self.negate(self.of_bits(a))
            }
            Apply(Operator::And, Width::W32, a, b) if self.number_of(b) == Some(u64::from(!NEGATIVE_ZERO)) => {
                self.magnitude(self.of_bits(a))
            }
            // ones where every NaN has them
            Apply(Operator::Or, Width::W32, _, b) if self.number_of(b).is_some_and(|ones| ones as u32 & NAN == NAN) => {
                self.constant_bits(NAN)
            }
            _ => self.float(OfBits(word)),
        }
    }

    /// A 32-bit integer, rounded to a float.
    pub fn of_integer(&self, signed: bool, word: Word) -> Float {
        match self.of_word(word) {
            WordIf(condition, a, b) => {
                self.choose_float(condition, self.of_integer(signed, a), self.of_integer(signed, b))
            }
            _ => self.float(OfInteger(signed, word)),
        }
    }

    /// An element of a constant table. The index must be below its length; that is for the caller to see to.
    pub fn element(&self, table: &Rc<[u64]>, index: Word) -> Word {
        match self.of_word(index) {
            WordIf(..) => self.mapped(index, &mut |index| self.element(table, index)),
            _ => self.word(Element(table.clone(), index)),
        }
    }

    /// A word with a function applied to each word that it is chosen from. Shared choices stay shared.
    pub fn mapped(&self, word: Word, function: &mut dyn FnMut(Word) -> Word) -> Word {
        let mut done = std::collections::HashMap::new();
        self.mapped_with(word, function, &mut done)
    }

    fn mapped_with(
        &self,
        word: Word,
        function: &mut dyn FnMut(Word) -> Word,
        done: &mut std::collections::HashMap<Word, Word>,
    ) -> Word {
        if let Some(&known) = done.get(&word) {
            return known;
        }
        let result = match self.of_word(word) {
            WordIf(condition, a, b) => {
                let (a, b) = (self.mapped_with(a, function, done), self.mapped_with(b, function, done));
                self.choose_word(condition, a, b)
            }
            _ => function(word),
        };
        done.insert(word, result);
        result
    }

    /// An operation of two words.
    pub fn apply(&self, operator: Operator, width: Width, a: Word, b: Word) -> Word {
        // masks and numbers that are chosen from go into the operation; what they are applied to stays whole
        let [first, second] = [a, b].map(|word| self.numbers(word).map_or(0, |numbers| numbers.len()));
        if let (WordIf(x, a1, a2), WordIf(y, b1, b2)) = (self.of_word(a), self.of_word(b))
            && x == y
        {
            return self.choose_word(x, self.apply(operator, width, a1, b1), self.apply(operator, width, a2, b2));
        }
        if first.max(1) * second.max(1) <= PAIRS {
            if second > 1 {
                return self.mapped(b, &mut |b| self.apply(operator, width, a, b));
            }
            if first > 1 {
                return self.mapped(a, &mut |a| self.apply(operator, width, a, b));
            }
        }
        if matches!(operator, Operator::And | Operator::Or | Operator::Xor) {
            for (choice, other) in [(b, a), (a, b)] {
                if let WordIf(condition, x, y) = self.of_word(choice)
                    && self.cancels(width, choice, other)
                {
                    return self.choose_word(
                        condition,
                        self.apply(operator, width, other, x),
                        self.apply(operator, width, other, y),
                    );
                }
            }
        }
        self.simplified(operator, width, a, b)
    }

    /// Tests whether a bitwise operation of a choice and another word becomes simpler in some case.
    fn cancels(&self, width: Width, choice: Word, other: Word) -> bool {
        self.leaves(choice.0).iter().any(|&leaf| match self.of_word(Word(leaf)) {
            Number(number) => number == 0 || number == width.mask(),
            Apply(Operator::Xor, _, p, q) => p == other || q == other,
            _ => leaf == other.0,
        })
    }

    fn simplified(&self, operator: Operator, width: Width, a: Word, b: Word) -> Word {
        use Operator::{Add, And, Multiply, Or, ShiftArithmetic, ShiftLeft, ShiftRight, Subtract, Xor};
        let commutes = matches!(operator, Add | Multiply | And | Or | Xor);
        // constants are second
        let swaps = commutes && (self.number_of(a).is_some() || self.number_of(b).is_none() && a > b);
        let (a, b) = if swaps { (b, a) } else { (a, b) };
        let ones = width.mask();
        match (operator, self.number_of(b)) {
            (Add | Or | Xor | Subtract | ShiftLeft | ShiftRight | ShiftArithmetic, Some(0)) => return a,
            (And | Multiply, Some(0)) => return b,
            (Multiply, Some(1)) => return a,
            (And, Some(number)) if number == ones => return a,
            (Or, Some(number)) if number == ones => return b,
            (Xor | Subtract, _) if a == b => return self.number(0),
            // a difference by a constant is a sum
            (Subtract, Some(number)) => return self.apply(Add, width, a, self.number(number.wrapping_neg() & ones)),
            // the sign alone
            (ShiftRight | ShiftArithmetic, Some(number)) if number == u64::from(width.bits()) - 1 => {
                let (negative, zero) = (self.is_negative(width, a), self.number(0));
                return self.choose_word(negative, self.number(if operator == ShiftRight { 1 } else { ones }), zero);
            }
            (Xor | Add | And | Or, Some(number)) => {
                if let Apply(inner, of, p, q) = self.of_word(a)
                    && (inner, of) == (operator, width)
                    && let Some(q) = self.number_of(q)
                {
                    return self.apply(operator, width, p, self.number(computed(operator, width, q, number)));
                }
            }
            // the distance of two addresses
            (Subtract, None) if self.moved(width, a).0 == self.moved(width, b).0 => {
                return self.number(self.moved(width, a).1.wrapping_sub(self.moved(width, b).1) & ones);
            }
            (Xor, None) => {
                for (word, other) in [(a, b), (b, a)] {
                    match self.of_word(word) {
                        Apply(Xor, _, p, q) if p == other => return q,
                        Apply(Xor, _, p, q) if q == other => return p,
                        _ => {}
                    }
                }
            }
            _ => {}
        }
        self.word(Apply(operator, width, a, b))
    }

    /// A word as a sum with a constant.
    fn moved(&self, width: Width, word: Word) -> (Word, u64) {
        match self.of_word(word) {
            Apply(Operator::Add, of, base, by) if of == width => self.number_of(by).map_or((word, 0), |by| (base, by)),
            _ => (word, 0),
        }
    }

    /// Tests the sign bit.
    pub fn is_negative(&self, width: Width, word: Word) -> Bool {
        self.within(word, width, &[(width.mask() / 2 + 1, width.mask())])
    }

    /// `a == b`
    pub fn same(&self, width: Width, a: Word, b: Word) -> Bool {
        if a == b {
            return Self::TRUE;
        }
        if let Some(b) = self.number_of(b) {
            return self.within(a, width, &[(b, b)]);
        }
        self.within(self.apply(Operator::Subtract, width, a, b), width, &[(0, 0)])
    }

    /// `a < b` of unsigned or signed numbers.
    pub fn below(&self, signed: bool, width: Width, a: Word, b: Word) -> Bool {
        let half = width.mask() / 2 + 1;
        let shifted = |number: u64| if signed { number ^ half } else { number };
        // the numbers whose order is between two places, seen as unsigned ones
        let between = |low: u64, high: u64| {
            if !signed {
                vec![(low, high)]
            } else if low < half && high >= half {
                vec![(0, high ^ half), (low ^ half, width.mask())]
            } else {
                vec![(low ^ half, high ^ half)]
            }
        };
        match (self.number_of(a), self.number_of(b)) {
            (_, Some(b)) => match shifted(b).checked_sub(1) {
                None => Self::FALSE,
                Some(last) => self.within(a, width, &between(0, last)),
            },
            (Some(a), _) if shifted(a) == width.mask() => Self::FALSE,
            (Some(a), _) => self.within(b, width, &between(shifted(a) + 1, width.mask())),
            _ if a == b => Self::FALSE,
            _ => match (self.of_word(a), self.of_word(b)) {
                (WordIf(condition, x, y), _) => {
                    self.choose(condition, self.below(signed, width, x, b), self.below(signed, width, y, b))
                }
                (_, WordIf(condition, x, y)) => {
                    self.choose(condition, self.below(signed, width, a, x), self.below(signed, width, a, y))
                }
                _ => self.atom(Below(signed, width, a, b)),
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Operator, Terms, Width};

    #[test]
    fn masks_of_differences_are_comparisons() {
        let terms = Terms::new();
        let (a, b) = (terms.source(0), terms.source(1));
        let difference = terms.subtract(a, b);
        let bits = terms.bits(difference);
        let w = Width::W32;
        let [one, infinity, ones, top, zero] = [1, 0x7f80_0000, 0xffff_ffff, 31, 0].map(|number| terms.number(number));
        let before = terms.apply(Operator::Subtract, w, bits, one);
        let lower = terms.apply(Operator::Subtract, w, before, infinity);
        let inverted = terms.apply(Operator::Xor, w, before, ones);
        let both = terms.apply(Operator::And, w, lower, inverted);
        let sign = terms.apply(Operator::ShiftRight, w, both, top);
        let mask = terms.apply(Operator::Subtract, w, zero, sign);
        let above = terms.less(b, a);
        assert_eq!(mask, terms.choose_word(above, ones, zero));
        // b ^ ((a ^ b) & mask) chooses
        let (a_bits, b_bits) = (terms.bits(a), terms.bits(b));
        let differing = terms.apply(Operator::Xor, w, a_bits, b_bits);
        let kept = terms.apply(Operator::And, w, differing, mask);
        let chosen = terms.apply(Operator::Xor, w, b_bits, kept);
        let float = terms.of_bits(chosen);
        assert_eq!(float, terms.choose_float(above, a, b));
    }

    #[test]
    fn a_mask_of_nan_is_a_test_for_it() {
        let terms = Terms::new();
        let a = terms.source(0);
        let bits = terms.bits(a);
        let w = Width::W32;
        let [magnitude, infinity, top] = [0x7fff_ffff, 0x7f80_0000, 31].map(|number| terms.number(number));
        let magnitude = terms.apply(Operator::And, w, bits, magnitude);
        let difference = terms.apply(Operator::Subtract, w, infinity, magnitude);
        let sign = terms.apply(Operator::ShiftRight, w, difference, top);
        let nan = terms.is_nan(a);
        assert_eq!(sign, terms.word_of(nan));
    }

    #[test]
    fn comparisons_of_choices_of_constants_are_decided() {
        let terms = Terms::new();
        let (x, y) = (terms.source(0), terms.source(1));
        let less = terms.less(x, y);
        let (three, five) = (terms.number(3), terms.number(0xffff_fffb));
        let word = terms.choose_word(less, three, five);
        let four = terms.number(4);
        assert_eq!(terms.below(false, Width::W32, word, four), less);
        assert_eq!(terms.below(true, Width::W32, word, four), Terms::TRUE);
        assert_eq!(terms.same(Width::W32, word, three), less);
        assert_eq!(terms.numbers(word), Some(vec![3, 0xffff_fffb]));
    }
}
