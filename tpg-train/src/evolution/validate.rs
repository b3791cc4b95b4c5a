//! Validation: the best roots race on the validation set, within a budget.
//!
//! Running means are noisy, so the root to keep is chosen on episodes that no root was trained on. The best few roots
//! by running mean start; after part of the episodes the better half continues (successive halving), and the last one
//! completes all of them. Validations take no more than a fixed share of a run's steps: one is done when the budget
//! allows for it and for the final one.

use super::generation::Evolution;
use super::stage::Candidate;
use super::state::{Best, State};
use std::cmp::Ordering;
use tpg_engine::{Environment, EpisodeResult, EvaluationError, Play, PolicyGraph, Summary};
use tpg_runtime::scalar::Scalar;

/// Number of episodes of the last validation if the budget is exhausted.
const MIN_EPISODES: usize = 20;
/// Number of roots that are compared: the best by running mean.
const ROOTS: usize = 8;
/// Number of thinned versions of the best policy for which a run's last validation has episodes left.
const THINNED: u64 = 2;
/// Number of episodes from which unknown ranges of inputs are estimated, and of states in each.
const EPISODES_FOR_RANGES: usize = 16;
const STATES_FOR_RANGES: u32 = 16;

/// Returns the total number of episodes of a race of `roots` whose winner completes `episodes`.
fn cost(roots: usize, episodes: usize) -> u64 {
    let mut left = roots;
    let mut total = 0;
    let mut done = 0;
    for stage in stages(roots, episodes) {
        total += (left * (stage - done)) as u64;
        done = stage;
        left = left.div_ceil(2);
    }
    total
}

/// Returns the numbers of episodes after which the field is halved; the last is `episodes`.
fn stages(roots: usize, episodes: usize) -> Vec<usize> {
    let halvings = roots.next_power_of_two().trailing_zeros();
    (0..=halvings).rev().map(|halving| (episodes >> halving).max(1)).collect()
}

/// Returns the number of episodes that validations may still take with their share of a run's steps, if these are as long as the best
/// candidate's.
fn episodes_left<Task>(state: &State<Task>, share: f64) -> u64 {
    let training = (state.steps - state.selection_steps) as f64;
    ((share / (1.0 - share) * training) as u64).saturating_sub(state.selection_steps) / state.episode_steps.max(1)
}

