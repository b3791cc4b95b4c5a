//! What the profile fast asks of bids, in words that are C and Rust.

use super::syntax::Syntax;
use crate::passes::schedule::{Bid, LazyBid, Sparing};

/// What must hold for a bid of this rank to be worth its bound; `None` where it is always.
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

/// Whether a bid of this rank can win; `None` where it must be looked at whatever the others bid.
pub(super) fn guard(syntax: &impl Syntax, lazy: &LazyBid, rank: &str) -> Option<String> {
    let LazyBid { bid, before_infinite, bound, .. } = *lazy;
    match bound.map(|bound| syntax.value(bound)) {
        // Also where the bound is NaN and says nothing.
        Some(bound) if bid.in_turn => Some(format!("!(best > {bound})")),
        Some(bound) => Some(format!("!((best > {bound}) || ((best >= {bound}) && (edge >= {rank})))")),
        // Nothing is higher than infinity; in turn, what is as high wins; and it may have been asked already.
        None if bid.in_turn || before_infinite => None,
        None => Some(format!("(best < {}) || (edge < {rank})", syntax.number(f64::INFINITY))),
    }
}

/// Whether a value of a bid of this rank makes it the leader.
pub(super) fn wins(bid: &Bid, rank: &str, value: &str, best: &str) -> String {
    if bid.in_turn {
        format!("{value} >= {best}")
    } else {
        format!("({value} >= {best}) && (({value} > {best}) || (edge < {rank}))")
    }
}
