//! The units of literals: half the range of each input, estimated if the environment does not declare it.

use super::config::EvolutionConfig;
use super::generation::{Evolution, Goal};
use super::mutate_leaf::LeafMutator;
use super::mutate_program::ProgramMutator;
use super::mutate_team::random_population;
use super::refine::Refiner;
use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{Environment, EvaluationError, Evaluator};
use tpg_runtime::scalar::Scalar;

/// Number of random roots that explore an environment, and of episodes for each.
const EXPLORERS: usize = 16;
const EPISODES: usize = 2;

/// Returns half the range of each value of the flat state that programs can read. Ends that the environment does not
/// know are estimated from states visited by random roots.
///
/// # Errors
/// If the episodes cannot be run.
pub fn scales<S: Scalar, E: Environment<S>, V: Evaluator<E::Task>>(
    config: &EvolutionConfig,
    environment: &E,
    evaluator: &V,
    seed: u64,
) -> Result<Vec<f64>, EvaluationError> {
    let sources = environment.sources();
    let readable = environment.bid_bounds().unwrap_or(sources.len());
    let ranges: Vec<[f64; 2]> = sources[..readable].iter().flat_map(|source| source.ranges.clone()).collect();
    let states = if ranges.iter().flatten().all(|end| end.is_finite()) {
        Vec::new()
    } else {
        explore(config, environment, evaluator, seed, ranges.len())?
    };
    Ok(ranges.iter().enumerate().map(|(input, range)| unit(*range, &states, input)).collect())
}

/// Returns states visited by random roots.
fn explore<S: Scalar, E: Environment<S>, V: Evaluator<E::Task>>(
    config: &EvolutionConfig,
    environment: &E,
    evaluator: &V,
    seed: u64,
    inputs: usize,
) -> Result<Vec<Vec<f64>>, EvaluationError> {
    let evolution = Evolution::new(config, environment, evaluator, vec![1.0; inputs], Goal::default());
    let vocabulary = evolution.vocabulary();
    let mutator = ProgramMutator { vocabulary, parameters: &config.program, literals: &config.literals };
    let actions = environment.actions().count().unwrap_or(0);
    let few = super::config::TpgParameters { init_nb_roots: EXPLORERS.max(actions), ..config.tpg.clone() };
    let mut stream = Stream::new(seed, 0, Purpose::Scales, 0);
    let population = if vocabulary.outputs().is_empty() {
        random_population(&mutator, &few, actions as u16, &mut stream)
    } else {
        let refiner = Refiner { vocabulary, parameters: &config.refinement };
        let growing =
            LeafMutator { bids: mutator, leaves: mutator, refiner, parameters: &config.leaves, tpg: &config.tpg };
        growing.random_population(EXPLORERS, &mut stream)
    };
    let policies: Vec<_> = population.roots().into_iter().map(|root| population.policy(root, vocabulary)).collect();
    evolution.visited(&policies[..EXPLORERS.min(policies.len())], EPISODES)
}

/// Returns half of a range, using visited values for unknown ends; 1 if all values are equal.
fn unit([min, max]: [f64; 2], states: &[Vec<f64>], input: usize) -> f64 {
    let values = || states.iter().map(|state| state[input]).filter(|value| value.is_finite());
    let min = if min.is_finite() { min } else { values().fold(f64::INFINITY, f64::min) };
    let max = if max.is_finite() { max } else { values().fold(f64::NEG_INFINITY, f64::max) };
    let half = 0.5 * (max - min);
    if half.is_finite() && half > 0.0 { half } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::unit;

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
