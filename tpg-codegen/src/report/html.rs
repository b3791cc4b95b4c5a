//! The report as a page: bytes, operations, what was removed, which inputs matter, the policy as formulas and as a graph.

use super::{GraphCounts, Report, ShapeCost, ShapeSize};
use crate::explain::PolicyFormulas;
use crate::options::Options;
use crate::passes::removed::Removed;
use crate::size::Target;
use tpg_graph::error::counted;
use tpg_graph::interpret::{Answer, answers};
use tpg_graph::states::StateSet;
use tpg_graph::{Graph, Input};
use tpg_picture::{Formulas, Headline, Page, Section, Table, graph};

/// States on which inputs are held still, at most.
const STATES: usize = 2_000;

/// Puts the page together; `name` is the graph's.
pub fn page(name: &str, report: &Report, graph: &Graph, options: &Options, states: &StateSet) -> Page {
    let formulas = PolicyFormulas::of(graph, options);
    Page {
        title: name.to_owned(),
        lead: format!(
            "Graph with SHA-256 {}, in {} with {} maths.",
            report.graph_sha256,
            report.scalar.name(),
            report.maths.name()
        ),
        headlines: headlines(report),
        sections: vec![
            sizes(report),
            costs(report),
            removed(report),
            influence(graph, states),
            policy(graph, formulas),
        ],
    }
}

fn table(header: &[&str], rows: Vec<Vec<String>>) -> Table {
    Table { header: header.iter().map(|&cell| cell.to_owned()).collect(), rows }
}

fn headlines(report: &Report) -> Vec<Headline> {
    let cortex = |size: &&ShapeSize| size.target == Target::M4f && size.flash.is_some();
    let least = report.sizes.iter().filter(cortex).min_by_key(|size| size.flash);
    let size = least.map(|size| Headline {
        name: "least flash on a Cortex-M4F".to_owned(),
        value: format!("{} bytes", size.flash.unwrap_or_default()),
        note: format!("C, profile {}, compiled with -Os", size.profile),
    });
    let quick = report.costs.iter().min_by(|a, b| a.mean.operations.total_cmp(&b.mean.operations));
    let cost = quick.map(|cost| Headline {
        name: "operations of a decision".to_owned(),
        value: format!("{:.1}, at most {}", cost.mean.operations, cost.worst.operations),
        note: format!("C, profile {}; mean over {}", cost.profile, report.states),
    });
    let GraphCounts { teams, edges, programs, inputs, .. } = report.graph;
    let dead = report.dead_inputs.len();
    let graph = Headline {
        name: "the graph".to_owned(),
        value: format!("{}, {}", counted(teams, "team"), counted(edges, "edge")),
        note: format!("{}; reads {} of {}", counted(programs, "program"), inputs - dead, counted(inputs, "input")),
    };
    size.into_iter().chain(cost).chain([graph]).collect()
}

fn sizes(report: &Report) -> Section {
    let number = |number: Option<u64>| number.map_or_else(|| "not known".to_owned(), |number| number.to_string());
    let row = |size: &ShapeSize| {
        let stack = size.stack.as_ref().map(|stack| stack.bytes);
        vec![
            size.profile.to_owned(),
            size.target.name().to_owned(),
            number(size.flash),
            number(size.ram),
            number(stack),
        ]
    };
    let header = ["profile", "target", "flash", "RAM", "stack"];
    Section {
        title: "Bytes".to_owned(),
        text: "Of the C, with -Os, without the libraries that are called.".to_owned(),
        tables: vec![table(&header, report.sizes.iter().map(row).collect())],
        ..Section::default()
    }
}

