//! Effects of guards and final hand-overs, with the shipped graph and actor, on validation episodes.

use super::ProblemInputs;
use super::rows::Row;
use tpg_arm::WIDOWX;
use tpg_arm::hybrid::Guard;
use tpg_graph::error::InputError;
use tpg_problems::arm::targets::{Set, Start, tasks};
use tpg_train::hybrid::arm::setting::{Hybrid, Setting};
use tpg_train::hybrid::arm::trial;
use tpg_train::hybrid::span::Span;

/// Seed of the episodes, used neither in training nor in choosing the shipped policies.
const SEED: u64 = 11;
const EPISODES: usize = 1000;

/// Measures a row for each idea.
///
/// # Errors
/// Files that are not policies.
pub fn measure(start: Start, inputs: &ProblemInputs) -> Result<Vec<Row>, InputError> {
    let shipped = Hybrid::read(&inputs.shipped)?;
    let tasks = tasks(&WIDOWX, SEED, Set::Validation, start, EPISODES);
    let (file, graph) = &shipped.graph;
    let paper = if start == Start::Fs { Setting::PAPER_FS } else { Setting::PAPER_RS };
    let no_hand_back = Setting { hand_back_after: Span::NEVER, ..paper };
    let guard = |setting, guard| Setting { guard, ..setting };
    let never_far = Setting { separation_mm: f64::INFINITY, ..guard(no_hand_back, Guard::Both) };
    let settings = [
        ("the paper's setting".to_owned(), paper),
        ("the same with a guard for collisions too".to_owned(), guard(paper, Guard::Collisions)),
        ("no hand-back, guard for collisions and the network".to_owned(), guard(no_hand_back, Guard::Both)),
        ("the same, never because of the distance".to_owned(), never_far),
        (format!("shipped: {}", shipped.setting.sentence()), shipped.setting),
    ];
    let arm = WIDOWX.to_f32();
    let mut rows = vec![
        Row::of("the graph alone", &[trial::graph_alone(file, graph, &WIDOWX, start, &tasks)?]),
        Row::of("the actor alone", &[tpg_problems::arm::trial::run(&arm, &shipped.actor.policy(), start, &tasks)]),
    ];
    for (name, setting) in settings {
        rows.push(Row::of_hybrids(&name, &[trial::run(file, graph, &shipped.actor, &setting, start, &tasks)?]));
    }
    Ok(rows)
}
