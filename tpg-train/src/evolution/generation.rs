//! One generation: populate, evaluate, select, record.

use super::archive::{Recording, bid};
use super::config::{EvolutionConfig, ParentChoice, RacingBy};
use super::genome::{Destination, ProgramId, TeamId};
use super::linear::LinearWriter;
use super::mirror::{Mirror, opposites};
use super::mutate_leaf::LeafMutator;
use super::mutate_program::ProgramMutator;
use super::mutate_team::{Moment, Parents, TeamMutator, random_population};
use super::refine::Refiner;
use super::select::{Candidate, ranked, survivors};
use super::state::{Deme, Record, Row, State};
use super::vocabulary::Vocabulary;
use std::collections::BTreeSet;
use std::marker::PhantomData;
use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{
    Ending, Environment, EvaluationError, Evaluator, PolicyGraph, Preference, Summary, TaskSet, UnitKey, Visit, Work,
    WorkUnit, bounded, finite,
};
use tpg_runtime::scalar::Scalar;

/// Evolution on one problem, independent of where its roots are evaluated.
#[derive(Debug)]
pub struct Evolution<'e, S: Scalar, E: Environment<S>, V> {
    pub(super) config: &'e EvolutionConfig,
    pub(super) vocabulary: Vocabulary,
    pub(super) environment: &'e E,
    pub(super) evaluator: &'e V,
    pub(super) selection_tasks: Vec<E::Task>,
    pub(super) goal: Goal,
    pub(super) actions: u16,
    /// The action that undoes each one, if there is one.
    opposites: Vec<Option<u16>>,
    /// Usual number of generations of the linear start.
    pub(super) linear: u64,
    number: PhantomData<S>,
}

/// Conditions under which a run ends before its last generation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Goal {
    /// Target for the mean score on the selection set.
    pub target: Option<f64>,
    /// Number of environment steps after which the run ends.
    pub max_steps: Option<u64>,
}

/// Returns the number of a root in its run, made of deme and team.
pub(super) fn root_number(deme: usize, team: TeamId) -> u64 {
    (deme as u64) << 40 | team.0
}

/// A root's evaluation in this generation.
struct Evaluated {
    deme: usize,
    team: TeamId,
    policy: PolicyGraph,
    /// Its lines; 0 where they have no price.
    lines: usize,
    endings: Vec<Ending>,
    dropped: bool,
}

/// The figures of an evaluation by which roots are selected.
struct Judged {
    scores: Vec<f64>,
    solved: Vec<bool>,
}

impl Judged {
    fn new(endings: &[Ending], preference: Preference) -> Self {
        let scores = endings.iter().map(|ending| finite(ending.score)).collect();
        let solved = match preference {
            Preference::Score => Vec::new(),
            Preference::Success => endings.iter().map(|ending| ending.success == Some(true)).collect(),
        };
        Self { scores, solved }
    }
}

impl<'e, S: Scalar, E: Environment<S>, V: Evaluator<E::Task>> Evolution<'e, S, E, V> {
    /// Creates the evolution with the given configuration; literals have the units of [`State::scales`].
    ///
    /// # Panics
    /// If the environment has neither outputs nor named actions, which [`EvolutionConfig::check_actions`] reports earlier.
    pub fn new(
        config: &'e EvolutionConfig,
        environment: &'e E,
        evaluator: &'e V,
        scales: Vec<f64>,
        goal: Goal,
    ) -> Self {
        let vocabulary = config.vocabulary(environment, scales);
        let selection_tasks =
            tpg_engine::tasks(environment, TaskSet::Validation, 0, config.selection.validation_episodes);
        let actions = environment.actions().count().unwrap_or(0) as u16;
        let opposites = opposites(&environment.actions());
        let weights = LinearWriter::new(&vocabulary, actions, config.start.kind).map_or(0, |writer| writer.weights());
        let linear = config.linear_generations(weights);
        let number = PhantomData;
        Self { config, vocabulary, environment, evaluator, selection_tasks, goal, actions, opposites, linear, number }
    }

    /// Returns the vocabulary of programs.
    pub fn vocabulary(&self) -> &Vocabulary {
        &self.vocabulary
    }

