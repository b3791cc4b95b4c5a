//! Effects of guards and final hand-overs, with the shipped graph and actor of a random start, on validation episodes.

use super::ProblemInputs;
use super::rows::{Ours, Row};
use tpg_engine::TaskSet;
use tpg_graph::error::InputError;
use tpg_problems::arm::targets::Start;
use tpg_train::{Acting, Detector, Episodes, Hybrid, Setting, Span};

/// Seed of the episodes, used neither in training nor in choosing the shipped policies.
const SEED: u64 = 11;
const EPISODES: usize = 1000;

/// Measures a row for each idea.
///
/// # Errors
/// Files that are not policies.
pub fn measure(inputs: &ProblemInputs) -> Result<Vec<Row>, InputError> {
    let shipped = Hybrid::read(&inputs.shipped)?;
    let episodes = Episodes { set: TaskSet::Study, count: EPISODES, seed: SEED, file: None };
    let ours = Ours { start: Start::Rs, episodes };
    // Hand-back after 100 actions, hand-over when the hand strays by 10 mm, no guard.
    let detector = Detector::Visited;
    let paper = Setting { hand_back_after: Span(100), separation: 10.0, detector, ..Setting::only_asks() };
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
        ours.row("the graph alone", [Acting::Graph(&shipped.graph)])?,
        ours.row("the actor alone", [Acting::Network(&shipped.network)])?,
    ];
    for (name, setting) in &settings {
        rows.push(ours.row(name, [Acting::Both(&shipped.graph, &shipped.network, setting)])?);
    }
    Ok(rows)
}
