//! One generation of a run: the stage asks, its candidates play, the stage is told.

use super::budget::{Limits, Point};
use super::config::{EvolutionConfig, StartConfig};
use super::mirror::opposites;
use super::record::Row;
use super::search::Search;
use super::stage::{Candidate, Context, EpisodePlan, Moment, Results, Stage};
use super::state::{State, actions};
use super::vocabulary::Vocabulary;
use std::collections::VecDeque;
use std::marker::PhantomData;
use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{
    Environment, EpisodeResult, EvaluationError, Evaluator, Moments, Play, PolicyGraph, TaskSet, Work, finite,
};
use tpg_graph::error::Finding;
use tpg_runtime::scalar::Scalar;

/// Capacity of the pool of hard episodes.
const POOL: usize = 300;
/// Fraction of the candidates that play on after a race.
const RACING_SHARE: f64 = 0.4;
/// Fewest samples of a generation of random search, and most for few weights and for many; and for how many generations its episodes
/// should be enough, if they are as long as those of the first generation.
const SAMPLES: [usize; 3] = [8, 16, 24];
const STEPS: f64 = 75.0;
/// Generations of evolution for which a run must have steps left, with outputs and with named actions, which sums choose less well.
/// Otherwise the searches for weights take all of it.
const GENERATIONS: [f64; 2] = [10.0, 0.5];
/// The mean of samples that are better than luck, as a part of the way from the first generation's median score to its best.
const LUCK: f64 = 0.9;

/// A run on one problem, independent of where its candidates are evaluated.
pub(crate) struct Evolution<'e, S: Scalar, E: Environment<S>> {
    pub(super) config: &'e EvolutionConfig,
    vocabulary: Vocabulary,
    pub(super) environment: &'e E,
    pub(super) evaluator: &'e dyn Evaluator<E::Task>,
    pub(super) selection_tasks: Vec<E::Task>,
    pub(super) goal: Goal,
    actions: u16,
    opposites: Vec<Option<u16>>,
    number: PhantomData<S>,
}

/// Conditions under which a run ends before its last generation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Goal {
    /// Target for the mean score on the validation set.
    pub target: Option<f64>,
    /// Number of environment steps after which the run ends.
    pub max_steps: Option<u64>,
}

impl<'e, S: Scalar, E: Environment<S>> Evolution<'e, S, E> {
    /// Creates a run with the given configuration, [fitted](EvolutionConfig::fitted) to the environment; literals have the units of
    /// [`State::scales`].
    ///
    /// # Panics
    /// If the environment has neither outputs nor named actions, which [`EvolutionConfig::check_environment`] reports earlier.
    pub(crate) fn new(
        config: &'e EvolutionConfig,
        environment: &'e E,
        evaluator: &'e dyn Evaluator<E::Task>,
        scales: Vec<f64>,
        goal: Goal,
    ) -> Self {
        let vocabulary = config.vocabulary(environment, scales);
        let selection_tasks =
            tpg_engine::tasks(environment, TaskSet::Validation, 0, config.selection.validation_episodes);
        let actions = environment.actions().count().unwrap_or(0) as u16;
        let opposites = opposites(&environment.actions());
        let number = PhantomData;
        Self { config, vocabulary, environment, evaluator, selection_tasks, goal, actions, opposites, number }
    }

    /// Returns the vocabulary of programs.
    pub(crate) fn vocabulary(&self) -> &Vocabulary {
        &self.vocabulary
    }

