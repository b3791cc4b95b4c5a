//! Static worst-case analysis of compiled code for a Cortex-M, a RISC-V or an AVR: maximum instructions, of an AVR cycles, on any
//! path through a function and its callees, and maximum bytes of stack.
//!
//! The input is the output of `objdump -dr` for an object or a linked image, of a RISC-V or an AVR a linked one. Every instruction is
//! a node of a graph; predicated ones count whether or not their condition holds, since they take their slot either way. Code
//! without a bound is rejected, with the place and the reason: loops without a `--loop-bound`, recursion, calls through
//! registers without `--calls`, jumps through tables that are not found, a stack pointer that changes by an amount known
//! only at run time, callees that are not in the object. The supplied [`facts`], and those about the loops of GCC's
//! arithmetic, are trusted: a bound is only as reliable as they are. So is that a table of jumps is the
//! one whose address goes into the jump, and ends where the code refers to something else or an entry leads out of the
//! function, and that a `bl` into the own function is a far jump.
//!
//! Not covered: the duration of an instruction except on an AVR, wait states of the memory, interrupts.
//!
//! | module | subject |
//! | --- | --- |
//! | [`listing`] | objdump's output, as functions of instructions |
//! | [`instruction`] | effects of an instruction on control flow and stack |
//! | `flow`, `table` | control flow of one function, and its tables of jumps |
//! | [`facts`] | facts supplied by the user: loop bounds, targets of calls through registers |
//! | `longest` | the longest path through it |
//! | [`analysis`] | a function together with its callees |

pub mod analysis;
pub mod facts;
mod flow;
pub mod instruction;
pub mod listing;
mod longest;
mod refusal;
mod table;

pub use analysis::{Analyser, Bound};
pub use facts::{Calls, LoopBounds, Turns};
pub use listing::{Listing, Site, disassemble};
pub use refusal::Refusal;
