//! A network on any built-in problem with outputs.

use super::report::EvaluationReport;
use crate::sac::network::Network;
use std::time::Instant;
use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{Ending, Measure};
use tpg_graph::error::InputError;
use tpg_problems::ContinuousProblem;

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
    let environment = problem.environment(seed);
    let draw = |index| environment.draw(&mut Stream::new(seed, 0, Purpose::Evaluation, index));
    let tasks: Vec<_> = (0..episodes as u64).map(draw).collect();
    let endings = network.endings(file, &&*environment, &tasks)?;
    Ok(Tested { endings, outcomes: environment.outcomes(), measure: environment.measure() })
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
