//! The book: `docs/` by mdBook, into `book/` beside it, where links out of `docs/` lead to the same files.

use crate::venv::{environment, interpreter};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{fs, io};
use tpg_testing::library::{target_folder, top};

/// Returns the mdBook to build with: the pinned one in a virtual environment, which PyPI has built, or else an installed one;
/// `None`, if there is neither a Python for the first nor the second.
///
/// # Errors
/// If there is a Python, but mdBook can neither be installed nor found.
pub(crate) fn mdbook() -> io::Result<Option<PathBuf>> {
    let installed = || tpg_testing::exists("mdbook").then(|| PathBuf::from("mdbook"));
    let Some(python) = interpreter() else { return Ok(installed()) };
    let requirements = top().join("xtask/requirements-book.txt");
    match environment(&python, &target_folder().join("mdbook"), &requirements) {
        Ok(venv) => Ok(Some(venv.join("bin/mdbook"))),
        Err(error) => installed().map(Some).ok_or(error),
    }
}

/// Builds the book; returns true if mdBook could build it.
///
/// # Errors
/// If mdBook cannot be started, or an earlier book cannot be removed.
pub(crate) fn build(mdbook: &Path) -> io::Result<bool> {
    let place = top().join("book");
    if place.exists() {
        fs::remove_dir_all(&place)?;
    }
    Ok(Command::new(mdbook).arg("build").arg(top().join("docs")).status()?.success())
}
