//! The planar four-joint arm: its environment, its tasks, and classical controllers as baselines.
//!
//! | module | subject |
//! | --- | --- |
//! | [`environment`] | the arm as an [`Environment`](tpg_engine::Environment), many episodes in parallel |
//! | [`config`] | the arm's section of a configuration |
//! | [`motors`] | the arm by its four motors, for policies with outputs |
//! | [`description`] | an arm as a section of a configuration |
//! | [`arms`] | arms that are known by name |
//! | [`import`](mod@import) | an arm from its URDF |
//! | [`targets`] | tasks over the reachable space |
//! | [`ik`] | inverse kinematics: poses that solve a task |
//! | [`planner`] | classical controllers |
//! | [`problem`] | scores and endings |
//! | [`evaluation`] | results of one policy on many tasks |

pub mod arms;
pub mod config;
pub mod description;
pub(crate) mod drawing;
pub mod environment;
pub mod evaluation;
pub mod ik;
pub mod import;
pub mod motors;
pub mod planner;
pub mod problem;
pub mod targets;

pub use config::ArmConfig;
pub use description::ArmDescription;
pub use environment::ArmEnvironment;
pub use problem::{ArmProblem, ArmTask};
