//! The study as one HTML page, with the paper's figures 5, 6 and 7 redrawn from our data.

use super::choice::Summary;
use super::command::Alone;
use super::study::{Cell, HAND_BACKS, SEPARATIONS};
use crate::hybrid::setting::shown;
use crate::picture::{Axis, Colour, Figure, FiveNumbers, Page, Plot, Section, Table};
use tpg_problems::arm::targets::Start;

/// Renders the page.
pub fn page(start: Start, cells: &[Cell], summaries: &[Summary], alone: &[Alone]) -> String {
    let problem = match start {
        Start::Fs => "fixed start",
        Start::Rs => "random start",
    };
    let pairs = cells.iter().map(|cell| (cell.tpg, cell.sac)).collect::<std::collections::BTreeSet<_>>().len();
    let episodes = cells.first().map_or(0, |cell| cell.episodes);
    Page {
        title: format!("Hybrid study, {problem}"),
        lead: format!(
            "{pairs} pairs of a graph and an actor, {} settings, {episodes} validation episodes each. An invalid action \
             ends an episode as a failure, whoever chose it. Times are those of the trainer's own evaluation.",
            summaries.len()
        ),
        sections: vec![
            chosen(summaries),
            section("Both parameters (the paper's figure 5)", figures(summaries, parameters)),
            section("Distance, success and time (figure 6)", vec![
                front(summaries, "distance, mm", |s| s.distance_mm),
                front(summaries, "success, %", |s| 100.0 * s.success),
            ]),
            section("Alone and together, over all pairs (figure 7)", vec![
                together(cells, summaries, alone, "distance, mm", |c| c.distance_mm, |a| a.distance_mm),
                together(cells, summaries, alone, "success, %", |c| 100.0 * c.success, |a| 100.0 * a.success),
            ]),
        ],
        ..Page::default()
    }
    .html()
}

fn section(title: &str, figures: Vec<Figure>) -> Section {
    Section { title: title.to_owned(), figures, ..Section::default() }
}

/// Draws a figure for each guard.
fn figures(summaries: &[Summary], draw: impl Fn(&str, &[&Summary]) -> Figure) -> Vec<Figure> {
    let mut guards: Vec<&str> = summaries.iter().map(|summary| summary.guard.as_str()).collect();
    guards.dedup();
    let of = |guard: &str| -> Vec<&Summary> { summaries.iter().filter(|summary| summary.guard == guard).collect() };
    guards.into_iter().map(|guard| draw(guard, &of(guard))).collect()
}

fn chosen(summaries: &[Summary]) -> Section {
    let header = [
        "guard",
        "cycles",
        "hands back after",
        "separation, mm",
        "success, %",
        "collision, %",
        "distance, mm",
        "actions",
        "by the graph, %",
        "ns per action",
        "",
    ];
    let row = |summary: &Summary| {
        let percent = |value: f64, sd: f64| format!("{:.1} ± {:.1}", 100.0 * value, 100.0 * sd);
        vec![
            summary.guard.clone(),
            summary.cycle_detector.name().to_owned(),
            summary.hand_back_after.to_string(),
            shown(summary.separation_mm),
            percent(summary.success, summary.success_sd),
            percent(summary.collision, summary.collision_sd),
            format!("{:.2} ± {:.2}", summary.distance_mm, summary.distance_sd),
            format!("{:.0}", summary.actions),
            format!("{:.1}", 100.0 * summary.tpg_action_ratio),
            format!("{:.0}", summary.ns_per_action),
            if summary.chosen { "chosen" } else { "" }.to_owned(),
        ]
    };
    let mut front: Vec<&Summary> = summaries.iter().filter(|summary| summary.on_front || summary.chosen).collect();
    front.sort_by(|a, b| a.ns_per_action.total_cmp(&b.ns_per_action));
    Section {
        title: "Settings on the front".to_owned(),
        text: "No other setting is at least as good in distance, success and time and better in one. Chosen: of those \
               within one standard error of the highest success, the one with the least time per action. Mean ± standard deviation over pairs."
            .to_owned(),
        tables: vec![Table { header: header.map(str::to_owned).into(), rows: front.into_iter().map(row).collect() }],
        ..Section::default()
    }
}

