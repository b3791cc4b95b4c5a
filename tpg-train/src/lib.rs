//! Trains policies for control problems: tangled program graphs, soft actor-critics, hybrids of both.
//!
//! | items | subject |
//! | --- | --- |
//! | [`train`], [`RunOptions`], [`Goal`], [`Progress`], [`RunEnd`], [`RunError`] | evolution of a graph, in a folder of its own |
//! | [`Config`], [`SacConfig`], [`Configuration`], [`Layers`], [`Preset`] | settings |
//! | [`train_network`], [`Network`] | soft actor-critics |
//! | [`evaluate`], [`Acting`], [`Episodes`], [`OwnProblem`], [`Shared`] | test episodes of a graph, a network, or both |
//! | [`Hybrid`], [`Setting`], [`Asking`], [`study_on`] | graphs and networks that share a problem |
//! | [`report_with`] | runs in one HTML file |
//! | [`Cli`] | the program `tpg-train` |
//! | [`evolve`], [`Ranks`], [`Link`] | `tpg-train tpg` over several processes |
//!
//! See [`train`] for an example.

mod arm_import;
mod cli;
mod configuration;
mod csv_text;
mod effort;
mod evaluate;
mod evolution;
mod folder;
mod hybrid;
mod interrupt;
mod problems;
mod progress;
mod quantise;
mod ranks;
mod report;
mod run_args;
mod run_time;
mod sac;
mod targets;
#[cfg(test)]
mod tests;

pub use cli::Cli;
pub use configuration::{Configuration, Layers, Preset};
pub use effort::Effort;
pub use evaluate::{Against, EvaluationReport, evaluate};
pub use evolution::checkpoint::steps_of;
pub use evolution::command::{TpgArgs, execute as evolve};
pub use evolution::config::{AskConfig, EvolutionConfig as Config, Units};
pub use evolution::generation::Goal;
pub use evolution::record::Row;
pub use evolution::run::{Progress, RunEnd, RunError, RunOptions, train};
pub use evolution::state::Best;
pub use hybrid::asking::Asking;
pub use hybrid::command::{StudyArgs, study_on};
pub use hybrid::rollout::{Acting, HybridResult};
pub use hybrid::setting::{Detector, Hybrid, HybridFile, Setting};
pub use hybrid::shared::{Episodes, Facts, OwnProblem, Shared};
pub use hybrid::span::Span;
pub use quantise::{QuantiseArgs, quantise};
pub use ranks::link::Link;
pub use ranks::workplace::Ranks;
pub use report::{ReportArgs, report_with};
pub use sac::config::SacConfig;
pub use sac::network::Network;
pub use sac::training::train_network;

/// Readers of files as functions of bytes, for fuzzers and tests.
#[doc(hidden)]
pub mod loaders {
    pub use crate::evolution::checkpoint as tpg;
    pub use crate::evolution::generation::Evolution;
    pub use crate::folder::checkpoint::look;
    pub use crate::folder::frame::seal;
    pub use crate::folder::{RunFolder, Trainer};
    pub use crate::hybrid::setting::{parse_file, read_file};
    pub use crate::sac::tensors::{Tensor, Tensors};
    pub use crate::sac::training::Training;
    pub use crate::sac::{checkpoint as sac, foreign, weights};
}