    /// Runs one generation.
    ///
    /// # Errors
    /// If roots cannot be evaluated; the state is then unchanged except for newly bred children.
    pub fn advance(&self, state: &mut State<E::Task>) -> Result<(), EvaluationError> {
        if self.is_linear(state) {
            return self.advance_linear(state);
        }
        let curriculum = &self.config.curriculum;
        let roughness = curriculum.at(state.generation);
        if state.generation > 0 && roughness != curriculum.at(state.generation - 1) {
            // Scores of coarser episodes are not comparable with these.
            state.pool.clear();
            state.demes.iter_mut().for_each(|deme| deme.records.clear());
        }
        self.breed(state);
        let tasks = self.tasks(state, self.config.learning.nb_iterations_per_policy_evaluation);
        let evaluated = self.evaluate(state, &tasks)?;
        let preference = self.environment.preference();
        let scores: Vec<Judged> = evaluated.iter().map(|root| Judged::new(&root.endings, preference)).collect();
        for (root, scores) in evaluated.iter().zip(&scores) {
            if !scores.scores.is_empty() {
                state.demes[root.deme].records.entry(root.team).or_default().add(&scores.scores);
            }
        }
        let mut row = self.row(state, &evaluated, &scores);
        state.count_training(evaluated.iter().flat_map(|root| &root.endings));
        self.remember_hard_tasks(state, &tasks, &evaluated, &scores);
        self.record(state, &tasks, &evaluated)?;
        self.select(state, &evaluated, &scores);
        self.migrate(state);
        self.end_worse_demes(state);
        row.teams = state.demes.iter().map(|deme| deme.genome.teams().len()).sum();
        row.programs = state.demes.iter().map(|deme| deme.genome.program_count()).sum();
        if roughness == 1 || self.is_last(state) {
            row.validation = self.validate(state)?;
        }
        state.rows.push(row);
        state.generation += 1;
        Ok(())
    }

    /// True if the current generation is the run's last one.
    pub(super) fn is_last(&self, state: &State<E::Task>) -> bool {
        let steps_done = self.goal.max_steps.is_some_and(|most| state.steps >= most);
        steps_done || state.generation + 1 >= self.config.learning.nb_generations
    }

    /// True if the run is over after its most recent generation.
    pub fn finished(&self, state: &State<E::Task>) -> bool {
        let reached =
            state.best.as_ref().zip(self.goal.target).is_some_and(|(best, target)| best.result.score >= target);
        let steps_done = self.goal.max_steps.is_some_and(|most| state.steps >= most);
        reached || steps_done || self.is_flat(state) || state.generation >= self.config.learning.nb_generations
    }

    /// True if the newest validations have brought no better root.
    fn is_flat(&self, state: &State<E::Task>) -> bool {
        let most = self.config.selection.flat_after;
        let Some(best) = state.best.as_ref().filter(|_| most > 0) else { return false };
        // A smaller root that is as good within doubt may be older than the best result.
        let newest = state.hall.iter().map(|it| it.generation).fold(best.generation, u64::max);
        let newest = if self.config.selection.choice_errors > 0.0 { newest } else { best.generation };
        let since = state.rows.iter().rev().take_while(|row| row.generation > newest);
        since.filter(|row| row.validation.is_some()).count() >= most
    }

