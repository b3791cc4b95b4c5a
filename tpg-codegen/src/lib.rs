//! Compiles tangled program graphs into C and `no_std` Rust, and proves the result equal to the graph.
//!
//! [`compile`] turns a graph into a [`Program`] with the [`Options`] of a compilation; everything else reads that program.
//!
//! ```
//! use tpg_codegen::emit::{Code, Language};
//! use tpg_codegen::{Options, compile};
//! use tpg_graph::sample::{self, Shape};
//!
//! let graph = sample::graph(&Shape::default(), 7);
//! let code = Code::of(compile(&graph, &Options::new("arm".parse()?), Language::C));
//! assert_eq!(code.files[1].name, "arm.c");
//! # Ok::<(), String>(())
//! ```
//!
//! # Map
//!
//! | module | subject |
//! | --- | --- |
//! | [`emit`] | from a graph to text |
//! | [`verify`] | compiles generated code and compares it with the interpreter |
//! | [`report`] | the resources of the code, the policy as formulas and as a table |
//! | [`size`] | bytes and stack of compiled code |
//! | [`quantise`] | from floats to whole numbers, which compile to integers |
//! | [`policy`] | quantised networks: `policy.q.json` into C and Rust |
//! | [`Cli`], [`shell`] | the program `tpg-codegen`; completions and manual pages of any program |

mod cli;
mod cost;
pub mod emit;
mod explain;
mod formula;
mod infix;
mod integers;
mod ir;
mod options;
mod package;
mod passes;
pub mod policy;
mod program;
pub mod quantise;
pub mod report;
mod shape;
pub mod size;
pub mod verify;

pub use cli::{Cli, shell};
pub use options::Options;
pub use program::{Program, compile};
