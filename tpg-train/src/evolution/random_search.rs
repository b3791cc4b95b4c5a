//! Augmented random search: small steps along random directions that turned out better than their opposites.
//!
//! The algorithm is V2-t of Mania, Guy and Recht (“Simple random search provides a competitive approach to reinforcement learning”,
//! 2018): one row of weights for each output or action, of inputs less their mean, divided by their standard deviation, both over
//! visited states. Steps shrink as the search goes on. Small steps find what a wide search for weights misses: a policy that hovers,
//! balances or walks a little, and gets better.

use serde::{Deserialize, Serialize};
use tpg_engine::random::Stream;

/// Length of a step along a direction whose samples differ by the scores' standard deviation.
const STEP: f64 = 0.03;

/// Minimum part of that length: it shrinks with the steps that are left.
const MIN_STEP: f64 = 0.1;

/// Standard deviation of a sample's distance from a weight, for [`INPUTS`] inputs.
const NOISE: f64 = 0.03;

/// Number of inputs for which [`NOISE`] is meant. Fewer are disturbed more: the distance of an output is the same for any number.
const INPUTS: f64 = 24.0;

/// Number of directions for each one that a step follows: the better half.
const DIRECTIONS_FOR_ONE: usize = 2;

/// Where the search is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RandomSearch {
    /// Weights of the normalised inputs, row after row.
    weights: Vec<f64>,
    /// Standard deviation of a sample's distance from a weight.
    noise: f64,
}

impl RandomSearch {
    /// Starts at 0.
    pub(super) fn new(rows: usize, inputs: usize) -> Self {
        Self { weights: vec![0.0; rows * inputs], noise: NOISE * (INPUTS / inputs as f64).sqrt() }
    }

    /// Returns the weights of the normalised inputs, row after row.
    pub(super) fn mean(&self) -> &[f64] {
        &self.weights
    }

    /// Draws pairs of opposite samples around the weights: `count` of them, or one more.
    pub(super) fn samples(&self, count: usize, stream: &mut Stream) -> Vec<Vec<f64>> {
        let pair = |_| {
            let steps: Vec<f64> = self.weights.iter().map(|_| self.noise * stream.normal()).collect();
            [1.0, -1.0].map(|side| self.weights.iter().zip(&steps).map(|(weight, step)| weight + side * step).collect())
        };
        (0..count.div_ceil(2)).flat_map(pair).collect()
    }

    /// Moves the weights towards the better sample of each of the best pairs, less far the smaller the part of the search that is
    /// `left`, from 1 to 0; scores without spread move nothing.
    pub(super) fn update(&mut self, samples: &[Vec<f64>], scores: &[f64], left: f64) {
        let mut pairs: Vec<_> = samples.chunks_exact(2).zip(scores.chunks_exact(2)).collect();
        pairs.sort_by(|(_, a), (_, b)| b[0].max(b[1]).total_cmp(&a[0].max(a[1])));
        pairs.truncate(pairs.len().div_ceil(DIRECTIONS_FOR_ONE));
        let count = pairs.len() as f64;
        let of_scores = |value: fn(f64, f64) -> f64, from: f64| {
            pairs.iter().flat_map(|(_, scores)| *scores).map(|&score| value(score, from)).sum::<f64>() / (2.0 * count)
        };
        let mean = of_scores(|score, _| score, 0.0);
        let deviation = of_scores(|score, mean| (score - mean) * (score - mean), mean).sqrt();
        if !(deviation.is_normal() && deviation.is_finite()) {
            return;
        }
        let step = STEP * left.max(MIN_STEP);
        for (sides, scores) in pairs {
            let length = step / (count * deviation) * (scores[0] - scores[1]);
            for (weight, (plus, minus)) in self.weights.iter_mut().zip(sides[0].iter().zip(&sides[1])) {
                *weight += length * 0.5 * (plus - minus) / self.noise;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{INPUTS, MIN_STEP, NOISE, RandomSearch, STEP};
    use tpg_engine::random::{Purpose, Stream};

    fn stream(number: u64) -> Stream {
        Stream::new(1, number, Purpose::Test, 0)
    }

    #[test]
    fn samples_are_opposite_pairs() {
        let mut search = RandomSearch::new(2, 3);
        search.weights = vec![1.0; 6];
        let samples = search.samples(5, &mut stream(0));
        assert_eq!(samples.len(), 6, "whole pairs");
        for pair in samples.chunks_exact(2) {
            for (plus, minus) in pair[0].iter().zip(&pair[1]) {
                assert!((plus + minus - 2.0).abs() < 1e-12 && plus != minus);
            }
        }
    }

    #[test]
    fn a_step_follows_the_better_half_of_the_pairs() {
        let mut search = RandomSearch::new(1, 2);
        let noise = search.noise;
        let samples = [[noise, 0.0], [-noise, 0.0], [0.0, noise], [0.0, -noise]].map(Vec::from);
        // The first pair has the best score, of mean 2 and deviation 1; the second does not count.
        search.update(&samples, &[3.0, 1.0, 2.0, -9.0], 1.0);
        assert_eq!(search.mean(), [2.0 * STEP, 0.0]);
        let before = search.clone();
        search.update(&samples, &[1.0; 4], 1.0);
        assert_eq!(search, before, "scores without a spread move nothing");
    }

    #[test]
    fn outputs_are_disturbed_alike_whatever_the_number_of_inputs() {
        let disturbed = |inputs: usize| {
            let mut search = RandomSearch::new(1, inputs);
            search.weights = vec![1.0; inputs];
            let samples = search.samples(2000, &mut stream(1));
            let distance = |sample: &Vec<f64>| sample.iter().map(|weight| weight - 1.0).sum::<f64>();
            (samples.iter().map(|sample| distance(sample).powi(2)).sum::<f64>() / samples.len() as f64).sqrt()
        };
        for inputs in [2, 8, 96] {
            assert!((disturbed(inputs) / (NOISE * INPUTS.sqrt()) - 1.0).abs() < 0.1, "{inputs}: {}", disturbed(inputs));
        }
    }

    #[test]
    fn steps_shrink_to_a_tenth() {
        for (left, length) in [(1.0, 1.0), (0.5, 0.5), (0.0, MIN_STEP)] {
            let mut search = RandomSearch::new(1, 2);
            let samples = [search.noise, -search.noise].map(|distance| vec![distance, 0.0]);
            search.update(&samples, &[3.0, 1.0], left);
            assert!((search.mean()[0] - 2.0 * STEP * length).abs() < 1e-12, "{left}: {:?}", search.mean());
        }
    }

    #[test]
    fn it_climbs_to_the_best_weights() {
        let best = [0.5, -0.3, 0.2];
        let score = |sample: &Vec<f64>| -sample.iter().zip(best).map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
        let mut search = RandomSearch::new(1, 3);
        for generation in 0..100 {
            let samples = search.samples(16, &mut stream(generation));
            let scores: Vec<f64> = samples.iter().map(score).collect();
            search.update(&samples, &scores, 1.0);
        }
        assert!(score(&search.weights) > -0.01, "{:?}", search.weights);
    }
}