    fn breed(&self, state: &mut State<E::Task>) {
        let mutator = ProgramMutator {
            vocabulary: &self.vocabulary,
            parameters: &self.config.program,
            literals: &self.config.literals,
        };
        let longer = LeafMutator::longer(&self.config.program, &self.config.leaves);
        let leaves = ProgramMutator { parameters: &longer, ..mutator };
        let refiner = Refiner { vocabulary: &self.vocabulary, parameters: &self.config.refinement };
        let growing =
            LeafMutator { bids: mutator, leaves, refiner, parameters: &self.config.leaves, tpg: &self.config.tpg };
        let (parameters, archive, actions) = (&self.config.tpg, &state.archive, self.actions);
        let probability = self.config.refinement.p_mirror;
        let mirror = Mirror { programs: mutator, opposites: &self.opposites, probability };
        let teams = TeamMutator { programs: mutator, refiner, mirror, parameters, archive, actions };
        let price = self.line_price(state);
        for (index, deme) in (0..).zip(&mut state.demes) {
            let moment = Moment { seed: state.seed, generation: state.generation, deme: index };
            self.refine_elite(deme, &refiner, moment);
            if !self.vocabulary.outputs().is_empty() {
                if deme.genome.teams().is_empty() {
                    let mut stream = moment.stream(Purpose::Initial, 0);
                    deme.genome = growing.random_population(self.config.tpg.init_nb_roots, &mut stream);
                }
                let parents = self.parents(deme, price);
                growing.populate(&mut deme.genome, &parents, moment);
                continue;
            }
            if deme.genome.teams().is_empty() {
                let mut stream = moment.stream(Purpose::Initial, 0);
                deme.genome = random_population(&mutator, &self.config.tpg, self.actions, &mut stream);
                mirror.complete_roots(&mut deme.genome, self.config.tpg.max_outgoing_edges);
            }
            let parents = self.parents(deme, price);
            teams.populate(&mut deme.genome, &parents, moment);
        }
    }

    /// Returns the parents of a deme's next children.
    fn parents(&self, deme: &Deme, price: f64) -> Parents {
        let choice = self.config.selection.parents;
        let mut roots = deme.genome.roots();
        if choice == ParentChoice::Better {
            let worth = |team: &TeamId| {
                let mean = deme.records.get(team).map_or(f64::NEG_INFINITY, |record| record.mean);
                mean - price * deme.genome.policy(*team, &self.vocabulary).lines() as f64
            };
            let mut worths: Vec<(f64, TeamId)> = roots.iter().map(|team| (worth(team), *team)).collect();
            worths.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
            roots = worths.into_iter().map(|(_, team)| team).collect();
        }
        Parents { roots, choice }
    }

    /// Adds children of a deme's best root that only have other constants.
    fn refine_elite(&self, deme: &mut Deme, refiner: &Refiner<'_>, moment: Moment) {
        let better = |a: &Record, b: &Record| a.mean.total_cmp(&b.mean);
        // The oldest of equals: `max_by` would return the last.
        let best = deme.records.iter().rev().max_by(|a, b| better(a.1, b.1)).map(|(&team, _)| team);
        let Some(best) = best else { return };
        for index in 0..self.config.refinement.elite as u64 {
            refiner.jittered(&mut deme.genome, best, &mut moment.stream(Purpose::Elite, index));
        }
    }

    /// Returns the tasks of a generation, the same for every root.
    pub(super) fn tasks(&self, state: &State<E::Task>, count: usize) -> Vec<E::Task> {
        let mut choice = Stream::new(state.seed, state.generation, Purpose::Pool, 0);
        let roughness = self.config.curriculum.at(state.generation);
        (0..count as u64)
            .map(|index| {
                if choice.chance(self.config.pool.share) && !state.pool.is_empty() {
                    state.pool[choice.below(state.pool.len())].clone()
                } else {
                    let mut stream = Stream::new(state.seed, state.generation, Purpose::Episode, index);
                    tpg_engine::coarser(self.environment, self.environment.draw(&mut stream), roughness)
                }
            })
            .collect()
    }

