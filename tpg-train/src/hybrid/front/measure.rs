//! Every policy of a sweep on the same validation episodes.

use super::work::{self, Work};
use super::{Front, Kind, Outcome, Point, Trained};
use crate::hybrid::cells::grid;
use crate::hybrid::command::quantiles;
use crate::hybrid::setting::{Detector, Setting};
use crate::hybrid::shared::Episodes;
use crate::hybrid::span::Span;
use crate::hybrid::trial::{Acting, HybridTrial};
use rayon::prelude::*;
use std::cmp::Ordering;
use tpg_engine::Summary;
use tpg_engine::random::Purpose;
use tpg_graph::Graph;
use tpg_graph::error::InputError;

/// Shares of the network in mixtures.
const SHARES: [f64; 4] = [0.05, 0.1, 0.2, 0.5];
/// Actions of the network before the graph takes over again.
const BACK: [Span; 3] = [Span(1), Span(5), Span(20)];
/// Actions without progress.
const PATIENCE: [Span; 2] = [Span(10), Span::NEVER];

/// A policy, and the operations of its graph; 0 without one.
type Counted<'a> = (Acting<'a>, f64);

/// Measures all policies.
///
/// # Errors
/// If one does not fit the problem.
pub fn measure(trained: &Trained<'_>) -> Result<Front, InputError> {
    let Trained { problem, network, seeds, alone, asking, .. } = trained;
    let episodes = episodes(trained.episodes);
    let rules = rules(trained)?;
    let of_network = work::of_network(&network.1);
    let of_graphs = |graphs: &[(String, Graph)]| graphs.par_iter().map(|(_, graph)| work::of_graph(graph)).collect();
    let of_alone: Vec<f64> = of_graphs(alone);
    let with = |acting: Vec<_>, operations: &[f64]| acting.into_iter().zip(operations.iter().copied()).collect();
    let mut policies: Vec<(Kind, String, Vec<Counted<'_>>)> = Vec::new();
    policies.push((Kind::Graph, "alone".to_owned(), with(alone.iter().map(Acting::Graph).collect(), &of_alone)));
    for (price, graphs) in asking {
        let acting = graphs.iter().map(|graph| Acting::Both(graph, network, &Setting::ONLY_ASKS)).collect();
        let acting = with(acting, &of_graphs(graphs));
        policies.push((Kind::Asking, format!("price {price}"), acting));
    }
    for setting in &rules {
        let acting = alone.iter().map(|graph| Acting::Both(graph, network, setting)).collect();
        policies.push((Kind::Rules, setting.sentence(), with(acting, &of_alone)));
    }
    for share in SHARES {
        let acting = alone.iter().map(|graph| Acting::Mixture(graph, network, share)).collect();
        policies.push((Kind::Mixture, format!("{} %", 100.0 * share), with(acting, &of_alone)));
    }
    policies.push((Kind::Network, "alone".to_owned(), vec![(Acting::Network(network), 0.0)]));
    let jobs: Vec<(usize, Acting<'_>, f64)> = (policies.iter().enumerate())
        .flat_map(|(point, (_, _, acting))| acting.iter().map(move |&(acting, of_graph)| (point, acting, of_graph)))
        .collect();
    let outcomes: Vec<Outcome> = jobs
        .par_iter()
        .map(|&(point, acting, of_graph)| {
            let done = problem.trial(acting, episodes)?;
            Ok(outcome(&done, |share| Work::of(policies[point].0, of_graph, of_network, share)))
        })
        .collect::<Result<_, InputError>>()?;
    let mut points: Vec<Point> = policies.iter().map(|(kind, setting, _)| Point::new(*kind, setting.clone())).collect();
    for ((point, ..), outcome) in jobs.iter().zip(outcomes) {
        points[*point].seeds.push(outcome);
    }
    points.iter_mut().for_each(|point| point.mean = mean(&point.seeds));
    best_rules(&mut points);
    mark(&mut points);
    Ok(Front {
        problem: problem.name(),
        network: network.0.clone(),
        seeds: seeds.clone(),
        episodes: episodes.count,
        rules_tried: rules.len(),
        points,
    })
}

/// Returns the episodes: drawn by another seed than those that choose within a run.
fn episodes(count: usize) -> Episodes {
    Episodes { purpose: Purpose::Selection, count, seed: 1 }
}

/// Returns the settings of rules to try.
fn rules(trained: &Trained<'_>) -> Result<Vec<Setting>, InputError> {
    let Trained { problem, network, alone, .. } = trained;
    let episodes = episodes(trained.episodes.min(50));
    let rises = alone.par_iter().map(|graph| problem.rises(graph, network, episodes));
    let rises = rises.collect::<Result<Vec<_>, _>>()?.concat();
    Ok(grid(&[Detector::None], &BACK, &quantiles(rises), &PATIENCE))
}

/// Sums a trial up; `work` tells the operations by the network's share of the actions.
fn outcome(done: &HybridTrial, work: impl Fn(f64) -> Work) -> Outcome {
    let summary = Summary::of(&done.endings);
    let share = done.network_actions / summary.actions.max(1.0);
    Outcome {
        score: summary.score,
        score_error: summary.score_deviation(&done.endings) / (summary.episodes.max(1) as f64).sqrt(),
        network_actions: done.network_actions,
        actions: summary.actions,
        operations: work(share),
    }
}

impl Point {
    fn new(kind: Kind, setting: String) -> Self {
        Self { kind, setting, mean: mean(&[]), on_front: false, chosen: false, seeds: Vec::new() }
    }
}

fn mean(seeds: &[Outcome]) -> Outcome {
    let count = seeds.len().max(1) as f64;
    let of = |value: fn(&Outcome) -> f64| seeds.iter().map(value).sum::<f64>() / count;
    let most = seeds.iter().map(|seed| seed.operations.worst).fold(0.0, f64::max);
    let squares: f64 = seeds.iter().map(|seed| seed.score_error * seed.score_error).sum();
    Outcome {
        score: of(|seed| seed.score),
        score_error: squares.sqrt() / count,
        network_actions: of(|seed| seed.network_actions),
        actions: of(|seed| seed.actions),
        // The mean over seeds, and the most of any.
        operations: Work { mean: of(|seed| seed.operations.mean), worst: most },
    }
}

/// Returns true if a result is at least as good as another with at most as many actions of the network, and better in one.
fn beats(one: &Outcome, other: &Outcome) -> bool {
    let (score, actions) = (one.score.total_cmp(&other.score), other.network_actions.total_cmp(&one.network_actions));
    score.is_ge() && actions.is_ge() && (score, actions) != (Ordering::Equal, Ordering::Equal)
}

/// Leaves out rules that other rules beat.
fn best_rules(points: &mut Vec<Point>) {
    let rules: Vec<Outcome> = points.iter().filter(|point| point.kind == Kind::Rules).map(|point| point.mean).collect();
    points.retain(|point| point.kind != Kind::Rules || !rules.iter().any(|rule| beats(rule, &point.mean)));
}

/// Marks the front, and the price to use: of those within one standard error of the best, the one that asks least.
fn mark(points: &mut [Point]) {
    let means: Vec<Outcome> = points.iter().map(|point| point.mean).collect();
    for point in &mut *points {
        point.on_front = !means.iter().any(|mean| beats(mean, &point.mean));
    }
    let asking = |points: &[Point]| {
        let places = points.iter().enumerate().filter(|(_, point)| point.kind == Kind::Asking);
        places.map(|(place, point)| (place, point.mean)).collect::<Vec<_>>()
    };
    let asking = asking(points);
    let Some((_, best)) = asking.iter().rev().max_by(|a, b| a.1.score.total_cmp(&b.1.score)) else { return };
    let good = asking.iter().filter(|(_, mean)| mean.score >= best.score - best.score_error);
    if let Some(&(place, _)) = good.min_by(|a, b| a.1.network_actions.total_cmp(&b.1.network_actions)) {
        points[place].chosen = true;
    }
}

#[cfg(test)]
mod tests {
    use super::{Kind, Outcome, Point, Work, best_rules, mark, mean};

    fn point(kind: Kind, setting: &str, score: f64, network_actions: f64) -> Point {
        let seeds =
            vec![Outcome { score, score_error: 2.0, network_actions, actions: 200.0, operations: Work::default() }];
        Point { mean: mean(&seeds), seeds, ..Point::new(kind, setting.to_owned()) }
    }

    #[test]
    fn what_another_beats_is_not_on_the_front_and_few_asks_are_chosen() {
        let mut points = vec![
            point(Kind::Graph, "alone", -200.0, 0.0),
            point(Kind::Asking, "price 1", -150.0, 40.0),
            point(Kind::Asking, "price 2", -151.5, 10.0), // within the standard error
            point(Kind::Asking, "price 3", -190.0, 12.0), // beaten by price 2
            point(Kind::Rules, "few", -160.0, 5.0),
            point(Kind::Rules, "many", -165.0, 50.0), // beaten by the other rules: left out
            point(Kind::Mixture, "5 %", -160.0, 5.0), // as good as the rules: neither beats the other
            point(Kind::Network, "alone", -149.0, 200.0),
        ];
        best_rules(&mut points);
        mark(&mut points);
        let names = |wanted: fn(&Point) -> bool| {
            points.iter().filter(|point| wanted(point)).map(|point| point.setting.as_str()).collect::<Vec<_>>()
        };
        assert_eq!(names(|point| point.on_front), ["alone", "price 1", "price 2", "few", "5 %", "alone"]);
        assert_eq!(names(|point| point.chosen), ["price 2"]);
        assert!(!names(|_| true).contains(&"many"));
    }

    #[test]
    fn a_mean_has_the_error_of_all_its_episodes() {
        let seed = |score| {
            let operations = Work { mean: score, worst: 10.0 * score };
            Outcome { score, score_error: 3.0, network_actions: score, actions: 10.0, operations }
        };
        let mean = mean(&[seed(1.0), seed(2.0), seed(3.0), seed(6.0)]);
        assert_eq!((mean.score, mean.score_error, mean.network_actions, mean.actions), (3.0, 1.5, 3.0, 10.0));
        assert_eq!(mean.operations, Work { mean: 3.0, worst: 60.0 });
    }
}
