//! Searches for the weights of [linear programs](super::linear). Mutations of single lines hardly ever find six weights that only help
//! together; these do.

use super::cma::Cma;
use super::linear::{LinearWriter, ProgramKind};
use super::random_search::RandomSearch;
use super::record::{Record, Row};
use super::stage::{Candidate, Context, EpisodePlan, Moment, Results, Stage};
use serde::{Deserialize, Serialize};
use std::collections::VecDeque;
use tpg_engine::random::Purpose;
use tpg_engine::{PolicyGraph, Summary};
use tpg_graph::error::Finding;

/// Number of generations whose median is a search's score.
const NEWEST: usize = 9;
/// The part of the samples that counts in a generation's score, the best ones: one that is unstable may lose a million.
const COUNTED: f64 = 0.75;
/// Samples of a generation that adapts variances, in Hansen's numbers of them.
const BREADTH: usize = 2;
/// Default length of a search: generations for each weight, and their minimum.
const GENERATIONS_PER_WEIGHT: u64 = 3;
const MIN_GENERATIONS: u64 = 20;
/// One search for weights.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Search {
    /// The form of the programs.
    pub kind: ProgramKind,
    /// The method.
    method: Method,
    /// The newest generations' scores.
    scores: VecDeque<f64>,
    /// The samples that are being evaluated.
    #[serde(skip)]
    samples: Vec<Vec<f64>>,
}

/// Method of a search for weights.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Method {
    /// Adaptation of variances, of the weights that are written.
    Cma(Cma),
    /// Random search, of the weights of normalised inputs.
    Random(RandomSearch),
}

impl Search {
    /// Begins the search that follows `before` others: a random one if there is one, then sums and, where programs can be that,
    /// products in turns. A run that is for random search alone has sums only.
    pub(super) fn begin(context: &Context<'_>, before: u64) -> Result<Self, Finding> {
        let random = context.config.start.random;
        let has_random = random > 0.0;
        let others = before.saturating_sub(has_random.into());
        let is_product =
            others % 2 == 1 && random < 1.0 && context.writer(ProgramKind::Product).is_ok_and(|it| context.fits(&it));
        let kind = if is_product { ProgramKind::Product } else { ProgramKind::Sum };
        let writer = context.writer(kind)?;
        let method = if has_random && before == 0 {
            Method::Random(RandomSearch::new(writer.rows(), writer.units().len()))
        } else {
            Method::Cma(Cma::new(writer.weights()))
        };
        Ok(Self { kind, method, scores: VecDeque::new(), samples: Vec::new() })
    }

    /// True for a random search.
    pub(super) fn is_random(&self) -> bool {
        matches!(self.method, Method::Random(_))
    }

    /// Returns the default number of generations.
    pub(super) fn length(&self, context: &Context<'_>) -> Result<u64, Finding> {
        Ok((GENERATIONS_PER_WEIGHT * context.writer(self.kind)?.weights() as u64).max(MIN_GENERATIONS))
    }

    /// Returns the weights in the middle of the samples, which are better than these.
    pub(super) fn weights(&self, writer: &LinearWriter<'_>) -> Vec<f64> {
        match &self.method {
            Method::Cma(cma) => cma.mean().to_vec(),
            Method::Random(search) => writer.weights_of_rows(&search.unfolded(search.mean(), &writer.units())),
        }
    }

    /// Returns the policy in the middle of the samples.
    pub(super) fn best(&self, context: &Context<'_>) -> Option<PolicyGraph> {
        let writer = context.writer(self.kind).ok()?;
        Some(writer.policy(&self.weights(&writer)))
    }

    /// Returns the score: a mean of samples, the median over some generations.
    pub(super) fn score(&self) -> Option<f64> {
        let mut scores: Vec<f64> = self.scores.iter().copied().collect();
        scores.sort_by(f64::total_cmp);
        scores.get(scores.len() / 2).copied()
    }

    /// Returns the better one of two searches; the first of equals.
    pub(super) fn better(self, other: Self) -> Self {
        if other.score() > self.score() { other } else { self }
    }
}

impl Context<'_> {
    /// Returns the writer of sums or products.
    pub(super) fn writer(&self, kind: ProgramKind) -> Result<LinearWriter<'_>, Finding> {
        LinearWriter::new(self.vocabulary, self.actions, kind)
    }

    /// True if programs may be as long as those of a writer.
    fn fits(&self, writer: &LinearWriter<'_>) -> bool {
        let program = &self.config.program;
        let most = if self.actions == 0 { program.leaf_lines() } else { program.max_program_size };
        writer.is_small() && writer.lines() <= most
    }
}

impl Stage for Search {
    fn ask(&mut self, context: &Context<'_>, moment: Moment) -> Vec<Candidate> {
        let Ok(writer) = context.writer(self.kind) else { return Vec::new() };
        let mut stream = moment.stream(Purpose::Linear, 0);
        let (samples, weights): (_, Vec<Vec<f64>>) = match &self.method {
            Method::Cma(cma) => {
                let count = BREADTH * Cma::default_population(writer.weights());
                let samples = cma.samples(count, &mut stream);
                (samples.clone(), samples)
            }
            Method::Random(search) => {
                let samples = search.samples(context.samples, &mut stream);
                let units = writer.units();
                let weights = samples.iter().map(|sample| writer.weights_of_rows(&search.unfolded(sample, &units)));
                let weights = weights.collect();
                (samples, weights)
            }
        };
        self.samples = samples;
        let candidate =
            |weights: &Vec<f64>| Candidate { policy: writer.policy(weights), deme: 0, record: Record::default() };
        weights.iter().map(candidate).collect()
    }

    fn episodes(&self) -> EpisodePlan {
        if self.is_random() { EpisodePlan::Pairs } else { EpisodePlan::Same }
    }

    fn tell(&mut self, context: &Context<'_>, moment: Moment, results: &Results) -> (Row, usize) {
        let summaries: Vec<Summary> = results.endings.iter().map(|endings| Summary::new(endings)).collect();
        let mut order: Vec<usize> = (0..summaries.len()).collect();
        order.sort_by(|&a, &b| summaries[b].score.total_cmp(&summaries[a].score));
        let counted = &order[..(COUNTED * order.len() as f64).ceil() as usize];
        let sum: f64 = counted.iter().map(|&place| summaries[place].score).sum();
        self.scores.push_back((sum / counted.len() as f64).clamp(-1e30, 1e30));
        self.scores.drain(..self.scores.len().saturating_sub(NEWEST));
        let samples = std::mem::take(&mut self.samples);
        match &mut self.method {
            Method::Cma(cma) => {
                let ranked: Vec<Vec<f64>> = order.iter().map(|&place| samples[place].clone()).collect();
                cma.update(&ranked);
            }
            Method::Random(search) => {
                let scores: Vec<f64> = summaries.iter().map(|result| result.score).collect();
                search.update(&samples, &scores, context.left);
                if let Ok(writer) = context.writer(self.kind) {
                    search.observe(&results.seen.select(writer.places()));
                }
            }
        }
        let best = &summaries[order[0]];
        let row = Row {
            generation: moment.generation,
            best_score: best.score,
            median_score: summaries[order[order.len() / 2]].score,
            best_success: best.success,
            best_measure: best.measure,
            roots: summaries.len(),
            ..Row::default()
        };
        (row, order[0])
    }
}
