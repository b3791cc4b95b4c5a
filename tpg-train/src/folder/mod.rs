//! A run's folder: one process at a time, its checkpoints, and nothing left of processes that were killed.
//!
//! | module | subject |
//! | --- | --- |
//! | (root) | [`RunFolder`], the folder of a run under way |
//! | [`lock`] | the file `run.lock` |
//! | [`frame`] | the checksum of a checkpoint |

pub(crate) mod frame;
pub(crate) mod lock;

use crate::run_args::place;
use lock::Lock;
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use tpg_graph::error::{InputError, Place};
use tpg_graph::files::{make_folder, write_atomically};
use tpg_graph::output::remove_unfinished;

/// Files that show that a folder holds a run.
const MARKS: [&str; 4] = ["config.toml", "graph.json", "study.toml", CHECKPOINT];

/// Name of the checkpoint.
const CHECKPOINT: &str = "checkpoint";

/// The folder of a run under way. It is locked until this is dropped or the process ends, by whatever cause.
#[derive(Debug)]
pub struct RunFolder {
    path: PathBuf,
    _lock: Lock,
}

impl RunFolder {
    /// Creates the folder if it does not exist, locks it, and removes unfinished files of killed processes.
    ///
    /// ```
    /// use tpg_train::parts::RunFolder;
    ///
    /// let place = tempfile::tempdir()?;
    /// let run = place.path().join("run");
    /// let folder = RunFolder::open(&run, false)?;
    /// let refused = RunFolder::open(&run, true).expect_err("it is in use");
    /// assert!(refused.found.contains(&format!("process {}", std::process::id())));
    ///
    /// folder.save("version 1", b"content".to_vec())?;
    /// drop(folder);
    /// let folder = RunFolder::open(&run, true)?;
    /// assert_eq!(folder.load("version 1", |_file, content| Ok(content.to_vec()))?, Some(b"content".to_vec()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If another process uses the folder, it holds a run and `resume` is false, or the folder cannot be written.
    pub fn open(path: &Path, resume: bool) -> Result<Self, InputError> {
        make_folder(path)?;
        // First without the lock: a folder that is refused stays as it is.
        if !resume {
            refuse_run(path)?;
        }
        let lock = Lock::take(path)?;
        if !resume {
            refuse_run(path)?;
        }
        remove_unfinished(path);
        Ok(Self { path: path.to_owned(), _lock: lock })
    }

    /// Returns the path of the folder.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Returns the path of a file in the folder.
    pub fn file(&self, name: &str) -> PathBuf {
        self.path.join(name)
    }

    /// Writes a checkpoint whole or not at all; `form` names trainer and version.
    ///
    /// # Errors
    /// If it cannot be written; the one before is then unchanged.
    pub fn save(&self, form: &str, content: Vec<u8>) -> Result<(), InputError> {
        write_atomically(&self.file(CHECKPOINT), &frame::seal(content, form))
    }

    /// Reads the checkpoint; `None` if there is none. `read` gets the name of the file and the content.
    ///
    /// # Errors
    /// If it is damaged or has another form, or `read` refuses its content.
    pub fn load<T>(
        &self,
        form: &str,
        read: impl FnOnce(&str, &[u8]) -> Result<T, InputError>,
    ) -> Result<Option<T>, InputError> {
        let path = self.file(CHECKPOINT);
        let bytes = match fs::read(&path) {
            Err(error) if error.kind() == ErrorKind::NotFound && self.file("graph.json").exists() => {
                let folder = self.path.display().to_string();
                let accepted = "the run's own folder, whole, or another folder";
                return Err(InputError::new(folder, Place::Whole, "a graph.json without a checkpoint", accepted));
            }
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
            bytes => bytes.map_err(|error| InputError::io(&path, &error, "a checkpoint that can be read"))?,
        };
        let content = frame::open(&bytes, form).map_err(|finding| place(&path, finding))?;
        read(&path.display().to_string(), content).map(Some)
    }
}

fn refuse_run(path: &Path) -> Result<(), InputError> {
    if MARKS.iter().any(|name| path.join(name).exists()) {
        let is_study = path.join("study.toml").exists();
        let accepted = if is_study { "another folder" } else { "another folder, or --resume to continue" };
        return Err(InputError::new(path.display().to_string(), Place::Whole, "already holds a run", accepted));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::{CHECKPOINT, MARKS, RunFolder};
    use std::fs;
    use tpg_graph::error::{InputError, Place};

    const FORM: &str = "tpg-train sac, checkpoint version 3";

    #[test]
    fn a_folder_belongs_to_one_process_at_a_time() {
        let place = tempfile::tempdir().expect("a temporary folder");
        let run = place.path().join("a/run");
        let open = |resume| RunFolder::open(&run, resume).map_err(|error| error.to_string());
        let folder = open(false).expect("a new folder");
        let refused = open(true).expect_err("in use");
        let process = format!("process {}", std::process::id());
        assert!(refused.contains(&process) && refused.contains("one process"), "{refused}");
        assert!(open(false).expect_err("in use").contains(&process));
        drop(folder);
        assert!(open(true).is_ok());
    }

    #[test]
    fn a_run_is_not_begun_again_by_mistake_and_the_folder_stays_as_it_was() {
        for mark in MARKS {
            let folder = tempfile::tempdir().expect("a temporary folder");
            fs::write(folder.path().join(mark), "content").expect("written");
            let refused = RunFolder::open(folder.path(), false).expect_err(mark);
            assert_eq!(refused.accepted.contains("--resume"), mark != "study.toml", "{refused}");
            assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 1, "{mark} alone");
        }
    }

    #[test]
    fn what_killed_processes_left_is_removed() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let left = folder.path().join(".tpg-unfinished-AbCdEf");
        fs::write(&left, "half").expect("written");
        RunFolder::open(folder.path(), true).expect("a folder");
        assert!(!left.exists());
    }

    #[test]
    fn the_newest_checkpoint_is_read_and_a_damaged_or_foreign_one_is_refused_and_stays() {
        let place = tempfile::tempdir().expect("a temporary folder");
        let folder = RunFolder::open(place.path(), true).expect("a folder");
        let text = |_: &str, content: &[u8]| Ok(String::from_utf8_lossy(content).into_owned());
        let load = || folder.load(FORM, text).map_err(|error| error.to_string());
        assert_eq!(load(), Ok(None));
        for content in ["one", "two"] {
            folder.save(FORM, content.into()).expect("written");
            assert_eq!(load().as_ref().map(Option::as_deref), Ok(Some(content)));
        }
        folder.save("tpg-train sac, checkpoint version 2", "three".into()).expect("written");
        let error = load().expect_err("another version");
        assert!(error.contains("checkpoint version 2; accepted: tpg-train sac, checkpoint version 3"), "{error}");
        fs::write(folder.file(CHECKPOINT), "{}").expect("written");
        assert!(load().expect_err("damaged").contains("no checksum"));
        assert_eq!(fs::read_to_string(folder.file(CHECKPOINT)).expect("it stays"), "{}");
        folder.save(FORM, "four".into()).expect("written");
        let refuse = |file: &str, _: &[u8]| Err::<(), _>(InputError::new(file, Place::Whole, "this", "that"));
        assert!(folder.load(FORM, refuse).is_err());
        for name in [CHECKPOINT, "graph.json"] {
            fs::remove_file(folder.file(name)).or_else(|_| fs::write(folder.file(name), "{}")).expect("written");
        }
        assert!(load().expect_err("a policy without its run").contains("a graph.json without a checkpoint"));
    }
}
