//! Soft actor-critic on any environment with outputs.
//!
//! | module | subject |
//! | --- | --- |
//! | [`interface`] | between an environment's values and a network's |
//! | [`config`], [`presets`] | the configuration of a run |
//! | [`training`] | the loop |
//! | [`checkpoint`] | a run under way as a file |
//! | [`contract`], [`weights`] | `policy.safetensors` |
//! | [`integers`] | a trained actor in integers |
//! | [`network`] | either kind of policy file, ready to act |
//! | [`import`], [`foreign`] | `tpg-train import`: actors of Stable-Baselines3 and CleanRL |
//! | [`command`] | `tpg-train sac` |

mod checkpoint;
pub(crate) mod command;
pub(crate) mod config;
pub(crate) mod contract;
mod failures;
pub mod foreign;
pub(crate) mod import;
pub(crate) mod integers;
pub(crate) mod interface;
mod lanes;
pub(crate) mod network;
pub(crate) mod policy;
pub(crate) mod presets;
mod replay;
pub(crate) mod tensors;
pub(crate) mod training;
pub mod weights;
