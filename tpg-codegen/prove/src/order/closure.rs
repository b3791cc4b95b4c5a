//! The transitive closure of what is assumed about an order.

use super::bound::Bounds;
use crate::maths::{LIMITS, STEPS};
use crate::term::{Arithmetic, Float, INFINITY, NEGATIVE_ZERO, Node, Terms, rank};
use Arithmetic::*;
use std::collections::HashMap;
use std::rc::Rc;

/// The first element is at most as high as the second, or, with `true`, lower.
type Relation = (usize, usize, bool);

/// Two relations, which may be one, and what follows from them.
type Implication = (Relation, Relation, Relation);

/// An order of elements as far as it is known. Element 0 is NaN.
#[derive(Clone)]
pub(super) struct Closure {
    facts: Rc<[Implication]>,
    words: usize,
    count: usize,
    /// For each element those that are at least, and those that are higher
    reached: Vec<u64>,
    higher: Vec<u64>,
}

impl Closure {
    /// The order of elements that are sorted: NaN, constants, others. None if the facts contradict each other.
    pub(super) fn new(terms: &Terms, elements: &[Float]) -> Option<Self> {
        let count = elements.len();
        let words = count.div_ceil(64);
        let (reached, higher) = (vec![0; count * words], vec![0; count * words]);
        let mut order = Self { facts: Rc::default(), words, count, reached, higher };
        for element in 0..count {
            order.reached[element * words + element / 64] |= 1 << (element % 64);
        }
        let places: HashMap<_, _> = elements.iter().enumerate().map(|(at, &element)| (element, at)).collect();
        let constants: Vec<i128> = elements.iter().map_while(|&element| terms.rank_of(element)).collect();
        let mut facts = Vec::new();
        for at in 1..constants.len() {
            if !order.link((at - 1, at, true)) {
                return None;
            }
            // nothing is between neighbours
            let is_one_kind = terms.is_whole(elements[at - 1]) == terms.is_whole(elements[at]);
            if is_one_kind && constants[at - 1] + 1 == constants[at] {
                for other in 0..count {
                    facts.push(alone((at - 1, other, true), (at, other, false)));
                    facts.push(alone((other, at, true), (other, at - 1, false)));
                }
            }
        }
        let mirror = |element: Float| places.get(&terms.zero_free(terms.negate(element))).copied();
        let mirrors: Vec<_> = (1..count).filter_map(|at| Some((at, mirror(elements[at])?))).collect();
        for &(a, of_a) in &mirrors {
            for &(b, of_b) in mirrors.iter().filter(|&&(b, _)| a.max(b) >= constants.len()) {
                for lower in [false, true] {
                    facts.push(((0, a, true), (a, b, lower), (of_b, of_a, lower)));
                }
            }
        }
        let mut roots = HashMap::new();
        let mut bounds = Bounds::new(terms, elements);
        for (at, &element) in elements.iter().enumerate().skip(constants.len()) {
            if terms.bits_of(elements[constants.len() - 1]) == Some(INFINITY) {
                order.link((at, constants.len() - 1, false));
            }
            if let Some([low, high]) = terms.interval(element) {
                order.link((0, at, true));
                for (place, &constant) in constants.iter().enumerate().skip(1) {
                    if constant >= high {
                        order.link((at, place, false));
                    } else if constant <= low {
                        order.link((place, at, false));
                    }
                }
            }
            let place = |operand: Float| places.get(&terms.zero_free(operand)).copied();
            if let Node::Own(function, argument, _) = terms.of_float(element) {
                facts.extend(place(argument).into_iter().flat_map(|argument| nan_with(argument, at)));
                let lowest = if function == "exp" { 0.0 } else { f32::NEG_INFINITY };
                let lowest = LIMITS.iter().find(|(name, _)| *name == function).map_or(lowest, |(_, limit)| -limit);
                let lowest = constants.iter().rposition(|&constant| constant <= rank(lowest.to_bits()).into());
                facts.extend(lowest.map(|lowest| alone((0, at, true), (lowest, at, false))));
                for (_, from, to) in STEPS.into_iter().filter(|(name, ..)| *name == function) {
                    let [argument, from, to] = [argument, terms.constant(from), terms.constant(to)].map(place);
                    if let (Some(argument), Some(from), Some(to)) = (argument, from, to) {
                        facts.push(((0, argument, true), (argument, from, false), (at, to, true)));
                    }
                }
            }
            if let Some(bounds) = &mut bounds {
                let above = (1..count).filter(|&of| of != at && bounds.is_at_most(element, elements[of]));
                facts.extend(above.map(|of| alone((0, of, true), (at, of, false))));
            }
            facts.extend(nan_alike(at, *roots.entry(nan_root(terms, element)).or_insert(at)));
            if let Node::Root(a) = terms.of_float(element) {
                facts.extend(place(a).into_iter().flat_map(|operand| nan_with(operand, at)));
            }
            let Node::Arithmetic(operation, a, b) = terms.of_float(element) else { continue };
            for (x, y) in [(a, b), (b, a)] {
                let mirrored = place(terms.negate(terms.zero_free(y)));
                facts.extend(place(y).into_iter().chain(mirrored).flat_map(|operand| nan_with(operand, at)));
                if operation == Add
                    && let (Some(zero), Some(x), Some(y)) = (place(terms.constant(0.0)), place(x), mirrored)
                {
                    // x - y > 0 exactly where x > y
                    let (positive, number, above) = ((zero, at, true), (0, y, true), (y, x, true));
                    facts.extend([alone(positive, number), alone(positive, above), (number, above, positive)]);
                    facts.push(alone((x, y, false), (at, zero, false)));
                }
            }
        }
        order.facts = facts.into();
        order.propagate().then_some(order)
    }

