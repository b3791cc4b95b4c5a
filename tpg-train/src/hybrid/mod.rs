//! Hybrids: a tangled program graph drives, and a network helps where the graph is stuck or lost. Settings and study.
//!
//! The switch itself is [`tpg_runtime::switch`]. It hands over when the distance to the goal has grown too much (drift),
//! when it has not fallen for too long (stall), or when the graph returns to an earlier state (cycle).
//!
//! | module | subject |
//! | --- | --- |
//! | [`setting`], [`span`] | the parameters, and `hybrid.toml` |
//! | [`shared`] | the problems that a graph and a network can share |
//! | [`rollout`] | a hybrid, or one of its parts, on many tasks |
//! | [`asking`] | one more action for a graph: ask the network, at a price |
//! | [`cells`] | the rows of a study |
//! | [`choice`] | the setting to use |
//! | [`command`] | `tpg-train hybrid`: every pair under every setting, in a folder |

pub(crate) mod asking;
pub(crate) mod cells;
pub(crate) mod choice;
pub(crate) mod command;
pub(crate) mod rollout;
pub(crate) mod setting;
pub(crate) mod shared;
pub(crate) mod span;
