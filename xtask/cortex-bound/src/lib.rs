//! The worst case of compiled code for a Cortex-M, found without running it: most instructions on any path through a
//! function and all that it calls, and most bytes of stack.
//!
//! It reads what `arm-none-eabi-objdump -dr` prints of an object or a linked image. Every instruction is a node of a graph;
//! predicated ones count whether or not their condition holds, as they take their slot either way. What has no bound is
//! refused, with the place and the reason: loops that no `--loop-bound` is given for, recursion, calls through registers
//! that no `--calls` is given for, jumps through tables that do not lie behind them, a stack pointer that moves by what only the run knows, callees
//! that are not in the object. What it was told ([`facts`]) it believes: whoever signs a bound signs those, too.
//!
//! What it does not know: how long an instruction takes, wait states of the memory, interrupts.
//!
//! | module | subject |
//! | --- | --- |
//! | [`listing`] | the text that objdump prints, as functions of instructions |
//! | [`instruction`] | what an instruction does to control flow and stack |
//! | `flow` | the control flow of one function |
//! | [`facts`] | what it is told: turns of loops, what calls through registers reach, how often functions run |
//! | `longest`, `path` | the longest path through it, and how often that comes where |
//! | [`analysis`] | a function with all that it calls |

pub mod analysis;
pub mod cli;
pub mod facts;
mod flow;
pub mod instruction;
pub mod listing;
mod longest;
mod path;
mod refusal;

pub use analysis::{Analyser, Bound, Loop, Share, Site};
pub use facts::{Calls, Limit, LoopBounds, Turns};
pub use listing::{Listing, disassemble};
pub use refusal::Refusal;
