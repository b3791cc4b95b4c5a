//! The cells of a study.

use super::rollout::Acting;
use super::setting::Setting;
use super::shared::{Episodes, Shared};
use crate::sac::network::Network;
use serde::Serialize;
use tpg_engine::Summary;
use tpg_graph::Graph;
use tpg_graph::error::InputError;

/// A pair under a setting: with these and its result, a row of `cells.csv`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Cell {
    /// Position of the graph on the command line, from 0.
    pub tpg: usize,
    /// Position of the network on the command line, from 0.
    pub sac: usize,
    /// The setting.
    #[serde(skip)]
    pub setting: Setting,
    /// The result.
    #[serde(skip)]
    pub result: Summary,
    /// Standard deviation of the scores, over the episodes (of the sample, n − 1).
    pub std_score: f64,
    /// Fraction of all actions that the graph chose.
    pub tpg_action_ratio: f64,
    /// Actions per episode that the network chose.
    pub network_actions: f64,
}

/// Subject of a study.
pub(crate) struct Subject<'a> {
    /// The problem.
    pub problem: &'a dyn Shared,
    /// The graphs, with their files.
    pub graphs: Vec<(String, Graph)>,
    /// The networks, with their files.
    pub networks: Vec<(String, Network)>,
    /// The settings.
    pub settings: Vec<Setting>,
    /// The episodes of each cell.
    pub episodes: Episodes<'a>,
}

impl Subject<'_> {
    /// Computes a cell.
    ///
    /// # Errors
    /// If a policy does not fit the problem.
    pub(crate) fn cell(&self, tpg: usize, sac: usize, setting: &Setting) -> Result<Cell, InputError> {
        let both = Acting::Both(&self.graphs[tpg], &self.networks[sac], setting);
        let done = self.problem.play(both, self.episodes)?;
        let result = Summary::new(&done.endings);
        Ok(Cell {
            tpg,
            sac,
            setting: setting.clone(),
            std_score: result.score_deviation(&done.endings),
            result,
            tpg_action_ratio: done.tpg_action_ratio,
            network_actions: done.network_actions,
        })
    }
}
