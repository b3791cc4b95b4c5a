//! Actions that move motors, by the naming convention of `graph.json`.

use tpg_graph::{ActionDocument, Effect, Graph};

/// The effect "move" of each action, in motor ticks; `None` where there are no actions, or one has no such effect, or one that is not a whole
/// number of ticks from −128 to 127.
pub(super) fn moves(graph: &Graph) -> Option<Vec<Vec<i8>>> {
    let ticks = |value: &f64| Some(*value as i8).filter(|&ticks| f64::from(ticks) == *value);
    let moves = |action: &ActionDocument| {
        let effect = action.effect.as_ref().filter(|effect| effect.name == Effect::MOVE)?;
        effect.values.iter().map(ticks).collect()
    };
    let has_actions = !graph.actions().is_empty();
    graph.actions().iter().map(moves).collect::<Option<_>>().filter(|_| has_actions)
}
