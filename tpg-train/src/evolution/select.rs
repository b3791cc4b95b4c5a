//! Selection: the roots that survive a generation.

use super::config::{SelectionConfig, SelectionMethod};
use tpg_engine::random::Stream;

/// An evaluated root.
#[derive(Clone, Debug)]
pub struct Candidate<'a> {
    /// Mean score over all of its evaluations, less the price of its lines.
    pub mean: f64,
    /// Scores of this generation, one per episode; empty for a root that was dropped by racing or whose score is final.
    pub scores: &'a [f64],
    /// The episodes that it solved, where policies are compared by success; empty otherwise.
    pub solved: &'a [bool],
    /// True if racing dropped it: it ranks below every root that was not dropped.
    pub dropped: bool,
}

/// Lexicase gives up after this many draws per survivor, because it rejects duplicates.
const TRIES_PER_SURVIVOR: usize = 8;

/// Returns the indices of the survivors, best mean first.
///
/// Selects `count` roots: [`lexicase_survivors`](SelectionConfig::lexicase_survivors) by lexicase, the others by the
/// configured method.
pub fn survivors(
    candidates: &[Candidate<'_>],
    count: usize,
    config: &SelectionConfig,
    stream: &mut Stream,
) -> Vec<usize> {
    let ranked = ranked(candidates);
    let count = count.min(ranked.len());
    let mut chosen = Vec::new();
    if config.lexicase_survivors > 0 {
        // Who was left behind in racing has fewer scores.
        let episodes = candidates.iter().map(|candidate| candidate.scores.len()).max().unwrap_or(0);
        let best: Vec<usize> = (ranked.iter().copied())
            .filter(|&place| episodes > 0 && candidates[place].scores.len() == episodes)
            .take(config.lexicase_candidates)
            .collect();
        let wanted = config.lexicase_survivors.min(count).min(best.len());
        for _ in 0..TRIES_PER_SURVIVOR * wanted {
            if chosen.len() == wanted {
                break;
            }
            let winner = lexicase(candidates, &best, config.lexicase_tolerance, stream);
            if !chosen.contains(&winner) {
                chosen.push(winner);
            }
        }
    }
    match config.method {
        SelectionMethod::Truncation => {
            for &place in &ranked {
                if chosen.len() < count && !chosen.contains(&place) {
                    chosen.push(place);
                }
            }
        }
        SelectionMethod::Tournament => {
            while chosen.len() < count {
                let rest: Vec<usize> = ranked.iter().copied().filter(|place| !chosen.contains(place)).collect();
                // `rest` is in order of rank, so the smallest index drawn is the best root.
                let best = (0..config.tournament_size).map(|_| stream.below(rest.len())).min().unwrap_or(0);
                chosen.push(rest[best]);
            }
        }
    }
    chosen.sort_by_key(|chosen| ranked.iter().position(|place| place == chosen));
    chosen
}

/// Ranks the indices by mean, best first; ties go to the older root, NaN comes last.
pub fn ranked(candidates: &[Candidate<'_>]) -> Vec<usize> {
    let worth = |place: usize| {
        let candidate = &candidates[place];
        let mean = if candidate.mean.is_nan() { f64::NEG_INFINITY } else { candidate.mean };
        (!candidate.dropped, mean)
    };
    let mut places: Vec<usize> = (0..candidates.len()).collect();
    places.sort_by(|&a, &b| {
        let ((a_kept, a_mean), (b_kept, b_mean)) = (worth(a), worth(b));
        b_kept.cmp(&a_kept).then(b_mean.total_cmp(&a_mean)).then(a.cmp(&b))
    });
    places
}

/// Selects one winner: episodes are visited in random order, and each keeps only the roots close to the best on it.
fn lexicase(candidates: &[Candidate<'_>], among: &[usize], tolerance: f64, stream: &mut Stream) -> usize {
    let mut left = among.to_vec();
    let mut episodes: Vec<usize> = (0..candidates[among[0]].scores.len()).collect();
    stream.shuffle(&mut episodes);
    for episode in episodes {
        if left.len() == 1 {
            break;
        }
        let score = |place: usize| candidates[place].scores[episode];
        // Solved is solved: nothing is gained by solving it faster.
        let solved = |place: usize| candidates[place].solved.get(episode).copied().unwrap_or(false);
        if left.iter().any(|&place| solved(place)) {
            left.retain(|&place| solved(place));
            continue;
        }
        let best = left.iter().map(|&place| score(place)).fold(f64::NEG_INFINITY, f64::max);
        let spread = median_deviation(among.iter().map(|&place| score(place)).collect());
        left.retain(|&place| score(place) >= best - tolerance * spread);
    }
    *stream.pick(&left)
}

/// Returns the median absolute deviation from the median: a measure of spread that is robust to extreme scores
/// (ε-lexicase selection, La Cava et al. 2016).
fn median_deviation(mut scores: Vec<f64>) -> f64 {
    let middle = |values: &mut Vec<f64>| {
        values.sort_by(f64::total_cmp);
        values[values.len() / 2]
    };
    let median = middle(&mut scores);
    middle(&mut scores.into_iter().map(|score| (score - median).abs()).collect())
}

#[cfg(test)]
mod tests {
    use super::{Candidate, survivors};
    use crate::evolution::config::{Effort, ParentChoice, RacingBy, SelectionConfig, SelectionMethod};
    use tpg_engine::random::{Purpose, Stream};

    fn config(method: SelectionMethod, lexicase_survivors: usize) -> SelectionConfig {
        SelectionConfig {
            method,
            tournament_size: 3,
            lexicase_survivors,
            lexicase_candidates: 100,
            lexicase_tolerance: 1.0,
            parents: ParentChoice::Uniform,
            racing_by: RacingBy::Generation,
            racing_episodes: 0,
            racing_share: 1.0,
            validation_roots: 1,
            validation_episodes: 1,
            validation_share: 0.1,
            validation_by: Effort::Episodes,
            line_price: 0.0,
            choice_errors: 0.0,
            flat_after: 0,
        }
    }

    fn candidates(scores: &[Vec<f64>]) -> Vec<Candidate<'_>> {
        let mean = |scores: &Vec<f64>| scores.iter().sum::<f64>() / scores.len() as f64;
        scores.iter().map(|scores| Candidate { mean: mean(scores), scores, solved: &[], dropped: false }).collect()
    }

    #[test]
    fn truncation_keeps_the_best_and_puts_dropped_and_nan_last() {
        let scores = vec![vec![1.0], vec![f64::NAN], vec![3.0], vec![9.0], vec![2.0]];
        let mut candidates = candidates(&scores);
        candidates[3].dropped = true;
        let mut stream = Stream::new(1, 0, Purpose::Test, 0);
        let kept = survivors(&candidates, 4, &config(SelectionMethod::Truncation, 0), &mut stream);
        assert_eq!(kept, [2, 4, 0, 1], "dropped only if nothing else is left");
    }

    #[test]
    fn lexicase_keeps_a_specialist_that_truncation_loses() {
        // Nine generalists and one root that alone solves episode 3, at a bad mean.
        let mut scores = vec![vec![5.0, 5.0, 5.0, 0.0]; 9];
        scores.push(vec![0.0, 0.0, 0.0, 9.0]);
        let candidates = candidates(&scores);
        let truncation = survivors(
            &candidates,
            5,
            &config(SelectionMethod::Truncation, 0),
            &mut Stream::new(1, 0, Purpose::Test, 0),
        );
        assert!(!truncation.contains(&9));
        // Each draw tries episode 3 first with a probability of one quarter.
        let kept = (0..50).filter(|&index| {
            let mut stream = Stream::new(1, 0, Purpose::Test, index);
            survivors(&candidates, 5, &config(SelectionMethod::Truncation, 5), &mut stream).contains(&9)
        });
        assert!(kept.count() > 40);
    }

    #[test]
    fn lexicase_compares_only_roots_that_ran_all_episodes() {
        let scores = [vec![9.0], vec![5.0, 5.0]];
        let candidates = candidates(&scores);
        for index in 0..20 {
            let mut stream = Stream::new(1, 0, Purpose::Test, index);
            assert_eq!(survivors(&candidates, 1, &config(SelectionMethod::Truncation, 1), &mut stream), [1]);
        }
    }

    #[test]
    fn where_success_counts_lexicase_does_not_prefer_the_faster() {
        // The first root solves both episodes slowly, the second one of them fast.
        let scores = [vec![10.0, 10.0], vec![11.0, -1.0]];
        let solved = [vec![true, true], vec![true, false]];
        let candidates: Vec<Candidate<'_>> = (scores.iter().zip(&solved))
            .map(|(scores, solved)| Candidate { mean: 0.0, scores, solved, dropped: false })
            .collect();
        for index in 0..20 {
            let mut stream = Stream::new(1, 0, Purpose::Test, index);
            assert_eq!(survivors(&candidates, 1, &config(SelectionMethod::Truncation, 1), &mut stream), [0]);
        }
    }

    #[test]
    fn tournaments_prefer_the_better_and_never_repeat() {
        let scores: Vec<Vec<f64>> = (0..100).map(|score| vec![f64::from(score)]).collect();
        let candidates = candidates(&scores);
        let mut stream = Stream::new(1, 0, Purpose::Test, 0);
        let mut kept = survivors(&candidates, 20, &config(SelectionMethod::Tournament, 0), &mut stream);
        let mean = kept.iter().sum::<usize>() as f64 / 20.0;
        assert!(mean > 60.0, "mean rank {mean}");
        kept.sort_unstable();
        kept.dedup();
        assert_eq!(kept.len(), 20);
    }
}
