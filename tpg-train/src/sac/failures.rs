//! Places where the actor under training fails: training episodes begin there again.
//!
//! Failures are rare, so random episodes hardly ever contain them. Most are cycles, which the noise of training breaks but
//! the actor without noise does not, so the critics hardly learn about them. Now and then the actor tries
//! fresh tasks, as it decides outside of training, and three places of each failed episode are remembered: its start, its
//! middle and the last place but one (in a cycle: within it; before an invalid action: just before).

use super::config::Retry;
use super::policy::NetworkPolicy;
use tpg_engine::Environment;
use tpg_engine::random::{Purpose, Stream};

/// Lets a policy try fresh tasks, and adds to the tasks that begin where it failed, the latest last. `at` tells one search of a run
/// from another.
pub(crate) fn look<E: Environment<f32>>(
    places: &mut Vec<E::Task>,
    policy: &NetworkPolicy<'_>,
    environment: &E,
    retry: &Retry,
    seed: u64,
    at: u64,
) {
    let stream = &mut Stream::new(seed, at, Purpose::Retry, 0);
    let drawn = |stream: &mut Stream| (0..retry.episodes).map(|_| environment.draw(stream)).collect();
    let own = environment.training().and_then(|training| training.evaluation_tasks(stream, retry.episodes));
    let tasks = own.unwrap_or_else(|| drawn(stream));
    for task in &tasks {
        let mut visited = Vec::new();
        let ending = policy.watch(environment, task, |episode| visited.push(environment.task_from(episode)));
        if ending.success == Some(false) {
            remember(places, &visited);
        }
    }
    places.drain(..places.len().saturating_sub(retry.remembered));
}

fn remember<Task: Clone>(places: &mut Vec<Task>, visited: &[Option<Task>]) {
    let last = visited.len() - 1;
    let mut kept = vec![0, last / 2, last.saturating_sub(1)];
    kept.dedup();
    places.extend(kept.into_iter().filter_map(|place| visited[place].clone()));
}

#[cfg(test)]
mod tests {
    use super::remember;

    #[test]
    fn episodes_leave_their_start_middle_and_last_place_but_one() {
        let mut places = Vec::new();
        for (length, expected) in [(1, vec![0]), (2, vec![0]), (3, vec![0, 1]), (10, vec![0, 4, 8])] {
            places.clear();
            remember(&mut places, &(0..length).map(Some).collect::<Vec<_>>());
            assert_eq!(places, expected, "of {length}");
        }
        // Where no task can begin, none is remembered.
        places.clear();
        remember(&mut places, &[Some(0), None, None, Some(3)]);
        assert_eq!(places, [0]);
    }
}
