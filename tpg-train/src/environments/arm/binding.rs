//! A graph's sources and actions as the arm's.

use tpg_arm::Move;
use tpg_arm::binding;
use tpg_arm::observation::Source;
use tpg_graph::error::{InputError, Place};
use tpg_graph::{Action, Graph};

/// The arm's sources that make up a graph's state, and the move of each of its actions.
///
/// # Errors
/// If the arm has no such source, or an action does not say what it moves.
pub fn bind(file: &str, graph: &Graph) -> Result<(Vec<Source>, Vec<Move>), InputError> {
    let error = |path: String, found: String, accepted: &str| {
        InputError::new(file, Place::Path(path), found, accepted.to_owned())
    };
    let source = |(place, declared): (usize, &tpg_graph::Source)| {
        let length = declared.ranges.len();
        binding::source(&declared.name, length).ok_or_else(|| {
            let found = format!("a source {:?} of {length} values", declared.name);
            error(format!("$.sources[{place}]"), found, &known_sources())
        })
    };
    let moved = |(place, action): (usize, &Action)| {
        let effect = action.effect.as_ref();
        effect.and_then(|effect| binding::moved(&effect.name, &effect.values)).ok_or_else(|| {
            let found = format!("the action {:?} without a move", action.name);
            error(format!("$.actions[{place}]"), found, "a move of the arm's four joints, in ticks")
        })
    };
    let sources = graph.sources().iter().enumerate().map(source).collect::<Result<_, _>>()?;
    Ok((sources, graph.actions().iter().enumerate().map(moved).collect::<Result<_, _>>()?))
}

fn known_sources() -> String {
    Source::ALL.map(|source| format!("{} ({} values)", source.name(), source.length())).join(", ")
}
