//! Flash and RAM of the control loop that a user copies, on an STM32F405.

use crate::Failure;
use crate::build::{self, SMALL};
use crate::line::Line;
use crate::programs::{EXAMPLE, Program, STACK};
use serde::Deserialize;
use tpg_codegen::size;

/// Compares the stack that a program has written to with what there is for it.
pub(crate) fn stack(Program { name, stack, .. }: &Program, lines: &[Line]) -> Result<(), Failure> {
    let used = lines.iter().find(|line| line.words == ["done"]).map_or(0, |line| line.number("stack"));
    println!("{name}: {used} bytes of stack were written to");
    // Only as much as there is was painted: a program that has written to all of it may have written beyond.
    if used == 0 || used >= *stack {
        return Err(Failure(format!("{name}: {used} bytes of stack, accepted: less than {stack}")));
    }
    Ok(())
}

/// `sizes.toml`.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct SizeBudget {
    /// Bytes of flash.
    flash: u64,
    /// Bytes of RAM, stack included.
    ram: u64,
}

/// Prints sizes and compares them with the budget.
pub(crate) fn check() -> Result<(), Failure> {
    let budget: SizeBudget = build::committed("sizes.toml")?;
    println!("{:<28} {:>8} {:>8} {:>8}", "on an STM32F405, bytes", "flash", "data", "stack");
    let Some(image) = build::board(&EXAMPLE, SMALL)? else { return Ok(()) };
    let size = size::measure(&build::read(&image)?)?;
    let (flash, ram) = (size.flash(), size.ram());
    println!("{:<28} {flash:>8} {ram:>8} {STACK:>8}", "the control loop");
    println!("{:<28} {:>8} {:>8}", "budget", budget.flash, budget.ram);
    if flash > budget.flash || ram + STACK > budget.ram {
        return Err(Failure::new("the control loop does not fit its budget"));
    }
    Ok(())
}
