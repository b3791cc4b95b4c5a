//! Decides which conditions can hold together, over all total preorders of the numbers that they compare.
//!
//! No solver: cases are split by one comparison at a time, and each is followed through a transitive closure. NaN is one more place
//! in the order, below minus infinity. What the order does not know, it takes to be possible, so that *never together* is a proof
//! and *together* may be none.

mod bound;
mod closure;

use crate::term::{Bool, Float, INFINITY, NAN, NEGATIVE_ZERO, Node::*, Terms, is_nan_bits, next_above};
use OrderValue::*;
use closure::Closure;
use std::collections::{BTreeSet, HashMap};

/// Conditions under a truth assignment.
struct OrderSearch<'t> {
    terms: &'t Terms,
    places: HashMap<Float, usize>,
    /// Truth of nodes: 0 where unknown, else 1 for *false* and 2 for *true*
    known: Vec<u8>,
    trail: Vec<u32>,
    /// The last evaluation in which a node was found to be unknown, with the atom that keeps it so
    unknown: Vec<(u32, u32)>,
    evaluation: u32,
    steps: u64,
    incomplete: bool,
}

/// The result of looking for what holds together.
#[derive(Debug, Default)]
pub(crate) struct Together {
    /// Pairs of a condition on the left and one on the right
    pub(crate) pairs: BTreeSet<(usize, usize)>,
    /// Cases looked at
    pub(crate) cases: u64,
    /// In some case no condition on the left holds
    pub(crate) incomplete: bool,
}

/// Finds the pairs of conditions, one of each side, that can hold at once where the assumption does. The conditions of a side must
/// exclude each other, and one must always hold; on the left that is checked. None if there are more cases than the limit.
pub(crate) fn together(terms: &Terms, assumption: Bool, [left, right]: [&[Bool]; 2], limit: u64) -> Option<Together> {
    let roots: Vec<_> = left.iter().chain(right).copied().chain([assumption]).collect();
    let elements = elements(terms, &roots);
    let closure = Closure::new(terms, &elements);
    let places = elements.iter().enumerate().map(|(place, &element)| (element, place)).collect();
    let count = terms.count();
    let mut search = OrderSearch {
        terms,
        places,
        known: vec![0; count],
        trail: Vec::new(),
        unknown: vec![(0, 0); count],
        evaluation: 0,
        steps: 0,
        incomplete: false,
    };
    let mut found = Together::default();
    if let Some(closure) = closure {
        search.explore(&closure, assumption, [left, right], &mut found.pairs, limit)?;
    }
    found.cases = search.steps;
    found.incomplete = search.incomplete;
    Some(found)
}

/// All numbers that are compared: NaN first, then constants from the lowest on, then the others.
fn elements(terms: &Terms, roots: &[Bool]) -> Vec<Float> {
    let mut seen: BTreeSet<Bool> = BTreeSet::new();
    let mut floats = BTreeSet::new();
    let mut open = roots.to_vec();
    while let Some(term) = open.pop() {
        if !seen.insert(term.positive()) {
            continue;
        }
        match terms.of_bool(term).0 {
            And(members) => open.extend(members.iter()),
            AtMost(a, b) => floats.extend([a, b]),
            _ => {}
        }
    }
    // constants with what is next to them, and all of that mirrored
    let constants: Vec<_> = floats.iter().filter_map(|&float| terms.bits_of(float)).collect();
    for bits in constants.into_iter().filter(|&bits| !is_nan_bits(bits) && bits != INFINITY) {
        for bits in [bits, next_above(bits)] {
            for bits in [bits, bits ^ NEGATIVE_ZERO] {
                floats.insert(terms.zero_free(terms.constant_bits(bits)));
            }
        }
    }
    if floats.iter().all(|&float| !terms.is_whole(float)) {
        floats.insert(terms.constant(0.0));
    }
    floats.insert(terms.constant_bits(NAN));
    let mut elements: Vec<_> = floats.into_iter().collect();
    elements.sort_by_key(|&element| match terms.rank_of(element) {
        Some(rank) => (u8::from(terms.bits_of(element) != Some(NAN)), rank, element),
        None => (2, 0, element),
    });
    elements
}

/// The value of a condition, or an atom on which it depends.
#[derive(Clone, Copy)]
enum OrderValue {
    Known(bool),
    Open(u32),
}

