//! The firmwares, checked: `cargo xtask qemu`, `cores` and `lint` run this.
//!
//! | module | subject |
//! | --- | --- |
//! | [`programs`] | the programs |
//! | [`problems`] | which episodes, and how graph and network share the arm |
//! | [`build`] | the firmwares |
//! | [`dodge`] | the control step among balls, on test scenes |
//! | [`emulate`] | QEMU |
//! | [`expected`] | the host's trajectories |
//! | [`record`] | hashes of what firmwares do |
//! | [`mod@cores`] | the shipped policies and the hybrid on every core |
//! | [`embassy`] | the example in Embassy |
//! | [`costs`] | instructions beside `costs.toml` |
//! | [`symbols`] | what must not be in an image |
//! | [`lint`] | linters on the C that is not generated |
//! | [`size`] | flash and RAM beside `sizes.toml` |

mod build;
mod cores;
mod costs;
mod dodge;
mod embassy;
mod emulate;
mod expected;
mod line;
mod lint;
mod problems;
mod programs;
mod record;
mod size;
mod symbols;

use build::{COUNTED, SMALL};
use clap::{Parser, Subcommand};
use costs::Costs;
use programs::{CHECKED, CONTROL};
use std::error::Error;
use std::fmt::Display;
use std::path::Path;
use std::process::{Command, ExitCode};

/// A reason that a check failed or could not be done.
#[derive(Debug)]
pub(crate) struct Failure(String);

impl<E: Error> From<E> for Failure {
    fn from(error: E) -> Self {
        Self::new(error)
    }
}

impl Failure {
    /// From whatever says why.
    pub(crate) fn new<E: Display>(error: E) -> Self {
        Self(error.to_string())
    }

    /// With the file.
    pub(crate) fn at<E: Display>(path: &Path, error: E) -> Self {
        Self(format!("{}: {error}", path.display()))
    }

    /// From every line of `messages`; no failure without one.
    pub(crate) fn unless_none(messages: Vec<String>) -> Result<(), Self> {
        if messages.is_empty() { Ok(()) } else { Err(Self(messages.join("\n"))) }
    }
}

/// Builds the firmwares, runs them under QEMU and compares them with the host and with committed figures.
#[derive(Debug, Parser)]
#[command(bin_name = "cargo xtask")]
struct HarnessCli {
    #[command(subcommand)]
    command: Check,
}

#[derive(Debug, Subcommand)]
enum Check {
    /// Flash, RAM, trajectories, instructions and stack of the firmwares
    Qemu {
        /// Write costs.toml instead of comparing with it
        #[arg(long)]
        update: bool,
    },
    /// Generated C and Rust and the hybrid on every core: as on the host, flash and instructions as in cores.toml
    Cores {
        /// Write cores.toml and docs/cores.md instead of comparing with them
        #[arg(long, conflicts_with = "only")]
        update: bool,
        /// Only cores and boards with this in their name
        #[arg(long, value_name = "TEXT", default_value = "", hide_default_value = true)]
        only: String,
    },
    /// clang-tidy, and cppcheck with its MISRA addon, on the firmwares' and the example's C
    Lint,
}

fn main() -> ExitCode {
    let result = match HarnessCli::parse().command {
        Check::Qemu { update } => qemu(update),
        Check::Cores { update, only } => cores::check(update, &only),
        Check::Lint => lint::sees_what_is_bad().and_then(|()| lint::check()),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(Failure(message)) => {
            eprintln!("FAILED: {message}");
            ExitCode::FAILURE
        }
    }
}

fn qemu(update: bool) -> Result<(), Failure> {
    size::check()?;
    if !tpg_testing::tool("qemu-system-arm", "qemu-system-arm", "the firmwares under QEMU") {
        return Ok(());
    }
    if let Some(image) = build::host(&CONTROL)? {
        expected::check("C on this machine", &emulate::until_done(&mut Command::new(image))?)?;
    }
    let mut costs = Costs::new();
    let mut all = true;
    for program in CHECKED {
        let Some(image) = build::board(program, COUNTED)? else {
            all = false;
            break;
        };
        symbols::check(&image)?;
        let lines = emulate::run(COUNTED, &image)?;
        (program.check)(&lines)?;
        size::stack(program, &lines)?;
        costs.add(&lines);
    }
    // The board with little memory runs the same episodes to the same ends.
    if let Some(image) = build::board(&CONTROL, SMALL)? {
        expected::check(SMALL, &emulate::run(SMALL, &image)?)?;
    }
    embassy::check()?;
    costs.print();
    if update && all {
        return costs.commit();
    }
    Failure::unless_none(costs.differences()?)
}
