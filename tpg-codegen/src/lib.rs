//! Compiles tangled program graphs into C and `no_std` Rust, and proves the result equal to the graph.
//!
//! # Map
//!
//! | module | subject |
//! | --- | --- |
//! | [`cli`] | the program `tpg-codegen`: its commands and exit codes |
//! | [`options`], [`program`] | the options, and [`compile`], which turns a graph into a [`Program`] |
//! | [`ir`], [`passes`] | the lowered graph, and the passes that make it small and fast without changing its behaviour |
//! | [`explain`] | the removals of each pass, and the remaining bids as formulas |
//! | [`emit`] | from a program to text |
//! | [`quantise`], [`integers`] | from floats to whole numbers; whole numbers in integers, by proof |
//! | [`package`] | code as a package of an ecosystem: CMake, Arduino, Cargo and others |
//! | [`cost`], [`size`], [`report`] | the resources of the code: operations, bytes, stack |
//! | [`verify`] | compiles generated code and compares it with the interpreter |
//! | [`policy`] | quantised networks: `policy.q.json` into C and Rust |

pub mod cli;
pub mod cost;
pub mod emit;
pub mod explain;
pub mod integers;
pub mod ir;
pub mod options;
pub mod package;
pub mod passes;
pub mod policy;
pub mod program;
pub mod quantise;
pub mod report;
pub mod size;
pub mod verify;

pub use options::Options;
pub use program::{Program, compile};