    /// Evaluates every root whose score is not final (`learningAgent.cpp`, `isRootEvalSkipped`).
    fn evaluate(&self, state: &State<E::Task>, tasks: &[E::Task]) -> Result<Vec<Evaluated>, EvaluationError> {
        let mut roots: Vec<Evaluated> = Vec::new();
        for (deme, population) in state.demes.iter().enumerate() {
            let teams = population.genome.roots();
            let policies = population.genome.policies(&teams, &self.vocabulary);
            for (team, policy) in teams.into_iter().zip(policies) {
                let lines = if self.config.selection.line_price > 0.0 { policy.lines() } else { 0 };
                roots.push(Evaluated { deme, team, policy, lines, endings: Vec::new(), dropped: false });
            }
        }
        let most = self.config.learning.max_nb_evaluation_per_policy;
        let open = |root: &Evaluated| {
            state.demes[root.deme].records.get(&root.team).is_none_or(|record| record.evaluations < most)
        };
        let mut open: Vec<usize> = (0..roots.len()).filter(|&place| open(&roots[place])).collect();
        let mut done = 0;
        if self.config.selection.racing_episodes > 0 && !open.is_empty() {
            done = self.config.selection.racing_episodes;
            self.evaluate_some(state, &tasks[..done], &mut roots, &open)?;
            let by_record = self.config.selection.racing_by == RacingBy::Record;
            let mean = |root: &Evaluated| {
                if by_record { running_mean(state, root) } else { Summary::of(&root.endings).score }
            };
            let mut means: Vec<f64> = open.iter().map(|&place| mean(&roots[place])).collect();
            means.sort_by(|a, b| b.total_cmp(a));
            let survivors = self.config.survivors() * state.demes.len();
            let share = (self.config.selection.racing_share * means.len() as f64).ceil() as usize;
            let least = means[share.max(survivors).clamp(1, means.len().max(1)) - 1];
            open.retain(|&place| {
                let goes_on = mean(&roots[place]) >= least;
                roots[place].dropped = !goes_on && !by_record;
                goes_on
            });
        }
        self.evaluate_some(state, &tasks[done..], &mut roots, &open)?;
        Ok(roots)
    }

    fn evaluate_some(
        &self,
        state: &State<E::Task>,
        tasks: &[E::Task],
        roots: &mut [Evaluated],
        places: &[usize],
    ) -> Result<(), EvaluationError> {
        let units = places.iter().map(|&place| {
            let Evaluated { deme, team, policy, .. } = &roots[place];
            let key = UnitKey { seed: state.seed, generation: state.generation, root: root_number(*deme, *team) };
            WorkUnit { key, policy: policy.clone() }
        });
        let work = Work { tasks: tasks.to_vec(), units: units.collect() };
        let answers = self.evaluator.evaluate(&work)?;
        for (&place, answer) in places.iter().zip(answers) {
            roots[place].endings.extend(answer.endings);
        }
        Ok(())
    }

    fn row(&self, state: &State<E::Task>, evaluated: &[Evaluated], scores: &[Judged]) -> Row {
        let candidates = self.candidates(state, evaluated, scores, None);
        let order = ranked(&candidates);
        let best = &evaluated[order[0]];
        let mean = |place: usize| record(state, &evaluated[place]).mean;
        let Summary { success, measure, .. } = Summary::of(&best.endings);
        Row {
            generation: state.generation,
            best_score: mean(order[0]),
            median_score: mean(order[order.len() / 2]),
            best_success: success,
            best_measure: measure,
            roots: evaluated.len(),
            teams: 0,
            programs: 0,
            validation: None,
        }
    }

    /// Adds the episodes of this generation that its best root failed to the pool; if the problem does not define
    /// success, those with a score below its mean.
    fn remember_hard_tasks(
        &self,
        state: &mut State<E::Task>,
        tasks: &[E::Task],
        evaluated: &[Evaluated],
        scores: &[Judged],
    ) {
        if self.config.pool.size == 0 {
            return;
        }
        let best = ranked(&self.candidates(state, evaluated, scores, None))[0];
        let mean = Summary::of(&evaluated[best].endings).score;
        for (task, ending) in tasks.iter().zip(&evaluated[best].endings) {
            let hard = ending.success.map_or(ending.score < mean, |success| !success);
            // With duplicates, the pool would fill up with the few episodes that no root can solve.
            if hard && !state.pool.contains(task) {
                state.pool.push_back(task.clone());
            }
        }
        while state.pool.len() > self.config.pool.size {
            state.pool.pop_front();
        }
    }

