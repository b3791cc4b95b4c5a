//! Finds the recorded data, and says loudly when it is not there.
//!
//! The data cannot be part of the repository: its source carries no licence. A test that needs it asks [`folder`] and is
//! skipped where there is none; [`tpg_testing::skip`] shows and counts that. A folder that is there but lacks a file is a
//! failure, never a skip.

use std::env;
use std::path::{Path, PathBuf};

/// The environment variable that names the folder.
const VARIABLE: &str = "TPG_CONFORMANCE";

/// The folder of the recorded data; `None` when `test` must be skipped.
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
