//! Conditions of the profile fast, in syntax that C and Rust share.

use super::syntax::Syntax;
use crate::passes::schedule::{Bid, LazyBid, Sparing};

/// The condition for evaluating the bound of a bid of this rank; `None` if it is always evaluated.
pub(super) fn considered(syntax: &impl Syntax, lazy: &LazyBid, rank: &str) -> Option<String> {
    let before = lazy.before_infinite.then(|| format!("(best < {}) || (edge < {rank})", syntax.number(f64::INFINITY)));
    let spared = lazy.sparing.map(|Sparing { argument, at_most, below }| {
        let [at_most, below] = [at_most, below].map(|number| syntax.number(number));
        format!("!(({} <= {at_most}) && (best >= {below}))", syntax.value(argument))
    });
    match (before, spared) {
        (Some(before), Some(spared)) => Some(format!("({before}) && {spared}")),
        (before, spared) => before.or(spared),
    }
}

/// The condition for computing a bid of this rank: it can still win. `None` if it is always computed.
pub(super) fn guard(syntax: &impl Syntax, lazy: &LazyBid, rank: &str) -> Option<String> {
    let LazyBid { bid, before_infinite, bound, .. } = *lazy;
    match bound.map(|bound| syntax.value(bound)) {
        // Also where the bound is NaN and says nothing.
        Some(bound) if bid.ascending => Some(format!("!(best > {bound})")),
        Some(bound) => Some(format!("!((best > {bound}) || ((best >= {bound}) && (edge >= {rank})))")),
        // Nothing is higher than infinity; in ascending order, an equal bid wins; and this may have been tested already.
        None if bid.ascending || before_infinite => None,
        None => Some(format!("(best < {}) || (edge < {rank})", syntax.number(f64::INFINITY))),
    }
}

/// The condition under which `value`, a bid of this rank, becomes the leader.
pub(super) fn wins(bid: &Bid, rank: &str, value: &str, best: &str) -> String {
    if bid.ascending {
        format!("{value} >= {best}")
    } else {
        format!("({value} >= {best}) && (({value} > {best}) || (edge < {rank}))")
    }
}