    fn select(&self, state: &mut State<E::Task>, evaluated: &[Evaluated], scores: &[Judged]) {
        for deme in 0..state.demes.len() {
            let of_deme: Vec<&Evaluated> = evaluated.iter().filter(|root| root.deme == deme).collect();
            let candidates = self.candidates(state, evaluated, scores, Some(deme));
            let count = self.config.survivors_of(candidates.len());
            let index = (deme as u64) << 40;
            let mut stream = Stream::new(state.seed, state.generation, Purpose::Lexicase, index);
            let kept: BTreeSet<TeamId> = survivors(&candidates, count, &self.config.selection, &mut stream)
                .into_iter()
                .map(|place| of_deme[place].team)
                .collect();
            let population = &mut state.demes[deme];
            let removed: Vec<TeamId> =
                of_deme.iter().map(|root| root.team).filter(|team| !kept.contains(team)).collect();
            population.genome.remove_roots(&removed);
            population.records.retain(|team, _| population.genome.teams().contains_key(team));
        }
    }

    /// Sends each deme's best survivors to the next deme, as they were before any of this generation's migrants
    /// arrived.
    fn migrate(&self, state: &mut State<E::Task>) {
        let demes = state.demes.len();
        let config = &self.config.demes;
        if demes < 2 || config.migrants == 0 || (state.generation + 1) % config.migration_interval != 0 {
            return;
        }
        let best = |deme: usize| {
            let population = &state.demes[deme];
            let mut roots: Vec<(TeamId, f64)> = (population.genome.roots().into_iter())
                .filter_map(|team| population.records.get(&team).map(|record| (team, record.mean)))
                .collect();
            roots.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
            roots.into_iter().take(config.migrants).map(|(team, _)| team).collect::<Vec<_>>()
        };
        let leaving: Vec<Vec<TeamId>> = (0..demes).map(best).collect();
        let before: Vec<_> = state.demes.iter().map(|deme| deme.genome.clone()).collect();
        for (from, roots) in leaving.into_iter().enumerate() {
            let to = &mut state.demes[(from + 1) % demes];
            for root in roots {
                to.genome.adopt(&before[from], root);
            }
        }
    }

    /// Ends the worse half of the demes, judged by their best root, where it is time for it: independent starts are many, but
    /// only the promising ones are paid for.
    fn end_worse_demes(&self, state: &mut State<E::Task>) {
        let linear = self.config.linear_end(self.linear, &state.milestones).unwrap_or(u64::MAX);
        let next = self.config.demes_at(state.generation + 1, linear);
        if next >= state.demes.len() {
            return;
        }
        let price = self.line_price(state);
        let worth = |deme: &Deme| {
            let worth = |(&team, record): (&TeamId, &Record)| {
                record.mean - price * deme.genome.policy(team, &self.vocabulary).lines() as f64
            };
            deme.records.iter().map(worth).fold(f64::NEG_INFINITY, f64::max)
        };
        let worths: Vec<f64> = state.demes.iter().map(worth).collect();
        let mut places: Vec<usize> = (0..worths.len()).collect();
        // The sort is stable: of equals, the first stays.
        places.sort_by(|&a, &b| worths[b].total_cmp(&worths[a]));
        let kept: BTreeSet<usize> = places.into_iter().take(next).collect();
        let mut place = 0..;
        state.demes.retain(|_| place.next().is_some_and(|place| kept.contains(&place)));
    }

    /// Draws recordings for the archive: a root, an episode, a state of it, and a program that bid in this state.
    fn record(
        &self,
        state: &mut State<E::Task>,
        tasks: &[E::Task],
        evaluated: &[Evaluated],
    ) -> Result<(), EvaluationError> {
        let evaluated: Vec<&Evaluated> = evaluated.iter().filter(|root| !root.endings.is_empty()).collect();
        let mut drawn: Vec<(&Evaluated, Stream)> = Vec::new();
        let mut visits = Vec::new();
        for index in 0..state.archive.size() as u64 {
            let mut stream = Stream::new(state.seed, state.generation, Purpose::Archive, index);
            if evaluated.is_empty() || !stream.chance(self.config.learning.archiving_probability.sqrt()) {
                continue;
            }
            let root = *stream.pick(&evaluated);
            let task = stream.below(root.endings.len());
            let after = vec![stream.below(root.endings[task].actions as usize) as u32];
            visits.push(Visit { policy: root.policy.clone(), task: tasks[task].clone(), after });
            drawn.push((root, stream));
        }
        let states = self.evaluator.visit(&visits)?.into_iter().flatten();
        for ((root, mut stream), seen) in drawn.into_iter().zip(states) {
            let bidders = self.walk(state, root, &seen);
            let (program, bid) = *stream.pick(&bidders);
            let recording = Recording { program: (root.deme as u64, program), state: seen, bid: bid.to_bits() };
            state.archive.record(recording);
        }
        Ok(())
    }

