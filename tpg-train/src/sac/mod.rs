//! Soft actor-critic: trains the actor whose fixed-point form is `tpg_arm::sac`.
//!
//! | module | subject |
//! | --- | --- |
//! | [`agent`] | actor, critics, temperature and one update |
//! | [`replay`] | the transitions that updates draw from |
//! | [`lanes`] | the arm in parallel lanes, rewards included |
//! | [`failures`] | where the actor fails, for episodes to begin there again |
//! | [`config`] | presets and their TOML |
//! | [`training`] | the loop |
//! | [`weights`] | `policy.safetensors` and its contract |
//! | [`fixed`] | a trained actor in integers |
//! | [`comparison`] | how well integers do beside floating point |
//! | [`evaluate`] | `tpg-train eval --policy` and `tpg-train quantise` |
//! | [`import`] | actors of Stable-Baselines3 and CleanRL |
//! | [`checkpoint`] | a run under way as a file |
//! | [`command`] | `tpg-train sac` |
//! | [`policy`] | a trained actor as a policy |

pub mod agent;
pub mod checkpoint;
pub mod command;
pub mod comparison;
pub mod config;
pub mod evaluate;
pub mod failures;
pub mod fixed;
pub mod import;
pub mod lanes;
pub mod policy;
pub mod replay;
pub mod tensors;
pub mod training;
pub mod weights;
