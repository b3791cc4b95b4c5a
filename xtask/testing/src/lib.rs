//! Test support: skips that are loud and counted, and the build of `libtpg_runtime.a` that tests and `xtask` share.
//!
//! A test that lacks a tool or data calls [`skip`] and returns. Whoever runs it sees the line, whatever the test harness
//! captures, and `cargo xtask test` lists it again in its summary. Where everything must be there, as in CI, a missing
//! tool fails instead.

pub mod library;

use std::fs::OpenOptions;
use std::io::{self, Write as _};
use std::process::{Command, Stdio};
use std::{env, fs};

/// Names the file that skips are appended to, a line each.
pub const LOG: &str = "TPG_SKIPPED_LOG";

/// Where this is `1`, a missing tool is a failure.
pub const REQUIRE: &str = "TPG_REQUIRE_EMBEDDED";

/// Whether missing tools must fail.
pub fn required() -> bool {
    env::var(REQUIRE).is_ok_and(|value| value == "1")
}

/// Says that something was not tested and why.
///
/// # Panics
/// When the log named by [`LOG`] cannot be written: a skip must not get lost.
pub fn skip(what: &str) {
    // Not eprintln!, which a test harness captures.
    let _ = writeln!(io::stderr().lock(), "SKIPPED: {what}");
    if let Some(path) = env::var_os(LOG) {
        let log = OpenOptions::new().create(true).append(true).open(&path);
        // One write, so that the lines of parallel tests do not mix.
        let written = log.and_then(|mut log| log.write_all(format!("{what}\n").as_bytes()));
        assert!(written.is_ok(), "cannot note in {} that this was skipped: {what}", path.display());
    }
}

/// The lines of a log of skips; none where nothing was skipped.
pub fn skipped(log: &std::path::Path) -> Vec<String> {
    fs::read_to_string(log).map(|text| text.lines().map(str::to_owned).collect()).unwrap_or_default()
}

/// Whether a program can be started; where not, `what` is [skipped](skip), and the package that has it named.
///
/// # Panics
/// Where the program is missing and [`REQUIRE`] is `1`.
pub fn tool(program: &str, package: &str, what: &str) -> bool {
    if exists(program) {
        return true;
    }
    let message = format!("{what}: {program} not found (cargo xtask setup installs it from {package})");
    assert!(!required(), "{message}");
    skip(&message);
    false
}

/// Whether a program can be started.
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
