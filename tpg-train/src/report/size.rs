//! Return against size: what a byte of flash buys.

use super::headline::flash;
use super::runs::{Group, Run};
use tpg_picture::{Axis, Colour, Figure, Plot, Section};

/// Draws each problem with at least two tested graphs.
pub(super) fn section(groups: &[Group]) -> Option<Section> {
    let mut problems: Vec<&str> = Vec::new();
    for group in groups {
        if !problems.contains(&group.problem()) {
            problems.push(group.problem());
        }
    }
    let figures: Vec<Figure> = problems.iter().filter_map(|problem| figure(groups, problem)).collect();
    (!figures.is_empty()).then(|| Section {
        title: "Return against size".to_owned(),
        text: "Each point is a policy: the chosen one, and entries of the hall of fame, which beat every smaller one. Vertical: mean return \
               on test episodes. Horizontal: flash of its fast C on a Cortex-M4F, compiled with -Os, without a network that it asks."
            .to_owned(),
        figures,
        ..Section::default()
    })
}

fn figure(groups: &[Group], problem: &str) -> Option<Figure> {
    let mut plot = Plot::new(Axis::linear("bytes of flash"), Axis::linear("mean return"));
    let mut count = 0;
    for (place, group) in groups.iter().enumerate().filter(|(_, group)| group.problem() == problem) {
        let point = |name: String, run: &Run| {
            let bytes = flash(run.evolved()?).ok()?;
            Some(([bytes as f64, run.result.as_ref()?.summary().score], name))
        };
        let chosen = group.runs.iter().filter_map(|run| point(run.name.clone(), run));
        let entry = |run: &Run, entry: &Run| point(format!("{}, {}", run.name, entry.name), entry);
        let halls = group.runs.iter().flat_map(|run| run.hall.iter().filter_map(move |one| entry(run, one)));
        let points: Vec<([f64; 2], String)> = chosen.chain(halls).collect();
        if points.is_empty() {
            continue;
        }
        count += points.len();
        plot.points(Colour(place), points);
        plot.name(Colour(place), &group.name);
    }
    let caption = format!("{problem}: mean return of each graph against the size of its code.");
    (count > 1).then(|| Figure { svg: plot.svg(&caption), caption, ..Figure::default() })
}