    /// Tests whether an element is at most as high as another, if that is known.
    pub(super) fn at_most(&self, a: usize, b: usize) -> Option<bool> {
        if self.holds((a, b, false)) {
            Some(true)
        } else if self.holds((b, a, true)) {
            Some(false)
        } else {
            None
        }
    }

    /// Assumes a relation. False if that cannot be.
    pub(super) fn assume(&mut self, relation: Relation) -> bool {
        self.link(relation) && self.propagate()
    }

    fn holds(&self, (a, b, lower): Relation) -> bool {
        let rows = if lower { &self.higher } else { &self.reached };
        rows[a * self.words + b / 64] >> (b % 64) & 1 == 1
    }

    /// Adds a relation with all that follows by transitivity.
    fn link(&mut self, (a, b, lower): Relation) -> bool {
        if self.holds((a, b, lower)) {
            return true;
        }
        if self.holds((b, a, !lower)) {
            return false;
        }
        for element in 0..self.count {
            if !self.holds((element, a, false)) {
                continue;
            }
            let strict = lower || self.holds((element, a, true));
            for word in 0..self.words {
                let (from, to) = (b * self.words + word, element * self.words + word);
                let (reached, higher) = (self.reached[from], self.higher[from]);
                self.reached[to] |= reached;
                self.higher[to] |= if strict { reached } else { higher };
            }
        }
        true
    }

    /// Applies the facts until nothing follows any more. False if the order contradicts itself.
    fn propagate(&mut self) -> bool {
        let facts = self.facts.clone();
        let mut changed = true;
        while std::mem::take(&mut changed) {
            for &(first, second, then) in facts.iter() {
                if self.holds(first) && self.holds(second) && !self.holds(then) {
                    changed = true;
                    if !self.link(then) {
                        return false;
                    }
                }
            }
        }
        true
    }
}

/// The consequences of one relation.
fn alone(relation: Relation, then: Relation) -> Implication {
    (relation, relation, then)
}

/// An element is NaN where another is.
fn nan_with(from: usize, to: usize) -> [Implication; 2] {
    [alone((from, 0, false), (to, 0, false)), alone((0, to, true), (0, from, true))]
}

/// Elements are NaN at once.
fn nan_alike(a: usize, b: usize) -> impl Iterator<Item = Implication> {
    nan_with(a, b).into_iter().chain(nan_with(b, a))
}

/// Returns the innermost term that is NaN exactly where a term is.
fn nan_root(terms: &Terms, mut term: Float) -> Float {
    loop {
        let inner = match terms.of_float(term) {
            Node::Negative(a) | Node::Magnitude(a) | Node::Own("exp", a, _) => Some(a),
            Node::Arithmetic(operation, a, b) => nan_as(terms, operation, a, b),
            _ => None,
        };
        let Some(inner) = inner else { return term };
        term = terms.zero_free(inner);
    }
}

/// An operand that is NaN exactly where the result is.
fn nan_as(terms: &Terms, operation: Arithmetic, a: Float, b: Float) -> Option<Float> {
    let constant = |term| terms.bits_of(term).filter(|bits| bits & !NEGATIVE_ZERO < INFINITY);
    let nonzero = |term| constant(term).is_some_and(|bits| bits & !NEGATIVE_ZERO != 0);
    match operation {
        Add if constant(b).is_some() => Some(a),
        Add if constant(a).is_some() => Some(b),
        Multiply | Divide if nonzero(b) => Some(a),
        Multiply | Divide if nonzero(a) => Some(b),
        _ => None,
    }
}
