//! Trains robot-arm policies, and replays the recorded episodes of the paper's own.
//!
//! # Map
//!
//! | module | subject |
//! | --- | --- |
//! | [`cli`] | the program `tpg-train`: its commands and exit codes |
//! | [`conformance`] | recorded trajectories, replayed in the paper's arithmetic |

pub mod cli;
pub mod conformance;
