//! Hybrids: a tangled program graph and a soft actor-critic that share the arm. Settings, study, table.
//!
//! The switch itself is [`tpg_arm::hybrid`].
//!
//! | module | subject |
//! | --- | --- |
//! | [`setting`] | the parameters, and `hybrid.toml` |
//! | [`graph`] | a graph as a policy of the arm |
//! | [`narrowed`] | an actor for an arm in any precision |
//! | [`trial`] | a hybrid on many tasks |
//! | [`study`] | every pair under every setting |
//! | [`cost`] | time of a decision |
//! | [`choice`] | means over pairs, Pareto front, the setting to use |
//! | [`report`] | the study as a page |
//! | [`command`] | `tpg-train hybrid` |

pub mod choice;
pub mod command;
pub mod cost;
pub mod graph;
pub mod narrowed;
pub mod report;
pub mod setting;
pub mod study;
pub mod trial;
