//! Atomic file writes.
//!
//! A file's bytes go to a temporary file in the same folder, are flushed to the disk, and only then is the file
//! renamed. Readers see either the old file or the new one, never a part, regardless of what fails.

use crate::command::print;
use crate::error::InputError;
use std::fs::{self, File};
use std::io::{self, Write};
use std::iter;
use std::path::{Path, PathBuf};
use tempfile::{Builder, NamedTempFile};

/// Writes one file, and removes what killed programs left beside it.
///
/// ```
/// use tpg_graph::output::write_atomically;
///
/// let folder = tempfile::tempdir()?;
/// let path = folder.path().join("report.txt");
/// write_atomically(&path, b"one")?;
/// write_atomically(&path, b"two")?;
/// assert_eq!(std::fs::read(&path)?, b"two");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// If the file cannot be written: no such folder, no permission, no space. Nothing has changed in that case.
pub fn write_atomically(path: &Path, bytes: &[u8]) -> Result<(), InputError> {
    remove_unfinished(folder_of(path));
    write_all(&[(path, bytes)])
}

/// Writes a text to a file, or to standard output where the path is `-`; tests for a file.
///
/// # Errors
/// As [`write_atomically`] and [`print()`].
pub fn write_or_print(path: &Path, text: &str) -> Result<bool, InputError> {
    let is_file = path != Path::new("-");
    if is_file { write_atomically(path, text.as_bytes()) } else { print(text) }.map(|()| is_file)
}

/// Writes a set of files. All go to temporary files first, so that if one cannot be written none of them appears.
///
/// A path that is not a regular file, such as `/dev/stdout`, is written to directly.
///
/// # Errors
/// As [`write_atomically`]; nothing has changed in that case, unless a folder disappeared between the last write and
/// the renaming.
pub fn write_all<P: AsRef<Path>, B: AsRef<[u8]>>(files: &[(P, B)]) -> Result<(), InputError> {
    let mut written = Vec::with_capacity(files.len());
    for (path, bytes) in files {
        let path = path.as_ref();
        written.push(Pending::write(path, bytes.as_ref()).map_err(|error| refused(path, &error))?);
    }
    for pending in written {
        pending.appear().map_err(|(path, error)| refused(&path, &error))?;
    }
    Ok(())
}

/// Creates a folder, and those of its files, and writes the files as [`write_all`] does. If that fails, the created folders
/// are removed again.
///
/// # Errors
/// As [`write_all`], or if the folder cannot be created.
pub fn write_folder<B: AsRef<[u8]>>(folder: &Path, files: &[(PathBuf, B)]) -> Result<(), InputError> {
    let mut made = Vec::new();
    let folders = iter::once(folder).chain(files.iter().filter_map(|(path, _)| path.parent()));
    let written = folders
        .into_iter()
        .try_for_each(|folder| {
            let missing = folder.ancestors().take_while(|above| !above.as_os_str().is_empty() && !above.exists());
            let missing: Vec<&Path> = missing.collect();
            made.extend(missing.into_iter().rev());
            fs::create_dir_all(folder).map_err(|error| InputError::io(folder, &error, "a folder that can be written"))
        })
        .and_then(|()| write_all(files));
    if written.is_err() {
        // Deepest first. A folder that is no longer empty has other users and stays.
        for folder in made.into_iter().rev() {
            let _ = fs::remove_dir(folder);
        }
    }
    written
}

fn refused(path: &Path, error: &io::Error) -> InputError {
    InputError::io(path, error, "a file that can be written, with space for it")
}

/// A written file that does not have its name yet. It is removed when dropped.
enum Pending {
    Temporary { file: NamedTempFile, path: PathBuf },
    Done,
}

impl Pending {
    fn write(path: &Path, bytes: &[u8]) -> io::Result<Self> {
        let path = match fs::metadata(path) {
            Ok(found) if found.is_dir() => return Err(io::Error::from(io::ErrorKind::IsADirectory)),
            Ok(found) if !found.is_file() => {
                let mut device = File::options().write(true).open(path)?;
                device.write_all(bytes)?;
                device.flush()?;
                return Ok(Self::Done);
            }
            Ok(_) => fs::canonicalize(path)?, // follow links, so that they stay links
            Err(_) => path.to_owned(),
        };
        let mut file = temporary_in(folder_of(&path))?;
        file.write_all(bytes)?;
        file.as_file().sync_all()?;
        Ok(Self::Temporary { file, path })
    }

