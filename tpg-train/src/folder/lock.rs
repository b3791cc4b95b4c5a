//! The file `run.lock`: locked by the system as long as its process lives, and one line that says whose the folder is.
//!
//! The file stays when the run ends. Its line still names the trainer, and a lock file that is removed could be locked
//! by two processes.

use super::Trainer;
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
    /// True if another process has locked the folder.
    pub(crate) fn is_held(folder: &Path) -> bool {
        let file = File::open(folder.join(NAME));
        file.is_ok_and(|file| matches!(file.try_lock(), Err(TryLockError::WouldBlock)))
    }

    /// Locks a folder for a trainer.
    ///
    /// # Errors
    /// If another process has locked it, it belongs to another trainer, or it cannot be written.
    pub(crate) fn take(folder: &Path, trainer: Trainer) -> Result<Self, InputError> {
        let path = folder.join(NAME);
        let io = |error: &std::io::Error| InputError::io(&path, error, "a folder that can be written");
        let line = fs::read_to_string(&path).unwrap_or_default();
        let file =
            (File::options().write(true).create(true).truncate(false).open(&path)).map_err(|error| io(&error))?;
        match file.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => return Err(in_use(folder, &line)),
            Err(TryLockError::Error(error)) if error.kind() == std::io::ErrorKind::Unsupported => {
                eprintln!("warning: {}: no locks on this file system; run one process only", path.display());
            }
            Err(TryLockError::Error(error)) => return Err(io(&error)),
        }
        if let Some(owner) = owner(&line).filter(|owner| *owner != trainer) {
            let found = format!("a run of tpg-train {owner}");
            let accepted = format!("a run of tpg-train {trainer}, or another --out");
            return Err(InputError::new(folder.display().to_string(), Place::Whole, found, accepted));
        }
        Ok(Self(file))
    }

    /// Writes who has locked the folder.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub(crate) fn write(&self, folder: &Path, trainer: Trainer) -> Result<(), InputError> {
        let path = folder.join(NAME);
        let line = format!("tpg-train {trainer}, process {}\n", std::process::id());
        let mut file = &self.0;
        // Overwrites before it shortens: on a full disk the old bytes still have their place.
        (file.rewind())
            .and_then(|()| file.write_all(line.as_bytes()))
            .and_then(|()| file.set_len(line.len() as u64))
            .map_err(|error| InputError::io(&path, &error, "a file that can be written, with space for it"))
    }
}

fn in_use(folder: &Path, line: &str) -> InputError {
    // The other process may not have written its line yet.
    let found = if owner(line).is_some() { line.trim_end() } else { "another process" };
    let accepted = "one process at a time in a folder: wait for its end, or another --out";
    InputError::new(folder.display().to_string(), Place::Whole, format!("in use by {found}"), accepted)
}

/// Returns the trainer that a line names.
fn owner(line: &str) -> Option<Trainer> {
    Trainer::from_name(line.strip_prefix("tpg-train ")?.split_once(", process ")?.0)
}
