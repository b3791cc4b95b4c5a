//! The soft actor-critic's policy: features, network, decision.
//!
//! A trained actor answers one *preference* per joint, the mean of its Gaussian before the tanh. Where actions are
//! discrete the tanh and the rounding behind it are monotone, so thresholds replace both ([`Decision`]); only the
//! features need floating point.
//!
//! | step | item | numbers |
//! | --- | --- | --- |
//! | observation to features | [`features`] | `f32` |
//! | features to preferences | a network, [`fixed`]; as it lies in flash, [`packed`] | `f32` in training, integers on the target |
//! | preferences to a move | [`Decision`] | whatever the network answers in |

mod decision;
mod features;
pub mod fixed;
pub mod packed;

pub use decision::{Actions, Decision, Mask};
pub use features::{FEATURE_CONTRACT, FEATURE_NAMES, FEATURES, features};
