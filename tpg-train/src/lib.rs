//! Trains policies for control problems: tangled program graphs, soft actor-critics, hybrids of both.
//!
//! # Map
//!
//! | module | subject |
//! | --- | --- |
//! | [`cli`] | the program `tpg-train`: its commands and exit codes |
//! | [`evolution`] | tangled program graphs: genome, mutation, selection, runs |
//! | [`sac`] | soft actor-critic on any environment with outputs |
//! | [`arm_import`] | `tpg-train arm import`: an arm from its URDF |
//! | [`quantise`] | `tpg-train quantise` |
//! | [`targets`] | tasks over the reachable space |
//! | [`evaluate`] | test episodes of a policy |
//! | [`hybrid`] | a graph and a network that share a problem: settings and study |
//! | [`picture`] | SVG, plots and the HTML page that contains them: the crate `tpg-picture` |
//! | [`configuration`] | the configuration and problem that a run's arguments ask for |
//! | [`files`] | atomic file writes |
//! | [`folder`] | a run's folder: lock, checkpoints |
//! | [`problems`] | `tpg-train problems` |
//! | [`run_args`] | the arguments of every run |
//! | [`ranks`] | runs over several processes |
//! | [`report`] | runs in one HTML file |

pub mod arm_import;
pub mod cli;
pub mod configuration;
mod csv_text;
pub mod evaluate;
pub mod evolution;
pub mod files;
pub mod folder;
pub mod hybrid;
mod interrupt;
pub mod problems;
mod progress;
pub mod quantise;
pub mod ranks;
pub mod report;
pub mod run_args;
pub mod sac;
pub mod targets;

pub use tpg_picture as picture;
