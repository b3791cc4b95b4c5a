//! The function that computes the values of a state that come from an image.

use super::interface::SourceView;
use askama::Template;
use std::collections::BTreeSet;
use tpg_graph::Graph;
use tpg_graph::image::{Feature, Find, Vision};

/// What both languages say about an image.
pub(super) struct LookView {
    pub(super) rows: usize,
    pub(super) columns: usize,
    pub(super) channels: usize,
    /// Places, or the brightest and the darkest window, that are looked for.
    finds: Vec<FindView>,
    values: Vec<ValueView>,
    windows: Vec<WindowView>,
}

#[derive(PartialEq)]
struct FindView {
    /// `first`, `last` or `windows`.
    function: &'static str,
    channel: u32,
    /// Of windows; 0 of a place.
    size: u32,
}

struct WindowView {
    size: u32,
    /// Number of windows below each other, and beside each other.
    down: u32,
    across: u32,
}

struct ValueView {
    /// The place in a flat state, and the member of C's structure.
    input: usize,
    member: String,
    /// The type that it has in the state.
    kind: String,
    /// The place that is looked for.
    place: String,
    feature: Feature,
}

impl LookView {
    /// Returns what a graph reads from an image; `None` if it sees none.
    pub(super) fn new(graph: &Graph, sources: &[SourceView]) -> Option<Self> {
        let vision = Vision::new(graph.sources())?;
        let [rows, columns, channels] = vision.shape();
        let member = |input: usize, source: &SourceView| match source.length {
            1 => source.field.clone(),
            _ => format!("{}[{}]", source.field, input - source.first),
        };
        let mut finds = Vec::new();
        let places: Vec<String> = (vision.finds().iter())
            .map(|&find| {
                let (wanted, part) = FindView::new(find);
                let known = finds.iter().position(|known| *known == wanted);
                let number = known.unwrap_or_else(|| {
                    finds.push(wanted);
                    finds.len() - 1
                });
                if part.is_empty() { format!("place_{number}") } else { format!("windows_{number}.{part}") }
            })
            .collect();
        let sizes: BTreeSet<u32> = finds.iter().map(|find| find.size).filter(|size| *size > 0).collect();
        let window = |size| WindowView { size, down: rows as u32 + 1 - size, across: columns as u32 + 1 - size };
        Some(Self {
            rows,
            columns,
            channels,
            windows: sizes.into_iter().map(window).collect(),
            finds,
            values: (vision.features())
                .filter_map(|(input, feature, find)| {
                    let source = sources.iter().find(|source| source.end > input)?;
                    let place = find.map_or_else(String::new, |find| places[find].clone());
                    Some(ValueView { input, member: member(input, source), kind: source.kind.clone(), place, feature })
                })
                .collect(),
        })
    }

    /// Tests for a function that the code calls.
    fn has(&self, function: &str) -> bool {
        let finds = self.finds.iter().any(|find| find.function == function);
        let reads = self.values.iter().any(|value| match value.feature {
            Feature::Sum { .. } => function == "sum",
            Feature::Cell { .. } => function == "cell",
            _ => false,
        });
        finds || reads
    }
}

impl FindView {
    /// Returns what is looked for, and the part of it that is wanted.
    fn new(find: Find) -> (Self, &'static str) {
        let (function, size, part) = match find {
            Find::First(_) => ("first", 0, ""),
            Find::Last(_) => ("last", 0, ""),
            Find::Brightest { size, .. } => ("windows", size, "bright"),
            Find::Darkest { size, .. } => ("windows", size, "dark"),
        };
        (Self { function, channel: find.channel(), size }, part)
    }
}

impl WindowView {
    fn count(&self) -> u32 {
        self.down * self.across
    }

    /// Returns the numbers of the columns before the newest one.
    fn before(&self) -> std::ops::Range<u32> {
        0..self.size - 1
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
