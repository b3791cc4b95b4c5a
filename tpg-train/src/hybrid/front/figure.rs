//! A front as a section of a page.

use super::{Front, Kind, Outcome, Point};
use crate::picture::{Axis, Colour, Figure, Plot, Section, Table};
use tpg_graph::error::counted;

/// Draws a front, and writes it as a table.
pub fn section(front: &Front) -> Section {
    let title = format!("{}: return against the network's actions in an episode", front.problem);
    Section {
        title: "Asking at several prices".to_owned(),
        text: format!(
            "{} of each price and of a graph that asks nobody, the network {}, {} validation episodes each; nothing is paid for asks \
             here. Rules and mixtures join the network with the graphs that ask nobody: of {} the front, which they were \
             chosen for on the same episodes; mixtures draw who acts. Crosses in the table: no other row has as high a score with as few \
             actions of the network. Operations of a decision: the graph's C takes at most so many, the network two for each weight. Chosen: of the prices within one standard error of the best, the one that asks least.",
            counted(front.seeds.len(), "seed"),
            front.network,
            front.episodes,
            counted(front.rules_tried, "setting")
        ),
        tables: vec![rows(front)],
        figures: vec![Figure { svg: plot(front).svg(&title), caption: title, ..Figure::default() }],
        ..Section::default()
    }
}

fn plot(front: &Front) -> Plot {
    let mut plot = Plot::new(Axis::linear("actions of the network in an episode"), Axis::linear("mean return"));
    for (colour, kind) in Kind::ALL.into_iter().enumerate() {
        let colour = Colour(colour);
        let of_kind: Vec<&Point> = front.points.iter().filter(|point| point.kind == kind).collect();
        let place = |result: &Outcome| [result.network_actions, result.score];
        let hint = |point: &Point, result: &Outcome| format!("{} {}: {:.2}", kind.name(), point.setting, result.score);
        let seeds = of_kind.iter().flat_map(|point| point.seeds.iter().map(|one| (place(one), hint(point, one))));
        // Of rules and mixtures only means: their seeds would hide the graphs that ask.
        let means = of_kind.iter().map(|point| (place(&point.mean), hint(point, &point.mean)));
        match kind {
            Kind::Rules | Kind::Mixture => plot.points(colour, means.collect()),
            Kind::Graph | Kind::Asking | Kind::Network => plot.points(colour, seeds.collect()),
        }
        let mut line: Vec<[f64; 2]> = of_kind.iter().map(|point| place(&point.mean)).collect();
        line.sort_by(|a, b| a[0].total_cmp(&b[0]));
        if line.len() > 1 {
            plot.line(colour, line);
        }
        plot.name(colour, legend(kind));
    }
    plot
}

fn legend(kind: Kind) -> &'static str {
    match kind {
        Kind::Graph => "graphs that ask nobody",
        Kind::Asking => "graphs that ask; line: mean of a price",
        Kind::Rules => "with rules, means",
        Kind::Mixture => "mixtures, means",
        Kind::Network => "the network",
    }
}

fn rows(front: &Front) -> Table {
    let header =
        ["policy", "setting", "return", "network's actions", "of all, %", "operations: mean, most", "front", ""];
    let row = |point: &Point| {
        let Outcome { score, score_error, network_actions, actions, operations } = point.mean;
        vec![
            point.kind.name().to_owned(),
            point.setting.clone(),
            format!("{score:.2} ± {:.2}", 1.96 * score_error),
            format!("{network_actions:.1}"),
            format!("{:.1}", 100.0 * network_actions / actions.max(1.0)),
            format!("{:.0}, {:.0}", operations.mean, operations.worst),
            if point.on_front { "×" } else { "" }.to_owned(),
            if point.chosen { "chosen" } else { "" }.to_owned(),
        ]
    };
    Table { header: header.map(str::to_owned).into(), rows: front.points.iter().map(row).collect() }
}
