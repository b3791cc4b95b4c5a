//! Test support: reported and counted skips, and the build of `libtpg_runtime.a` that tests and `xtask` share.
//!
//! A test that lacks a tool or data calls [`skip`] and returns. The line is always visible, even if the test harness
//! captures output, and `cargo xtask test` lists it again in its summary. If everything must be present, as in CI, a
//! missing tool is a failure instead.

pub mod book;
pub mod library;
pub mod numbers;

use std::fs::OpenOptions;
use std::io::{self, Write as _};
use std::process::{Command, Stdio};
use std::{env, fs};

/// Environment variable naming the file that skips are appended to, one per line.
pub const LOG: &str = "TPG_SKIPPED_LOG";

/// Environment variable: if it is `1`, a missing tool is a failure.
pub const REQUIRE: &str = "TPG_REQUIRE_EMBEDDED";

/// True if missing tools must fail.
pub fn required() -> bool {
    env::var(REQUIRE).is_ok_and(|value| value == "1")
}

/// Reports that something was not tested, and why.
///
/// # Panics
/// If the log named by [`LOG`] cannot be written: a skip must not be lost.
pub fn skip(what: &str) {
    // Not eprintln!, which a test harness captures.
    let _ = writeln!(io::stderr().lock(), "SKIPPED: {what}");
    if let Some(path) = env::var_os(LOG) {
        let log = OpenOptions::new().create(true).append(true).open(&path);
        // A single write, so that the lines of parallel tests do not mix.
        let written = log.and_then(|mut log| log.write_all(format!("{what}\n").as_bytes()));
        assert!(written.is_ok(), "cannot note in {} that this was skipped: {what}", path.display());
    }
}

/// Returns the lines of a log of skips; empty if nothing was skipped.
pub fn skipped(log: &std::path::Path) -> Vec<String> {
    fs::read_to_string(log).map(|text| text.lines().map(str::to_owned).collect()).unwrap_or_default()
}

/// True if a program can be started; otherwise `what` is [skipped](skip), naming the package to install.
///
/// # Panics
/// If the program is missing and [`REQUIRE`] is `1`.
pub fn tool(program: &str, package: &str, what: &str) -> bool {
    if exists(program) {
        return true;
    }
    let message = format!("{what}: {program} not found (cargo xtask setup installs it from {package})");
    assert!(!required(), "{message}");
    skip(&message);
    false
}

/// True if a program can be started.
pub fn exists(program: &str) -> bool {
    Command::new(program)
        .arg("--version")
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .is_ok()
}

/// Names the variable by which nothing is shortened.
pub const FULL: &str = "TPG_FULL_TESTS";

/// Returns `all` where [`FULL`] is `1`, as in CI, and `some` otherwise: the amount of work of a long test.
///
/// A shortened test covers the same code on fewer cases, so that `cargo xtask test` stays a matter of minutes.
pub fn amount<T>(some: T, all: T) -> T {
    if env::var(FULL).is_ok_and(|value| value == "1") { all } else { some }
}
