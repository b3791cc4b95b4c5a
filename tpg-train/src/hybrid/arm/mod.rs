//! The arm's part of hybrids: guards, distances in mm, and the paper's two parameters.
//!
//! The switch itself is [`tpg_arm::hybrid`].
//!
//! | module | subject |
//! | --- | --- |
//! | [`setting`] | the parameters, and the arm's `hybrid.toml` |
//! | [`graph`] | a graph as a policy of the arm |
//! | [`narrowed`] | an actor for an arm in any precision |
//! | [`trial`] | a hybrid on many tasks |
//! | [`study`] | the cells of a study |
//! | [`cost`] | time of a decision |
//! | [`choice`] | means over pairs, Pareto front, the setting to use |
//! | [`report`] | the study as a page |
//! | [`command`] | `tpg-train hybrid` with `fs` or `rs` |

pub mod choice;
pub mod command;
pub mod cost;
pub mod graph;
pub mod narrowed;
pub mod report;
pub mod setting;
pub mod study;
pub mod trial;
