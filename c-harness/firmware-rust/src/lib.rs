//! Shared parts of the firmware's programs: output, counting of instructions, records of what was done.

#![no_std]

mod platform;
#[path = "../../src/record.rs"]
pub mod record;
mod report;
mod tally;

pub use platform::{Counter, exit, paint_stack, run, stack_used};
pub use report::Report;
pub use tally::Tally;
