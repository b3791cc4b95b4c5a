//! The runtime of learned robot-arm policies: what trainer, interpreter, generated code and firmware share.
//!
//! Every meaning has its one definition here. A trajectory in training, in the interpreter, in generated Rust, in
//! generated C and on a Cortex-M4 is the same list of integers because they all stand on this crate.
//!
//! ```
//! use tpg_runtime::arm::{Joint, Move, WIDOWX};
//! use tpg_runtime::cycle::Brent;
//! use tpg_runtime::episode::{Episode, Outcome, Problem};
//! use tpg_runtime::observation::Observation;
//! use tpg_runtime::policy::Policy;
//!
//! /// Turns the base until the hand is on the target's side.
//! struct TurnBase;
//!
//! impl Policy for TurnBase {
//!     type State = Observation<f64>;
//!     type Action = Move;
//!
//!     fn decide(&self, seen: &Observation<f64>) -> Move {
//!         Move::single(Joint(0), if seen.difference[0] < 0.0 { 3 } else { -3 })
//!     }
//! }
//!
//! let problem = Problem { start: WIDOWX.home, target: [-250.0, 239.2, 267.0], tolerance: 3.0, max_actions: 1707 };
//! let summary = Episode::new(&WIDOWX, problem, Brent::new()).run(&TurnBase, |_pose| ());
//! assert_eq!(summary.outcome, Outcome::Reached);
//! ```
//!
//! # Map
//!
//! | module | subject |
//! | --- | --- |
//! | [`arm`] | the arm as data, joint limits, collision test, the rule of one step |
//! | [`kinematics`] | motor positions to points, by table or by libm |
//! | [`observation`] | the 13 values a policy sees, and a graph's data sources |
//! | [`frame`] | what follows from an observation: polar errors, gradients, clearances |
//! | [`binding`] | a graph's names and numbers as sources and moves |
//! | [`policy`] | the [`Policy`](policy::Policy) trait that generated code implements |
//! | [`ops`] | the instruction set, and sin, cos, ln, exp with the same bits everywhere |
//! | [`cycle`] | has the arm been here before? |
//! | [`episode`] | one episode and how it ended |
//! | [`hybrid`] | two policies that share an arm: who drives, and when they change |
//! | [`sac`] | the soft actor-critic's features, its network in integers, its decision |
//! | [`scalar`] | `f32` and `f64` |
//!
//! # Features
//!
//! | feature | effect |
//! | --- | --- |
//! | `std` | [`ops::System`] is the platform's libm instead of the crate `libm` |
//! | `standalone` | the text of the files that generated code needs, for tools that compile it |
//!
//! No heap, no panic, no `unsafe`; builds for `thumbv7em-none-eabihf` and `thumbv6m-none-eabi`. MSRV 1.89.

#![no_std]

#[cfg(feature = "std")]
extern crate std;

pub mod arm;
pub mod binding;
pub mod cycle;
pub mod episode;
pub mod frame;
pub mod hybrid;
pub mod kinematics;
pub mod observation;
pub mod ops;
pub mod policy;
pub mod sac;
pub mod scalar;
#[cfg(feature = "standalone")]
pub mod standalone;
