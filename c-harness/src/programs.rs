//! The programs of the firmwares: what each is linked with in C, and what its output must be, in C and in Rust.

use crate::build::{self, Board};
use crate::line::Line;
use crate::{Failure, dodge, expected, network, size, table, worst};
use std::path::{Path, PathBuf};

/// The stack of a C program that the linker script keeps free, bytes.
pub(crate) const STACK: u64 = 2304;

/// A program in both languages.
pub(crate) struct Program {
    pub(crate) name: &'static str,
    /// The files of generated C that it is linked with.
    pub(crate) generated: &'static [&'static str],
    /// Bytes kept for the stack in C.
    pub(crate) stack: u64,
    check: fn(&Ran<'_>) -> Result<(), Failure>,
}

/// The output of a program under QEMU.
pub(crate) struct Ran<'a> {
    pub(crate) language: &'a str,
    pub(crate) image: &'a Path,
    pub(crate) lines: &'a [Line],
}

/// The files of a hybrid of each start.
const HYBRIDS: &[&str] = &["widowx_fs", "widowx_rs", "widowx_sac"];

const fn program(
    name: &'static str,
    generated: &'static [&'static str],
    check: fn(&Ran<'_>) -> Result<(), Failure>,
) -> Program {
    Program { name, generated, stack: STACK, check }
}

/// The control program, which runs on this machine and on every board, too.
pub(crate) static CONTROL: Program = program("control", HYBRIDS, |ran| {
    expected::check(ran.language, ran.lines)?;
    size::stack(ran, &CONTROL)?;
    worst::check(ran)
});

/// The table of sensor faults.
pub(crate) static FAULTS: Program = program("faults", HYBRIDS, |ran| table::check(ran.language, ran.lines));

/// The control step among balls, which needs more stack.
static DODGE: Program = Program {
    stack: 4096,
    ..program("dodge", &["dodge", "balls"], |ran| {
        dodge::check(ran)?;
        size::stack(ran, &DODGE)
    })
};

/// The control loop that a user copies.
pub(crate) static EXAMPLE: Program = program("example", &["widowx_fs", "widowx_sac"], |_| Ok(()));

/// The pendulum's network.
static NETWORK: Program = program("network", &["pendulum"], network::check);

/// Every program whose output is checked.
pub(crate) fn all() -> [&'static Program; 4] {
    [&CONTROL, &FAULTS, &DODGE, &NETWORK]
}

/// A language of the firmwares, and the builder of its images.
pub(crate) type Language = (&'static str, fn(&Program, Board) -> Result<Option<PathBuf>, Failure>);

pub(crate) const LANGUAGES: [Language; 2] = [("C", build::c), ("Rust", build::rust)];

impl Program {
    /// The file with `main`, in C.
    pub(crate) fn main(&self) -> String {
        if self.name == "example" { "example/main.c".to_owned() } else { format!("firmware-c/{}.c", self.name) }
    }

    /// Compares what it printed with this machine.
    pub(crate) fn check(&self, ran: &Ran<'_>) -> Result<(), Failure> {
        (self.check)(ran)
    }
}
