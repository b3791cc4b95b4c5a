//! The report for people.

use super::{Cost, GraphCounts, Report, ShapeCost, ShapeSize};
use crate::size::Target;
use std::fmt;
use tpg_graph::MathsProvider;
use tpg_graph::error::counted;

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let GraphCounts {
            teams,
            depth,
            edges,
            programs,
            actions,
            outputs,
            memory,
            leaves,
            inputs,
            lines,
            introns,
            distinct_operations,
            operations,
        } = self.graph;
        let asks = &self.asks;
        let answers = match outputs {
            0 if asks.is_empty() => counted(actions, "action"),
            0 => format!("{}, of which {} asks {}", counted(actions, "action"), asks.len(), asks.join(", ")),
            _ => format!(
                "{} with {}{}",
                counted(leaves, "leaf"),
                counted(outputs, "output"),
                if memory == 0 { String::new() } else { format!(" and {} of memory", counted(memory, "value")) }
            ),
        };
        writeln!(f, "graph     SHA-256 {}", self.graph_sha256)?;
        writeln!(
            f,
            "          {}, at most {depth} per decision; {}, {}, {}",
            counted(teams, "team"),
            counted(edges, "edge"),
            counted(programs, "program"),
            answers
        )?;
        match self.is_integer {
            true => writeln!(f, "computes  in integers")?,
            false => writeln!(f, "computes  in {} with {} maths", self.scalar.name(), self.maths.name())?,
        }
        if let Some(was) = &self.conversion {
            writeln!(
                f,
                "          the graph says {} with {} maths: {}",
                was.from.name(),
                was.maths.name(),
                was.agreement
            )?;
        }
        let dead = if self.dead_inputs.is_empty() { "none".to_owned() } else { self.dead_inputs.join(", ") };
        writeln!(f, "inputs    {inputs}; unused: {dead}")?;
        writeln!(f, "lines     {lines}; {introns} introns removed ({})", percent(introns, lines))?;
        let effective = lines - introns;
        writeln!(
            f,
            "work      {effective} effective lines, {distinct_operations} distinct, {operations} after all passes"
        )?;
        self.costs(f)?;
        for sizes in self.sizes.chunk_by(|a, b| a.target == b.target) {
            self.sizes(f, sizes)?;
        }
        Ok(())
    }
}

impl Report {
    fn costs(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let maths = match self.maths {
            MathsProvider::System => "libm calls",
            MathsProvider::Own => "own maths calls",
        };
        writeln!(f, "\na decision in C at most")?;
        writeln!(f, "{:<16}{:>12}{maths:>18}{:>8}{:>8}", "", "operations", "bids", "teams")?;
        for ShapeCost { profile, worst: Cost { teams, bids, operations, maths_calls } } in &self.costs {
            writeln!(f, "{profile:<16}{operations:>12}{maths_calls:>18}{bids:>8}{teams:>8}")?;
        }
        Ok(())
    }

    /// The sizes on one target.
    fn sizes(&self, f: &mut fmt::Formatter<'_>, sizes: &[ShapeSize]) -> fmt::Result {
        let Some(first) = sizes.first() else { return Ok(()) };
        let name = first.target.name();
        if let Some(why) = first.unavailable.as_ref().filter(|_| sizes.iter().all(|size| size.flash.is_none())) {
            return writeln!(f, "\nbytes on {name}: not known: {why}");
        }
        writeln!(f, "\nbytes on {name}, compiled with -Os{}", explanation(sizes))?;
        let rust = if first.target == Target::M4f { &self.rust_sizes[..] } else { &[] };
        let flash_of_rust =
            |size: &ShapeSize| rust.iter().find(|rust| rust.profile == size.profile).and_then(|rust| rust.flash);
        let columns: [Column<'_>; 7] = [
            ("flash", &|size| size.flash),
            ("linked", &|size| size.linked_flash),
            ("RAM", &|size| size.ram),
            ("stack", &|size| size.stack),
            (first.target.unit(), &|size| size.instructions),
            ("look", &|size| size.look),
            ("flash, Rust", &flash_of_rust),
        ];
        let (always, known) = (["flash", "RAM"], |column: &dyn Fn(&ShapeSize) -> Option<u64>| {
            sizes.iter().any(|size| column(size).is_some())
        });
        let columns: Vec<_> =
            columns.into_iter().filter(|(name, column)| always.contains(name) || known(column)).collect();
        let width = |name: &str| 3 + name.len().max(6);
        let heads = columns.iter().map(|(name, _)| format!("{name:>width$}", width = width(name)));
        writeln!(f, "{:<16}{}", "", heads.collect::<String>())?;
        for size in sizes {
            let cells = columns.iter().map(|(name, column)| {
                let number = column(size).map_or_else(|| "?".to_owned(), |number| number.to_string());
                format!("{number:>width$}", width = width(name))
            });
            let note = size.unavailable.as_ref().map_or_else(String::new, |note| format!("  {note}"));
            writeln!(f, "{:<16}{}{note}", size.profile, cells.collect::<String>())?;
        }
        if let Some(why) = rust.iter().find_map(|size| size.unavailable.as_ref()) {
            writeln!(f, "bytes of the Rust: not known: {}", why.lines().next().unwrap_or(""))?;
        }
        Ok(())
    }
}

/// A column: its head, and its number of a row.
type Column<'a> = (&'static str, &'a dyn Fn(&ShapeSize) -> Option<u64>);

/// Explains the columns.
fn explanation(sizes: &[ShapeSize]) -> String {
    let any = |known: fn(&ShapeSize) -> bool| sizes.iter().any(known);
    let linked = "; linked: with the library functions that are called";
    match (any(|size| size.linked_flash.is_some()), sizes.iter().find(|size| size.instructions.is_some())) {
        (false, _) => ", without the libraries that are called".to_owned(),
        (true, None) => linked.to_owned(),
        (true, Some(size)) => format!(
            "{linked};\n{}{}: of a decision and what it calls, at most, by analysis of the machine code",
            size.target.unit(),
            if size.look.is_some() { ", and look" } else { "" }
        ),
    }
}

fn percent(part: usize, whole: usize) -> String {
    format!("{:.1} %", if whole == 0 { 0.0 } else { 100.0 * part as f64 / whole as f64 })
}
