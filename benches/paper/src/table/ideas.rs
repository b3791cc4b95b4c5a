//! Effects of guards and final hand-overs, with the shipped graph and actor of a random start, on validation episodes.

use super::ProblemInputs;
use super::ours::{Ours, paper_setting};
use super::rows::Row;
use tpg_graph::error::InputError;
use tpg_problems::arm::targets::Start;
use tpg_train::{Acting, Hybrid, Setting, Span};

/// Seed of the episodes, used neither in training nor in choosing the shipped policies.
const SEED: u64 = 11;
const EPISODES: usize = 1000;

/// Measures a row for each idea.
///
/// # Errors
/// Files that are not policies.
pub fn measure(inputs: &ProblemInputs) -> Result<Vec<Row>, InputError> {
    let shipped = Hybrid::read(&inputs.shipped)?;
    let ours = Ours::validation(Start::Rs, EPISODES, SEED);
    let paper = paper_setting(Start::Rs);
    let guard = |setting: &Setting, guard: &str| Setting { guard: guard.to_owned(), ..setting.clone() };
    let no_hand_back = guard(&Setting { hand_back_after: Span::NEVER, ..paper.clone() }, "both");
    let settings = [
        ("the paper's setting".to_owned(), paper.clone()),
        ("the same with a guard for collisions too".to_owned(), guard(&paper, "collisions")),
        ("no hand-back, guard for collisions and the network".to_owned(), no_hand_back.clone()),
        ("the same, never because of the distance".to_owned(), Setting { separation: f64::INFINITY, ..no_hand_back }),
        (format!("shipped: {}", shipped.setting.sentence()), shipped.setting.clone()),
    ];
    let mut rows = vec![
        Row::new("the graph alone", &[ours.graph(&shipped.graph)?]),
        Row::new("the actor alone", &[ours.network(&shipped.network)?]),
    ];
    for (name, setting) in settings {
        let together = ours.play(Acting::Both(&shipped.graph, &shipped.network, &setting))?;
        rows.push(Row::of_hybrids(&name, &[together]));
    }
    Ok(rows)
}
