//! Text of the report for people, beside its fields.

use super::{Report, ShapeSize};
use crate::size::Target;
use tpg_graph::MathsProvider;

/// A column of the sizes on a target: its head, and its number in each row.
pub(super) struct Column {
    pub(super) head: &'static str,
    numbers: Vec<Option<u64>>,
}

impl Column {
    pub(super) fn width(&self) -> usize {
        3 + self.head.len().max(6)
    }

    pub(super) fn cell(&self, row: &usize) -> String {
        self.numbers[*row].map_or_else(|| "?".to_owned(), |number| number.to_string())
    }
}

impl Report {
    /// The percentage of lines that are introns.
    pub(super) fn removed(&self) -> f64 {
        100.0 * self.graph.introns as f64 / self.graph.lines.max(1) as f64
    }

    /// The name of calls of the maths.
    pub(super) fn calls(&self) -> &'static str {
        match self.maths {
            MathsProvider::System => "libm calls",
            MathsProvider::Own => "own maths calls",
        }
    }

    pub(super) fn by_target(&self) -> impl Iterator<Item = &[ShapeSize]> {
        self.sizes.chunk_by(|a, b| a.target == b.target)
    }

    /// The reason for knowing nothing about a target.
    pub(super) fn unknown<'a>(&self, sizes: &'a [ShapeSize]) -> Option<&'a String> {
        sizes[0].unavailable.as_ref().filter(|_| sizes.iter().all(|size| size.flash.is_none()))
    }

    /// The reason for not knowing the size of the Rust on a target.
    pub(super) fn rust_unknown(&self, sizes: &[ShapeSize]) -> Option<&str> {
        let why = self.rust_sizes.iter().find_map(|size| size.unavailable.as_ref())?;
        why.lines().next().filter(|_| sizes[0].target == Target::M4f)
    }

    /// The columns of which a number is known, and flash and RAM.
    pub(super) fn columns(&self, sizes: &[ShapeSize]) -> Vec<Column> {
        let of_rust = |size: &ShapeSize| {
            let rust = self.rust_sizes.iter().filter(|_| size.target == Target::M4f);
            rust.into_iter().find(|rust| rust.profile == size.profile).and_then(|rust| rust.flash)
        };
        let column = |head, number: &dyn Fn(&ShapeSize) -> Option<u64>| Column {
            head,
            numbers: sizes.iter().map(number).collect(),
        };
        let columns = [
            column("flash", &|size| size.flash),
            column("linked", &|size| size.linked_flash),
            column("RAM", &|size| size.ram),
            column("stack", &|size| size.stack),
            column(sizes[0].target.unit(), &|size| size.instructions),
            column("look", &|size| size.look),
            column("flash, Rust", &of_rust),
        ];
        let is_shown =
            |column: &Column| ["flash", "RAM"].contains(&column.head) || column.numbers.iter().any(Option::is_some);
        columns.into_iter().filter(is_shown).collect()
    }

    pub(super) fn has(&self, columns: &[Column], head: &str) -> bool {
        columns.iter().any(|column| column.head == head)
    }
}
