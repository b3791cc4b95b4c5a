//! The file `run.lock`: locked by the system as long as its process lives, and one line that says which one that is.
//!
//! The file stays when the run ends: one that is removed could be locked by two processes.

use std::fs::{self, File, TryLockError};
use std::io::{Seek as _, Write as _};
use std::path::Path;
use tpg_graph::error::{InputError, Place};

/// Name of the file.
const NAME: &str = "run.lock";

/// A locked folder.
#[derive(Debug)]
pub(crate) struct Lock(File);

impl Drop for Lock {
    /// Unlocks the folder at once: a child that is just starting may hold a copy of the file.
    fn drop(&mut self) {
        let _ = self.0.unlock();
    }
}

impl Lock {
    /// Locks a folder, and writes who has done so.
    ///
    /// # Errors
    /// If another process has locked it, or it cannot be written.
    pub(crate) fn take(folder: &Path) -> Result<Self, InputError> {
        let path = folder.join(NAME);
        let io = |error: &std::io::Error| InputError::io(&path, error, "a folder that can be written");
        let mut file =
            (File::options().write(true).create(true).truncate(false).open(&path)).map_err(|error| io(&error))?;
        match file.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => {
                // The other process may not have written its line yet.
                let line = fs::read_to_string(&path).unwrap_or_default();
                let found = if line.ends_with('\n') { line.trim_end() } else { "another process" };
                let accepted = "one process at a time in a folder: wait for its end, or another --out";
                let found = format!("in use by {found}");
                return Err(InputError::new(folder.display().to_string(), Place::Whole, found, accepted));
            }
            Err(TryLockError::Error(error)) if error.kind() == std::io::ErrorKind::Unsupported => {
                eprintln!("warning: {}: no locks on this file system; run one process only", path.display());
            }
            Err(TryLockError::Error(error)) => return Err(io(&error)),
        }
        let line = format!("process {}\n", std::process::id());
        // Overwrites before it shortens: on a full disk the old bytes still have their place.
        (file.rewind())
            .and_then(|()| file.write_all(line.as_bytes()))
            .and_then(|()| file.set_len(line.len() as u64))
            .map_err(|error| InputError::io(&path, &error, "a file that can be written, with space for it"))?;
        Ok(Self(file))
    }
}
