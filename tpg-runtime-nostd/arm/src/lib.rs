//! Robot arms for learned policies: arms as data, kinematics, observation, episodes.
//!
//! ```
//! use tpg_arm::cycle::Brent;
//! use tpg_arm::episode::{Episode, Outcome, ReachTask};
//! use tpg_arm::observation::Observation;
//! use tpg_arm::{Joint, Move, WIDOWX};
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
//! let problem = ReachTask { start: WIDOWX.home, target: [-250.0, 239.2, 267.0], tolerance: 3.0, max_actions: 1707 };
//! let summary = Episode::new(&WIDOWX, problem, Brent::new()).run(&TurnBase, |_pose| ());
//! assert_eq!(summary.outcome, Outcome::Reached);
//! ```
//!
//! # Map
//!
//! | module | subject |
//! | --- | --- |
//! | (root) | the [`Arm`] as data, joint limits, collision test, the rule of one step |
//! | [`kinematics`] | motor positions to points, by table or by libm |
//! | [`observation`] | the 13 values a policy sees, and a graph's data sources |
//! | [`frame`] | quantities derived from an observation: polar errors, gradients, clearances |
//! | [`binding`] | a graph's names and numbers as sources and moves |
//! | [`cycle`] | detection of poses where the arm has been before |
//! | [`dodge`] | the arm among moving balls: distances, behaviours, the search for a plan |
//! | [`episode`] | one episode and how it ended |
//! | [`hybrid`] | two policies that share an arm: the one that drives, and when they change |
//! | [`sensors`] | readings that a control step refuses, and the watch over stuck motors |
//! | [`sac`] | the soft actor-critic's features, its network in integers, its decision |
//!
//! No heap, no panic, no `unsafe`; builds for `thumbv7em-none-eabihf` and `thumbv6m-none-eabi`. MSRV 1.89.

#![no_std]

mod arm;
pub mod binding;
pub mod cycle;
pub mod dodge;
pub mod episode;
pub mod frame;
pub mod hybrid;
pub mod kinematics;
pub mod observation;
pub mod sac;
pub mod sensors;

pub use arm::{
    Arm, ArmError, BaseEdge, Collision, Invalid, JOINTS, Joint, JointRange, Links, Move, Play, Pose, Shapes, Step,
    TICKS_PER_TURN, WIDOWX,
};
