//! This project's policies, run by the trainer.

use std::path::Path;
use tpg_engine::TaskSet;
use tpg_graph::Graph;
use tpg_graph::error::InputError;
use tpg_problems::Problem;
use tpg_problems::arm::evaluation::ReachStatistics;
use tpg_problems::arm::targets::Start;
use tpg_train::{Acting, Episodes, Network, Setting, Shared as _};

/// A problem with its episodes.
#[derive(Clone, Copy, Debug)]
pub struct Ours<'a> {
    start: Start,
    episodes: Episodes<'a>,
}

impl<'a> Ours<'a> {
    /// Takes the episodes of a file.
    pub fn from_file(start: Start, file: &'a Path) -> Self {
        Self { start, episodes: Episodes { set: TaskSet::Test, count: 0, seed: 0, file: Some(file) } }
    }

    /// Draws validation episodes.
    pub fn validation(start: Start, count: usize, seed: u64) -> Self {
        Self { start, episodes: Episodes { set: TaskSet::Study, count, seed, file: None } }
    }

    /// Lets policies act; returns the trial and the fraction of actions that the graph chose.
    ///
    /// # Errors
    /// If a policy is not one of the arm.
    pub fn play(&self, acting: Acting<'_>) -> Result<(ReachStatistics, f64), InputError> {
        let done = Problem::tested(self.start.into(), None)?.play(acting, self.episodes)?;
        Ok((ReachStatistics::new(&done.endings), done.tpg_action_ratio))
    }

    /// Lets a graph act alone.
    ///
    /// # Errors
    /// A policy that cannot be read.
    pub fn graph(&self, graph: &(String, Graph)) -> Result<ReachStatistics, InputError> {
        self.play(Acting::Graph(graph)).map(|(trial, _)| trial)
    }

    /// Lets a network act alone.
    ///
    /// # Errors
    /// A policy that cannot be read.
    pub fn network(&self, network: &(String, Network)) -> Result<ReachStatistics, InputError> {
        self.play(Acting::Network(network)).map(|(trial, _)| trial)
    }
}

/// Returns the paper's setting: hand-back after 100 actions, hand-over when the hand strays by 20 or 10 mm, no guard.
pub fn paper_setting(start: Start) -> Setting {
    let separation = if start == Start::Fs { 20.0 } else { 10.0 };
    let detector = tpg_train::Detector::Visited;
    Setting { hand_back_after: tpg_train::Span(100), separation, detector, ..Setting::only_asks() }
}
