//! The Adam optimiser (Kingma and Ba 2015), as PyTorch computes it: β = (0.9, 0.999), ε = 1e-8.

use super::vectors::vectorised;
use serde::{Deserialize, Serialize};

const BETA: [f64; 2] = [0.9, 0.999];
const EPSILON: f32 = 1e-8;

/// Adam's state for one vector of parameters.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Adam {
    steps: u64,
    mean: Vec<f32>,
    square: Vec<f32>,
}

impl Adam {
    /// Creates the optimiser for `parameters` parameters, before its first step.
    pub fn new(parameters: usize) -> Self {
        Self { steps: 0, mean: vec![0.0; parameters], square: vec![0.0; parameters] }
    }

    /// Takes one step of gradient descent.
    ///
    /// # Panics
    /// If `parameters` or `gradient` differs in length from the optimiser's state.
    pub fn step(&mut self, parameters: &mut [f32], gradient: &[f32], rate: f64) {
        assert!(parameters.len() == self.mean.len() && gradient.len() == self.mean.len(), "another parameter vector");
        self.steps = self.steps.saturating_add(1);
        let steps = self.steps as f64;
        let [correction, square_correction] = BETA.map(|beta| 1.0 - libm::pow(beta, steps));
        let (rate, root) = ((rate / correction) as f32, (1.0 / square_correction.sqrt()) as f32);
        let [kept, kept_square] = BETA.map(|beta| beta as f32);
        let [new, new_square] = BETA.map(|beta| (1.0 - beta) as f32);
        let moments = self.mean.iter_mut().zip(&mut self.square);
        let all = parameters.iter_mut().zip(gradient).zip(moments);
        vectorised(
            #[inline(always)]
            || {
                for ((parameter, &slope), (mean, square)) in all {
                    *mean = kept * *mean + new * slope;
                    *square = kept_square * *square + new_square * slope * slope;
                    *parameter -= rate * *mean / (square.sqrt() * root + EPSILON);
                }
            },
        );
    }
}

#[cfg(test)]
mod tests {
    use super::Adam;

    #[test]
    fn the_first_step_is_the_rate_against_the_slope() {
        let mut adam = Adam::new(2);
        let mut parameters = [1.0, 1.0];
        adam.step(&mut parameters, &[3.0, -0.01], 0.1);
        assert!((parameters[0] - 0.9).abs() < 1e-6 && (parameters[1] - 1.1).abs() < 1e-6, "{parameters:?}");
    }

    #[test]
    fn it_finds_the_bottom_of_a_bowl() {
        let mut adam = Adam::new(2);
        let mut at = [5.0f32, -3.0];
        for _ in 0..2000 {
            let slope = [2.0 * (at[0] - 1.0), 20.0 * (at[1] - 2.0)];
            adam.step(&mut at, &slope, 0.02);
        }
        assert!((at[0] - 1.0).abs() < 1e-3 && (at[1] - 2.0).abs() < 1e-3, "{at:?}");
    }
}
