//! Proves that C or machine code decides like a tangled program graph, for every input, NaN and infinities included.
//!
//! The crate shares nothing with the compiler that it checks: it has its own reader of `graph.json`, its own reader of C and its own
//! decoder of machine code, and depends on no other crate of the workspace. Both sides of a proof are built in one table of
//! [terms](term): what is one node is equal, and what is left is decided over the order of the numbers that are compared.

pub mod c;
mod code;
mod elf;
pub mod execute;
pub mod graph;
pub mod input;
pub mod machine;
mod maths;
mod order;
pub mod product;
pub mod proof;
mod states;
pub mod term;
mod thumb;
