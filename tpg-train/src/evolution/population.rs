//! Evolution as a stage of a run: demes of roots that breed, are selected, and end where others are better.

use super::genome::{Genome, TeamId};
use super::linear::ProgramKind;
use super::mirror::Mirror;
use super::mutate_leaf::LeafMutator;
use super::mutate_program::ProgramMutator;
use super::mutate_team::{TeamMutator, random_population};
use super::record::{Record, Row};
use super::refine::Refiner;
use super::search::Search;
use super::select::{Scored, ranked, survivors};
use super::stage::{Candidate, Context, EpisodePlan, Moment, Results, Stage};
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use tpg_engine::random::Purpose;
use tpg_engine::{EpisodeResult, Preference, Summary, finite};
use tpg_graph::error::Finding;

/// Teams and programs that breed separately.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Deme {
    /// Its teams and programs.
    pub genome: Genome,
    /// Its surviving roots' records.
    pub records: BTreeMap<TeamId, Record>,
}

/// The demes of a run.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Population {
    /// The demes.
    pub demes: Vec<Deme>,
    /// The roots of this generation.
    #[serde(skip)]
    roots: Vec<Root>,
}

/// A root of this generation.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Root {
    deme: usize,
    team: TeamId,
    lines: usize,
    /// Its number among the candidates; none if its score is final.
    candidate: Option<usize>,
}

impl Population {
    /// Creates demes without teams.
    pub(crate) fn new(demes: usize) -> Self {
        Self { demes: vec![Deme::default(); demes], roots: Vec::new() }
    }

    /// Lets half of the demes begin with what searches have found, the best first.
    pub(super) fn begin(&mut self, context: &Context<'_>, mut found: Vec<&Search>) -> Result<(), Finding> {
        found.sort_by(|a, b| b.score().partial_cmp(&a.score()).unwrap_or(std::cmp::Ordering::Equal));
        let half = self.demes.len().div_ceil(2);
        for deme in &mut self.demes[..half] {
            *deme = Deme::default();
            for search in &found {
                let writer = context.writer(search.kind)?;
                let root = writer.add_root(&mut deme.genome, &search.weights(&writer));
                deme.records.insert(root, Record { mean: search.score().unwrap_or(f64::MIN), evaluations: 0 });
            }
        }
        Ok(())
    }

    /// Lets half of the demes, which are empty, begin with linear policies.
    pub(super) fn begin_linear(&mut self, context: &Context<'_>, policies: &[Vec<Vec<f64>>]) -> Result<(), Finding> {
        let half = self.demes.len().div_ceil(2);
        for rows in policies {
            let writer = context.writer(ProgramKind::Sum)?;
            self.demes[..half].iter_mut().for_each(|deme| _ = writer.add_linear(&mut deme.genome, rows));
        }
        Ok(())
    }

    /// Forgets all records: scores of coarser episodes are not comparable with others.
    pub(super) fn forget(&mut self) {
        self.demes.iter_mut().for_each(|deme| deme.records.clear());
    }

    /// Returns the number of teams, and of programs.
    pub(super) fn size(&self) -> (usize, usize) {
        let teams = self.demes.iter().map(|deme| deme.genome.teams.len()).sum();
        (teams, self.demes.iter().map(|deme| deme.genome.programs.len()).sum())
    }

