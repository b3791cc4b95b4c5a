//! Compiles tangled program graphs into C and `no_std` Rust, and proves the result equal to the graph.
//!
//! # Map
//!
//! | module | subject |
//! | --- | --- |
//! | [`cli`] | the program `tpg-codegen`: its commands and exit codes |
//! | [`options`], [`program`] | what to generate, and [`compile`], which makes a [`Program`] of a graph |
//! | [`ir`], [`passes`] | the lowered graph, and what makes it small and fast without changing what it does |
//! | [`explain`] | what each pass removed, and what is left in formulas |
//! | [`emit`] | from a program to text |
//! | [`cost`], [`size`], [`report`] | what the code takes: operations, bytes, stack |
//! | [`verify`] | compiles what was generated and compares it with the interpreter |
//! | [`policy`] | networks in integers: `policy.q.json` into C and Rust |

pub mod cli;
pub mod cost;
pub mod emit;
pub mod explain;
pub mod ir;
pub mod options;
pub mod passes;
pub mod policy;
pub mod program;
pub mod report;
pub mod size;
pub mod verify;

pub use options::Options;
pub use program::{Program, compile};
