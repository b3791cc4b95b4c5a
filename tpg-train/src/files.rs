//! Files that are either whole or not there.

use std::fs::{self, File};
use std::io::Write as _;
use std::path::Path;
use tpg_codegen::error::InputError;

const ACCEPTED: &str = "a folder that can be written, with room on its disk";

/// Makes a folder with all above it.
///
/// # Errors
/// If that cannot be done.
pub fn make_folder(folder: &Path) -> Result<(), InputError> {
    fs::create_dir_all(folder).map_err(|error| InputError::io(folder, &error, ACCEPTED))
}

/// Writes a file beside its place, forces it to the disk, and moves it there: whatever happens, the file is the old one or
/// the new one.
///
/// # Errors
/// If the folder cannot be written or the disk is full; the old file is then untouched.
pub fn write_atomically(path: &Path, bytes: &[u8]) -> Result<(), InputError> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let write = || {
        let mut file = tempfile::Builder::new().prefix(".unfinished-").tempfile_in(folder)?;
        file.write_all(bytes)?;
        file.as_file().sync_all()?;
        file.persist(path).map_err(|error| error.error)?;
        // The move itself is on the disk only when its folder is.
        File::open(folder).and_then(|folder| folder.sync_all())
    };
    write().map_err(|error| InputError::io(path, &error, ACCEPTED))
}

/// Reads a text file.
///
/// # Errors
/// If it cannot be read.
pub fn read_text(path: &Path, accepted: &str) -> Result<String, InputError> {
    fs::read_to_string(path).map_err(|error| InputError::io(path, &error, accepted))
}

#[cfg(test)]
mod tests {
    use super::write_atomically;
    use std::fs;

    #[test]
    fn a_file_is_replaced_as_a_whole_and_nothing_is_left_beside_it() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("file");
        for text in ["first", "second, longer"] {
            write_atomically(&path, text.as_bytes()).expect("the folder can be written");
            assert_eq!(fs::read_to_string(&path).expect("the file is there"), text);
        }
        assert_eq!(fs::read_dir(folder.path()).expect("the folder is there").count(), 1);
    }

    #[test]
    fn a_folder_that_is_not_there_is_an_error_that_names_the_file() {
        let error = write_atomically("/no/such/folder/file".as_ref(), b"x").expect_err("it cannot be written");
        assert_eq!(error.file, "/no/such/folder/file");
    }
}
