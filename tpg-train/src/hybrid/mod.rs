//! A tangled program graph and a soft actor-critic that share the arm: settings, study, table.
//!
//! The switch itself is [`tpg_runtime::hybrid`].
//!
//! | module | subject |
//! | --- | --- |
//! | [`setting`] | the parameters, and `hybrid.toml` |
//! | [`graph`] | a graph as a policy of the arm |
//! | [`actor`] | an actor from its file |
//! | [`trial`] | a hybrid on many tasks |

pub mod actor;
pub mod graph;
pub mod setting;
pub mod trial;
