//! A whole episode of an environment with outputs.

use tpg_engine::{Act, Ending, Environment, SourceSet};

/// The length of an environment's flat state.
pub(crate) fn state_length(environment: &impl Environment<f32>) -> usize {
    environment.sources().iter().map(|source| source.length as usize).sum()
}

/// Plays one episode: `answer` writes the values for a flat state, `each` sees the episode at its start and after every
/// action.
pub(crate) fn play<E: Environment<f32>>(
    environment: &E,
    task: &E::Task,
    mut answer: impl FnMut(&[f32], &mut Vec<f32>),
    mut each: impl FnMut(&E::Episode),
) -> Ending {
    let mut episode = environment.start(task);
    let (mut state, mut values) = (vec![0.0; state_length(environment)], Vec::new());
    let (mut score, mut actions) = (0.0, 0);
    each(&episode);
    loop {
        environment.observe(&mut episode, SourceSet::ALL, &mut state);
        answer(&state, &mut values);
        let step = environment.step(&mut episode, Act::Values(&values));
        each(&episode);
        score += step.reward;
        actions += 1;
        let end = step.end.or_else(|| (actions >= environment.time_limit()).then(|| environment.timeout(&episode)));
        if let Some(end) = end {
            return Ending { outcome: end.outcome, success: end.success, score, measure: end.measure, actions };
        }
    }
}
