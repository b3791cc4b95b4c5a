//! Return against size: what a byte of flash buys.

use super::headline::flash;
use super::runs::{Group, Run};
use super::test::Tested;
use tpg_picture::{Axis, Colour, Figure, Plot, Section};

/// Draws each problem with at least two tested graphs. `halls` are the halls of fame of each group's runs.
pub(super) fn section(
    groups: &[Group],
    tested: &[Vec<Option<Tested>>],
    halls: &[Vec<(String, &Run, Tested)>],
) -> Option<Section> {
    let mut problems: Vec<&str> = Vec::new();
    for group in groups {
        if !problems.contains(&group.problem()) {
            problems.push(group.problem());
        }
    }
    let figures: Vec<Figure> = problems.iter().filter_map(|problem| figure(groups, tested, halls, problem)).collect();
    (!figures.is_empty()).then(|| Section {
        title: "Return against size".to_owned(),
        text: "Each point is a policy: the chosen one, and entries of the hall of fame, which beat every smaller one. Vertical: mean return \
               on test episodes. Horizontal: flash of its fast C on a Cortex-M4F, compiled with -Os, without a network that it asks."
            .to_owned(),
        figures,
        ..Section::default()
    })
}

fn figure(
    groups: &[Group],
    tested: &[Vec<Option<Tested>>],
    halls: &[Vec<(String, &Run, Tested)>],
    problem: &str,
) -> Option<Figure> {
    let mut plot = Plot::new(Axis::linear("bytes of flash"), Axis::linear("mean return"));
    let mut count = 0;
    for (((place, group), tested), hall) in
        groups.iter().enumerate().zip(tested).zip(halls).filter(|(((_, group), _), _)| group.problem() == problem)
    {
        let chosen = group.runs.iter().zip(tested).filter_map(|(run, tested)| Some((&run.name, run, tested.as_ref()?)));
        let points: Vec<([f64; 2], String)> = (chosen
            .chain(hall.iter().map(|(name, run, tested)| (name, *run, tested))))
        .filter_map(|(name, run, tested)| {
            let bytes = flash(run.evolved()?).ok()?;
            Some(([bytes as f64, tested.summary().score], name.clone()))
        })
        .collect();
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
