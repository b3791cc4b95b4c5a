//! Compiles tangled program graphs into C and `no_std` Rust, and proves the result equal to the graph.
pub mod cli;
pub mod emit;
pub mod engine;
pub mod error;
pub mod export;
pub mod graph;
pub mod import;
pub mod interpret;
pub mod ir;
pub mod output;
pub mod passes;
pub mod policy;
pub mod sample;
pub mod size;
pub mod states;
pub mod verify;
