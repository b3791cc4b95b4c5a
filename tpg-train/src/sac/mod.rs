//! Soft actor-critic on any environment with outputs.
//!
//! | module | subject |
//! | --- | --- |
//! | [`agent`] | actor, critics, temperature and one update |
//! | [`interface`] | between an environment's values and a network's |
//! | [`config`], [`presets`] | the configuration of a run |
//! | [`training`] | the loop |
//! | [`checkpoint`] | a run under way as a file |
//! | [`contract`], [`weights`] | `policy.safetensors` |
//! | [`integers`] | a trained actor in integers, and how well it does |
//! | [`network`] | either kind of policy file, ready to act |
//! | [`motors`] | networks of an arm's motors |
//! | [`import`], [`foreign`] | `tpg-train import`: actors of Stable-Baselines3 and CleanRL |
//! | [`command`] | `tpg-train sac` |

pub mod agent;
pub mod checkpoint;
pub mod command;
pub mod config;
pub mod contract;
mod curve;
mod episode;
mod failures;
pub mod foreign;
pub mod import;
pub mod integers;
pub mod interface;
mod lanes;
mod log;
pub mod motors;
pub mod network;
pub(crate) mod policy;
pub mod presets;
mod replay;
pub mod tensors;
pub mod training;
pub mod weights;
