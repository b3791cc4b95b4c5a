//! The study as one HTML page: settings, the front, and the hybrid beside its parts.

use super::cells::{Alone, Cell};
use super::choice::Summary;
use super::setting::shown;
use std::collections::BTreeSet;
use tpg_picture::{Axis, Colour, Figure, FiveNumbers, Page, Plot, Section, Table};

/// Renders the page.
pub(crate) fn page(problem: &str, cells: &[Cell], summaries: &[Summary], alone: &[Alone]) -> String {
    let pairs = cells.iter().map(|cell| (cell.tpg, cell.sac)).collect::<BTreeSet<_>>().len();
    let episodes = cells.first().map_or(0, |cell| cell.episodes);
    Page {
        title: format!("Hybrid study, {problem}"),
        lead: format!(
            "{pairs} pairs of a graph and a network, {} settings, {episodes} validation episodes each.",
            summaries.len()
        ),
        sections: vec![front(summaries), parts(alone), together(cells, summaries, alone)],
        ..Page::default()
    }
    .html()
}

fn front(summaries: &[Summary]) -> Section {
    let header = [
        "guard",
        "cycles",
        "hands back after",
        "separation",
        "patience",
        "score",
        "success, %",
        "actions",
        "by the graph, %",
        "network's actions",
        "",
    ];
    let row = |summary: &Summary| {
        vec![
            summary.setting.guard.clone(),
            summary.setting.detector.name().to_owned(),
            summary.setting.hand_back_after.to_string(),
            shown(summary.setting.separation),
            summary.setting.patience.to_string(),
            format!("{:.2} ± {:.2}", summary.score, summary.score_sd),
            percent(summary.success),
            format!("{:.1}", summary.steps),
            format!("{:.1}", 100.0 * summary.tpg_action_ratio),
            format!("{:.1}", summary.network_actions),
            if summary.chosen { "chosen" } else { "" }.to_owned(),
        ]
    };
    let mut listed: Vec<&Summary> = summaries.iter().filter(|summary| summary.on_front || summary.chosen).collect();
    listed.sort_by(|a, b| a.network_actions.total_cmp(&b.network_actions));
    let mut plot = Plot::new(Axis::linear("actions of the network in an episode"), Axis::linear("score"));
    let point = |summary: &Summary| {
        let hint = format!("{}: score {:.2}", summary.setting.sentence(), summary.score);
        ([summary.network_actions, summary.score], hint)
    };
    plot.points(Colour(0), summaries.iter().map(point).collect());
    plot.name(Colour(0), "every setting");
    plot.line(Colour(1), listed.iter().filter(|s| s.on_front).map(|s| [s.network_actions, s.score]).collect());
    plot.name(Colour(1), "the front");
    let title = "Score against actions of the network, mean over pairs".to_owned();
    Section {
        title: "Settings on the front".to_owned(),
        text: "No other setting is at least as good with as few actions of the network, and better in one of them. Chosen: \
               of those within one standard error of the best, the one with the fewest actions of the network. Mean ± \
               standard deviation over pairs."
            .to_owned(),
        tables: vec![Table { header: header.map(str::to_owned).into(), rows: listed.into_iter().map(row).collect() }],
        figures: vec![Figure { svg: plot.svg(&title), caption: title, ..Figure::default() }],
        ..Section::default()
    }
}

fn parts(alone: &[Alone]) -> Section {
    let header = ["policy", "file", "score", "success, %", "actions"].map(str::to_owned).into();
    let row = |alone: &Alone| {
        vec![
            alone.kind.to_owned(),
            alone.file.clone(),
            format!("{:.2}", alone.mean_score),
            percent(alone.success),
            format!("{:.1}", alone.mean_steps),
        ]
    };
    let rows = alone.iter().map(row).collect();
    Section { title: "Alone".to_owned(), tables: vec![Table { header, rows }], ..Section::default() }
}

fn together(cells: &[Cell], summaries: &[Summary], alone: &[Alone]) -> Section {
    let kind = |kind: &str| -> Vec<f64> { alone.iter().filter(|a| a.kind == kind).map(|a| a.mean_score).collect() };
    let chosen = summaries.iter().find(|summary| summary.chosen).map(|summary| &summary.setting);
    let hybrid = cells.iter().filter(|cell| chosen == Some(&cell.setting)).map(|cell| cell.mean_score).collect();
    let names = ["graph alone", "network alone", "hybrid"].map(str::to_owned).into();
    let mut plot = Plot::new(Axis::names("", names), Axis::linear("score"));
    for (place, sample) in [kind("tpg"), kind("sac"), hybrid].into_iter().enumerate() {
        if let Some(five) = FiveNumbers::new(&sample) {
            plot.five(Colour(place), place as f64, five);
        }
        let points = sample.iter().map(|&value| ([place as f64, value], format!("{value:.2}")));
        plot.points(Colour(place), points.collect());
    }
    let title = "Mean score: graphs alone, networks alone, and all their pairs under the chosen setting".to_owned();
    let figures = vec![Figure { svg: plot.svg(&title), caption: title, ..Figure::default() }];
    Section { title: "Alone and together".to_owned(), figures, ..Section::default() }
}

fn percent(rate: Option<f64>) -> String {
    rate.map_or_else(|| "–".to_owned(), |rate| format!("{:.1}", 100.0 * rate))
}
