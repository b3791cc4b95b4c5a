//! Evolution as a stage of a run: roots that breed and are selected.

use super::genome::{Genome, TeamId};
use super::linear::ProgramKind;
use super::record::{Record, Row};
use super::search::Search;
use super::select::{Scored, ranked, survivors};
use super::stage::{Candidate, Context, EpisodePlan, Moment, Results, Stage};
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use tpg_engine::random::Purpose;
use tpg_engine::{EpisodeResult, Preference, Summary, finite};
use tpg_graph::error::Finding;

/// The teams and programs of a run.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct Population {
    /// The teams and programs.
    pub genome: Genome,
    /// The surviving roots' records.
    pub records: BTreeMap<TeamId, Record>,
    /// The roots of this generation.
    #[serde(skip)]
    roots: Vec<Root>,
}

/// A root of this generation.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Root {
    team: TeamId,
    lines: usize,
    /// Its number among the candidates; none if its score is final.
    candidate: Option<usize>,
}

impl Population {
    /// Begins with what searches have found, the best first.
    pub(super) fn begin(&mut self, context: &Context<'_>, mut found: Vec<&Search>) -> Result<(), Finding> {
        found.sort_by(|a, b| b.score().partial_cmp(&a.score()).unwrap_or(std::cmp::Ordering::Equal));
        *self = Self::default();
        for search in found {
            let writer = context.writer(search.kind)?;
            let root = writer.add_root(&mut self.genome, &search.weights(&writer));
            self.records.insert(root, Record { mean: search.score().unwrap_or(f64::MIN), evaluations: 0 });
        }
        Ok(())
    }

    /// Begins with linear policies.
    pub(super) fn begin_linear(&mut self, context: &Context<'_>, policies: &[Vec<Vec<f64>>]) -> Result<(), Finding> {
        for rows in policies {
            context.writer(ProgramKind::Sum)?.add_linear(&mut self.genome, rows);
        }
        Ok(())
    }

    /// Forgets all records: scores of coarser episodes are not comparable with others.
    pub(super) fn forget(&mut self) {
        self.records.clear();
    }

    /// Returns the number of teams, and of programs.
    pub(super) fn size(&self) -> (usize, usize) {
        (self.genome.teams.len(), self.genome.programs.len())
    }

    /// Returns the surviving roots with their records less the price of their lines, best first; of equals the smaller one, then the
    /// older one.
    pub(super) fn survivors(&self, context: &Context<'_>) -> Vec<(f64, Candidate)> {
        let root = |(&team, &record): (&TeamId, &Record)| {
            let policy = self.genome.policy(team, context.vocabulary);
            (record.mean - context.line_price * policy.lines() as f64, Candidate { policy, record })
        };
        let mut roots: Vec<_> = self.records.iter().map(root).collect();
        roots.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.policy.lines().cmp(&b.1.policy.lines())));
        roots
    }

    fn breed(&mut self, context: &Context<'_>, moment: Moment) {
        let genome = &mut self.genome;
        if genome.teams.is_empty() {
            let mut stream = moment.stream(Purpose::Initial, 0);
            if context.actions == 0 {
                *genome = context.random_leaves(&mut stream);
            } else {
                *genome = context.random_teams(&mut stream);
                context.complete_roots(genome);
            }
        }
        if context.actions == 0 {
            context.populate_leaves(genome, moment);
        } else {
            context.populate_teams(genome, moment);
        }
    }

    /// Returns a root as the results rank it.
    fn scored(&self, context: &Context<'_>, results: &Results, root: &Root) -> Scored {
        let endings = root.candidate.map_or(&[][..], |place| &results.endings[place]);
        let solved = |ending: &EpisodeResult| context.preference == Preference::Success && ending.success == Some(true);
        Scored {
            mean: self.record(root.team).mean - context.line_price * root.lines as f64,
            scores: endings.iter().map(|ending| finite(ending.score)).collect(),
            solved: endings.iter().map(solved).collect(),
        }
    }

    fn record(&self, root: TeamId) -> Record {
        self.records.get(&root).copied().unwrap_or_default()
    }
}

impl Stage for Population {
    fn ask(&mut self, context: &Context<'_>, moment: Moment) -> Vec<Candidate> {
        self.breed(context, moment);
        let most = context.config.learning.max_nb_evaluation_per_policy;
        let (mut roots, mut candidates) = (Vec::new(), Vec::new());
        let teams = self.genome.roots();
        let policies = self.genome.policies(&teams, context.vocabulary);
        for (team, policy) in teams.into_iter().zip(policies) {
            let record = self.record(team);
            let lines = if context.config.selection.line_price > 0.0 { policy.lines() } else { 0 };
            // As GEGELATI, which does not evaluate a root whose score is final (`learningAgent.cpp`, `isRootEvalSkipped`).
            let candidate = (record.evaluations < most).then_some(candidates.len());
            if candidate.is_some() {
                candidates.push(Candidate { policy, record });
            }
            roots.push(Root { team, lines, candidate });
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
                self.records.entry(root.team).or_default().add(scores);
            }
        }
        let roots = std::mem::take(&mut self.roots);
        let scored: Vec<Scored> = roots.iter().map(|root| self.scored(context, results, root)).collect();
        let order = ranked(&scored);
        let (best, middle) = (&roots[order[0]], &roots[order[order.len() / 2]]);
        let endings = best.candidate.map_or(&[][..], |place| &results.endings[place]);
        let Summary { success, measure, .. } = Summary::new(endings);
        let row = Row {
            generation: moment.generation,
            best_score: self.record(best.team).mean,
            median_score: self.record(middle.team).mean,
            best_success: success,
            best_measure: measure,
            roots: roots.len(),
            ..Row::default()
        };
        let best = best.candidate.unwrap_or(usize::MAX);
        let mut stream = moment.stream(Purpose::Lexicase, 0);
        let kept = survivors(&scored, context.config.survivors(), &context.config.selection, &mut stream);
        let kept: BTreeSet<TeamId> = kept.into_iter().map(|place| roots[place].team).collect();
        let removed: Vec<TeamId> = roots.iter().map(|root| root.team).filter(|team| !kept.contains(team)).collect();
        self.genome.remove_roots(&removed);
        self.records.retain(|team, _| self.genome.teams.contains_key(team));
        (row, best)
    }
}