    fn appear(self) -> Result<(), (PathBuf, io::Error)> {
        let Self::Temporary { file, path } = self else { return Ok(()) };
        if let Err(error) = file.persist(&path) {
            return Err((path, error.error));
        }
        // The rename is durable only once the folder is synced. Some systems cannot open folders; the file is complete
        // anyway.
        if let Ok(folder) = File::open(folder_of(&path)) {
            let _ = folder.sync_all();
        }
        Ok(())
    }
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// Prefix of unfinished files. A program that was killed leaves them behind.
const UNFINISHED: &str = ".tpg-unfinished-";

/// Removes the unfinished files that killed programs left in a folder. Files of programs that still write them stay:
/// they are locked. Files that cannot be removed stay, too, which is harmless.
pub fn remove_unfinished(folder: &Path) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        if entry.file_name().to_string_lossy().starts_with(UNFINISHED) {
            let abandoned = File::open(entry.path()).is_ok_and(|file| file.try_lock().is_ok());
            if abandoned {
                let _ = fs::remove_file(entry.path());
            }
        }
    }
}

/// Creates a temporary file with the permissions of ordinary new files; by default only the owner could read it. It is
/// locked as long as it is open, so that [`remove_unfinished`] knows it from one that was abandoned.
fn temporary_in(folder: &Path) -> io::Result<NamedTempFile> {
    let mut builder = Builder::new();
    builder.prefix(UNFINISHED);
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let file = builder.tempfile_in(folder)?;
    // On a file system without locks the file is only unprotected for the moment of its writing.
    let _ = file.as_file().try_lock();
    Ok(file)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        let mut names: Vec<String> = (fs::read_dir(folder).expect("a folder"))
            .map(|entry| entry.expect("an entry").file_name().into_string().expect("a plain name"))
            .collect();
        names.sort();
        names
    }

    #[test]
    fn a_set_appears_and_replaces() {
        let folder = tempfile::tempdir().expect("a folder");
        let [a, b] = ["a", "b"].map(|name| folder.path().join(name));
        write_all(&[(&a, "old")]).expect("written");
        write_all(&[(&a, "new"), (&b, "other")]).expect("written");
        assert_eq!(fs::read_to_string(&a).expect("a"), "new");
        assert_eq!(fs::read_to_string(&b).expect("b"), "other");
        assert_eq!(names(folder.path()), ["a", "b"]);
    }

    #[test]
    fn one_that_fails_keeps_all_from_appearing() {
        let folder = tempfile::tempdir().expect("a folder");
        let good = folder.path().join("good");
        fs::write(&good, "old").expect("written");
        for bad in [folder.path().join("missing/file"), folder.path().to_owned(), good.join("below a file")] {
            let error = write_all(&[(&good, "new"), (&bad, "new")]).expect_err("refused");
            assert_eq!(error.file, bad.display().to_string());
            assert_eq!(fs::read_to_string(&good).expect("good"), "old");
            assert_eq!(names(folder.path()), ["good"]);
        }
    }

    #[test]
    fn a_folder_appears_with_its_files_or_not_at_all() {
        let folder = tempfile::tempdir().expect("a folder");
        let new = folder.path().join("a/b");
        write_folder(&new, &[(new.join("sub/file"), "text"), (new.join("sub"), "text")]).expect_err("refused");
        assert!(names(folder.path()).is_empty());
        write_folder(&new, &[(new.join("file"), "text"), (new.join("sub/file"), "text")]).expect("written");
        assert_eq!([names(&new), names(&new.join("sub"))], [vec!["file", "sub"], vec!["file"]]);
        write_folder(&new, &[(new.join("file"), "new"), (new.join("file/below"), "text")]).expect_err("refused");
        assert_eq!(fs::read_to_string(new.join("file")).expect("file"), "text", "existing files stay");
        fs::write(folder.path().join("plain"), "").expect("written");
        let error = write_folder(&folder.path().join("plain/b"), &[(new.join("x"), "")]).expect_err("refused");
        assert!(error.file.ends_with("plain/b"), "{error}");
    }

    #[test]
    fn only_abandoned_files_are_removed() {
        let folder = tempfile::tempdir().expect("a folder");
        let held = temporary_in(folder.path()).expect("written");
        let held_name = held.path().file_name().expect("a name").to_string_lossy().into_owned();
        fs::write(folder.path().join(format!("{UNFINISHED}AbCdEf")), "half").expect("written");
        fs::write(folder.path().join("file"), "whole").expect("written");
        remove_unfinished(folder.path());
        assert_eq!(names(folder.path()), [held_name, "file".to_owned()]);
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_full_device_is_an_error() {
        let error = write_atomically(Path::new("/dev/full"), b"bytes").expect_err("no space");
        assert!(error.found.contains("No space left"), "{error}");
    }

    #[cfg(unix)]
    #[test]
    fn a_link_stays_one_and_others_may_read() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().expect("a folder");
        let [file, link, plain] = ["file", "link", "plain"].map(|name| folder.path().join(name));
        fs::write(&file, "old").expect("written");
        fs::write(&plain, "").expect("written");
        std::os::unix::fs::symlink(&file, &link).expect("linked");
        write_atomically(&link, b"new").expect("written");
        assert!(link.is_symlink());
        assert_eq!(fs::read_to_string(&file).expect("file"), "new");
        let mode = |path: &Path| fs::metadata(path).expect("a file").permissions().mode();
        assert_eq!(mode(&file), mode(&plain));
    }
}
