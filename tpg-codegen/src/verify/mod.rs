//! Compiles generated code and compares it with the interpreter, state by state.

mod build;
mod compare;
mod process;
mod proof;

pub use build::{Batch, BuildError, Workshop, c_command, compile, runtime_library, rustc};
pub(crate) use build::{c_compiler, write_runtime};
pub use compare::{Comparison, Difference, compare};
pub use process::Process;
pub use proof::{Proof, Unproven};
