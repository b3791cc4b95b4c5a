//! Compiles tangled program graphs into C and `no_std` Rust, and proves the result equal to the graph.
//!
//! # Map
//!
//! | module | subject |
//! | --- | --- |
//! | [`cli`] | the program `tpg-codegen`: its commands and exit codes |
//! | [`mod@graph`] | a policy with everything that decides its behaviour: `graph.json` |
//! | [`import`], [`export`] | GEGELATI's `.dot`, and other formats than `graph.json` |
//! | [`interpret`] | the reference that everything generated is compared with |
//! | [`in_arithmetic_of`] | from the arithmetic that a graph names to the types that compute in it |
//! | [`conversion`] | a graph in another scalar type, and how often it still takes the same action |
//! | [`ir`], [`passes`] | the lowered graph, and what makes it small and fast without changing what it does |
//! | [`explain`] | what each pass removed, and what is left in formulas |
//! | [`emit`] | from the lowered graph to text |
//! | [`cost`], [`size`], [`report`] | what the code takes: operations, bytes, stack |
//! | [`engine`], [`states`], [`trace`], [`sample`] | who decides, and on what: states, recorded ones, random graphs |
//! | [`verify`] | compiles what was generated and compares it with the interpreter |
//! | [`policy`] | networks in integers: `policy.q.json` into C and Rust |
//! | [`error`], [`output`] | what is wrong with an input; files that are whole or not there |

mod arithmetic;
pub mod cli;
pub mod conversion;
pub mod cost;
pub mod emit;
pub mod engine;
pub mod error;
pub mod explain;
pub mod export;
pub mod graph;
pub mod import;
pub mod interpret;
pub mod ir;
pub mod output;
pub mod passes;
pub mod policy;
pub mod report;
pub mod sample;
pub mod size;
pub mod states;
pub mod trace;
pub mod verify;
