//! A trained policy: as formulas in the problem's units, as a graph, and what it does in episodes.

use super::headline::options;
use super::runs::Run;
use tpg_codegen::report::PolicyFormulas;
use tpg_graph::Graph;
use tpg_picture::{Formulas, Section, graph};

/// The section of a run's policy.
pub(super) fn section(run: &Run) -> Section {
    let (graph, tested) = (run.graph(), run.result.as_ref());
    let mut figures: Vec<_> = graph.map(graph::figure).into_iter().collect();
    figures.extend(tested.map(|tested| tested.pictures.clone()).unwrap_or_default());
    let episodes = if tested.is_some() { "the test episodes" } else { "the episodes that chose it" };
    let mut text = format!("The best of the group on {episodes}.");
    text.extend(graph.map(|graph| format!(" It sees {}.", seen(graph))));
    let formulas = graph.map(formulas).unwrap_or_default();
    Section { title: format!("Policy of {}", run.name), text, formulas, figures, ..Section::default() }
}

/// The sources with their units.
fn seen(graph: &Graph) -> String {
    let source = |source: &tpg_graph::Source| match (source.unit.as_str(), source.ranges.len()) {
        ("", 1) => source.name.clone(),
        (unit, 1) => format!("{} in {unit}", source.name),
        ("", count) => format!("{} ({count} values)", source.name),
        (unit, count) => format!("{} ({count} values, {unit})", source.name),
    };
    graph.sources().iter().map(source).collect::<Vec<_>>().join(", ")
}

/// The formulas of teams and leaves, optimised as the code is.
fn formulas(graph: &Graph) -> Vec<Formulas> {
    let PolicyFormulas { teams, leaves } = PolicyFormulas::of(graph, &options());
    let teams = teams.into_iter().enumerate().map(|(place, team)| {
        let bids = team.bids.into_iter().map(|bid| (bid.to, bid.formula));
        let root = if place == 0 { ", the root: the highest bid wins; of equal bids, the last" } else { "" };
        Formulas { heading: format!("team {}{root}", team.id), rows: team.shared.into_iter().chain(bids).collect() }
    });
    let outputs = graph.outputs();
    let unit = |name: &str| {
        let output = outputs.iter().find(|output| output.name == name);
        output.map_or_else(String::new, |output| {
            format!(", limited to {} {}", output.range, output.unit).trim_end().to_owned()
        })
    };
    let leaves = leaves.into_iter().map(|leaf| {
        let limits: String = leaf.values.first().map(|(name, _)| unit(name)).unwrap_or_default();
        let rows = leaf.shared.into_iter().chain(leaf.values).collect();
        Formulas { heading: format!("leaf {}{limits}", leaf.id), rows }
    });
    teams.chain(leaves).collect()
}
