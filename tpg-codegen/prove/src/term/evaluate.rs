//! Exact evaluation of terms for one state.

use super::float::rounded;
use super::rank::{NAN, NEGATIVE_ZERO, is_nan_bits, rank};
use super::set::holds;
use super::word::computed;
use super::{Bool, Float, Node, Terms, Word};
use Node::*;

/// Evaluates terms of one table, state after state. Values of inner nodes are kept for the state that they were computed for.
#[derive(Debug, Default)]
pub struct Evaluator {
    values: Vec<(u32, u64)>,
    round: u32,
    state: Vec<u32>,
    guessed: bool,
}

impl Evaluator {
    /// Makes an evaluator for a state, given as bits.
    #[must_use]
    pub fn new(state: &[u32]) -> Self {
        let mut evaluator = Self::default();
        evaluator.set(state);
        evaluator
    }

    /// Tests whether a value was asked for of which nothing is known, since the state was set.
    #[must_use]
    pub fn has_guessed(&self) -> bool {
        self.guessed
    }

    /// Goes on with another state.
    pub fn set(&mut self, state: &[u32]) {
        self.guessed = false;
        self.round += 1;
        self.state = state.to_vec();
    }

    /// A truth value.
    pub fn truth(&mut self, terms: &Terms, term: Bool) -> bool {
        (self.value(terms, term.0 >> 1) != 0) != (term.0 & 1 == 1)
    }

    /// The bits of a float; those of every NaN are [`NAN`].
    pub fn bits(&mut self, terms: &Terms, term: Float) -> u32 {
        self.value(terms, term.0) as u32
    }

    /// A number, for people.
    pub(crate) fn text(&mut self, terms: &Terms, term: Float) -> String {
        let value = self.value(terms, term.0);
        if terms.is_whole(term) { (value as i64).to_string() } else { format!("{:?}", f32::from_bits(value as u32)) }
    }

    /// A word.
    pub fn word(&mut self, terms: &Terms, term: Word) -> u64 {
        self.value(terms, term.0)
    }

    pub(super) fn value(&mut self, terms: &Terms, at: u32) -> u64 {
        if let Some(&(round, value)) = self.values.get(at as usize)
            && round == self.round
        {
            return value;
        }
        let value = self.computed(terms, &terms.node_at(at));
        if self.values.len() <= at as usize {
            self.values.resize(terms.count(), (0, 0));
        }
        self.values[at as usize] = (self.round, value);
        value
    }

    fn computed(&mut self, terms: &Terms, node: &Node) -> u64 {
        let state = |index: u32| self.state.get(index as usize).copied().unwrap_or_default();
        match *node {
            Source(index) => canonical(state(index)),
            Count(index) => i64::from(state(index) as i32) as u64,
            Unknown(_) => {
                self.guessed = true;
                NAN.into()
            }
            // every NaN is evaluated as a positive one
            IsNegativeNan(_) => 0,
            Bits(a) => self.value(terms, a.0),
            _ => value_of(terms, node, &mut |part| Some(self.value(terms, part))).unwrap_or_default(),
        }
    }
}

/// The bits of a number, or those that stand for every NaN.
fn canonical(bits: u32) -> u64 {
    u64::from(if is_nan_bits(bits) { NAN } else { bits })
}

/// The value of a node, if those of its parts give it. The bits of a NaN are unknown.
pub(super) fn value_of(terms: &Terms, node: &Node, get: &mut dyn FnMut(u32) -> Option<u64>) -> Option<u64> {
    let mut float = |term: Float| get(term.0).map(|bits| bits as u32);
    Some(match *node {
        AtMost(a, b) if terms.is_whole(a) => u64::from(get(a.0)? as i64 <= get(b.0)? as i64),
        Sum(ref products) => {
            let mut sum = 0_u64;
            for (product, by) in products.iter() {
                let mut value = *by as u64;
                for &factor in product {
                    value = value.wrapping_mul(get(factor)?);
                }
                sum = sum.wrapping_add(value);
            }
            sum
        }
        Quotient(a, b) => (get(a.0)? as i64).checked_div(get(b.0)? as i64).unwrap_or_default() as u64,
        Shifted(a, by) => (get(a.0)? as i64).div_euclid(by as i64) as u64,
        AtMost(a, b) => u64::from(rank(float(a)?) <= rank(float(b)?)),
        IsNegativeZero(a) => u64::from(float(a)? == NEGATIVE_ZERO),
        Arithmetic(operation, a, b) => {
            canonical(rounded(operation, f32::from_bits(float(a)?), f32::from_bits(float(b)?)).to_bits())
        }
        Negative(a) => canonical(float(a)? ^ NEGATIVE_ZERO),
        Magnitude(a) => canonical(float(a)? & !NEGATIVE_ZERO),
        Root(a) => canonical(f32::from_bits(float(a)?).sqrt().to_bits()),
        Bits(a) => float(a).filter(|&bits| !is_nan_bits(bits))?.into(),
        True => 1,
        And(ref members) => {
            for &member in members.iter() {
                if !truth(member, get)? {
                    return Some(0);
                }
            }
            1
        }
        Within(word, ref set) => u64::from(holds(set, get(word.0)?)),
        Below(signed, width, a, b) => {
            let (a, b) = (get(a.0)?, get(b.0)?);
            u64::from(if signed { width.signed(a) < width.signed(b) } else { a < b })
        }
        FloatIf(condition, Float(a), Float(b)) | WordIf(condition, Word(a), Word(b)) => {
            let side = if truth(condition, get)? { a } else { b };
            get(side)?
        }
        Own(_, _, definition) => get(definition.0)?,
        OfBits(word) => canonical(get(word.0)? as u32),
        OfInteger(signed, word) => {
            let number = get(word.0)? as u32;
            u64::from(if signed { number as i32 as f32 } else { number as f32 }.to_bits())
        }
        Apply(operator, width, a, b) => computed(operator, width, get(a.0)?, get(b.0)?),
        Element(ref table, index) => *table.get(usize::try_from(get(index.0)?).ok()?)?,
        Constant(bits) => bits.into(),
        Number(number) => number,
        Source(_) | Count(_) | Unknown(_) | IsNegativeNan(_) => return None,
    })
}

fn truth(term: Bool, get: &mut dyn FnMut(u32) -> Option<u64>) -> Option<bool> {
    Some((get(term.0 >> 1)? != 0) != (term.0 & 1 == 1))
}

#[cfg(test)]
mod tests {
    use super::super::{Operator, Terms, Width};
    use super::Evaluator;

    #[test]
    fn evaluates_what_was_built() {
        let terms = Terms::new();
        let (x, y) = (terms.source(0), terms.source(1));
        let (smaller, sum) = (terms.minimum(x, y), terms.add(x, y));
        let bits = terms.bits(sum);
        let one = terms.number(1);
        let word = terms.apply(Operator::Subtract, Width::W32, bits, one);
        for (a, b) in [(1.0, 2.5), (f32::NAN, 1.0), (f32::INFINITY, f32::NEG_INFINITY), (-0.0, 0.0)] {
            let mut evaluator = Evaluator::new(&[f32::to_bits(a), f32::to_bits(b)]);
            let expected = if a < b { a } else { b };
            let got = f32::from_bits(evaluator.bits(&terms, smaller));
            assert!(got.to_bits() == expected.to_bits() || got.is_nan() && expected.is_nan(), "{a} {b} {got}");
            if !(a + b).is_nan() {
                assert_eq!(evaluator.word(&terms, word), u64::from((a + b).to_bits().wrapping_sub(1)));
            }
        }
    }
}
