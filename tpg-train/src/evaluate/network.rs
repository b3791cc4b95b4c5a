//! A network on any built-in problem with outputs.

use super::report::EvaluationReport;
use crate::sac::network::Network;
use std::time::Instant;
use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{Ending, Environment, Measure};
use tpg_graph::error::InputError;
use tpg_problems::{ContinuousProblem, Visitor};

/// The test episodes of a network.
pub struct Tested {
    /// The ending of each episode.
    pub endings: Vec<Ending>,
    /// The environment's outcomes.
    pub outcomes: &'static [&'static str],
    /// The quantity beside the score, where the problem has one.
    pub measure: Option<Measure>,
}

/// Runs a network on `episodes` test episodes of a problem, the same as a graph's; `file` is what an error names.
///
/// # Errors
/// If the network reads or answers something else than the problem has.
pub fn test(
    problem: &ContinuousProblem,
    file: &str,
    network: &Network,
    episodes: usize,
    seed: u64,
) -> Result<Tested, InputError> {
    problem.open(seed, Test { file, network, episodes, seed })
}

struct Test<'a> {
    file: &'a str,
    network: &'a Network,
    episodes: usize,
    seed: u64,
}

impl Visitor<f32> for Test<'_> {
    type Output = Result<Tested, InputError>;

    fn visit<E: Environment<f32>>(self, environment: E) -> Self::Output {
        let draw = |index| environment.draw(&mut Stream::new(self.seed, 0, Purpose::Evaluation, index));
        let tasks: Vec<_> = (0..self.episodes as u64).map(draw).collect();
        let endings = self.network.endings(self.file, &environment, &tasks)?;
        Ok(Tested { endings, outcomes: environment.outcomes(), measure: environment.measure() })
    }
}

/// Evaluates a network on a problem: see [`test()`].
///
/// # Errors
/// As [`test()`].
pub fn on_problem(
    problem: &ContinuousProblem,
    file: &str,
    network: &Network,
    episodes: usize,
    seed: u64,
) -> Result<EvaluationReport, InputError> {
    let began = Instant::now();
    let Tested { endings, outcomes, measure } = test(problem, file, network, episodes, seed)?;
    let seconds = began.elapsed().as_secs_f64();
    Ok(EvaluationReport::new(problem.name().name(), file, Some(seed), &endings, outcomes, measure, seconds))
}
