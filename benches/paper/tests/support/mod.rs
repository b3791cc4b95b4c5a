//! Finds the recorded data, and reports when it is missing.
//!
//! The data cannot be part of the repository because its source carries no licence. A test that needs it calls
//! [`folder`] and is skipped if there is none; [`tpg_testing::skip`] reports and counts that. A folder that exists but
//! lacks a file is a failure, never a skip.

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

fn default_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/conformance")
}
