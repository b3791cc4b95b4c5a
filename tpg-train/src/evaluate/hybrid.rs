//! A hybrid on any problem but the arm's.

use super::report::{Asks, EvaluationReport, HybridFigures};
use crate::hybrid::command::check_detector;
use crate::hybrid::setting::Hybrid;
use crate::hybrid::shared::{Episodes, Facts, Shared};
use crate::hybrid::trial::{Acting, HybridTrial, TRIGGERS};
use crate::run_args::command_line;
use std::time::Instant;
use tpg_engine::random::Purpose;
use tpg_graph::error::InputError;

/// Runs a hybrid on `count` drawn test episodes of a problem, the same as a graph's or a network's.
///
/// # Errors
/// If the hybrid is for another problem, or its policies or its setting do not fit the problem.
pub fn test(problem: &dyn Shared, hybrid: &Hybrid, count: usize, seed: u64) -> Result<HybridTrial, InputError> {
    let name = problem.name();
    if hybrid.problem != name {
        let found = format!("a hybrid for {} with --problem {name}", hybrid.problem);
        return Err(command_line(found, "the same problem twice"));
    }
    check_detector(hybrid.setting.detector, problem.facts().has_key, &name)?;
    let episodes = Episodes { purpose: Purpose::Evaluation, count, seed };
    let acting = Acting::Both(&hybrid.graph, &hybrid.network, &hybrid.setting);
    problem.trial(acting, episodes)
}

/// Evaluates a hybrid on a problem, such as
/// [an environment of your own](crate::hybrid::shared::OwnProblem); `file` is the policy's name in the report.
///
/// # Errors
/// As [`test()`].
pub fn on_problem(
    problem: &dyn Shared,
    file: &str,
    hybrid: &Hybrid,
    count: usize,
    seed: u64,
) -> Result<EvaluationReport, InputError> {
    let began = Instant::now();
    let done = test(problem, hybrid, count, seed)?;
    let seconds = began.elapsed().as_secs_f64();
    let Facts { outcomes, measure, .. } = problem.facts();
    let general = EvaluationReport::new(&problem.name(), file, Some(seed), &done.endings, outcomes, measure, seconds);
    let hand_overs = TRIGGERS.iter().zip(done.hand_overs).map(|((name, _), count)| ((*name).to_owned(), count));
    let figures = HybridFigures {
        tpg_action_ratio: done.tpg_action_ratio,
        network_actions: done.network_actions,
        hand_overs: hand_overs.collect(),
        hand_backs: done.hand_backs,
        asks: Asks::of(&hybrid.graph.1, &done),
    };
    Ok(EvaluationReport { hybrid: Some(figures), ..general })
}