fn parameters(guard: &str, summaries: &[&Summary]) -> Figure {
    let names = SEPARATIONS.map(shown).into();
    let mut plot = Plot::new(Axis::names("separation, mm", names), Axis::linear("distance at the end, mm"));
    for (colour, back) in HAND_BACKS.into_iter().enumerate() {
        let at = |separation: f64| {
            let of_back = summaries.iter().find(|s| s.hand_back_after == back && s.separation_mm == separation)?;
            Some(of_back.distance_mm)
        };
        let points = SEPARATIONS.into_iter().enumerate().filter_map(|(x, mm)| Some([x as f64, at(mm)?]));
        plot.line(Colour(colour), points.collect());
        plot.name(Colour(colour), &format!("hands back after {back}"));
    }
    let title = format!("Distance at the end by both parameters, guard {guard}");
    Figure { svg: plot.svg(&title), caption: title, ..Figure::default() }
}

fn front(summaries: &[Summary], label: &str, value: impl Fn(&Summary) -> f64) -> Figure {
    let mut plot = Plot::new(Axis::linear("ns per action"), Axis::linear(label));
    let mut guards: Vec<&str> = summaries.iter().map(|summary| summary.guard.as_str()).collect();
    guards.dedup();
    for (colour, guard) in guards.into_iter().enumerate() {
        let of_guard = summaries.iter().filter(|summary| summary.guard == guard);
        let point = |summary: &Summary| {
            let hint = format!(
                "hands back after {}, separation {} mm, guard {}: {:.1} % success, {:.2} mm, {:.0} ns",
                summary.hand_back_after,
                shown(summary.separation_mm),
                summary.guard,
                100.0 * summary.success,
                summary.distance_mm,
                summary.ns_per_action
            );
            ([summary.ns_per_action, value(summary)], hint)
        };
        plot.points(Colour(colour), of_guard.map(point).collect());
        plot.name(Colour(colour), &format!("guard {guard}"));
    }
    let mut best: Vec<[f64; 2]> =
        summaries.iter().filter(|s| s.on_front).map(|s| [s.ns_per_action, value(s)]).collect();
    best.sort_by(|a, b| a[0].total_cmp(&b[0]));
    plot.line(Colour(7), best);
    plot.name(Colour(7), "the front");
    let title = format!("Every setting: {label} against time per action");
    Figure {
        svg: plot.svg(&title),
        caption: format!("{title}. The front is that of distance, success and time together."),
        ..Figure::default()
    }
}

fn together(
    cells: &[Cell],
    summaries: &[Summary],
    alone: &[Alone],
    label: &str,
    of_cell: impl Fn(&Cell) -> f64,
    of_alone: impl Fn(&Alone) -> f64,
) -> Figure {
    let kind = |kind: &str| -> Vec<f64> { alone.iter().filter(|a| a.kind == kind).map(&of_alone).collect() };
    let chosen = summaries.iter().find(|summary| summary.chosen);
    let hybrid: Vec<f64> = cells.iter().filter(|cell| chosen.is_some_and(|c| c.is_of(cell))).map(&of_cell).collect();
    let names = ["graph alone", "actor alone", "hybrid"].map(str::to_owned).into();
    let mut plot = Plot::new(Axis::names("", names), Axis::linear(label));
    for (place, sample) in [kind("tpg"), kind("sac"), hybrid].into_iter().enumerate() {
        if let Some(five) = FiveNumbers::of(&sample) {
            plot.five(Colour(place), place as f64, five);
        }
        let points = sample.iter().map(|&value| ([place as f64, value], format!("{value:.2}")));
        plot.points(Colour(place), points.collect());
    }
    let title = format!("{label}: graphs alone, actors alone, and all their pairs under the chosen setting");
    Figure { svg: plot.svg(&title), caption: title, ..Figure::default() }
}