    /// Returns every program that bids on the walk from a root to its action, with its bid.
    fn walk(&self, state: &State<E::Task>, root: &Evaluated, seen: &[f64]) -> Vec<(ProgramId, f64)> {
        let genome = &state.demes[root.deme].genome;
        let mut bidders = Vec::new();
        let mut team = root.team;
        loop {
            let mut winner: Option<(f64, Destination)> = None;
            for edge in &genome.team(team).edges {
                let mut lines = genome.program(edge.program).lines(&self.vocabulary);
                if let Destination::Action(action) = edge.to {
                    lines.extend(self.vocabulary.bound(action).map(bounded));
                }
                let bid = bid(&lines, &self.vocabulary, seen);
                bidders.push((edge.program, bid));
                let bid = if bid.is_nan() { f64::NEG_INFINITY } else { bid };
                if winner.is_none_or(|(best, _)| bid >= best) {
                    winner = Some((bid, edge.to));
                }
            }
            match winner {
                Some((_, Destination::Team(next))) => team = next,
                _ => return bidders,
            }
        }
    }

    /// Returns the price of a line, in the unit of the score.
    pub(super) fn line_price(&self, state: &State<E::Task>) -> f64 {
        let price = self.config.selection.line_price;
        let Some((first, newest)) = state.rows.first().zip(state.rows.last()).filter(|_| price > 0.0) else {
            return 0.0;
        };
        price * (newest.best_score - first.median_score).max(0.0)
    }

    /// Returns the roots of one deme, or of all, as candidates for selection.
    fn candidates<'a>(
        &self,
        state: &State<E::Task>,
        evaluated: &[Evaluated],
        scores: &'a [Judged],
        deme: Option<usize>,
    ) -> Vec<Candidate<'a>> {
        let price = self.line_price(state);
        (evaluated.iter().zip(scores))
            .filter(|(root, _)| deme.is_none_or(|deme| root.deme == deme))
            .map(|(root, scores)| Candidate {
                mean: record(state, root).mean - price * root.lines as f64,
                scores: &scores.scores,
                solved: &scores.solved,
                dropped: root.dropped,
            })
            .collect()
    }
}

/// Returns a root's mean score over its record and the episodes of this generation.
fn running_mean<Task>(state: &State<Task>, root: &Evaluated) -> f64 {
    let mut record = record(state, root);
    record.add(&root.endings.iter().map(|ending| finite(ending.score)).collect::<Vec<_>>());
    record.mean
}

/// Returns a root's record so far.
fn record<Task>(state: &State<Task>, root: &Evaluated) -> Record {
    state.demes[root.deme].records.get(&root.team).copied().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::{Evaluated, running_mean};
    use crate::evolution::genome::TeamId;
    use crate::evolution::state::{Record, State};
    use tpg_engine::{Destination, Edge, Ending, PolicyGraph};

    #[test]
    fn a_bad_episode_moves_a_long_record_little_and_decides_about_a_new_root() {
        let mut state = State::<u64>::new(1, 1, 0);
        state.demes[0].records.insert(TeamId(0), Record { mean: 100.0, evaluations: 9 });
        let ending = Ending { outcome: 0, success: None, score: 0.0, measure: 0.0, actions: 1 };
        let policy = PolicyGraph::new(1, 0, vec![vec![Edge { program: 0, to: Destination::Action(0) }]], vec![vec![]]);
        let root = |team| Evaluated {
            deme: 0,
            team: TeamId(team),
            policy: policy.clone(),
            lines: 1,
            endings: vec![ending],
            dropped: false,
        };
        assert_eq!(running_mean(&state, &root(0)), 90.0);
        assert_eq!(running_mean(&state, &root(1)), 0.0);
    }
}
