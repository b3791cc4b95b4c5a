//! `cargo xtask`: every CI step, for local use.

mod book;
mod check;
mod dist;
mod figures;
mod fuzz;
mod nightly;
mod python;
mod setup;
mod summary;
mod venv;
mod web;

use XtaskCommand::*;
use check::{Run, run};
use clap::{Parser, Subcommand};
use std::io;
use std::path::PathBuf;
use std::process::ExitCode;
use tpg_testing::library;

/// Sets a machine up for this repository and tests it.
#[derive(Debug, Parser)]
#[command(bin_name = "cargo xtask")]
struct XtaskCli {
    #[command(subcommand)]
    command: XtaskCommand,
}

#[derive(Clone, Debug, Subcommand)]
enum XtaskCommand {
    /// Install what is missing: compilers, linters and emulator (apt-get), cross targets (rustup)
    Setup,
    /// Run the tests of every crate; long ones are shortened
    Test,
    /// Run everything else: format, clippy, documentation, supply chain, no_std builds, firmwares under QEMU, lint of
    /// generated C
    Check,
    /// Make libtpg_runtime.a for this machine and for Cortex-M, with header, CMake and pkg-config files
    Library {
        /// Targets; all of them by default
        #[arg(long)]
        target: Vec<String>,
        /// Output folder; by default `tpg_runtime` in cargo's target folder
        #[arg(short, long)]
        out: Option<PathBuf>,
    },
    /// Run the firmware under QEMU: trajectories as on the host, instructions as in costs.toml; flash and RAM on an STM32F405
    #[command(disable_help_flag = true)]
    Qemu(HarnessArgs),
    /// Generated C and Rust and the hybrid on every core under QEMU: as on the host, figures as in cores.toml
    #[command(disable_help_flag = true)]
    Cores(HarnessArgs),
    /// Only the lint of C, generated and the firmwares' own: gcc, clang, clang-tidy, cppcheck with its MISRA addon, Frama-C
    /// EVA
    Lint,
    /// Have a solver prove every rule that proofs apply, and some proofs; writes what is proven. Then own maths for every number, and
    /// instructions on a million operands
    Lemmas,
    /// Every loader and the compiler under libFuzzer (nightly, cargo-fuzz)
    Fuzz(fuzz::FuzzArgs),
    /// Run tests of the runtime, the kernels and the C interface under Miri (nightly)
    Miri,
    /// Random calls of the C interface under ASan and UBSan, with overflow checks (nightly, gcc)
    Sanitize {
        /// Seeds, some 57,000 calls each
        #[arg(long, default_value_t = 20)]
        seeds: u32,
    },
    /// Build the Python package, install it into a virtual environment, run pytest, ruff, mypy and stubtest
    Python(python::PythonArgs),
    /// Make what users download: static programs for Linux, libraries for every target, a bill of materials, checksums
    Dist(dist::DistArgs),
    /// Build the book of `docs/` with mdBook, into book/
    Book {
        /// First write the pages that are made from the programs: command lines and configuration
        #[arg(long)]
        update: bool,
    },
    /// Write the tables of README.md and docs/experiments.md from docs/figures.toml and the provenance of shipped policies
    Figures,
    /// Build the page into target/web: the arm and three problems with their policies as WebAssembly; test it under Node and in
    /// a browser
    Web,
}

/// What a command passes on to the harness, which `--help` asks, too.
#[derive(Clone, Debug, clap::Args)]
struct HarnessArgs {
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    words: Vec<String>,
}

fn main() -> ExitCode {
    let good = match XtaskCli::parse().command {
        Setup => setup::run(),
        Test => run(Run::all_tests),
        Check => run(Run::all),
        Library { target, out } => library(target, out),
        Qemu(HarnessArgs { words }) => run(|run| run.firmware("qemu", &words)),
        Cores(HarnessArgs { words }) => run(|run| run.firmware("cores", &words)),
        Lint => run(Run::lint),
        Lemmas => run(|run| {
            run.lemmas();
            run.operands();
        }),
        Fuzz(arguments) => run(|run| arguments.run(run)),
        Miri => run(nightly::miri),
        Sanitize { seeds } => run(|run| nightly::sanitize(run, seeds)),
        Python(arguments) => run(|run| python::check(run, arguments)),
        Dist(arguments) => is_done(arguments.run()),
        Book { update } => run(|run| {
            if update {
                run.pages();
            }
            run.book();
        }),
        Figures => is_done(figures::write()),
        Web => run(web::check),
    };
    if good { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// Tells an error; true if there is none.
fn is_done(result: io::Result<()>) -> bool {
    result.inspect_err(|error| eprintln!("{error}")).is_ok()
}

/// Builds libraries and prints their locations.
fn library(targets: Vec<String>, out: Option<PathBuf>) -> bool {
    let folder = out.unwrap_or_else(library::dist);
    let all = || library::TARGETS.into_iter().chain([library::host()]).map(str::to_owned).collect();
    let targets: Vec<String> = if targets.is_empty() { all() } else { targets };
    targets.iter().fold(true, |good, target| {
        let made = library::make(target, &folder).map(|archive| {
            archive.iter().for_each(|path| println!("{}", path.display()));
        });
        is_done(made) & good
    })
}
