//! The transitive closure of what is assumed about an order.

use crate::interval::Intervals;
use crate::term::{Arithmetic, Float, INFINITY, NEGATIVE_ZERO, Node, Terms, next_above, rank};
use Arithmetic::*;
use std::collections::HashMap;
use std::rc::Rc;

/// What is known of the elements for good.
#[derive(Default)]
struct OrderFacts {
    /// Where the negated element is
    mirror: Vec<Option<usize>>,
    /// The constant that an element reaches unless it is NaN
    lowest: Vec<Option<usize>>,
    /// An element that is NaN exactly where this one is
    nan_as: Vec<(usize, usize)>,
    /// An element that makes the other NaN where it is
    nan_with: Vec<(usize, usize)>,
    /// Zero, and an element that is the difference of two more
    differences: Vec<[usize; 4]>,
    /// Constants of neighbouring ranks
    neighbours: Vec<(usize, usize)>,
}

/// An order of elements as far as it is known. Element 0 is NaN.
#[derive(Clone)]
pub(super) struct Closure {
    facts: Rc<OrderFacts>,
    words: usize,
    count: usize,
    /// For each element those that are at least, and those that are higher
    reached: Vec<u64>,
    higher: Vec<u64>,
}

impl Closure {
    /// The order of elements that are sorted: NaN, constants, others. None if the facts contradict each other.
    pub(super) fn new(terms: &Terms, intervals: &mut Intervals, elements: &[Float]) -> Option<Self> {
        let count = elements.len();
        let words = count.div_ceil(64);
        let facts = OrderFacts { mirror: vec![None; count], lowest: vec![None; count], ..OrderFacts::default() };
        let mut order = Self {
            facts: Rc::new(OrderFacts::default()),
            words,
            count,
            reached: vec![0; count * words],
            higher: vec![0; count * words],
        };
        for element in 0..count {
            order.reached[element * words + element / 64] |= 1 << (element % 64);
        }
        let facts = order.learn(terms, intervals, elements, facts)?;
        order.facts = Rc::new(facts);
        order.propagate().then_some(order)
    }

    fn learn(
        &mut self,
        terms: &Terms,
        intervals: &mut Intervals,
        elements: &[Float],
        mut facts: OrderFacts,
    ) -> Option<OrderFacts> {
        let places: HashMap<_, _> = elements.iter().enumerate().map(|(at, &element)| (element, at)).collect();
        let constants: Vec<u32> = elements.iter().map_while(|&element| terms.bits_of(element)).collect();
        let mut roots = HashMap::new();
        for at in 1..constants.len() {
            if !self.link(at - 1, at, true) {
                return None;
            }
            if next_above(constants[at - 1]) == constants[at] {
                facts.neighbours.push((at - 1, at));
            }
        }
        for (at, &element) in elements.iter().enumerate().skip(1) {
            facts.mirror[at] = places.get(&terms.zero_free(terms.negate(element))).copied();
            if at < constants.len() {
                continue;
            }
            let interval = intervals.interval(terms, element);
            let reaches = |bound: f32| constants.iter().rposition(|&constant| rank(constant) <= rank(bound.to_bits()));
            let limits = |bound: f32| constants.iter().position(|&constant| rank(constant) >= rank(bound.to_bits()));
            if let Some(high) = limits(interval.high)
                && !self.link(at, high, false)
            {
                return None;
            }
            if !interval.nan && !self.link(0, at, true) {
                return None;
            }
            facts.lowest[at] = reaches(interval.low).filter(|&low| low > 0);
            let root = Self::relate(terms, &places, (at, element), &mut facts);
            facts.nan_as.push((at, *roots.entry(root).or_insert(at)));
        }
        Some(facts)
    }

    /// Learns how an operation's result depends on its operands. Returns what is NaN exactly where the result is.
    fn relate(
        terms: &Terms,
        places: &HashMap<Float, usize>,
        (at, element): (usize, Float),
        facts: &mut OrderFacts,
    ) -> Float {
        let mut inner = element;
        loop {
            let next = match terms.of_float(inner) {
                Node::Negative(a) | Node::Magnitude(a) => a,
                Node::Arithmetic(operation, a, b) => match nan_with(terms, operation, a, b) {
                    Some(other) => other,
                    None => break,
                },
                _ => break,
            };
            inner = terms.zero_free(next);
            facts.nan_as.extend(places.get(&inner).map(|&other| (at, other)));
        }
        let Node::Arithmetic(operation, a, b) = terms.of_float(element) else { return inner };
        let [a, b] = [a, b].map(|operand| terms.zero_free(operand));
        for operand in [a, b] {
            let mirrored = terms.negate(operand);
            for operand in [operand, mirrored] {
                facts.nan_with.extend(places.get(&operand).map(|&operand| (operand, at)));
            }
        }
        if operation == Add {
            let zero = terms.constant(0.0);
            for (a, b) in [(a, b), (b, a)] {
                let mirrored = terms.negate(b);
                if let (Some(&zero), Some(&a), Some(&b)) = (places.get(&zero), places.get(&a), places.get(&mirrored)) {
                    facts.differences.push([zero, at, a, b]);
                }
            }
        }
        inner
    }

