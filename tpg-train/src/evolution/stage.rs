//! The stages of a run: a random search for weights, searches that adapt their variances, evolution. Each asks for episodes of
//! candidates and is told how these ended; the budget says which stage has the next generation.

use super::config::EvolutionConfig;
use super::record::{Record, Row};
use super::vocabulary::Vocabulary;
use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{EpisodeResult, Moments, PolicyGraph, Preference};

/// The parts of a run that stages read.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Context<'a> {
    /// The settings.
    pub config: &'a EvolutionConfig,
    /// The vocabulary of programs.
    pub vocabulary: &'a Vocabulary,
    /// Number of actions; 0 with outputs.
    pub actions: u16,
    /// The action that undoes each one, if there is one.
    pub opposites: &'a [Option<u16>],
    /// Maximum number of lines of a program that is drawn or changed; those of leaves may be longer than bids.
    pub max_lines: usize,
    /// The criterion by which policies are compared.
    pub preference: Preference,
    /// Price of a line, in the unit of the score.
    pub line_price: f64,
    /// The part of a random search that is still to come, 0 to 1.
    pub left: f64,
    /// Number of samples of a local search's generations.
    pub samples: usize,
    /// Maximum number of actions of an episode.
    pub time_limit: u32,
}

/// Seed and generation: the first half of every stream's address.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Moment {
    /// Seed of the run.
    pub seed: u64,
    /// The generation.
    pub generation: u64,
}

impl Moment {
    /// Returns the stream for a purpose.
    pub(crate) fn stream(self, purpose: Purpose, index: u64) -> Stream {
        Stream::new(self.seed, self.generation, purpose, index)
    }
}

/// A policy to evaluate.
#[derive(Clone, Debug)]
pub(crate) struct Candidate {
    /// The policy.
    pub policy: PolicyGraph,
    /// Its record so far.
    pub record: Record,
}

/// The episodes that the candidates of a generation play.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum EpisodePlan {
    /// Every two candidates in a row another one: much is seen, and opposites are compared under the same conditions.
    Pairs,
    /// All the same.
    Same,
    /// The same, and after some of them only the better candidates play on.
    Racing,
}

/// Results of the episodes of a generation.
#[derive(Clone, Debug, Default)]
pub(crate) struct Results {
    /// The endings of each candidate.
    pub endings: Vec<Vec<EpisodeResult>>,
    /// Moments of the flat states, if candidates played in pairs.
    pub seen: Moments,
}

/// A part of a run.
pub(crate) trait Stage {
    /// Returns the candidates of a generation.
    fn ask(&mut self, context: &Context<'_>, moment: Moment) -> Vec<Candidate>;

    /// Returns what episodes these play.
    fn episodes(&self) -> EpisodePlan;

    /// Learns from the results. Returns the figures of the generation, and the best candidate.
    fn tell(&mut self, context: &Context<'_>, moment: Moment, results: &Results) -> (Row, usize);
}
