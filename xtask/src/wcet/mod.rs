//! The worst case of compiled code for a Cortex-M, found without running it: most instructions on any path through a
//! function and all that it calls, and most bytes of stack.
//!
//! It reads what `arm-none-eabi-objdump -dr` prints of an object or a linked image. Every instruction is a node of a graph;
//! predicated ones count whether or not their condition holds, as they take their slot either way. What has no bound is
//! refused, with the place and the reason: loops that no `--loop-bound` is given for, recursion, calls and jumps through
//! registers or tables, a stack pointer that moves by what only the run knows, callees that are not in the object.
//!
//! What it does not know: how long an instruction takes, wait states of the memory, interrupts.
//!
//! | module | subject |
//! | --- | --- |
//! | [`listing`] | the text that objdump prints, as functions of instructions |
//! | [`instruction`] | what an instruction does to control flow and stack |
//! | `flow` | the control flow of one function |
//! | `longest` | the longest path through it |
//! | [`analysis`] | a function with all that it calls |

pub mod analysis;
mod flow;
pub mod instruction;
pub mod listing;
mod longest;
mod refusal;

pub use analysis::{Analyser, Bound, LoopBounds, Site};
pub use listing::{Listing, disassemble};
pub use refusal::Refusal;
