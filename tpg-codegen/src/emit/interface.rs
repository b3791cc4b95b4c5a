//! The sources of a state and the outputs of an answer as generated code documents them.

use super::field;
use super::syntax::Syntax;
use tpg_graph::{Graph, Output, Range};

/// A source.
pub(super) struct SourceView {
    pub(super) name: String,
    /// The field of C's struct.
    pub(super) field: String,
    /// The places of its values in a flat state: from the first to the one behind the last.
    pub(super) first: usize,
    pub(super) end: usize,
    pub(super) length: usize,
    pub(super) unit: String,
    pub(super) range: String,
}

/// Every source, its unit made safe for a comment.
pub(super) fn sources(graph: &Graph, safe: impl Fn(&str) -> String) -> Vec<SourceView> {
    let mut end = 0;
    (graph.sources().iter())
        .map(|source| {
            let length = source.ranges.len();
            end += length;
            SourceView {
                name: source.name.clone(),
                field: field(graph, &source.name),
                first: end - length,
                end,
                length,
                unit: safe(&source.unit),
                range: range(&source.ranges),
            }
        })
        .collect()
}

/// The name in capitals of the policy that each asking action asks, and the action's number.
pub(super) fn asks(graph: &Graph) -> Vec<(String, usize)> {
    let actions = graph.actions().iter().enumerate();
    actions.filter_map(|(number, action)| Some((action.ask.as_ref()?.to_ascii_uppercase(), number))).collect()
}

/// An output.
pub(super) struct OutputView {
    pub(super) name: String,
    /// The field of C's struct.
    pub(super) field: String,
    pub(super) unit: String,
    pub(super) range: String,
    pub(super) nan: f64,
    /// The literal of that value, which is a memory's first.
    pub(super) initial: String,
    /// Its place among the outputs.
    pub(super) place: usize,
    /// The literals of its lowest value, its highest, and the value in place of NaN.
    pub(super) limits: String,
}

impl OutputView {
    /// The variable that holds its value before it is limited.
    pub(super) fn variable(&self) -> String {
        format!("out{}", self.place)
    }
}

/// Every output, its unit made safe for a comment.
pub(super) fn outputs(syntax: &impl Syntax, safe: impl Fn(&str) -> String) -> Vec<OutputView> {
    (syntax.graph().outputs().iter().enumerate())
        .map(|(place, Output { name, unit, range, nan, .. })| OutputView {
            name: name.clone(),
            field: field(syntax.graph(), name),
            unit: safe(unit),
            range: range.to_string(),
            nan: *nan,
            initial: syntax.literal(*nan),
            place,
            limits: [range.min, range.max, *nan].map(|limit| syntax.literal(limit)).join(", "),
        })
        .collect()
}

/// The common range of the values, or if ranges differ, each value's own in order.
fn range(ranges: &[Range]) -> String {
    match ranges {
        [first, others @ ..] if others.iter().all(|range| range == first) => first.to_string(),
        _ => ranges.iter().map(Range::to_string).collect::<Vec<_>>().join("; "),
    }
}

#[cfg(test)]
mod tests {
    use super::range;
    use tpg_graph::Range;

    #[test]
    fn each_value_has_its_own_range_where_they_differ() {
        let of = |min, max| Range { min, max };
        assert_eq!(range(&[of(-1.0, 1.0)]), "-1 to 1");
        assert_eq!(range(&[of(-1.0, 1.0), of(-1.0, 1.0)]), "-1 to 1");
        assert_eq!(range(&[of(-1.0, 1.0), of(0.0, 2.5)]), "-1 to 1; 0 to 2.5");
    }
}
