//! The paper's recorded trajectories, replayed step by step.
//!
//! The paper's arithmetic stays in this one crate: `f64`, a KDL matrix chain evaluated in one exact order ([`chain`]), the
//! collision test's own angles ([`plane`]), the system's libm, and the artifact's way of ending an episode ([`episode`]).
//! The geometry, the limits, the collision test and the rule of one step are the
//! runtime's. A mathematically equal closed form already breaks 8 % of the recorded rows, so nothing here may be
//! simplified; on a libm other than glibc's a row may differ.
//!
//! | module | subject |
//! | --- | --- |
//! | [`chain`] | forward kinematics, bit for bit |
//! | [`plane`] | the arm plane of the collision test, bit for bit |
//! | [`episode`] | an episode as the artifact kept its books |
//! | [`data`] | the recorded files |
//! | [`sac`] | the recorded actors' episodes |
//! | [`actor`] | a recorded actor: its file, its answers |
//! | [`hybrid`] | the recorded graphs and actors together |
//! | [`torch_random`] | PyTorch's random numbers |
//! | [`limits`] | action limits of the recorded episodes |
//! | [`replay`] | all rows of a file in lockstep, compared with what was recorded |
//! | [`fk`] | forward kinematics and collisions against recorded values, the runtime's fast paths too |
//! | [`clearance`] | how near an arm is to changing its collision answer |
//! | [`command`] | `tpg-paper replay` |

pub mod actor;
pub mod chain;
pub mod clearance;
pub mod cli;
pub mod data;
pub mod episode;
pub mod fk;
pub mod hybrid;
pub mod limits;
pub mod plane;
pub mod replay;
pub mod replay_command;
pub mod sac;
pub mod table;
pub mod torch_random;
