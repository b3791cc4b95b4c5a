//! Folders, text files and graphs, with errors that name them. Files are written by [`write_atomically`].

use std::fs;
use std::path::Path;
use tpg_graph::Graph;
use tpg_graph::error::InputError;
use tpg_graph::output::UNFINISHED;
pub use tpg_graph::output::write_atomically;

/// Creates a folder and its parents.
///
/// # Errors
/// If the folder cannot be created.
pub fn make_folder(folder: &Path) -> Result<(), InputError> {
    fs::create_dir_all(folder).map_err(|error| InputError::io(folder, &error, "a folder that can be created"))
}

/// Removes unfinished files that a killed program left in its folder. Files that cannot be removed stay, which is
/// harmless.
pub fn remove_unfinished(folder: &Path) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        if entry.file_name().to_string_lossy().starts_with(UNFINISHED) {
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// Reads a `graph.json`.
///
/// # Errors
/// If it cannot be read or is not a graph.
pub fn read_graph(path: &Path) -> Result<Graph, InputError> {
    Graph::from_json(&path.display().to_string(), &read_text(path, "a graph.json")?)
}

/// Reads a text file.
///
/// # Errors
/// If it cannot be read.
pub fn read_text(path: &Path, accepted: &str) -> Result<String, InputError> {
    fs::read_to_string(path).map_err(|error| InputError::io(path, &error, accepted))
}
