//! Building blocks of the benchmarks: policies with states to decide, programs that time these decisions, and a table
//! of the results.
//!
//! | module | subject |
//! | --- | --- |
//! | [`subject`] | a graph, and the states of its own episodes |
//! | [`variant`] | a way to run a graph: interpreter, C, Rust, by profile |
//! | [`program`] | a variant as a program that times itself |
//! | [`callgrind`] | instructions of such a program |
//! | [`table`] | ratios by graph, and their geometric mean |

pub mod callgrind;
pub mod program;
pub mod subject;
pub mod table;
pub mod variant;
