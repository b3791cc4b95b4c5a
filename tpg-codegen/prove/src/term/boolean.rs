//! Truth values: conjunctions and negation; everything else is made of them.

use super::{Bool, Node, Terms};
use std::ops::Not;
use std::rc::Rc;

impl Not for Bool {
    type Output = Self;

    fn not(self) -> Self {
        Self(self.0 ^ 1)
    }
}

impl Bool {
    /// The truth value or its negation, whichever is no negation.
    pub(crate) const fn positive(self) -> Self {
        Self(self.0 & !1)
    }

    /// The number of the node.
    pub(crate) const fn node_number(self) -> u32 {
        self.0 >> 1
    }
}

impl Terms {
    /// A truth value from one that is known.
    #[must_use]
    pub const fn known(value: bool) -> Bool {
        if value { Self::TRUE } else { Self::FALSE }
    }

    /// The members of a conjunction; a truth value of another kind is its own only member.
    fn conjuncts(&self, term: Bool) -> Rc<[Bool]> {
        match self.of_bool(term) {
            (Node::And(members), false) => members,
            _ => Rc::default(),
        }
    }

    /// The members of a conjunction, or the truth value alone.
    pub(crate) fn parts(&self, term: Bool) -> Vec<Bool> {
        match &*self.conjuncts(term) {
            [] => vec![term],
            members => members.to_vec(),
        }
    }

    /// `a && b`
    pub fn and(&self, a: Bool, b: Bool) -> Bool {
        self.all([a, b])
    }

    /// `a || b`
    pub fn or(&self, a: Bool, b: Bool) -> Bool {
        !self.all([!a, !b])
    }

    /// The disjunction of all.
    pub fn any(&self, terms: impl IntoIterator<Item = Bool>) -> Bool {
        let negated: Vec<_> = terms.into_iter().map(|term| !term).collect();
        !self.all(negated)
    }

    /// A choice between two truth values.
    pub fn choose(&self, condition: Bool, a: Bool, b: Bool) -> Bool {
        if a == b {
            return a;
        }
        self.or(self.and(condition, a), self.and(!condition, b))
    }

    /// The conjunction of all.
    pub fn all(&self, terms: impl IntoIterator<Item = Bool>) -> Bool {
        let mut members = self.flattened(terms);
        loop {
            members.sort_unstable();
            members.dedup();
            // Negations are neighbours: they differ in the lowest bit.
            if members.contains(&Self::FALSE) || members.windows(2).any(|pair| pair[0] == !pair[1]) {
                return Self::FALSE;
            }
            match self.shortened(&members) {
                Some(shorter) => members = self.flattened(shorter),
                None => break,
            }
        }
        match members[..] {
            [] => Self::TRUE,
            [only] => only,
            _ => self.atom(Node::And(members.into())),
        }
    }

    /// The members without what the others decide: `a && !(a && b)` is `a && !b`.
    fn shortened(&self, members: &[Bool]) -> Option<Vec<Bool>> {
        for (at, &member) in members.iter().enumerate() {
            let inner = self.conjuncts(!member);
            if inner.is_empty() {
                continue;
            }
            let has = |term: &Bool| members.binary_search(term).is_ok();
            if inner.iter().any(has) {
                let rest: Vec<_> = inner.iter().copied().filter(|term| !has(term)).collect();
                let mut shorter = [&members[..at], &members[at + 1..]].concat();
                shorter.push(!self.all(rest));
                return Some(shorter);
            }
        }
        None
    }

    /// The members of all, but for *true*.
    fn flattened(&self, terms: impl IntoIterator<Item = Bool>) -> Vec<Bool> {
        let parts = terms.into_iter().flat_map(|term| self.parts(term));
        parts.filter(|&part| part != Self::TRUE).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::Terms;

    #[test]
    fn conjunctions_are_simplified() {
        let terms = Terms::new();
        let [x, y] = [0, 1].map(|index| {
            let (source, zero) = (terms.source(index), terms.constant(0.0));
            terms.at_most(source, zero)
        });
        let both = terms.and(x, y);
        assert_eq!(terms.and(x, !both), terms.and(x, !y));
        assert_eq!(terms.and(both, !x), Terms::FALSE);
        assert_eq!(terms.or(x, !x), Terms::TRUE);
        assert_eq!(terms.choose(x, y, y), y);
        assert_eq!(terms.choose(x, Terms::TRUE, Terms::FALSE), x);
    }
}