    /// Returns what stages know.
    pub(crate) fn context(&self, state: &State<E::Task>) -> Context<'_> {
        let random = self.start(state).random;
        let begun = state.budget.part;
        let part = self.part(state).map_or(0.0, |part| (part - begun) / (random - begun));
        let first = state.rows.first().map_or(1.0, |row| row.steps as f64 / row.roots.max(1) as f64);
        let episodes = self.goal.max_steps.map(|most| random * most as f64 / first.max(1.0));
        let [fewest, few, many] = SAMPLES;
        let rows = if self.actions == 0 { self.vocabulary.outputs.len() } else { self.actions.into() };
        let most = (rows * self.vocabulary.inputs().len()).clamp(few, many);
        Context {
            config: self.config,
            vocabulary: &self.vocabulary,
            actions: self.actions,
            opposites: &self.opposites,
            max_lines: self.config.program.max_program_size,
            preference: self.environment.preference(),
            line_price: self.line_price(state),
            left: (1.0 - part).clamp(0.0, 1.0),
            samples: episodes.map_or(most, |all| (all / STEPS) as usize).clamp(fewest, most),
            time_limit: self.environment.time_limit(),
        }
    }

    /// Runs one generation.
    ///
    /// # Errors
    /// If candidates cannot be evaluated; the state is then unchanged except for newly bred children.
    pub(crate) fn advance(&self, state: &mut State<E::Task>) -> Result<(), EvaluationError> {
        let curriculum = &self.config.curriculum;
        let roughness = curriculum.at(state.generation);
        if state.generation > 0 && roughness != curriculum.at(state.generation - 1) {
            state.pool.clear();
            state.population.forget();
        }
        let is_search = self.config.start.share > 0.0 && state.budget.ended.is_none();
        let context = self.context(state);
        if is_search && (state.search.is_none() || state.budget.begun == state.generation) {
            let (searches, last) = (state.budget.searches, state.search.as_ref());
            let next = match state.stalled.take_if(|before| searches == 0 && before.resumes(last)) {
                Some(before) => before,
                None => Search::begin(&context, searches, last).map_err(EvaluationError::new)?,
            };
            if let Some(last) = state.search.replace(next) {
                state.stalled = Some(match state.stalled.take() {
                    Some(before) => before.better(last),
                    None => last,
                });
            }
        }
        if let Some(training) = self.environment.training().filter(|_| state.generation == 0 && !is_search) {
            state.population.begin_linear(&context, &training.linear()).map_err(EvaluationError::new)?;
        }
        let mut row = self.play(state, &context, is_search)?;
        let begins = is_search && {
            self.spend(state, &context).map_err(EvaluationError::new)?;
            state.budget.ended.is_some() || self.is_last(state)
        };
        if begins {
            let found = state.search.iter().chain(&state.stalled).collect();
            state.population.begin(&context, found).map_err(EvaluationError::new)?;
        }
        (row.teams, row.programs) = state.population.size();
        if is_search && !begins {
            let best = state.search.as_ref().and_then(|search| search.best(&context));
            row.validation = self.try_for_target(state, row.best_score, best)?;
        } else if roughness == 1 || self.is_last(state) {
            row.validation = self.validate(state)?;
        }
        if state.budget.ended.is_some() {
            (state.search, state.stalled) = (None, None);
        }
        if self.is_last(state) {
            state.ended_at = self.goal.max_steps;
        }
        row.steps = state.steps;
        state.rows.push(row);
        state.generation += 1;
        Ok(())
    }

    /// Lets the candidates of a stage play; returns the figures of the generation.
    fn play(&self, state: &mut State<E::Task>, context: &Context<'_>, is_search: bool) -> Result<Row, EvaluationError> {
        let moment = Moment { seed: state.seed, generation: state.generation };
        let survivors = self.config.survivors();
        let stage: &mut dyn Stage = match &mut state.search {
            Some(search) if is_search => search,
            _ => &mut state.population,
        };
        let candidates = stage.ask(context, moment);
        let episodes = self.config.learning.nb_iterations_per_policy_evaluation;
        let count = if stage.episodes() == EpisodePlan::Pairs { candidates.len().div_ceil(2) } else { episodes };
        let tasks = self.tasks(&state.pool, moment, count);
        let results = match stage.episodes() {
            EpisodePlan::Pairs => self.pairs_of_episodes(&candidates, &tasks)?,
            EpisodePlan::Same => self.same_episodes(&candidates, &tasks, None, state.episode_steps)?,
            EpisodePlan::Racing => self.same_episodes(&candidates, &tasks, Some(survivors), state.episode_steps)?,
        };
        let (row, best) = stage.tell(context, moment, &results);
        state.count_training(&results.endings, best);
        if self.config.pool.share > 0.0 {
            let endings = results.endings.get(best).map_or(&[][..], |endings| endings);
            state.remember_hard(&tasks, endings, POOL);
        }
        Ok(row)
    }

    /// Lets every two candidates play an episode of their own.
    fn pairs_of_episodes(&self, candidates: &[Candidate], tasks: &[E::Task]) -> Result<Results, EvaluationError> {
        let tasks = tasks.iter().flat_map(|task| [task; 2]);
        let plays: Vec<_> = (candidates.iter().zip(tasks))
            .map(|(candidate, task)| Play { policy: candidate.policy.clone(), task: task.clone(), after: Vec::new() })
            .collect();
        let values = tpg_engine::state_length(&self.environment.sources());
        let mut results = Results { seen: Moments::new(values), ..Results::default() };
        for played in self.evaluator.play(&plays)? {
            results.seen.merge(&played.seen);
            results.endings.push(vec![played.ending]);
        }
        Ok(results)
    }

    /// Lets the candidates play the same episodes, fewer where these take more than the run has to spend. In a race only the better
    /// ones by running mean play on after some of them, at least `survivors`. An episode is expected to take `episode_steps`; 0 if
    /// that is not known.
    fn same_episodes(
        &self,
        candidates: &[Candidate],
        tasks: &[E::Task],
        survivors: Option<usize>,
        episode_steps: u64,
    ) -> Result<Results, EvaluationError> {
        let mut endings: Vec<Vec<EpisodeResult>> = vec![Vec::new(); candidates.len()];
        let mut open: Vec<usize> = (0..candidates.len()).collect();
        let racing = survivors.map_or(0, |_| self.config.selection.racing_episodes);
        let evaluate = |endings: &mut Vec<Vec<EpisodeResult>>, open: &[usize], tasks: &[E::Task]| {
            let policies = open.iter().map(|&place| &candidates[place].policy);
            for (&place, answer) in open.iter().zip(self.endings(policies, tasks)?) {
                endings[place].extend(answer);
            }
            Ok::<_, EvaluationError>(())
        };
        let (mut tasks, mut done) = (tasks, 0);
        let expected = episode_steps.saturating_mul((candidates.len() * tasks.len()) as u64);
        if self.most_steps().is_some_and(|most| expected == 0 || expected > most / 4) && tasks.len() > 1 {
            evaluate(&mut endings, &open, &tasks[..1])?;
            done = 1;
            tasks = &tasks[..Self::affordable(self.most_steps(), actions(endings.iter().flatten()), tasks.len())];
        }
        let racing = racing.min(tasks.len());
        if racing > 0 && !open.is_empty() {
            if done < racing {
                evaluate(&mut endings, &open, &tasks[done..racing])?;
                done = racing;
            }
            let mean = |place: usize| {
                let mut record = candidates[place].record;
                record.add(endings[place].iter().map(|ending| finite(ending.score)));
                record.mean
            };
            let mut means: Vec<f64> = open.iter().map(|&place| mean(place)).collect();
            means.sort_by(|a, b| b.total_cmp(a));
            let share = (RACING_SHARE * means.len() as f64).ceil() as usize;
            let limit = means[share.max(survivors.unwrap_or(0)).min(means.len()) - 1];
            open.retain(|&place| mean(place) >= limit);
        }
        if done < tasks.len() {
            evaluate(&mut endings, &open, &tasks[done..])?;
        }
        Ok(Results { endings, ..Results::default() })
    }

    /// Lets policies play tasks: the endings of each.
    pub(super) fn endings<'p>(
        &self,
        policies: impl IntoIterator<Item = &'p PolicyGraph>,
        tasks: &[E::Task],
    ) -> Result<Vec<Vec<EpisodeResult>>, EvaluationError> {
        let policies = policies.into_iter().cloned().collect();
        self.evaluator.evaluate(&Work { tasks: tasks.to_vec(), policies })
    }

    /// Returns the maximum number of steps of a generation's training, unless one episode of each policy takes more: half of the run's.
    fn most_steps(&self) -> Option<u64> {
        self.goal.max_steps.map(|most| most / 2)
    }

    /// Returns how many of `count` rounds, each of so many steps, `most` steps are enough for; at least one.
    pub(super) fn affordable(most: Option<u64>, steps: u64, count: usize) -> usize {
        let rounds = most.map_or(u64::MAX, |most| most / steps.max(1));
        rounds.clamp(1, count.max(1) as u64) as usize
    }

    /// Returns the number of steps that validations may take, of which the last one has what others have left.
    pub(super) fn steps_of_validation(&self) -> Option<u64> {
        self.goal.max_steps.map(|most| (self.config.selection.validation_share * most as f64) as u64)
    }

    /// Returns the part of the run's training steps that is over.
    fn trained(&self, state: &State<E::Task>) -> Option<f64> {
        let most = self.goal.max_steps.zip(self.steps_of_validation()).map(|(all, validation)| all - validation);
        most.map(|most| (state.steps - state.selection_steps) as f64 / most.max(1) as f64)
    }

    /// Returns the tasks of a generation.
    fn tasks(&self, pool: &VecDeque<E::Task>, moment: Moment, count: usize) -> Vec<E::Task> {
        let mut choice = moment.stream(Purpose::Pool, 0);
        let roughness = self.config.curriculum.at(moment.generation);
        (0..count as u64)
            .map(|index| {
                if choice.chance(self.config.pool.share) && !pool.is_empty() {
                    pool[choice.below(pool.len())].clone()
                } else {
                    let mut stream = Stream::new(moment.seed, moment.generation, Purpose::Episode, index);
                    tpg_engine::coarser(self.environment, self.environment.draw(&mut stream), roughness)
                }
            })
            .collect()
    }

    /// Spends a generation of the search's budget.
    fn spend(&self, state: &mut State<E::Task>, context: &Context<'_>) -> Result<(), Finding> {
        let Some(search) = &state.search else { return Ok(()) };
        let start = self.start(state);
        let luck = state
            .rows
            .first()
            .map_or(f64::NEG_INFINITY, |first| first.median_score + LUCK * (first.best_score - first.median_score));
        let limits = Limits {
            length: search.length(context)?,
            part: if search.is_local() { start.random } else { start.share },
            luck: search.is_local().then_some(luck),
            restart: search.should_restart(),
            waits: state.stalled.is_some(),
        };
        let (generation, score) = (state.generation + 1, search.score().unwrap_or(f64::NEG_INFINITY));
        state.budget.spend(Point { generation, part: self.part(state), score }, limits);
        Ok(())
    }

    /// Returns the parts of the run for searches: the whole run where the rest is too short for evolution, with episodes as long as the
    /// best sample's, or the limit where standing still lasts that long.
    fn start(&self, state: &State<E::Task>) -> StartConfig {
        let start = self.config.start.clone();
        let episodes = self.config.tpg.nb_roots as f64;
        let steps = match &state.search {
            Some(search) if search.discourages_standing() => self.environment.time_limit().into(),
            _ => state.episode_steps,
        };
        let evolution = GENERATIONS[usize::from(self.actions > 0)] * episodes * steps as f64;
        let is_short = self.goal.max_steps.is_some_and(|most| (1.0 - start.share) * (most as f64) < evolution);
        match is_short && start.share > 0.0 {
            true => StartConfig { random: if start.random > 0.0 { 1.0 } else { 0.0 }, share: 1.0 },
            false => start,
        }
    }

    /// Returns the part of the run that is over after the current generation; none in a run without a limit.
    fn part(&self, state: &State<E::Task>) -> Option<f64> {
        let most = self.config.learning.nb_generations;
        let generations = (most > 0).then(|| (state.generation + 1) as f64 / most as f64);
        [self.trained(state), generations].into_iter().flatten().reduce(f64::max)
    }

    /// True if the current generation is the run's last one.
    pub(super) fn is_last(&self, state: &State<E::Task>) -> bool {
        self.is_spent(state, state.generation + 1)
    }

    /// True if the run is over after its most recent generation.
    pub(crate) fn finished(&self, state: &State<E::Task>) -> bool {
        let reached =
            state.best.as_ref().zip(self.goal.target).is_some_and(|(best, target)| best.result.score >= target);
        let ended = |most: u64| state.steps >= most || state.ended_at == Some(most);
        reached || self.goal.max_steps.is_some_and(ended) || self.has_generations(state.generation)
    }

    /// True if the run has no steps left but for its last validation, or no generations.
    fn is_spent(&self, state: &State<E::Task>, generations: u64) -> bool {
        let left = self.steps_of_validation().map_or(0, |all| all.saturating_sub(state.selection_steps));
        self.goal.max_steps.is_some_and(|most| state.steps + left >= most) || self.has_generations(generations)
    }

    fn has_generations(&self, generations: u64) -> bool {
        let most = self.config.learning.nb_generations;
        most > 0 && generations >= most
    }

    /// Returns the price of a line, in the unit of the score.
    pub(super) fn line_price(&self, state: &State<E::Task>) -> f64 {
        match (state.rows.first(), state.rows.last()) {
            (Some(first), Some(newest)) => {
                self.config.selection.line_price * (newest.best_score - first.median_score).max(0.0)
            }
            _ => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Evolution, Goal};
    use crate::evolution::config::{EvolutionConfig, StartConfig};
    use crate::evolution::state::State;
    use tpg_engine::{Choices, LocalThreads};
    use tpg_problems::Pendulum;
    use tpg_runtime::ops::Own;

    #[test]
    fn searches_have_a_run_whose_rest_is_too_short_for_evolution() {
        let environment: Choices<f32, Pendulum> = Choices::new(Pendulum, None).expect("a torque");
        let named: Choices<f32, Pendulum> = Choices::new(Pendulum, Some(2)).expect("two torques");
        let mut config = EvolutionConfig::default();
        config.tpg.nb_roots = 30;
        let evaluator = LocalThreads::<f32, Own, _>::new(&environment, 1).expect("a thread");
        let mut state = State::new(1);
        state.episode_steps = 200;
        // A quarter of so many steps is enough for ten generations.
        let enough = 4 * 10 * 10 * 3 * 200;
        let start = |random, share| StartConfig { random, share };
        for (asked, max_steps, expected) in [
            (start(0.5, 0.75), Some(enough), start(0.5, 0.75)),
            (start(0.375, 0.75), Some(enough - 4), start(1.0, 1.0)),
            (start(0.0, 0.75), Some(1), start(0.0, 1.0)),
            (start(0.0, 0.0), Some(1), start(0.0, 0.0)),
            (start(0.5, 0.75), None, start(0.5, 0.75)),
        ] {
            config.start = asked;
            let goal = Goal { max_steps, target: None };
            let evolution = Evolution::new(&config, &environment, &evaluator, vec![1.0; 3], goal);
            assert_eq!(evolution.start(&state), expected, "{max_steps:?}");
        }
        // Where actions are named, half a generation is enough.
        let evaluator = LocalThreads::<f32, Own, _>::new(&named, 1).expect("a thread");
        config.start = start(0.5, 0.75);
        for (max_steps, expected) in [(enough / 20, start(0.5, 0.75)), (enough / 20 - 4, start(1.0, 1.0))] {
            let goal = Goal { max_steps: Some(max_steps), target: None };
            let evolution = Evolution::new(&config, &named, &evaluator, vec![1.0; 3], goal);
            assert_eq!(evolution.start(&state), expected, "named actions, {max_steps}");
        }
    }
}