    /// Tests whether an element is at most as high as another, if that is known.
    pub(super) fn at_most(&self, a: usize, b: usize) -> Option<bool> {
        if self.has(&self.reached, a, b) {
            Some(true)
        } else if self.has(&self.higher, b, a) {
            Some(false)
        } else {
            None
        }
    }

    /// Assumes that an element is at most as high as another, or lower. False if that cannot be.
    pub(super) fn assume(&mut self, a: usize, b: usize, lower: bool) -> bool {
        self.link(a, b, lower) && self.propagate()
    }

    fn has(&self, rows: &[u64], a: usize, b: usize) -> bool {
        rows[a * self.words + b / 64] >> (b % 64) & 1 == 1
    }

    /// Adds a relation with all that follows by transitivity.
    fn link(&mut self, a: usize, b: usize, lower: bool) -> bool {
        if self.has(if lower { &self.higher } else { &self.reached }, a, b) {
            return true;
        }
        if self.has(&self.higher, b, a) || lower && self.has(&self.reached, b, a) {
            return false;
        }
        for element in 0..self.count {
            if !self.has(&self.reached, element, a) {
                continue;
            }
            let strict = lower || self.has(&self.higher, element, a);
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
        loop {
            let mut changed = false;
            let mut add = |order: &mut Self, a: usize, b: usize, lower: bool| {
                if order.has(if lower { &order.higher } else { &order.reached }, a, b) {
                    return true;
                }
                changed = true;
                order.link(a, b, lower)
            };
            for at in 1..self.count {
                if let Some(low) = facts.lowest[at]
                    && self.has(&self.higher, 0, at)
                    && !add(self, low, at, false)
                {
                    return false;
                }
            }
            for &(a, b) in &facts.nan_as {
                for (from, to) in [(a, b), (b, a)] {
                    let number = self.has(&self.higher, 0, from);
                    let nan = self.has(&self.reached, from, 0);
                    if number && !add(self, 0, to, true) || nan && !add(self, to, 0, false) {
                        return false;
                    }
                }
            }
            for &(operand, result) in &facts.nan_with {
                if self.has(&self.reached, operand, 0) && !add(self, result, 0, false)
                    || self.has(&self.higher, 0, result) && !add(self, 0, operand, true)
                {
                    return false;
                }
            }
            // x - y > 0 exactly where x > y
            for &[zero, difference, x, y] in &facts.differences {
                let number = self.has(&self.higher, 0, y);
                if self.has(&self.higher, zero, difference) && !(add(self, 0, y, true) && add(self, y, x, true))
                    || number && self.has(&self.higher, y, x) && !add(self, zero, difference, true)
                    || number && self.has(&self.reached, difference, zero) && !add(self, x, y, false)
                    || self.has(&self.reached, x, y) && !add(self, difference, zero, false)
                {
                    return false;
                }
            }
            for &(low, high) in &facts.neighbours {
                for at in 0..self.count {
                    if self.has(&self.higher, low, at) && !add(self, high, at, false)
                        || self.has(&self.higher, at, high) && !add(self, at, low, false)
                    {
                        return false;
                    }
                }
            }
            for a in 1..self.count {
                let Some(mirrored) = facts.mirror[a] else { continue };
                // a number is where its negation is one
                if self.has(&self.higher, 0, a) && !add(self, 0, mirrored, true)
                    || self.has(&self.reached, a, 0) && !add(self, mirrored, 0, false)
                {
                    return false;
                }
                if !self.has(&self.higher, 0, a) {
                    continue;
                }
                for b in 1..self.count {
                    let Some(other) = facts.mirror[b] else { continue };
                    let lower = self.has(&self.higher, a, b);
                    if (lower || self.has(&self.reached, a, b)) && !add(self, other, mirrored, lower) {
                        return false;
                    }
                }
            }
            if !changed {
                return true;
            }
        }
    }
}

/// An operand that is NaN exactly where the result is.
fn nan_with(terms: &Terms, operation: Arithmetic, a: Float, b: Float) -> Option<Float> {
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