impl<S: Scalar, E: Environment<S>> Evolution<'_, S, E> {
    /// Validates if it is time to; returns the result of the winner, and updates the best root so far.
    pub(super) fn validate(&self, state: &mut State<E::Task>) -> Result<Option<Summary>, EvaluationError> {
        let mut roots = state.population.survivors(&self.context(state));
        roots.truncate(ROOTS);
        let best = roots.iter().map(|(_, root)| root.record.mean).fold(f64::NEG_INFINITY, f64::max);
        let Some(episodes) = self.episodes_to_spend(state, roots.len(), best) else { return Ok(None) };
        let (policy, endings) = self.race(state, roots, episodes)?;
        let result = self.enter(state, policy, &endings)?;
        if self.is_thinned(state) {
            self.thin(state, episodes)?;
        }
        Ok(Some(result))
    }

    /// True if this is the last validation of a run that prefers small policies.
    fn is_thinned(&self, state: &State<E::Task>) -> bool {
        self.config.selection.line_price > 0.0 && self.is_last(state)
    }

    /// Enters a policy with its endings on the validation set, the first tasks first; returns its result.
    pub(super) fn enter(
        &self,
        state: &mut State<E::Task>,
        policy: PolicyGraph,
        endings: &[EpisodeResult],
    ) -> Result<Summary, EvaluationError> {
        let (preference, result) = (self.environment.preference(), Summary::new(endings));
        let ranges = self.learned_ranges(&policy, endings)?;
        let winner = Best { generation: state.generation, result, ranges, policy };
        let is_better =
            |best: &Best| self.compare(state, (&best.result, &best.policy), (&result, &winner.policy)).is_gt();
        if state.best.as_ref().is_none_or(is_better) {
            state.best = Some(winner.clone());
        }
        winner.enter(&mut state.hall, preference);
        Ok(result)
    }

    /// Compares two results, in favour of the second, less the price of the policies' lines; of equal ones the smaller policy is
    /// greater.
    fn compare(
        &self,
        state: &State<E::Task>,
        old: (&Summary, &PolicyGraph),
        new: (&Summary, &PolicyGraph),
    ) -> Ordering {
        let price = self.line_price(state);
        let (old_lines, new_lines) = (old.1.lines(), new.1.lines());
        let less = |result: &Summary, lines: usize| Summary { score: result.score - price * lines as f64, ..*result };
        let preference = self.environment.preference();
        (less(new.0, new_lines).compare(&less(old.0, old_lines), preference)).then(old_lines.cmp(&new_lines))
    }

    /// Returns the number of episodes for the winner of a race of so many roots now, of which the best has a running mean; `None` if
    /// it is not time for one.
    fn episodes_to_spend(&self, state: &State<E::Task>, roots: usize, best: f64) -> Option<usize> {
        let selection = &self.config.selection;
        let all = selection.validation_episodes;
        let cost = cost(roots, all) + if self.is_thinned(state) { THINNED * all as u64 } else { 0 };
        let left = episodes_left(state, selection.validation_share);
        if self.is_last(state) {
            let affordable = (all as u64 * left / cost.max(1)) as usize;
            // A race of so many roots costs a multiple of its episodes.
            let each = cost.div_ceil(all.max(1) as u64);
            let least = Self::affordable(self.steps_of_validation(), each * state.episode_steps, MIN_EPISODES.min(all));
            return Some(affordable.clamp(least, all));
        }
        let training = state.steps - state.selection_steps;
        let promising = self.goal.target.is_some_and(|target| best >= target)
            && training >= state.selection_steps + cost * state.episode_steps;
        (promising || left >= 2 * cost).then_some(all)
    }

    fn race(
        &self,
        state: &mut State<E::Task>,
        roots: Vec<(f64, Candidate)>,
        episodes: usize,
    ) -> Result<(PolicyGraph, Vec<EpisodeResult>), EvaluationError> {
        let mut field: Vec<(Candidate, Vec<EpisodeResult>)> =
            roots.into_iter().map(|(_, root)| (root, Vec::new())).collect();
        let mut done = 0;
        for stage in stages(field.len(), episodes) {
            let policies = field.iter().map(|(root, _)| &root.policy);
            let tasks = &self.selection_tasks[done..stage.max(done)];
            let answers = self.endings(policies, tasks)?;
            for ((_, endings), answer) in field.iter_mut().zip(answers) {
                state.count_selection(&answer);
                endings.extend(answer);
            }
            done = stage;
            // The sort is stable: among equal results of equal size, the root with the better running mean stays.
            field.sort_by(|(a, of_a), (b, of_b)| {
                self.compare(state, (&Summary::new(of_a), &a.policy), (&Summary::new(of_b), &b.policy))
            });
            if stage < episodes {
                field.truncate(field.len().div_ceil(2));
            }
        }
        let (winner, endings) = field.swap_remove(0);
        Ok((winner.policy, endings))
    }

    /// Returns the ranges of inputs if the environment does not know all of them: those visited by the policy in episodes
    /// that ended so, widened by a quarter.
    fn learned_ranges(
        &self,
        policy: &PolicyGraph,
        endings: &[EpisodeResult],
    ) -> Result<Option<Vec<[f64; 2]>>, EvaluationError> {
        let sources = self.environment.sources();
        let declared: Vec<[f64; 2]> = sources.into_iter().flat_map(|source| source.ranges).collect();
        if declared.iter().flatten().all(|end| end.is_finite()) {
            return Ok(None);
        }
        let played = self.selection_tasks.iter().zip(endings).take(EPISODES_FOR_RANGES);
        let plays: Vec<_> = played.map(|(task, ending)| along(policy, task, ending, STATES_FOR_RANGES)).collect();
        let states = self.states(&plays)?;
        Ok(Some((declared.into_iter().enumerate()).map(|(input, range)| widened(range, &states, input)).collect()))
    }

    /// Returns states along the episodes of policies, each policy on the first of the selection tasks.
    pub(super) fn visited(&self, policies: &[PolicyGraph], episodes: usize) -> Result<Vec<Vec<f64>>, EvaluationError> {
        let tasks = &self.selection_tasks[..episodes.min(self.selection_tasks.len())];
        let answers = self.endings(policies, tasks)?;
        let along = |(policy, endings): (&PolicyGraph, Vec<EpisodeResult>)| {
            let played = tasks.iter().zip(endings);
            played.map(|(task, ending)| along(policy, task, &ending, STATES_FOR_RANGES)).collect::<Vec<_>>()
        };
        self.states(&policies.iter().zip(answers).flat_map(along).collect::<Vec<_>>())
    }

    /// Returns the recorded states of episodes.
    pub(super) fn states(&self, plays: &[Play<E::Task>]) -> Result<Vec<Vec<f64>>, EvaluationError> {
        Ok(self.evaluator.play(plays)?.into_iter().flat_map(|played| played.states).collect())
    }
}

