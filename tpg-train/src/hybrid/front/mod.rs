//! The front of a sweep over prices: return against the network's actions, beside what needs no learning.
//!
//! | file | subject |
//! | --- | --- |
//! | (root) | [`Front`], and [`conclude`], which makes and writes one |
//! | [`measure`] | every policy on validation episodes |
//! | [`work`] | operations of a decision |
//! | [`files`] | `front.json`, `front.csv`, `hybrid.toml` |
//! | [`figure`] | the front as a section of a page |

pub mod figure;
pub mod files;
pub mod measure;
pub mod work;

use super::shared::Shared;
use crate::files::write_atomically;
use crate::picture::Page;
use crate::sac::network::Network;
use serde::{Deserialize, Serialize};
use std::path::Path;
use tpg_graph::Graph;
use tpg_graph::error::InputError;
use work::Work;

/// The graphs of a sweep, one for each seed.
pub struct Trained<'a> {
    /// The problem.
    pub problem: &'a dyn Shared,
    /// The network, and its file.
    pub network: (String, Network),
    /// Number of validation episodes of each policy.
    pub episodes: usize,
    /// The seeds.
    pub seeds: Vec<u64>,
    /// The graphs that ask nobody, with their files, relative to the sweep's folder.
    pub alone: Vec<(String, Graph)>,
    /// The graphs that ask, for each price.
    pub asking: Vec<(f64, Vec<(String, Graph)>)>,
}

/// The kind of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// A graph alone.
    Graph,
    /// A graph that asks, trained at a price.
    Asking,
    /// A graph alone with a network that rules call.
    Rules,
    /// A graph alone and a network, by draws.
    Mixture,
    /// The network alone.
    Network,
}

impl Kind {
    /// Every kind, in the order of tables.
    pub const ALL: [Self; 5] = [Self::Graph, Self::Asking, Self::Rules, Self::Mixture, Self::Network];

    /// Returns the name in files and legends.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Graph => "graph",
            Self::Asking => "asking",
            Self::Rules => "rules",
            Self::Mixture => "mixture",
            Self::Network => "network",
        }
    }
}

/// A policy's result on the episodes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Outcome {
    /// Mean score; nothing is paid for asks.
    pub score: f64,
    /// Standard error of the mean score.
    pub score_error: f64,
    /// Actions of the network in an episode.
    pub network_actions: f64,
    /// Actions of an episode.
    pub actions: f64,
    /// Operations of a decision.
    pub operations: Work,
}

/// A price, a share, or a setting of rules: the mean over seeds, and each seed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Point {
    /// Its kind.
    pub kind: Kind,
    /// The price, the share or the rules, in words.
    pub setting: String,
    /// The mean over seeds; its error is that of the episodes.
    pub mean: Outcome,
    /// True if no other point has as high a score with as few actions of the network, and is better in one of them.
    pub on_front: bool,
    /// True for the price to use.
    pub chosen: bool,
    /// Each seed, in order; one entry for the network.
    pub seeds: Vec<Outcome>,
}

/// All points of a sweep.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Front {
    /// The problem's name.
    pub problem: String,
    /// The network's file.
    pub network: String,
    /// The seeds of the graphs.
    pub seeds: Vec<u64>,
    /// Validation episodes of each policy, which no training reads.
    pub episodes: usize,
    /// Number of settings of rules that were tried; the points are the front of them.
    pub rules_tried: usize,
    /// The points.
    pub points: Vec<Point>,
}

/// Measures the policies of a sweep, and writes `front.json`, `front.csv`, `front.html` and `hybrid.toml` into its folder.
///
/// # Errors
/// If a policy does not fit the problem, or a file cannot be written.
pub fn conclude(trained: &Trained<'_>, threads: &rayon::ThreadPool, folder: &Path) -> Result<(), InputError> {
    let front = threads.install(|| measure::measure(trained))?;
    files::write(&front, trained, folder)?;
    let page = Page {
        title: format!("Asking, {}", front.problem),
        sections: vec![figure::section(&front)],
        ..Page::default()
    };
    write_atomically(&folder.join("front.html"), page.html().as_bytes())?;
    for point in front.points.iter().filter(|point| matches!(point.kind, Kind::Graph | Kind::Asking | Kind::Network)) {
        let Point { kind, setting, mean, chosen, .. } = point;
        tpg_graph::command::note(format_args!(
            "{} {setting}: score {:.2}, {:.1} of {:.1} actions by the network{}",
            kind.name(),
            mean.score,
            mean.network_actions,
            mean.actions,
            if *chosen { "; chosen" } else { "" }
        ));
    }
    Ok(())
}
