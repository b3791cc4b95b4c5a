//! `--explain`: the bids of each team, and the values of each leaf, as readable formulas.

mod policy;
mod table;

pub use policy::{BidFormula, LeafFormulas, PolicyFormulas, TeamFormulas};
pub use table::{Bids, Destination, Value};

use crate::options::Options;
use std::fmt::{self, Write as _};
use tpg_graph::{Graph, Output, Range};

/// Returns the formulas of a graph as fast C: what each team's bids are, and what each leaf computes.
pub fn explain(graph: &Graph, options: &Options) -> String {
    let mut out = String::new();
    if graph.has_counts() {
        out += "Sums are in the units of sources and outputs, the bids of a team divided by one number; what is in counts says so.\n";
    }
    let formulas = PolicyFormulas::of(graph, options);
    let written = write_teams(&formulas.teams, &mut out).and_then(|()| write_leaves(graph, &formulas.leaves, &mut out));
    written.expect("a string takes everything");
    out.trim_start().to_owned()
}

fn write_teams(teams: &[TeamFormulas], out: &mut String) -> fmt::Result {
    if teams.is_empty() {
        return Ok(());
    }
    writeln!(out, "\nWhat the teams compute\n")?;
    writeln!(out, "The highest bid wins; of equal bids, the last. NaN is lowest.")?;
    write_words(&teams, out)?;
    for (index, team) in teams.iter().enumerate() {
        writeln!(out, "\nteam {}{}", team.id, if index == 0 { ", the root" } else { "" })?;
        write_shared(out, &team.shared)?;
        for BidFormula { program, to, formula, .. } in &team.bids {
            writeln!(out, "  program {program} -> {to}: {formula}")?;
        }
    }
    Ok(())
}

/// Writes what a word means whose name does not say it.
fn write_words(formulas: &impl fmt::Debug, out: &mut String) -> fmt::Result {
    if format!("{formulas:?}").contains("negate_if_less(") {
        writeln!(out, "negate_if_less(a, b) is -a where a < b, else a.")?;
    }
    Ok(())
}

fn write_leaves(graph: &Graph, leaves: &[LeafFormulas], out: &mut String) -> fmt::Result {
    let (answers, memory) = graph.split_outputs();
    if graph.outputs().is_empty() {
        return Ok(());
    }
    writeln!(out, "\nWhat the leaves compute\n")?;
    for Output { name, unit, range, nan, counts, .. } in answers {
        let value = |end| counts.map_or(end, |counts| counts.value(end));
        let (range, nan) = (Range { min: value(range.min), max: value(range.max) }, value(*nan));
        let space = if unit.is_empty() { "" } else { " " };
        writeln!(out, "{name} is limited to {range}{space}{unit}; {nan} replaces NaN.")?;
    }
    let counts = if graph.has_counts() { ", in counts" } else { "" };
    for Output { name, range, nan, .. } in memory {
        writeln!(
            out,
            "{name} in a formula is its value at the last decision, {nan} at the first, limited to {range}{counts}; {nan} replaces NaN."
        )?;
    }
    write_words(&leaves, out)?;
    for leaf in leaves {
        writeln!(out, "\nleaf {}", leaf.id)?;
        write_shared(out, &leaf.shared)?;
        for (name, formula) in &leaf.values {
            writeln!(out, "  {name} = {formula}")?;
        }
    }
    Ok(())
}

fn write_shared(out: &mut String, shared: &[(String, String)]) -> fmt::Result {
    shared.iter().try_for_each(|(name, formula)| writeln!(out, "    {name} = {formula}"))
}