    /// Returns the surviving roots with their records less the price of their lines, best first; of equals the smaller one, then that
    /// of the earlier deme, then the older one.
    pub(super) fn survivors(&self, context: &Context<'_>) -> Vec<(f64, Candidate)> {
        let mut roots = Vec::new();
        for (deme, population) in self.demes.iter().enumerate() {
            for (&team, &record) in &population.records {
                let policy = population.genome.policy(team, context.vocabulary);
                let worth = record.mean - context.line_price * policy.lines() as f64;
                roots.push((worth, Candidate { policy, deme, record }));
            }
        }
        roots.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.policy.lines().cmp(&b.1.policy.lines())));
        roots
    }

    /// Ends the worse demes, judged by their best root, until `count` are left: independent starts are many, but only the promising
    /// ones are paid for.
    pub(super) fn keep_best(&mut self, count: usize, context: &Context<'_>) {
        if count >= self.demes.len() {
            return;
        }
        let mut kept = BTreeSet::new();
        for (_, root) in self.survivors(context) {
            if kept.len() < count {
                kept.insert(root.deme);
            }
        }
        let mut place = 0..;
        self.demes.retain(|_| place.next().is_some_and(|place| kept.contains(&place)));
    }

    fn breed(&mut self, context: &Context<'_>, moment: Moment) {
        let Context { config, vocabulary, opposites, .. } = *context;
        let programs = ProgramMutator { vocabulary, parameters: &config.program, literals: &config.literals };
        let longer = config.program.of_leaves();
        let leaves = ProgramMutator { parameters: &longer, ..programs };
        let refiner = Refiner { vocabulary, parameters: &config.refinement };
        let growing = LeafMutator { bids: programs, leaves, refiner, tpg: &config.tpg };
        let mirror = Mirror { programs, opposites, probability: config.refinement.p_mirror };
        let actions = context.actions;
        let teams = TeamMutator { programs, refiner, mirror, parameters: &config.tpg, actions };
        for (deme, population) in (0..).zip(&mut self.demes) {
            let moment = Moment { deme, ..moment };
            let genome = &mut population.genome;
            if genome.teams.is_empty() {
                let mut stream = moment.stream(Purpose::Initial, 0);
                if actions == 0 {
                    *genome = growing.random_population(config.tpg.init_nb_roots, &mut stream);
                } else {
                    *genome = random_population(&programs, &config.tpg, actions, &mut stream);
                    mirror.complete_roots(genome, config.tpg.max_outgoing_edges);
                }
            }
            if actions == 0 {
                growing.populate(genome, moment);
            } else {
                teams.populate(genome, moment);
            }
        }
    }

    /// Returns the roots of one deme, or of all, as the results rank them.
    fn scored(&self, context: &Context<'_>, results: &Results, deme: Option<usize>) -> Vec<Scored> {
        let roots = self.roots.iter().filter(|root| deme.is_none_or(|deme| root.deme == deme));
        roots
            .map(|root| {
                let mean = self.record(root).mean - context.line_price * root.lines as f64;
                let endings = root.candidate.map_or(&[][..], |place| &results.endings[place]);
                let solved =
                    |ending: &EpisodeResult| context.preference == Preference::Success && ending.success == Some(true);
                Scored {
                    mean,
                    scores: endings.iter().map(|ending| finite(ending.score)).collect(),
                    solved: endings.iter().map(solved).collect(),
                }
            })
            .collect()
    }

    fn record(&self, root: &Root) -> Record {
        self.demes[root.deme].records.get(&root.team).copied().unwrap_or_default()
    }

    fn select(&mut self, context: &Context<'_>, moment: Moment, results: &Results) {
        for deme in 0..self.demes.len() {
            let scored = self.scored(context, results, Some(deme));
            let roots: Vec<TeamId> = self.roots.iter().filter(|root| root.deme == deme).map(|root| root.team).collect();
            let mut stream = Moment { deme: deme as u64, ..moment }.stream(Purpose::Lexicase, 0);
            let kept = survivors(&scored, context.config.survivors(), &context.config.selection, &mut stream);
            let kept: BTreeSet<TeamId> = kept.into_iter().map(|place| roots[place]).collect();
            let removed: Vec<TeamId> = roots.into_iter().filter(|team| !kept.contains(team)).collect();
            let Deme { genome, records } = &mut self.demes[deme];
            genome.remove_roots(&removed);
            records.retain(|team, _| genome.teams.contains_key(team));
        }
    }
}

impl Stage for Population {
    fn ask(&mut self, context: &Context<'_>, moment: Moment) -> Vec<Candidate> {
        self.breed(context, moment);
        let most = context.config.learning.max_nb_evaluation_per_policy;
        let (mut roots, mut candidates) = (Vec::new(), Vec::new());
        for (deme, population) in self.demes.iter().enumerate() {
            let teams = population.genome.roots();
            let policies = population.genome.policies(&teams, context.vocabulary);
            for (team, policy) in teams.into_iter().zip(policies) {
                let record = population.records.get(&team).copied().unwrap_or_default();
                let lines = if context.config.selection.line_price > 0.0 { policy.lines() } else { 0 };
                // As GEGELATI, which does not evaluate a root whose score is final (`learningAgent.cpp`, `isRootEvalSkipped`).
                let candidate = (record.evaluations < most).then_some(candidates.len());
                if candidate.is_some() {
                    candidates.push(Candidate { policy, deme, record });
                }
                roots.push(Root { deme, team, lines, candidate });
            }
        }
        self.roots = roots;
        candidates
    }

    fn episodes(&self) -> EpisodePlan {
        EpisodePlan::Racing
    }

    fn tell(&mut self, context: &Context<'_>, moment: Moment, results: &Results) -> (Row, usize) {
        for root in &self.roots {
            if let Some(candidate) = root.candidate {
                let scores = results.endings[candidate].iter().map(|ending| finite(ending.score));
                self.demes[root.deme].records.entry(root.team).or_default().add(scores);
            }
        }
        let order = ranked(&self.scored(context, results, None));
        let (best, middle) = (&self.roots[order[0]], &self.roots[order[order.len() / 2]]);
        let endings = best.candidate.map_or(&[][..], |place| &results.endings[place]);
        let Summary { success, measure, .. } = Summary::new(endings);
        let row = Row {
            generation: moment.generation,
            best_score: self.record(best).mean,
            median_score: self.record(middle).mean,
            best_success: success,
            best_measure: measure,
            roots: self.roots.len(),
            ..Row::default()
        };
        let best = best.candidate.unwrap_or(usize::MAX);
        self.select(context, moment, results);
        self.roots.clear();
        (row, best)
    }
}
