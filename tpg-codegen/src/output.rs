//! Writes files whole or not at all.

use crate::error::InputError;
use std::fs::File;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

const ACCEPTED: &str = "a file that can be written, on a disk with room";

/// Writes one file: after a crash, a full disk or a kill there is the old file or the new one, never a part.
///
/// # Errors
/// When the folder or the disk does not allow it; the old file is then as it was.
pub fn write_atomically(path: &Path, bytes: &[u8]) -> Result<(), InputError> {
    prepare(path, bytes)?.commit()
}

/// Writes several files: none is put in its place before all are written.
///
/// # Errors
/// As [`write_atomically`].
pub fn write_all(files: &[(PathBuf, &str)]) -> Result<(), InputError> {
    let prepared: Vec<Prepared<'_>> =
        files.iter().map(|(path, text)| prepare(path, text.as_bytes())).collect::<Result<_, _>>()?;
    prepared.into_iter().try_for_each(Prepared::commit)
}

/// A file written beside its place; dropped, it is gone.
struct Prepared<'a> {
    path: &'a Path,
    file: NamedTempFile,
}

fn prepare<'a>(path: &'a Path, bytes: &[u8]) -> Result<Prepared<'a>, InputError> {
    let write = || -> io::Result<NamedTempFile> {
        let mut file = tempfile::Builder::new().prefix(".tpg-").tempfile_in(folder(path))?;
        file.write_all(bytes)?;
        file.as_file().sync_all()?;
        readable_by_all(file.as_file())?;
        Ok(file)
    };
    write().map(|file| Prepared { path, file }).map_err(|error| InputError::io(path, &error, ACCEPTED))
}

impl Prepared<'_> {
    fn commit(self) -> Result<(), InputError> {
        let failed = |error: io::Error| InputError::io(self.path, &error, ACCEPTED);
        self.file.persist(self.path).map_err(|error| failed(error.error))?;
        // The rename itself must reach the disk.
        File::open(folder(self.path)).and_then(|folder| folder.sync_all()).map_err(failed)
    }
}

/// Temporary files are private; a result is as readable as any other file.
#[cfg(unix)]
fn readable_by_all(file: &File) -> io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    file.set_permissions(std::fs::Permissions::from_mode(0o644))
}

#[cfg(not(unix))]
fn readable_by_all(_: &File) -> io::Result<()> {
    Ok(())
}

fn folder(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if parent != Path::new("") => parent,
        _ => Path::new("."),
    }
}

#[cfg(test)]
mod tests {
    use super::{write_all, write_atomically};
    use std::fs;

    #[test]
    fn a_file_is_replaced_whole() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("a");
        write_atomically(&path, b"old, and longer").expect("written");
        write_atomically(&path, b"new").expect("written");
        assert_eq!(fs::read(&path).expect("there"), b"new");
    }

    #[test]
    fn nothing_is_written_when_one_of_several_cannot_be() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let good = folder.path().join("good");
        let bad = folder.path().join("missing").join("bad");
        let error = write_all(&[(good.clone(), "text"), (bad, "text")]).expect_err("no such folder");
        assert!(error.to_string().contains("bad"), "{error}");
        assert_eq!(fs::read_dir(folder.path()).expect("there").count(), 0);
    }
}
