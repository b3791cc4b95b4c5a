//! Compiles tangled program graphs into C and `no_std` Rust, and proves the result equal to the graph.
pub mod emit;
pub mod engine;
pub mod error;
pub mod graph;
pub mod interpret;
pub mod ir;
pub mod passes;
pub mod states;
pub mod verify;