impl OrderSearch<'_> {
    /// Records the pairs that are possible in a case.
    fn explore(
        &mut self,
        closure: &Closure,
        assumption: Bool,
        [left, right]: [&[Bool]; 2],
        found: &mut BTreeSet<(usize, usize)>,
        limit: u64,
    ) -> Option<()> {
        self.steps += 1;
        if self.steps > limit {
            return None;
        }
        self.evaluation += 1;
        let open = match self.value(closure, assumption) {
            Known(false) => return Some(()),
            Open(atom) => Some(atom),
            Known(true) => match self.chosen(closure, left) {
                Err(None) => {
                    self.incomplete = true;
                    None
                }
                Err(atom) => atom,
                Ok(first) => match self.chosen(closure, right) {
                    Ok(second) => {
                        found.insert((first, second));
                        None
                    }
                    // a case that the order alone does not exclude
                    Err(None) => None,
                    Err(atom) => {
                        // nothing new can be found here
                        let all = (0..right.len()).all(|second| {
                            found.contains(&(first, second))
                                || matches!(self.value(closure, right[second]), Known(false))
                        });
                        if all { None } else { atom }
                    }
                },
            },
        };
        let Some(atom) = open else { return Some(()) };
        for value in [true, false] {
            let mark = self.trail.len();
            let mut case = closure.clone();
            if self.assume(&mut case, atom, value) {
                self.explore(&case, assumption, [left, right], found, limit)?;
            }
            for node in self.trail.drain(mark..) {
                self.known[node as usize] = 0;
            }
        }
        Some(())
    }

    /// The condition that holds, or an atom that decides it; none if no condition can hold.
    fn chosen(&mut self, closure: &Closure, conditions: &[Bool]) -> Result<usize, Option<u32>> {
        let mut first = None;
        for (at, &condition) in conditions.iter().enumerate() {
            match self.value(closure, condition) {
                Known(true) => return Ok(at),
                Known(false) => {}
                Open(atom) => first = first.or(Some(atom)),
            }
        }
        Err(first)
    }

    fn assume(&mut self, closure: &mut Closure, atom: u32, value: bool) -> bool {
        self.set(atom, value);
        let AtMost(a, b) = self.terms.node_at(atom) else { return true };
        let (a, b) = (self.places[&a], self.places[&b]);
        closure.assume(if value { (a, b, false) } else { (b, a, true) })
    }

    fn set(&mut self, node: u32, value: bool) {
        self.known[node as usize] = 1 + u8::from(value);
        self.trail.push(node);
    }

    fn value(&mut self, closure: &Closure, term: Bool) -> OrderValue {
        let (node, negated) = (term.node_number(), term != term.positive());
        match self.node_value(closure, node) {
            Known(value) => Known(value != negated),
            open => open,
        }
    }

    fn node_value(&mut self, closure: &Closure, node: u32) -> OrderValue {
        if let known @ 1.. = self.known[node as usize] {
            return Known(known == 2);
        }
        let (evaluation, atom) = self.unknown[node as usize];
        if evaluation == self.evaluation {
            return Open(atom);
        }
        let terms = self.terms;
        let value = match terms.node_at(node) {
            True => Known(true),
            And(ref members) => {
                let mut open = None;
                let mut result = None;
                for &member in members.iter() {
                    match self.value(closure, member) {
                        Known(false) => {
                            result = Some(Known(false));
                            break;
                        }
                        Known(true) => {}
                        Open(atom) => open = open.or(Some(atom)),
                    }
                }
                result.unwrap_or_else(|| open.map_or(Known(true), Open))
            }
            AtMost(a, b) => match closure.at_most(self.places[&a], self.places[&b]) {
                Some(value) => Known(value),
                None => Open(node),
            },
            _ => Open(node),
        };
        match value {
            Known(value) => self.set(node, value),
            Open(atom) => self.unknown[node as usize] = (self.evaluation, atom),
        }
        value
    }
}

#[cfg(test)]
mod tests {
    use super::together;
    use crate::term::{Bool, Float, Terms};

    fn holds(terms: &Terms, condition: Bool) -> bool {
        let (left, right) = ([condition, !condition], [Terms::TRUE]);
        let found = together(terms, Terms::TRUE, [&left, &right], 1 << 16).expect("few cases");
        !found.pairs.contains(&(1, 0))
    }

