//! Selection: the roots that survive a generation.

use super::config::SelectionConfig;
use tpg_engine::random::Stream;

/// The results of a root by which it is selected.
#[derive(Clone, Debug)]
pub(super) struct Scored {
    /// Mean score over all of its evaluations, less the price of its lines.
    pub mean: f64,
    /// Scores of this generation, one per episode; fewer for a root that racing stopped or whose score is final.
    pub scores: Vec<f64>,
    /// The episodes that it solved, where policies are compared by success; all false otherwise.
    pub solved: Vec<bool>,
}

/// Lexicase chooses among so many roots for each of its survivors: the best by running mean.
const CANDIDATES_PER_SURVIVOR: usize = 12;
/// Lexicase gives up after this many draws per survivor, because it rejects duplicates.
const TRIES_PER_SURVIVOR: usize = 8;
/// Lexicase treats scores as equal within this many median absolute deviations of an episode's scores.
const TOLERANCE: f64 = 0.1;

/// Returns the indices of the survivors, best mean first.
///
/// Selects `count` roots: [`lexicase_survivors`](SelectionConfig::lexicase_survivors) by lexicase, the others by mean.
pub(super) fn survivors(roots: &[Scored], count: usize, config: &SelectionConfig, stream: &mut Stream) -> Vec<usize> {
    let ranked = ranked(roots);
    let count = count.min(ranked.len());
    let mut chosen = Vec::new();
    if config.lexicase_survivors > 0 {
        let episodes = roots.iter().map(|root| root.scores.len()).max().unwrap_or(0);
        let best: Vec<usize> = (ranked.iter().copied())
            .filter(|&place| episodes > 0 && roots[place].scores.len() == episodes)
            .take(CANDIDATES_PER_SURVIVOR * config.lexicase_survivors)
            .collect();
        let wanted = config.lexicase_survivors.min(count).min(best.len());
        for _ in 0..TRIES_PER_SURVIVOR * wanted {
            if chosen.len() == wanted {
                break;
            }
            let winner = lexicase(roots, &best, stream);
            if !chosen.contains(&winner) {
                chosen.push(winner);
            }
        }
    }
    for &place in &ranked {
        if chosen.len() < count && !chosen.contains(&place) {
            chosen.push(place);
        }
    }
    chosen.sort_by_key(|chosen| ranked.iter().position(|place| place == chosen));
    chosen
}

/// Ranks the indices by mean, best first; ties go to the older root, NaN comes last.
pub(super) fn ranked(roots: &[Scored]) -> Vec<usize> {
    let mean = |place: usize| if roots[place].mean.is_nan() { f64::NEG_INFINITY } else { roots[place].mean };
    let mut places: Vec<usize> = (0..roots.len()).collect();
    places.sort_by(|&a, &b| mean(b).total_cmp(&mean(a)));
    places
}

/// Selects one winner: episodes are visited in random order, and each keeps only the roots close to the best on it.
fn lexicase(roots: &[Scored], among: &[usize], stream: &mut Stream) -> usize {
    let mut left = among.to_vec();
    let mut episodes: Vec<usize> = (0..roots[among[0]].scores.len()).collect();
    stream.shuffle(&mut episodes);
    for episode in episodes {
        if left.len() == 1 {
            break;
        }
        let score = |place: usize| roots[place].scores[episode];
        // Solved is solved: nothing is gained by solving it faster.
        let solved = |place: usize| roots[place].solved[episode];
        if left.iter().any(|&place| solved(place)) {
            left.retain(|&place| solved(place));
            continue;
        }
        let best = left.iter().map(|&place| score(place)).fold(f64::NEG_INFINITY, f64::max);
        let spread = median_deviation(among.iter().map(|&place| score(place)).collect());
        left.retain(|&place| score(place) >= best - TOLERANCE * spread);
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
    use super::{Scored, survivors};
    use crate::evolution::config::SelectionConfig;
    use tpg_engine::random::{Purpose, Stream};

    /// Returns the survivors of 50 selections with other streams.
    fn kept(scores: &[&[f64]], count: usize, lexicase_survivors: usize) -> Vec<Vec<usize>> {
        let config = SelectionConfig { lexicase_survivors, ..SelectionConfig::default() };
        let root = |scores: &&[f64]| Scored {
            mean: scores.iter().sum::<f64>() / scores.len() as f64,
            scores: scores.to_vec(),
            solved: scores.iter().map(|score| *score >= 10.0).collect(),
        };
        let roots: Vec<Scored> = scores.iter().map(root).collect();
        (0..50).map(|index| survivors(&roots, count, &config, &mut Stream::new(1, 0, Purpose::Test, index))).collect()
    }

    #[test]
    fn truncation_keeps_the_best_and_puts_nan_last() {
        assert_eq!(kept(&[&[1.0], &[f64::NAN], &[3.0], &[2.0]], 3, 0)[0], [2, 3, 0]);
    }

    #[test]
    fn lexicase_keeps_a_specialist_that_truncation_loses() {
        // Nine generalists and one root that alone does well in episode 3, at a bad mean.
        let mut scores: Vec<&[f64]> = vec![&[5.0, 5.0, 5.0, 0.0]; 9];
        scores.push(&[0.0, 0.0, 0.0, 9.0]);
        let specialist = |lexicase| kept(&scores, 5, lexicase).iter().filter(|kept| kept.contains(&9)).count();
        assert_eq!(specialist(0), 0);
        // Each draw tries episode 3 first with a probability of one quarter.
        assert!(specialist(5) > 40);
    }

    #[test]
    fn lexicase_compares_only_roots_that_played_all_episodes_and_does_not_prefer_the_faster() {
        assert!(kept(&[&[9.0], &[5.0, 5.0]], 1, 1).iter().all(|kept| *kept == [1]));
        // The first root solves both episodes slowly, the second one of them fast.
        assert!(kept(&[&[10.0, 10.0], &[11.0, -1.0]], 1, 1).iter().all(|kept| *kept == [0]));
    }
}