fn costs(report: &Report) -> Section {
    let row = |ShapeCost { profile, worst, mean }: &ShapeCost| {
        vec![
            profile.to_string(),
            format!("{:.1}", mean.operations),
            worst.operations.to_string(),
            format!("{:.1}", mean.bids),
            worst.bids.to_string(),
            format!("{:.2}", mean.teams),
            worst.teams.to_string(),
        ]
    };
    let header = ["profile", "operations, mean", "at most", "bids, mean", "at most", "teams, mean", "at most"];
    Section {
        title: "Cost of a decision".to_owned(),
        text: format!("In C. Means are over {}.", report.states),
        tables: vec![table(&header, report.costs.iter().map(row).collect())],
        ..Section::default()
    }
}

fn removed(report: &Report) -> Section {
    let GraphCounts { lines, introns, distinct_operations, operations, .. } = report.graph;
    let Removed { duplicate_bids, hopeless_bids, teams_without_choice, twin_teams, unreachable_teams, .. } =
        report.removed;
    let rows = [
        ("lines of programs", lines),
        ("introns: lines that no result depends on", introns),
        ("operations that differ", distinct_operations),
        ("operations after all passes", operations),
        ("bids that equal a later one of their team", duplicate_bids),
        ("bids that another one always outbids", hopeless_bids),
        ("teams without a choice", teams_without_choice),
        ("teams that decide as another one", twin_teams),
        ("teams that no edge leads to any more", unreachable_teams),
    ];
    let rows = rows.into_iter().filter(|&(_, count)| count > 0);
    Section {
        title: "What was removed".to_owned(),
        tables: vec![table(
            &["", "count"],
            rows.map(|(what, count)| vec![what.to_owned(), count.to_string()]).collect(),
        )],
        ..Section::default()
    }
}

/// Returns for each input the share of states where the answer changes when that input alone is held at the middle of its range,
/// from 0 to 1.
pub fn changed_answers(graph: &Graph, states: &StateSet) -> Vec<f64> {
    let (length, mut all) = (graph.state_length(), states.all().into_owned());
    all.truncate(STATES * length);
    let before = answers(graph, &all);
    let held = |input: Input, middle: f64| {
        let mut still = all.clone();
        still.chunks_exact_mut(length).for_each(|state| state[input.index()] = middle);
        let after = answers(graph, &still);
        let changed = before.iter().zip(&after).filter(|(before, after)| !Answer::same_bits(before, after)).count();
        changed as f64 / before.len().max(1) as f64
    };
    graph
        .inputs()
        .zip(graph.state_ranges())
        .map(|(input, range)| held(input, 0.5 * range.min + 0.5 * range.max))
        .collect()
}

fn influence(graph: &Graph, states: &StateSet) -> Section {
    let shares = changed_answers(graph, states);
    let mut rows: Vec<(f64, Input)> = shares.into_iter().zip(graph.inputs()).collect();
    rows.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    let row = |(share, input): (f64, Input)| {
        let (source, _) = graph.source_of(input);
        vec![graph.input_name(input), source.unit.clone(), format!("{:.1} %", 100.0 * share)]
    };
    Section {
        title: "Inputs that matter".to_owned(),
        text: format!(
            "Share of {} where the answer changes when this input alone is held at the middle of its declared range.",
            counted(states.count().min(STATES), "state")
        ),
        tables: vec![table(&["input", "unit", "answers changed"], rows.into_iter().map(row).collect())],
        ..Section::default()
    }
}

fn policy(graph: &Graph, PolicyFormulas { teams, leaves }: PolicyFormulas) -> Section {
    let teams = teams.into_iter().map(|team| {
        let bids = team.bids.into_iter().map(|bid| (bid.to, bid.formula));
        Formulas { heading: format!("team {}", team.id), rows: team.shared.into_iter().chain(bids).collect() }
    });
    let leaves = leaves.into_iter().map(|leaf| Formulas {
        heading: format!("leaf {}", leaf.id),
        rows: leaf.shared.into_iter().chain(leaf.values).collect(),
    });
    Section {
        title: "The policy".to_owned(),
        text: "The first team is the root. The highest bid wins, of equal bids the last; a NaN is the lowest."
            .to_owned(),
        formulas: teams.chain(leaves).collect(),
        figures: vec![graph::figure(graph)],
        ..Section::default()
    }
}
