//! Folders and text files, with errors that name them. Files are written by [`write_atomically`].

use std::fs;
use std::path::Path;
use tpg_codegen::error::InputError;
pub use tpg_codegen::output::write_atomically;

/// Makes a folder with all above it.
///
/// # Errors
/// If that cannot be done.
pub fn make_folder(folder: &Path) -> Result<(), InputError> {
    fs::create_dir_all(folder).map_err(|error| InputError::io(folder, &error, "a folder that can be made"))
}

/// Reads a text file.
///
/// # Errors
/// If it cannot be read.
pub fn read_text(path: &Path, accepted: &str) -> Result<String, InputError> {
    fs::read_to_string(path).map_err(|error| InputError::io(path, &error, accepted))
}
