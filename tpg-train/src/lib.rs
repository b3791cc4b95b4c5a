//! Trains robot-arm policies, and replays the recorded episodes of the paper's own.
//!
//! # Map
//!
//! | module | subject |
//! | --- | --- |
//! | [`cli`] | the program `tpg-train`: its commands and exit codes |
//! | [`environments`] | the arm and a pendulum |
//! | [`evolution`] | tangled program graphs: genome, mutation, selection, runs |
//! | [`sac`] | soft actor-critic |
//! | [`targets`] | tasks over the reachable space |
//! | [`trial`] | one actor on many tasks |
//! | [`evaluate`] | how a policy's episodes end |
//! | [`hybrid`] | a graph and an actor that share the arm: study and table |
//! | [`interrupt`] | Ctrl-C |
//! | [`ik`] | goals of the inverse kinematics, for training only |
//! | [`planner`] | classical yardsticks that learn nothing |
//! | [`picture`] | SVG, plots and the page that holds them |
//! | [`files`] | files that are whole or not there |
//! | [`report`] | runs in one HTML file |
//! | [`conformance`] | recorded trajectories, replayed in the paper's arithmetic |

pub mod cli;
pub mod conformance;
pub mod environments;
pub mod evaluate;
pub mod evolution;
pub mod files;
pub mod hybrid;
pub mod ik;
pub mod interrupt;
pub mod picture;
pub mod planner;
pub mod report;
pub mod sac;
pub mod targets;
pub mod trial;
