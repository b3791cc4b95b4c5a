//! The arm's actors: networks with a preference for each motor, in floating point and in integers.
//!
//! | module | subject |
//! | --- | --- |
//! | [`policy`] | an actor as a policy of the arm |
//! | [`fixed`] | an actor in integers |
//! | [`file`](mod@file) | either of them from its file |
//! | [`version1`] | actors that earlier versions wrote |
//! | [`comparison`] | integers beside floating point |
//! | [`import`] | `tpg-train import` |

pub mod comparison;
pub mod file;
pub mod fixed;
pub mod import;
pub mod policy;
pub mod version1;
