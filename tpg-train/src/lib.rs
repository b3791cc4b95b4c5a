//! Trains robot-arm policies, and replays the recorded episodes of the paper's own.
//!
//! # Map
//!
//! | module | subject |
//! | --- | --- |
//! | [`cli`] | the program `tpg-train`: its commands and exit codes |
//! | [`evolution`] | tangled program graphs: genome, mutation, selection, runs |
//! | [`sac`] | soft actor-critic |
//! | [`targets`] | tasks over the reachable space |
//! | [`evaluate`] | evaluation: outcomes of a policy's episodes |
//! | [`hybrid`] | graphs and actors that share the arm: study and table |
//! | [`interrupt`] | Ctrl-C |
//! | [`picture`] | SVG, plots and the HTML page that contains them |
//! | [`files`] | atomic file writes |
//! | [`problems`] | `tpg-train problems` |
//! | [`progress`], [`run_args`] | the progress bar and the arguments of every run |
//! | [`report`] | runs in one HTML file |

pub mod cli;
pub mod evaluate;
pub mod evolution;
pub mod files;
pub mod hybrid;
pub mod interrupt;
pub mod picture;
pub mod problems;
pub mod progress;
pub mod report;
pub mod run_args;
pub mod sac;
pub mod targets;
