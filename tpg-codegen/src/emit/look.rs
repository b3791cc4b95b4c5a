//! The function that computes the values of a state that come from an image.

use super::interface::SourceView;
use askama::Template;
use tpg_graph::Graph;
use tpg_graph::image::{Feature, Find, Vision};

/// What both languages say about an image.
pub(super) struct LookView {
    pub(super) rows: usize,
    pub(super) columns: usize,
    pub(super) channels: usize,
    /// Places that are looked for.
    finds: Vec<FindView>,
    values: Vec<ValueView>,
}

struct FindView {
    /// `first`, `last` or `window`.
    function: &'static str,
    channel: u32,
    /// Of a window: its size, and true for the darkest.
    size: u32,
    is_dark: bool,
}

struct ValueView {
    /// The place in a flat state, and the member of C's structure.
    input: usize,
    member: String,
    /// The type that it has in the state.
    kind: String,
    /// The number of the place that is looked for.
    find: usize,
    feature: Feature,
}

impl LookView {
    /// Returns what a graph reads from an image; `None` if it sees none.
    pub(super) fn new(graph: &Graph, sources: &[SourceView]) -> Option<Self> {
        let vision = Vision::new(graph.sources())?;
        let ([rows, columns, channels], finds) = (vision.shape(), vision.finds());
        let member = |input: usize, source: &SourceView| match source.length {
            1 => source.field.clone(),
            _ => format!("{}[{}]", source.field, input - source.first),
        };
        Some(Self {
            rows,
            columns,
            channels,
            finds: finds.iter().map(|&find| FindView::new(find)).collect(),
            values: (vision.features())
                .filter_map(|(input, feature, find)| {
                    let (find, source) = (find.unwrap_or_default(), sources.iter().find(|source| source.end > input)?);
                    Some(ValueView { input, member: member(input, source), kind: source.kind.clone(), find, feature })
                })
                .collect(),
        })
    }
}

impl LookView {
    /// Tests for a function that the code calls.
    fn has(&self, function: &str) -> bool {
        let finds = self.finds.iter().any(|find| find.function == function);
        let reads = self.values.iter().any(|value| match value.feature {
            Feature::Sum { .. } => function == "sum",
            Feature::Cell { .. } => function == "cell",
            _ => false,
        });
        finds || reads || function == "sum" && self.has("window")
    }
}

impl FindView {
    fn new(find: Find) -> Self {
        let (size, is_dark) = match find {
            Find::First(_) | Find::Last(_) => (0, false),
            Find::Brightest { size, .. } => (size, false),
            Find::Darkest { size, .. } => (size, true),
        };
        let function = match find {
            Find::First(_) => "first",
            Find::Last(_) => "last",
            Find::Brightest { .. } | Find::Darkest { .. } => "window",
        };
        Self { function, channel: find.channel(), size, is_dark }
    }
}

#[derive(Template)]
#[template(path = "c/look.c", escape = "none")]
struct CLook<'a> {
    prefix: &'a str,
    look: &'a LookView,
}

#[derive(Template)]
#[template(path = "rust/look.rs", escape = "none")]
struct RustLook<'a> {
    name: &'a str,
    scalar: &'a str,
    state: usize,
    look: &'a LookView,
}

/// The function in C.
pub(super) fn c(look: &LookView, prefix: &str) -> String {
    CLook { prefix, look }.render().expect("the template renders")
}

/// The function in Rust, for a state of so many values.
pub(super) fn rust(look: &LookView, name: &str, scalar: &str, state: usize) -> String {
    RustLook { name, scalar, state, look }.render().expect("the template renders")
}
