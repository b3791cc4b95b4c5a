//! Trains policies for control problems: tangled program graphs, soft actor-critics, hybrids of both.
//!
//! | items | subject |
//! | --- | --- |
//! | [`train`], [`RunOptions`], [`Goal`], [`Naming`], [`Progress`], [`RunEnd`], [`RunError`] | evolution of a graph, in a folder of its own |
//! | [`Config`], [`SacConfig`], [`Configuration`], [`Layers`] | settings |
//! | [`train_network`], [`Network`], [`Decide`] | soft actor-critics |
//! | [`evaluate`], [`Acting`], [`Episodes`], [`OwnProblem`], [`Shared`] | test episodes of a graph, a network, or both |
//! | [`Hybrid`], [`Setting`], [`Asking`] | graphs and networks that share a problem |
//! | [`in_integers`], [`InIntegers`], [`Visit`] | graphs in integers that keep their return |
//! | [`report_with`] | runs in one HTML file |
//! | [`Cli`] | the program `tpg-train` |
//! | [`evolve`], [`Link`] | `tpg-train tpg` over several processes |
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
mod quantise;
mod ranks;
mod report;
mod run_args;
mod run_time;
mod sac;
#[cfg(test)]
mod tests;

pub use cli::Cli;
pub use configuration::{Configuration, Layers};
pub use evaluate::{EvaluationReport, evaluate};
pub use evolution::command::TpgArgs;
pub use evolution::config::EvolutionConfig as Config;
pub use evolution::generation::Goal;
pub use evolution::record::Row;
pub use evolution::run::{Naming, Progress, RunEnd, RunError, RunOptions, train};
pub use evolution::state::Best;
pub use hybrid::asking::Asking;
pub use hybrid::rollout::Acting;
pub use hybrid::setting::{Detector, Hybrid, Setting};
pub use hybrid::shared::{Episodes, OwnProblem, Shared};
pub use hybrid::span::Span;
pub use quantise::{InIntegers, Visit, in_integers};
pub use ranks::evolve;
pub use ranks::link::Link;
pub use report::{ReportArgs, report_with};
pub use sac::config::SacConfig;
pub use sac::network::{Decide, Network};
pub use sac::training::train_network;

/// Parts of the commands, and readers of files as functions of bytes, for fuzzers and tests.
#[doc(hidden)]
pub mod parts {
    pub use crate::evolution::config::{AskConfig, Units};
    pub use crate::folder::RunFolder;
    pub use crate::hybrid::command::{StudyArgs, study_on};
    pub use crate::hybrid::setting::parse_file;
    pub use crate::quantise::{GraphArgs, QuantiseArgs, quantise};
    pub use crate::sac::tensors::{Tensor, Tensors};
    pub use crate::sac::{foreign, weights};
}
