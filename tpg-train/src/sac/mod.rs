//! Soft actor-critic on any environment with outputs.
//!
//! | module | subject |
//! | --- | --- |
//! | [`agent`] | actor, critics, temperature and one update |
//! | [`replay`] | the transitions that updates draw from |
//! | [`interface`] | between an environment's values and a network's |
//! | [`episode`] | a whole episode |
//! | [`lanes`] | training episodes side by side |
//! | [`failures`] | places where the actor fails, for episodes to begin there again |
//! | [`policy`] | a trained actor as a policy |
//! | [`config`], [`presets`] | the configuration of a run |
//! | [`training`] | the loop |
//! | [`checkpoint`] | a run under way as a file |
//! | [`contract`], [`weights`] | `policy.safetensors` |
//! | [`integers`] | a trained actor in integers, and how well it does |
//! | [`network`] | either kind of policy file, ready to act |
//! | [`motors`] | networks of an arm's motors |
//! | [`import`], [`foreign`] | `tpg-train import`: actors of Stable-Baselines3 and CleanRL |
//! | [`command`], [`log`] | `tpg-train sac` and its logs |

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
