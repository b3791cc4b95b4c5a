//! The paper's recorded trajectories, replayed step by step.
//!
//! The paper's arithmetic is confined to this crate: `f64`, a KDL matrix chain evaluated in one exact order
//! ([`chain`]), the collision test's own angles ([`plane`]), the system's libm, and the artifact's rules for ending an
//! episode ([`episode`]). Geometry, limits, collision test and the rule of one step are the runtime's. A mathematically
//! equal closed form breaks 8 % of the recorded rows, so nothing here may be simplified; on a libm other than glibc's a
//! row may differ.
//!
//! | module | subject |
//! | --- | --- |
//! | [`chain`] | forward kinematics, bit for bit |
//! | [`plane`] | the arm plane of the collision test, bit for bit |
//! | [`episode`] | episodes by the artifact's rules |
//! | [`data`] | recorded files |
//! | [`binding`] | the arm's sources and moves behind a recorded graph |
//! | [`conformance`] | the folder of recorded data, made from a clone of the artifact |
//! | [`actor`] | recorded actors: files and outputs |
//! | [`limits`] | action limits of the recorded episodes |
//! | [`replay`] | all rows of a file in lockstep, compared with the recording |
//! | [`table`] | `tpg-paper table2` |
//! | [`cli`] | the command line |

pub mod actor;
pub mod binding;
pub mod chain;
pub mod cli;
pub mod conformance;
pub mod data;
pub mod episode;
pub mod limits;
pub mod plane;
pub mod replay;
pub mod table;
