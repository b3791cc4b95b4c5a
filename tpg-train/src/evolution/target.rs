//! An early end for a run with a target: what reaches it in training plays the validation episodes for as long as it may.

use super::generation::Evolution;
use super::state::State;
use tpg_engine::{Environment, EpisodeResult, EvaluationError, PolicyGraph, Summary};
use tpg_runtime::scalar::Scalar;

/// Number of episodes after which a trial is judged first; then after twice as many, again and again.
const FIRST: usize = 4;

/// Returns the numbers of episodes after which a trial is judged; the last is `episodes`.
fn stages(episodes: usize) -> impl Iterator<Item = usize> {
    let doubled = std::iter::successors(Some(FIRST), |stage| Some(2 * stage));
    doubled.take_while(move |&stage| stage < episodes).chain([episodes])
}

impl<S: Scalar, E: Environment<S>> Evolution<'_, S, E> {
    /// Lets a policy play the validation episodes and enters it, if their mean reaches the run's target after each stage. `found`
    /// is what training has found of it: a trial is due where that reaches the target, and where no more steps have been
    /// spent on selection than on training.
    pub(super) fn try_for_target(
        &self,
        state: &mut State<E::Task>,
        found: f64,
        policy: Option<PolicyGraph>,
    ) -> Result<Option<Summary>, EvaluationError> {
        let Some(target) = self.goal.target.filter(|&target| found >= target) else { return Ok(None) };
        let Some(policy) = policy.filter(|_| 2 * state.selection_steps <= state.steps) else { return Ok(None) };
        let mut endings: Vec<EpisodeResult> = Vec::new();
        for stage in stages(self.selection_tasks.len()) {
            let tasks = &self.selection_tasks[endings.len()..stage];
            for answer in self.endings([&policy], tasks)? {
                state.count_selection(&answer);
                endings.extend(answer);
            }
            if Summary::new(&endings).score < target {
                return Ok(None);
            }
        }
        self.enter(state, policy, &endings).map(Some)
    }
}

#[cfg(test)]
mod tests {
    use super::stages;

    #[test]
    fn a_trial_doubles_its_episodes_up_to_all() {
        assert_eq!(stages(100).collect::<Vec<_>>(), [4, 8, 16, 32, 64, 100]);
        assert_eq!(stages(8).collect::<Vec<_>>(), [4, 8]);
        assert_eq!(stages(3).collect::<Vec<_>>(), [3]);
    }
}
