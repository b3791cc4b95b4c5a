//! Folders and text files, with errors that name them. Files are written by [`write_atomically`].

use std::fs;
use std::path::Path;
use tpg_graph::error::InputError;
use tpg_graph::output::UNFINISHED;
pub use tpg_graph::output::write_atomically;

/// Makes a folder with all above it.
///
/// # Errors
/// If that cannot be done.
pub fn make_folder(folder: &Path) -> Result<(), InputError> {
    fs::create_dir_all(folder).map_err(|error| InputError::io(folder, &error, "a folder that can be made"))
}

/// Removes what a killed program left unfinished in its folder. What cannot be removed stays: it does no harm.
pub fn remove_unfinished(folder: &Path) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        if entry.file_name().to_string_lossy().starts_with(UNFINISHED) {
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// Reads a text file.
///
/// # Errors
/// If it cannot be read.
pub fn read_text(path: &Path, accepted: &str) -> Result<String, InputError> {
    fs::read_to_string(path).map_err(|error| InputError::io(path, &error, accepted))
}
