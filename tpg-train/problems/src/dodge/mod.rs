//! Reaching among moving balls: scenes that can be solved, the rules of a step, and the arm's behaviours as actions.
//!
//! | module | subject |
//! | --- | --- |
//! | [`config`] | the section `[problem]` of a configuration |
//! | [`scene`] | a task among balls, and where the balls are at any time |
//! | [`draw`] | the generator: every scene has a plan that solves it |
//! | [`walk`] | plans of any number of legs, followed step by step |
//! | [`mod@file`] | lists of scenes as CSV |
//! | [`episode`] | the rules of a step |
//! | [`environment`] | the problem as an [`Environment`](tpg_engine::Environment) |

pub mod config;
pub mod draw;
pub mod environment;
pub mod episode;
pub mod file;
pub mod scene;
pub mod walk;

pub use config::DodgeConfig;
pub use environment::Dodge;

use tpg_arm::WIDOWX;
use tpg_arm::dodge::{Body, WIDOWX_RADII};

/// The arm with its capsules.
pub static BODY: Body = Body::new(WIDOWX.to_f32(), WIDOWX_RADII);
