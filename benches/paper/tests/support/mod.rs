//! Finds the recorded data, and reports when it is missing.
//!
//! The data cannot be part of the repository because its source carries no licence. A test that needs it calls
//! [`folder`] and is skipped if there is none; [`tpg_testing::skip`] reports and counts that. A folder that exists but
//! lacks a recorded file is a failure, never a skip.

pub(crate) mod clearance;
pub(crate) mod fk;
pub(crate) mod hybrid;
pub(crate) mod policies;
pub(crate) mod sac;
pub(crate) mod torch_random;
pub(crate) mod traces;

use std::env;
use std::path::{Path, PathBuf};

/// The environment variable that names the folder.
const VARIABLE: &str = "TPG_CONFORMANCE";

/// Returns the folder of the recorded data; `None` if `test` must be skipped.
pub(crate) fn folder(test: &str) -> Option<PathBuf> {
    let folder = env::var_os(VARIABLE).map_or_else(default_folder, PathBuf::from);
    if folder.is_dir() {
        return Some(folder);
    }
    tpg_testing::skip(&format!("tpg-paper, {test}: no folder {} ({VARIABLE} names another)", folder.display()));
    None
}

/// Returns a file of the folder that only another program can make; `None` if `test` must be skipped: a folder that
/// `tpg-paper conformance` made has none.
pub(crate) fn foreign_file(test: &str, name: &str) -> Option<PathBuf> {
    let path = folder(test)?.join(name);
    if path.is_file() {
        return Some(path);
    }
    tpg_testing::skip(&format!("tpg-paper, {test}: no file {}, which other programs make", path.display()));
    None
}

fn default_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/conformance")
}
