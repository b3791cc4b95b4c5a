//! Conditions of the profiles fast and balanced, in syntax that C and Rust share.

use super::syntax::Syntax;
use crate::passes::cases::Function;
use crate::passes::schedule::{Bid, LazyBid, Sparing};

/// The condition for evaluating the bound of a bid of this rank; `None` if it is always evaluated.
pub(super) fn considered(syntax: &impl Syntax, lazy: &LazyBid, rank: &str) -> Option<String> {
    let before = lazy.before_infinite.then(|| format!("(best < {}) || (edge < {rank})", syntax.number(f64::INFINITY)));
    let spared = lazy.sparing.map(|it| format!("!({})", low(syntax, it, &syntax.value(it.argument))));
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

/// The condition under which a function of a table's bid, whose argument is `argument`, need not be called.
pub(super) fn is_low(syntax: &impl Syntax, function: &Function, argument: &str) -> Option<String> {
    let bound = function.bound.map(|bound| format!("best > {}", syntax.number(bound)));
    bound.or_else(|| function.sparing.map(|sparing| low(syntax, sparing, argument)))
}

/// The condition under which an argument is low and the best bid is not.
fn low(syntax: &impl Syntax, Sparing { at_most, below, .. }: Sparing, argument: &str) -> String {
    let [at_most, below] = [at_most, below].map(|number| syntax.number(number));
    format!("({argument} <= {at_most}) && (best >= {below})")
}
