//! An arm among moving balls: distances and their gradients, behaviours, the search for a plan, the guard.
//!
//! Lengths in mm, angles in motor ticks, times in steps of at most 3 ticks a joint; all in `f32`. Every function is bounded:
//! no loop depends on anything but the number of balls and the looks of the search.
//!
//! | module | subject |
//! | --- | --- |
//! | (root) | [`Ball`], [`Body`]: clearance, nearest point, gradient by the joints |
//! | [`plan`] | a walk to a goal, at once or by way of another pose |
//! | [`Behaviour`] | what a policy chooses among |
//! | [`Scout`] | the search: a few looks at a few plans in every step |
//! | [`guarded`] | the guard: a step that would be hit is replaced, none is against limits, table or base |
//! | [`DodgeSource`] | what a policy sees |
//! | [`Dodger`] | all of that around a policy |
//! | [`DodgeControl`] | a control step on a real arm, whose readings may be wrong |

mod ball;
mod behaviour;
mod body;
mod control;
mod dodger;
mod guard;
pub mod plan;
mod scout;
mod sources;

pub use ball::Ball;
pub use behaviour::{BALLS, Behaviour, FIELD, Field, View, away};
pub use body::{Body, CAPSULES, Nearest, Outline, Posture, WIDOWX_RADII};
pub use control::{Chooser, DodgeControl, DodgeStep, GOALS};
pub use dodger::{Dodger, DodgerSettings};
pub use guard::{Guarded, guarded, permitted};
pub use scout::{Fate, HORIZON, Scout};
pub use sources::{DodgeSource, VALUES};
