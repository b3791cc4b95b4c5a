//! Learning curves: mean over the seeds of a group, with a band of one standard deviation.

use super::runs::{Group, OWN};
use tpg_engine::{Sample, quantile};
use tpg_picture::{Axis, Colour, Figure, Plot, Section};

/// The label of axes of scores.
const SCORE: &str = "score";

/// The place of a curve's values in a row of the log, their axis and a caption.
type Shown = (&'static str, Axis, &'static str);

pub(super) fn sections(groups: &[Group]) -> Vec<Section> {
    let success =
        |place| (place, Axis::linear("success").between(0.0, 1.0), "Share of the validation episodes that it solved.");
    let measure = |place| {
        (place, Axis::log("measure", 1.0), "The problem's measure at the end of these episodes, such as a distance.")
    };
    let score = |place, caption| (place, Axis::linear(SCORE), caption);
    let tpg = [
        score("/validation/score", "Mean score of the best survivor on the validation episodes."),
        success("/validation/success"),
        measure("/validation/measure"),
        score("/best_score", "Best running mean of a root's score."),
        score("/median_score", "Median of the roots' running means."),
        ("/teams", Axis::linear("teams"), "Teams of the surviving population."),
    ];
    let sac = [
        score("/score", "Mean score of the actor on the validation episodes."),
        success("/success"),
        measure("/measure"),
        ("/entropy", Axis::linear("nats"), "Entropy of the actor's decisions in training."),
    ];
    let mut sections = Vec::new();
    for (kind, title, x, shown) in
        [("TPG", "Evolution", "steps", &tpg[..]), ("SAC", "Soft actor-critic", "decisions", &sac[..])]
    {
        let groups: Vec<&Group> = groups.iter().filter(|group| group.runs[0].kind() == kind).collect();
        let mut problems: Vec<&str> = groups.iter().map(|group| group.problem()).collect();
        problems.dedup();
        // Scores of different problems have nothing to do with each other.
        for problem in problems {
            let groups: Vec<&Group> = groups.iter().copied().filter(|group| group.problem() == problem).collect();
            let of = if problem == OWN { String::new() } else { format!(": {problem}") };
            sections.push(section(format!("{title}{of}"), x, &groups, shown));
        }
    }
    sections
}

fn section(title: String, x: &str, groups: &[&Group], shown: &[Shown]) -> Section {
    let runs = || groups.iter().flat_map(|group| &group.runs);
    // A problem may define no success or no measure; a point is no curve, nor is a run without teams.
    let known = |(place, ..): &&Shown| {
        let tells =
            |points: Vec<[f64; 2]>| points.len() > 1 && (*place != "/teams" || points.iter().any(|it| it[1] != 0.0));
        runs().any(|run| tells(run.curve(place)))
    };
    // All curves begin where training does, and end together.
    let all = runs().flat_map(|run| shown.iter().flat_map(|(place, ..)| run.curve(place)));
    let end = all.map(|[x, _]| x).fold(1.0, f64::max);
    let scores = ends_of_scores(groups, shown);
    let figure = |(place, y, caption): &Shown| {
        let ends = scores.filter(|_| y.label == SCORE);
        let y = ends.map_or(y.clone(), |[low, high]| y.clone().between(low, high));
        let inside = |y: f64| ends.map_or(y, |[low, high]| y.clamp(low, high));
        let mut plot = Plot::new(Axis::linear(x).between(0.0, end), y);
        for (colour, group) in (0..).map(Colour).zip(groups) {
            let curves = group.runs.iter().map(|run| run.curve(place)).filter(|curve| !curve.is_empty());
            let points = over_seeds(&curves.collect::<Vec<_>>());
            let band = |&(x, mean, sd): &(f64, f64, Option<f64>)| Some([x, inside(mean - sd?), inside(mean + sd?)]);
            plot.band(colour, points.iter().filter_map(band).collect());
            plot.line(colour, points.iter().map(|&(x, mean, _)| [x, inside(mean)]).collect());
            plot.name(colour, &format!("{} ({})", group.name, group.runs.len()));
        }
        Figure { svg: plot.svg(caption), caption: (*caption).to_owned(), ..Figure::default() }
    };
    let text = "Lines are means over the seeds (how many, in brackets), bands one standard deviation. Scores below the fifth percentile \
                are drawn at the lower end of the axis."
        .to_owned();
    Section { title, text, figures: shown.iter().filter(known).map(figure).collect(), ..Section::default() }
}

/// The fifth percentile and the maximum of all curves of scores, which share their axis; `None` where these are the same.
fn ends_of_scores(groups: &[&Group], shown: &[Shown]) -> Option<[f64; 2]> {
    let places = shown.iter().filter(|(_, y, _)| y.label == SCORE).map(|(place, ..)| *place);
    let runs = || groups.iter().flat_map(|group| &group.runs);
    let scores = places.flat_map(|place| runs().flat_map(move |run| run.curve(place)));
    let finite: Vec<f64> = scores.map(|[_, score]| score).filter(|score| score.is_finite()).collect();
    let [low, high] = [quantile(&finite, 0.05)?, finite.iter().copied().fold(f64::NEG_INFINITY, f64::max)];
    (low < high).then_some([low, high])
}

/// Returns x, mean and standard deviation wherever a curve has a value, from where all have begun; a curve keeps a value until its
/// next one, so that runs with generations of different length have a mean. No curve may be empty.
fn over_seeds(curves: &[Vec<[f64; 2]>]) -> Vec<(f64, f64, Option<f64>)> {
    let begin = curves.iter().map(|curve| curve[0][0]).fold(f64::NEG_INFINITY, f64::max);
    let mut all: Vec<f64> = curves.iter().flatten().map(|&[x, _]| x).filter(|&x| x >= begin).collect();
    all.sort_by(f64::total_cmp);
    all.dedup();
    let point = |x: f64| {
        let value = |curve: &Vec<[f64; 2]>| curve[curve.partition_point(|&[at, _]| at <= x) - 1][1];
        let sample = Sample::new(&curves.iter().map(value).collect::<Vec<_>>());
        (x, sample.mean, (sample.count > 1).then(|| sample.sample_deviation()))
    };
    all.into_iter().map(point).collect()
}

#[cfg(test)]
mod tests {
    use super::over_seeds;

    #[test]
    fn the_mean_of_curves_with_values_at_different_places_begins_where_all_have_begun() {
        let one = over_seeds(&[vec![[10.0, 1.0], [20.0, 3.0]]]);
        assert_eq!(one, [(10.0, 1.0, None), (20.0, 3.0, None)]);
        let two = over_seeds(&[vec![[10.0, 1.0], [20.0, 3.0]], vec![[15.0, 5.0], [20.0, 5.0], [30.0, 9.0]]]);
        let means: Vec<(f64, f64)> = two.iter().map(|&(x, mean, _)| (x, mean)).collect();
        assert_eq!(means, [(15.0, 3.0), (20.0, 4.0), (30.0, 6.0)]);
        assert!(over_seeds(&[]).is_empty());
    }
}