    /// The code's way to find the winner: the best bid so far, from the lowest number on.
    fn winners(terms: &Terms, bids: &[Float], strict: Option<usize>) -> Vec<Bool> {
        let lowest = terms.constant(f32::MIN);
        let (mut best, mut winner) = (lowest, vec![Terms::FALSE; bids.len()]);
        winner[bids.len() - 1] = Terms::TRUE;
        for (at, &bid) in bids.iter().enumerate() {
            let wins = if strict == Some(at) { terms.less(best, bid) } else { terms.less_or_equal(best, bid) };
            best = terms.choose_float(wins, bid, best);
            for (other, place) in winner.iter_mut().enumerate() {
                *place = terms.choose(wins, Terms::known(other == at), *place);
            }
        }
        winner
    }

    /// The declarative meaning: no earlier bid is higher, no later one is as high, NaN counts as minus infinity.
    fn meaning(terms: &Terms, bids: &[Float], at: usize) -> Bool {
        let infinity = terms.constant(f32::NEG_INFINITY);
        let keys: Vec<_> = (bids.iter())
            .map(|&bid| {
                let nan = terms.is_nan(bid);
                terms.choose_float(nan, infinity, bid)
            })
            .collect();
        let mut all = Vec::new();
        for other in 0..bids.len() {
            if other < at {
                all.push(terms.at_most(keys[other], keys[at]));
            } else if other > at {
                all.push(!terms.at_most(keys[at], keys[other]));
            }
        }
        terms.all(all)
    }

    #[test]
    fn the_best_so_far_is_the_highest_bid() {
        let terms = Terms::new();
        let bids: Vec<_> = (0..7).map(|index| terms.source(index)).collect();
        let code = winners(&terms, &bids, None);
        let graph: Vec<_> = (0..7).map(|at| meaning(&terms, &bids, at)).collect();
        let found = together(&terms, Terms::TRUE, [&code, &graph], 1 << 20).expect("few cases");
        assert_eq!(found.pairs, (0..7).map(|at| (at, at)).collect());
    }

    #[test]
    fn one_strict_comparison_is_noticed() {
        let terms = Terms::new();
        let bids: Vec<_> = (0..4).map(|index| terms.source(index)).collect();
        let code = winners(&terms, &bids, Some(2));
        let graph: Vec<_> = (0..4).map(|at| meaning(&terms, &bids, at)).collect();
        let found = together(&terms, Terms::TRUE, [&code, &graph], 1 << 20).expect("few cases");
        assert!(found.pairs.contains(&(0, 2)) || found.pairs.contains(&(1, 2)), "{:?}", found.pairs);
    }

    #[test]
    fn orders_are_total_and_transitive() {
        let terms = Terms::new();
        let [a, b, c] = [0, 1, 2].map(|index| terms.source(index));
        let (first, second, third) = (terms.at_most(a, b), terms.at_most(b, c), terms.at_most(a, c));
        let both = terms.and(first, second);
        let transitive = terms.or(!both, third);
        assert!(holds(&terms, transitive));
        let converse = terms.or(!third, both);
        assert!(!holds(&terms, converse));
        let back = terms.at_most(b, a);
        let total = terms.or(first, back);
        assert!(holds(&terms, total));
    }

    #[test]
    fn mirrored_and_neighbouring_numbers_are_known() {
        let terms = Terms::new();
        let [a, b, c] = [0, 1, 2].map(|index| terms.source(index));
        let negated = terms.negate(a);
        // c <= -a and b <= c give a <= -b
        let (up, middle) = (terms.less_or_equal(c, negated), terms.less_or_equal(b, c));
        let mirrored = terms.negate(b);
        let down = terms.less_or_equal(a, mirrored);
        let both = terms.and(up, middle);
        let implied = terms.or(!both, down);
        assert!(holds(&terms, implied));
        // nothing is between minus infinity and the lowest number
        let (lowest, infinity) = (terms.constant(f32::MIN), terms.constant(f32::NEG_INFINITY));
        let (above, reaches) = (terms.less(infinity, a), terms.less_or_equal(lowest, a));
        let gap = terms.or(!above, reaches);
        assert!(holds(&terms, gap));
    }
}
