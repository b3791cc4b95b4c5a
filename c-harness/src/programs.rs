//! The programs of the firmwares: what each is linked with, and what its output must be.

use crate::line::Line;
use crate::{Failure, dodge, expected};

/// The stack of a program that the linker script keeps free, bytes.
pub(crate) const STACK: u64 = 2304;

/// A program.
pub(crate) struct Program {
    pub(crate) name: &'static str,
    /// The file with `main`.
    pub(crate) main: &'static str,
    /// The files of generated C that it is linked with.
    pub(crate) generated: &'static [&'static str],
    /// Bytes kept for the stack.
    pub(crate) stack: u64,
    /// Compares what an image printed with this machine.
    pub(crate) check: fn(&[Line]) -> Result<(), Failure>,
}

/// The control program, which runs on this machine and on every board, too.
pub(crate) static CONTROL: Program = Program {
    name: "control",
    main: "firmware-c/control.c",
    generated: &["widowx_fs", "widowx_rs", "widowx_sac"],
    stack: STACK,
    check: |lines| expected::check("firmware", lines),
};

/// The control step among balls, which needs more stack.
static DODGE: Program = Program {
    name: "dodge",
    main: "firmware-c/dodge.c",
    generated: &["dodge", "balls"],
    stack: 4096,
    check: dodge::check,
};

/// The control loop that a user copies.
pub(crate) static EXAMPLE: Program = Program {
    name: "example",
    main: "example/main.c",
    generated: &["widowx_fs", "widowx_sac"],
    stack: STACK,
    check: |_| Ok(()),
};

/// Every program whose output is checked.
pub(crate) static CHECKED: [&Program; 2] = [&CONTROL, &DODGE];
