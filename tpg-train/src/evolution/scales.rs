//! The units of literals: half the range of each input, estimated if the environment does not declare it.

use super::config::{EvolutionConfig, Units};
use super::generation::{Evolution, Goal};
use super::stage::{Moment, Stage as _};
use super::state::State;
use super::validate::visited_range;
use tpg_engine::{Environment, EvaluationError, Evaluator};
use tpg_runtime::scalar::Scalar;

/// Number of random roots that explore an environment, and of episodes for each.
const EXPLORERS: usize = 16;
const EPISODES: usize = 2;

/// The part of the visited values on either side that does not count for a usual range: random policies lose control now and
/// then, and what they see then is far from where good ones are.
const RARE: f64 = 0.1;

/// That part where nearly all values are equal: an input that is rarely on.
const VERY_RARE: f64 = 0.025;

/// Returns half the range of each value of the flat state that programs can read: the declared one, with ends that the
/// environment does not know estimated from states visited by random roots, or where these usually are.
///
/// # Errors
/// If the episodes cannot be run.
pub(super) fn scales<S: Scalar, E: Environment<S>>(
    config: &EvolutionConfig,
    environment: &E,
    evaluator: &dyn Evaluator<E::Task>,
    seed: u64,
) -> Result<Vec<f64>, EvaluationError> {
    let sources = environment.sources();
    let ranges: Vec<[f64; 2]> = sources.into_iter().flat_map(|source| source.ranges).collect();
    let units = config.literals.units;
    let states = if units == Units::Declared && ranges.iter().flatten().all(|end| end.is_finite()) {
        Vec::new()
    } else {
        explore(config, environment, evaluator, seed, ranges.len())?
    };
    let declared = |(input, range): (usize, &[f64; 2])| unit(*range, &states, input);
    let scale = |(input, range)| match units {
        Units::Declared => declared((input, range)),
        Units::Visited => visited_unit(&states, input).unwrap_or_else(|| declared((input, range))),
    };
    let scales = ranges.iter().enumerate().map(scale).collect();
    Ok(match units {
        Units::Declared => scales,
        Units::Visited => shrink_to_mean(scales),
    })
}

/// Moves units half of the way, in logarithms, to their mean. What random policies visit says little about what good ones need:
/// in units of it alone, an input that hardly moves there would begin with the largest weight.
fn shrink_to_mean(scales: Vec<f64>) -> Vec<f64> {
    let mean = scales.iter().map(|scale| libm::log(*scale)).sum::<f64>() / scales.len().max(1) as f64;
    scales.into_iter().map(|scale| libm::exp(0.5 * (libm::log(scale) + mean))).collect()
}

/// Returns half the range of most of the visited values of an input; `None` if they are equal.
fn visited_unit(states: &[Vec<f64>], input: usize) -> Option<f64> {
    let mut values: Vec<f64> = states.iter().map(|state| state[input]).filter(|value| value.is_finite()).collect();
    values.sort_by(f64::total_cmp);
    let half = |part: f64| {
        let tail = (part * values.len() as f64) as usize;
        let (low, high) = (values.get(tail)?, values.get(values.len() - 1 - tail)?);
        let half = 0.5 * (high - low);
        (half > 0.0).then_some(half)
    };
    half(RARE).or_else(|| half(VERY_RARE))
}

/// Returns states visited by random roots.
fn explore<S: Scalar, E: Environment<S>>(
    config: &EvolutionConfig,
    environment: &E,
    evaluator: &dyn Evaluator<E::Task>,
    seed: u64,
    inputs: usize,
) -> Result<Vec<Vec<f64>>, EvaluationError> {
    let mut few = config.clone();
    let actions = environment.actions().count().unwrap_or(0);
    (few.tpg.nb_roots, few.tpg.init_nb_roots) = (2, EXPLORERS.max(actions));
    let evolution = Evolution::new(&few, environment, evaluator, vec![1.0; inputs], Goal::default());
    let mut state = State::new(seed);
    let moment = Moment { seed, generation: 0 };
    let context = evolution.context(&state);
    let candidates = state.population.ask(&context, moment);
    let policies: Vec<_> = candidates.into_iter().map(|candidate| candidate.policy).collect();
    evolution.visited(&policies[..EXPLORERS.min(policies.len())], EPISODES)
}

/// Returns half of a range, using visited values for unknown ends; 1 if all values are equal.
fn unit([min, max]: [f64; 2], states: &[Vec<f64>], input: usize) -> f64 {
    let [low, high] = visited_range(states, input);
    let min = if min.is_finite() { min } else { low };
    let max = if max.is_finite() { max } else { high };
    let half = 0.5 * (max - min);
    if half.is_finite() && half > 0.0 { half } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::{shrink_to_mean, unit, visited_unit};

    #[test]
    fn units_move_half_of_the_way_to_their_mean() {
        let near = shrink_to_mean(vec![0.01, 1.0, 100.0]);
        for (found, expected) in near.iter().zip([0.1, 1.0, 10.0]) {
            assert!((found / expected - 1.0).abs() < 1e-12, "{near:?}");
        }
        assert_eq!(shrink_to_mean(Vec::new()), Vec::<f64>::new());
    }

    #[test]
    fn a_usual_unit_leaves_out_rare_values() {
        let mut states: Vec<Vec<f64>> = (0..=100).map(|value| vec![f64::from(value), 3.0]).collect();
        states[50][0] = 1e9;
        states[51][0] = f64::NAN;
        assert_eq!(visited_unit(&states, 0), Some(0.5 * (91.0 - 10.0)));
        assert_eq!(visited_unit(&states, 1), None, "always the same value");
        let switch: Vec<Vec<f64>> = (0..100).map(|at| vec![f64::from(u8::from(at < 5))]).collect();
        assert_eq!(visited_unit(&switch, 0), Some(0.5), "rarely on");
        assert_eq!(visited_unit(&[], 0), None);
    }

    #[test]
    fn a_unit_is_half_the_range_known_or_visited() {
        let unknown = [f64::NEG_INFINITY, f64::INFINITY];
        let states = [vec![-1.0, 5.0], vec![3.0, 5.0]];
        assert_eq!(unit([-4.0, 4.0], &states, 0), 4.0);
        assert_eq!(unit(unknown, &states, 0), 2.0);
        assert_eq!(unit([f64::NEG_INFINITY, 7.0], &states, 0), 4.0);
        assert_eq!(unit(unknown, &states, 1), 1.0, "always the same value");
        assert_eq!(unit(unknown, &[], 0), 1.0);
    }
}
