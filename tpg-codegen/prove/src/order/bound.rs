//! Bounds of what functions of own maths compute: for these, code skips functions that cannot matter.
//!
//! Rounding is monotone: where operands are not greater, neither is a sum, nor the magnitude of a product.

use crate::maths::LIMITS;
use crate::term::{Arithmetic::*, Float, INFINITY, NEGATIVE_ZERO, Node, Terms};
use std::collections::{HashMap, HashSet};

/// The bits of 1.
const ONE: u32 = 0x3f80_0000;

/// Bounds among terms, which share parts.
pub(super) struct Bounds<'t> {
    terms: &'t Terms,
    at_most: HashMap<(Float, Float), bool>,
    within: HashMap<(Float, Float), bool>,
    highest: HashMap<Float, Option<f32>>,
}

impl<'t> Bounds<'t> {
    /// Bounds of terms; none if none of them holds a function.
    pub(super) fn new(terms: &'t Terms, elements: &[Float]) -> Option<Self> {
        let (mut seen, mut open) = (HashSet::new(), elements.to_vec());
        while let Some(term) = open.pop() {
            match terms.of_float(term) {
                Node::Own(..) => {
                    let (at_most, within, highest) = (HashMap::new(), HashMap::new(), HashMap::new());
                    return Some(Self { terms, at_most, within, highest });
                }
                Node::Negative(a) | Node::Magnitude(a) => open.extend(seen.insert(term).then_some(a)),
                Node::Arithmetic(_, a, b) | Node::FloatIf(_, a, b) if seen.insert(term) => open.extend([a, b]),
                _ => {}
            }
        }
        None
    }

    /// Tests whether a number ranks at most as high as another wherever that is no NaN.
    pub(super) fn is_at_most(&mut self, a: Float, b: Float) -> bool {
        if let Some(&known) = self.at_most.get(&(a, b)) {
            return known;
        }
        let is_below = match self.terms.of_float(b) {
            Node::Constant(bits) => self.highest(a).is_some_and(|highest| highest <= f32::from_bits(bits)),
            _ => false,
        };
        let holds = a == b || is_below || self.is_within(a, b) || self.is_sum_or_minimum_at_most(a, b);
        self.at_most.insert((a, b), holds);
        holds
    }

    /// Returns a number that a term is never above, if functions and constants alone give one.
    fn highest(&mut self, term: Float) -> Option<f32> {
        if let Some(&known) = self.highest.get(&term) {
            return known;
        }
        let highest = match self.terms.of_float(term) {
            Node::Constant(bits) => Some(f32::from_bits(bits)),
            Node::Own(function, ..) => LIMITS.iter().find(|(name, _)| *name == function).map(|(_, limit)| *limit),
            // the limits of functions hold on both sides
            Node::Negative(a) if matches!(self.terms.of_float(a), Node::Own(..)) => self.highest(a),
            Node::Arithmetic(Add, a, b) => self.highest(a).zip(self.highest(b)).map(|(a, b)| a + b),
            _ => None,
        };
        self.highest.insert(term, highest);
        highest
    }

    fn is_sum_or_minimum_at_most(&mut self, a: Float, b: Float) -> bool {
        let terms = self.terms;
        match (terms.of_float(a), terms.of_float(b)) {
            (Node::Arithmetic(Add, x, y), sum) => {
                let parts = match sum {
                    Node::Arithmetic(Add, u, v) => {
                        orders(u, v).any(|(u, v)| self.is_at_most(x, u) && self.is_at_most(y, v))
                    }
                    _ => false,
                };
                parts || orders(x, y).any(|(x, y)| is_negative(terms, y) && self.is_at_most(x, b))
            }
            // a minimum is at most its second operand
            (Node::FloatIf(condition, x, y), _) => {
                let [first, second] = [x, y].map(|side| self.is_at_most(side, b));
                let is_minimum = |condition, x, y| condition == terms.less(x, y);
                first && (second || is_minimum(!condition, y, x)) || second && is_minimum(condition, x, y)
            }
            _ => false,
        }
    }

    /// Tests whether the magnitude of a number ranks at most as high as another wherever that is no NaN.
    fn is_within(&mut self, a: Float, b: Float) -> bool {
        if let Some(&known) = self.within.get(&(a, b)) {
            return known;
        }
        let holds = self.has_magnitude_within(a, b);
        self.within.insert((a, b), holds);
        holds
    }

    fn has_magnitude_within(&mut self, a: Float, b: Float) -> bool {
        let terms = self.terms;
        match (terms.of_float(a), terms.of_float(b)) {
            (Node::Constant(x), Node::Constant(y)) => x & !NEGATIVE_ZERO <= y && y <= INFINITY,
            (Node::Own(function, ..), Node::Constant(bits)) => {
                let limit = LIMITS.iter().find(|(name, _)| *name == function);
                limit.is_some_and(|(_, limit)| (limit.to_bits()..=INFINITY).contains(&bits))
            }
            (Node::Negative(x) | Node::Magnitude(x), _) => self.is_within(x, b),
            (_, Node::Magnitude(y)) if y == a => true,
            (Node::FloatIf(_, x, y), _) => self.is_within(x, b) && self.is_within(y, b),
            (Node::Arithmetic(Multiply, x, y), bound) => {
                let one = terms.constant_bits(ONE);
                let factors = match bound {
                    Node::Arithmetic(Multiply, u, v) => {
                        orders(u, v).any(|(u, v)| self.is_within(x, u) && self.is_within(y, v))
                    }
                    _ => false,
                };
                factors || orders(x, y).any(|(x, y)| self.is_within(y, one) && self.is_within(x, b))
            }
            (Node::Arithmetic(Divide, x, y), Node::Arithmetic(Divide, u, v)) => {
                terms.magnitude(y) == v && self.is_within(x, u)
            }
            (sum, Node::Arithmetic(Add, u, v)) => {
                let parts = match sum {
                    Node::Arithmetic(Add, x, y) => {
                        orders(u, v).any(|(u, v)| self.is_within(x, u) && self.is_within(y, v))
                    }
                    _ => false,
                };
                parts || orders(u, v).any(|(u, v)| is_positive(terms, v) && self.is_within(a, u))
            }
            _ => false,
        }
    }
}

/// Tests for what is never above 0.
fn is_negative(terms: &Terms, term: Float) -> bool {
    matches!(terms.of_float(term), Node::Negative(a) if is_positive(terms, a))
}

/// Tests for what is never below 0.
fn is_positive(terms: &Terms, term: Float) -> bool {
    match terms.of_float(term) {
        Node::Own(function, ..) => function == "exp",
        Node::Magnitude(_) => true,
        Node::Constant(bits) => bits <= INFINITY,
        Node::Arithmetic(Add | Multiply | Divide, a, b) => is_positive(terms, a) && is_positive(terms, b),
        _ => false,
    }
}

/// Two operands in both orders.
fn orders(a: Float, b: Float) -> impl Iterator<Item = (Float, Float)> {
    [(a, b), (b, a)].into_iter()
}
