//! Folders, text files and graphs, with errors that name them. Files are written by [`write_atomically`].

pub use crate::output::write_atomically;

use crate::Graph;
use crate::error::{InputError, Place};
use std::fs;
use std::path::Path;

/// Creates a folder and its parents.
///
/// # Errors
/// If the folder cannot be created.
pub fn make_folder(folder: &Path) -> Result<(), InputError> {
    fs::create_dir_all(folder).map_err(|error| InputError::io(folder, &error, "a folder that can be created"))
}

/// Reads a `graph.json`.
///
/// # Errors
/// If it cannot be read or is not a graph.
pub fn read_graph(path: &Path) -> Result<Graph, InputError> {
    if path.extension().is_some_and(|extension| extension == "dot") {
        let accepted = "a graph.json, which `tpg-codegen convert` makes of it";
        return Err(InputError::new(path.display().to_string(), Place::Whole, "a .dot of GEGELATI", accepted));
    }
    Graph::from_json(&path.display().to_string(), &read_text(path, "a graph.json")?)
}

/// Reads a text file.
///
/// # Errors
/// If it cannot be read.
pub fn read_text(path: &Path, accepted: &str) -> Result<String, InputError> {
    fs::read_to_string(path).map_err(|error| InputError::io(path, &error, accepted))
}
