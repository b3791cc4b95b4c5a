//! The native bids of the profile `balanced`, in syntax that C and Rust share.

use super::block::Block;
use super::syntax::Syntax;
use super::team::low;
use crate::passes::cases::{Case, CaseFunction, CaseKind, Cases};

/// A distinct bid.
#[derive(PartialEq)]
pub(super) struct CaseView {
    /// Computed always.
    pub(super) before: Vec<String>,
    /// The upper bound of the bid, which is skipped if the best is above it.
    pub(super) bound: Option<String>,
    /// Computed unless it is skipped.
    pub(super) inside: Vec<String>,
    /// The bid, or the argument of its function.
    pub(super) value: String,
}

/// A function behind the switch.
pub(super) struct FunctionView {
    /// The number of its first bid.
    pub(super) first: usize,
    /// The condition for skipping it.
    pub(super) is_low: Option<String>,
    /// The call.
    pub(super) call: String,
}

/// Views the bids; `hidden` makes a 0 that no optimiser knows: see the profile `fast`. An operation that is the bid itself needs no statement.
pub(super) fn bids(
    syntax: &impl Syntax,
    cases: &Cases,
    hidden: impl Fn(&str) -> (Option<String>, String),
) -> Vec<CaseView> {
    let view = |&case: &Case| {
        let (bound, result) = match case.kind {
            CaseKind::Plain => (None, case.value),
            CaseKind::Bounded(bound) => (Some(bound), case.value),
            CaseKind::Function(CaseFunction { argument, .. }) => (None, argument),
        };
        let reads = bound.map(|bound| (bound, Some("bound".to_owned()))).into_iter().chain([(result, None)]);
        let mut block = Block::new(syntax, reads);
        let mut before = bound.map_or_else(Vec::new, |bound| block.statements(bound));
        let (inside, value) = block.argument(result, || "value".to_owned());
        let bound = bound.map(|bound| block.value(bound));
        let inside = if bound.is_some() {
            inside
        } else {
            before.extend(inside);
            Vec::new()
        };
        let is_zero = case.kind == CaseKind::Plain && cases.nodes[result.index()].as_constant() == Some(0.0);
        let (zero, value) = if is_zero && syntax.hides_zeros() { hidden(&value) } else { (None, value) };
        before.extend(zero);
        CaseView { before, bound, inside, value }
    };
    cases.bids.iter().map(view).collect()
}

/// Views the functions, the highest numbers first; `bid` holds the argument.
pub(super) fn functions(syntax: &impl Syntax, cases: &Cases) -> Vec<FunctionView> {
    let view = |(first, function): (usize, CaseFunction)| FunctionView {
        first,
        is_low: match (function.bound, function.sparing) {
            (Some(bound), _) => Some(format!("best > {}", syntax.literal(bound))),
            (None, sparing) => sparing.map(|sparing| low(syntax, sparing, "bid")),
        },
        call: syntax.instruction(function.instruction, &["bid".to_owned()]),
    };
    cases.functions().into_iter().map(view).collect()
}
