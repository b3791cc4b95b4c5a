//! Finds the recorded data, and says loudly when it is not there.
//!
//! The data cannot be part of the repository: its source carries no licence. A test that needs it asks [`folder`]. Where
//! there is none, the test is skipped: one line that starts with `SKIPPED:` goes to stderr past libtest's capture, and the
//! test's name is appended to `skipped.txt` in cargo's folder for test files (`target/tmp`), so that whoever runs the
//! whole suite can sum them up. A folder that is there but lacks a file is a failure, never a skip.

use std::fs::{self, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::{env, io};

/// The environment variable that names the folder.
const VARIABLE: &str = "TPG_CONFORMANCE";

/// The folder of the recorded data; `None` when `test` must be skipped.
pub(crate) fn folder(test: &str) -> Option<PathBuf> {
    let folder = env::var_os(VARIABLE).map_or_else(default_folder, PathBuf::from);
    if folder.is_dir() {
        return Some(folder);
    }
    let test = format!("{}::{test}", env!("CARGO_CRATE_NAME"));
    // Written to the stream itself: what `eprintln!` prints is captured and shown for failures only.
    let line = format!("SKIPPED: {test}: no folder {} ({VARIABLE} names another)\n", folder.display());
    io::stderr().write_all(line.as_bytes()).expect("stderr can be written");
    count(&test).expect("the list of skipped tests can be written");
    None
}

fn default_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/conformance")
}

fn count(test: &str) -> io::Result<()> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    fs::create_dir_all(folder)?;
    let mut list = OpenOptions::new().create(true).append(true).open(folder.join("skipped.txt"))?;
    // One write, so that lines of tests that run side by side stay whole.
    list.write_all(format!("{test}\n").as_bytes())
}
