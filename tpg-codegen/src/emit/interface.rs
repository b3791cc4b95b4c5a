//! The sources of a state as generated code documents them.

use tpg_graph::Graph;

/// A source.
pub(super) struct SourceView {
    pub(super) name: String,
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
                first: end - length,
                end,
                length,
                unit: safe(&source.unit),
                range: source.envelope().to_string(),
            }
        })
        .collect()
}