/// Returns an episode that ended so, to be played again with `states` evenly spaced states.
pub(super) fn along<Task: Clone>(policy: &PolicyGraph, task: &Task, ending: &EpisodeResult, states: u32) -> Play<Task> {
    let actions = u64::from(ending.actions);
    let after = (0..states).map(|state| (u64::from(state) * actions / u64::from(states)) as u32);
    Play { policy: policy.clone(), task: task.clone(), after: after.collect() }
}

/// Returns the lowest and the highest finite value of an input in some states; infinity and minus infinity without one.
pub(super) fn visited_range(states: &[Vec<f64>], input: usize) -> [f64; 2] {
    let values = || states.iter().map(|state| state[input]).filter(|value| value.is_finite());
    [values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max)]
}

/// Returns a declared range whose infinite ends are replaced by visited values, widened by a quarter; never empty.
fn widened(declared: [f64; 2], states: &[Vec<f64>], input: usize) -> [f64; 2] {
    let [low, high] = visited_range(states, input);
    let (low, high) = if low <= high { (low, high) } else { (-1.0, 1.0) };
    let margin = 0.25 * (high - low).max(1e-3);
    let [min, max] = declared;
    let min = if min.is_finite() { min } else { low - margin };
    let max = if max.is_finite() { max } else { high + margin };
    [min, max.max(min)]
}

#[cfg(test)]
mod tests {
    use super::{cost, episodes_left, stages, widened};
    use crate::evolution::state::State;
    use tpg_engine::EpisodeResult;

    #[test]
    fn a_race_halves_its_field_and_its_winner_does_all_episodes() {
        assert_eq!(stages(4, 1000), [250, 500, 1000]);
        assert_eq!(stages(5, 1000), [125, 250, 500, 1000]);
        assert_eq!(stages(1, 1000), [1000]);
        assert_eq!(cost(4, 1000), 4 * 250 + 2 * 250 + 500);
        assert_eq!(cost(1, 7), 7);
    }

    #[test]
    fn a_share_of_the_steps_is_fewer_episodes_where_they_have_grown_long() {
        let mut state = State::<u64>::new(1);
        let ending =
            |actions| EpisodeResult { outcome: 0, success: None, score: 0.0, final_reward: 0.0, measure: 0.0, actions };
        state.count_training(&[vec![ending(10); 900]], 0);
        state.count_training(&[vec![ending(500); 40], vec![ending(500), ending(499)], vec![ending(499); 58]], 1);
        assert_eq!((state.steps, state.episode_steps), (58_941, 500));
        // Half of the steps, which is as much as training.
        assert_eq!(episodes_left(&state, 0.5), 117);
        state.count_selection(&[ending(1000); 50]);
        assert_eq!((state.steps, state.selection_steps), (108_941, 50_000));
        assert_eq!(episodes_left(&state, 0.5), 17);
        assert_eq!(episodes_left(&state, 0.1), 0, "more than it may");
    }

    #[test]
    fn unknown_ends_are_learned_and_known_ones_stay() {
        let states = [vec![-1.0, 4.0], vec![3.0, f64::NAN]];
        assert_eq!(widened([-2.0, 2.0], &states, 0), [-2.0, 2.0]);
        assert_eq!(widened([f64::NEG_INFINITY, 9.0], &states, 0), [-2.0, 9.0]);
        let [low, high] = widened([f64::NEG_INFINITY, f64::INFINITY], &states, 1);
        assert!(low < 4.0 && high > 4.0);
        assert_eq!(widened([f64::NEG_INFINITY, f64::INFINITY], &[], 0), [-1.5, 1.5]);
    }
}
