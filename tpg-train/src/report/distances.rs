//! The problem's measure at the end of episodes: its distribution within each run, and between the seeds of a group.

use super::runs::Group;
use super::test::Tested;
use crate::picture::{Axis, Colour, Figure, FiveNumbers, Plot, Section};

/// Smaller values are shown as this one.
const NEAREST: f64 = 0.1;
/// Number of points of a cumulative curve.
const POINTS: usize = 240;

pub(super) fn section(groups: &[Group], tested: &[Vec<Option<Tested>>]) -> Option<Section> {
    let measure = tested.iter().flatten().flatten().find_map(|tested| tested.measure)?;
    let label = format!("{} at the end, {}", measure.name, measure.unit);
    let distance = || Axis::log(&label, NEAREST);

    let names = groups.iter().flat_map(|group| group.runs.iter().map(|run| short(group, &run.name, run.seed)));
    let mut boxes = Plot::new(Axis::names("seed", names.collect()), distance());
    let mut seeds = Plot::new(
        Axis::names("group", groups.iter().map(|group| group.name.clone()).collect()),
        Axis::log(&format!("mean {label}"), 1.0),
    );
    let mut cumulative = Plot::new(distance(), Axis::linear("fraction of the episodes").between(0.0, 1.0));
    let mut place = 0.0;
    for ((colour, group), tested) in (0..).map(Colour).zip(groups).zip(tested) {
        let mut all = Vec::new();
        let mut means = Vec::new();
        for (run, tested) in group.runs.iter().zip(tested) {
            if let Some(tested) = tested.as_ref().filter(|tested| tested.measure == Some(measure)) {
                if let Some(five) = FiveNumbers::of(&tested.measures()) {
                    boxes.five(colour, place, five);
                }
                means.push(([colour.0 as f64, tested.summary().measure], run.name.clone()));
                all.extend(tested.measures());
            }
            place += 1.0;
        }
        let sample: Vec<f64> = means.iter().map(|([_, mean], _)| *mean).collect();
        if let Some(five) = FiveNumbers::of(&sample).filter(|_| sample.len() > 2) {
            seeds.five(colour, colour.0 as f64, five);
        }
        seeds.points(colour, means);
        cumulative.line(colour, curve(all));
        for plot in [&mut boxes, &mut cumulative] {
            plot.name(colour, &group.name);
        }
    }
    let figure = |plot: &Plot, caption: &str| Figure {
        svg: plot.svg(caption),
        caption: caption.to_owned(),
        ..Figure::default()
    };
    let mut figures = vec![figure(&boxes, "Each seed's episodes: median, quartiles, 5th and 95th percentile.")];
    if groups.iter().any(|group| group.runs.len() > 1) {
        let caption = "Each seed's mean as a point; boxes as in the picture before, over the seeds of a group.";
        figures.push(figure(&seeds, caption));
    }
    let caption = "Fraction of a group's episodes, all seeds together, that end below a value.";
    figures.push(figure(&cumulative, caption));
    let title = format!("The {} at the end of the test episodes", measure.name);
    Some(Section { title, figures, ..Section::default() })
}

/// Returns a run's name for use next to its group's name: its seed.
fn short(group: &Group, name: &str, seed: Option<u64>) -> String {
    if group.runs.len() == 1 && seed.is_none() {
        name.to_owned()
    } else {
        seed.map_or_else(String::new, |s| s.to_string())
    }
}

/// Returns the empirical distribution, at a limited number of points.
fn curve(mut distances: Vec<f64>) -> Vec<[f64; 2]> {
    distances.sort_by(f64::total_cmp);
    let count = distances.len();
    let at = |k: usize| (k * count / POINTS).max(1);
    (0..=POINTS)
        .filter(|_| count > 0)
        .map(|k| [distances[at(k) - 1].max(NEAREST), at(k) as f64 / count as f64])
        .collect()
}
