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
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::{fmt, fs};
use tpg_graph::error::{InputError, Place};
use tpg_graph::files::{make_folder, write_atomically};
use tpg_graph::output::remove_unfinished;

/// A command that keeps its state in a folder.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trainer {
    /// `tpg-train tpg`, one seed.
    Tpg,
    /// `tpg-train tpg --seeds`: the folder that holds a folder for each seed.
    Restarts,
    /// `tpg-train sac`.
    Sac,
    /// `tpg-train hybrid`.
    Hybrid,
}

impl Trainer {
    const ALL: [Self; 4] = [Self::Tpg, Self::Restarts, Self::Sac, Self::Hybrid];

    /// Returns the name in a run's files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Tpg => "tpg",
            Self::Restarts => "tpg --seeds",
            Self::Sac => "sac",
            Self::Hybrid => "hybrid",
        }
    }

    /// Finds the trainer with the given [`name`](Self::name).
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|trainer| trainer.name() == name)
    }
}

impl fmt::Display for Trainer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// Files that show that a folder holds a run.
const MARKS: [&str; 4] = ["config.toml", "graph.json", "study.toml", CHECKPOINT];

/// Name of the checkpoint.
const CHECKPOINT: &str = "checkpoint";

/// The folder of a run under way. It is locked until this is dropped or the process ends, by whatever cause.
#[derive(Debug)]
pub struct RunFolder {
    path: PathBuf,
    trainer: Trainer,
    _lock: Lock,
}

impl RunFolder {
    /// Creates the folder if it does not exist, locks it, and removes unfinished files of killed processes.
    ///
    /// ```
    /// use tpg_train::parts::{RunFolder, Trainer};
    ///
    /// let place = tempfile::tempdir()?;
    /// let run = place.path().join("run");
    /// let folder = RunFolder::open(&run, Trainer::Tpg, false)?;
    /// let refused = RunFolder::open(&run, Trainer::Tpg, true).expect_err("it is in use");
    /// assert!(refused.found.contains(&format!("process {}", std::process::id())));
    ///
    /// folder.save(1, b"content".to_vec())?;
    /// drop(folder);
    /// let folder = RunFolder::open(&run, Trainer::Tpg, true)?;
    /// assert_eq!(folder.load(1, |_file, content| Ok(content.to_vec()))?, Some(b"content".to_vec()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If another process uses the folder, it holds a run and `resume` is false, the run belongs to another trainer or
    /// an earlier version, or the folder cannot be written.
    pub fn open(path: &Path, trainer: Trainer, resume: bool) -> Result<Self, InputError> {
        make_folder(path)?;
        // First without the lock: a folder that is refused stays as it is.
        if !resume && !Lock::is_held(path) {
            refuse_run(path, trainer)?;
        }
        let lock = Lock::take(path, trainer)?;
        if !resume {
            refuse_run(path, trainer)?;
        }
        remove_unfinished(path);
        lock.write(path, trainer)?;
        Ok(Self { path: path.to_owned(), trainer, _lock: lock })
    }

    /// Returns the path of the folder.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Returns the path of a file in the folder.
    pub fn file(&self, name: &str) -> PathBuf {
        self.path.join(name)
    }

    /// Writes a checkpoint whole or not at all.
    ///
    /// # Errors
    /// If it cannot be written; the one before is then unchanged.
    pub fn save(&self, version: u32, content: Vec<u8>) -> Result<(), InputError> {
        write_atomically(&self.file(CHECKPOINT), &frame::seal(content, self.trainer, version))
    }

    /// Reads the checkpoint; `None` if there is none. `read` gets the name of the file and the content.
    ///
    /// # Errors
    /// If it is damaged or belongs to another trainer or version, or `read` refuses its content.
    pub fn load<T>(
        &self,
        version: u32,
        read: impl FnOnce(&str, &[u8]) -> Result<T, InputError>,
    ) -> Result<Option<T>, InputError> {
        let path = self.file(CHECKPOINT);
        let bytes = match fs::read(&path) {
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
            bytes => bytes.map_err(|error| InputError::io(&path, &error, "a checkpoint that can be read"))?,
        };
        let content = frame::open(&bytes, self.trainer, version).map_err(|finding| place(&path, finding))?;
        read(&path.display().to_string(), content).map(Some)
    }
}

fn refuse_run(path: &Path, trainer: Trainer) -> Result<(), InputError> {
    if MARKS.iter().any(|name| path.join(name).exists()) {
        let accepted =
            if trainer == Trainer::Hybrid { "another folder" } else { "another folder, or --resume to continue" };
        return Err(InputError::new(path.display().to_string(), Place::Whole, "already holds a run", accepted));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::{CHECKPOINT, MARKS, RunFolder, Trainer};
    use std::fs;
    use tpg_graph::error::{InputError, Place};

    #[test]
    fn a_folder_belongs_to_one_trainer_and_to_one_process_at_a_time() {
        let place = tempfile::tempdir().expect("a temporary folder");
        let run = place.path().join("a/run");
        let open = |trainer, resume| RunFolder::open(&run, trainer, resume).map_err(|error| error.to_string());
        let folder = open(Trainer::Sac, false).expect("a new folder");
        let refused = open(Trainer::Sac, true).expect_err("in use");
        let process = format!("process {}", std::process::id());
        assert!(refused.contains(&process) && refused.contains("one process"), "{refused}");
        assert!(open(Trainer::Sac, false).expect_err("in use").contains(&process));
        drop(folder);
        for trainer in [Trainer::Tpg, Trainer::Restarts, Trainer::Hybrid] {
            let refused = open(trainer, true).expect_err("of another trainer");
            assert!(refused.contains("tpg-train sac") && refused.contains(trainer.name()), "{refused}");
        }
        assert!(open(Trainer::Sac, true).is_ok());
    }

    #[test]
    fn a_run_is_not_begun_again_by_mistake_and_the_folder_stays_as_it_was() {
        for mark in MARKS {
            let folder = tempfile::tempdir().expect("a temporary folder");
            fs::write(folder.path().join(mark), "content").expect("written");
            let refused = RunFolder::open(folder.path(), Trainer::Tpg, false).expect_err(mark);
            assert!(refused.accepted.contains("--resume"), "{refused}");
            assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 1, "{mark} alone");
        }
    }

    #[test]
    fn what_killed_processes_left_is_removed() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let left = folder.path().join(".tpg-unfinished-AbCdEf");
        fs::write(&left, "half").expect("written");
        RunFolder::open(folder.path(), Trainer::Hybrid, true).expect("a folder");
        assert!(!left.exists());
    }

    #[test]
    fn the_newest_checkpoint_is_read_and_a_damaged_or_foreign_one_is_refused_and_stays() {
        let place = tempfile::tempdir().expect("a temporary folder");
        let folder = RunFolder::open(place.path(), Trainer::Sac, true).expect("a folder");
        let text = |_: &str, content: &[u8]| Ok(String::from_utf8_lossy(content).into_owned());
        let load = || folder.load(3, text).map_err(|error| error.to_string());
        assert_eq!(load(), Ok(None));
        for content in ["one", "two"] {
            folder.save(3, content.into()).expect("written");
            assert_eq!(load().as_ref().map(Option::as_deref), Ok(Some(content)));
        }
        folder.save(2, "three".into()).expect("written");
        let error = load().expect_err("another version");
        assert!(error.contains("checkpoint version 2; accepted: tpg-train sac, checkpoint version 3"), "{error}");
        fs::write(folder.file(CHECKPOINT), "{}").expect("written");
        assert!(load().expect_err("damaged").contains("no checksum"));
        assert_eq!(fs::read_to_string(folder.file(CHECKPOINT)).expect("it stays"), "{}");
        folder.save(3, "four".into()).expect("written");
        let refuse = |file: &str, _: &[u8]| Err::<(), _>(InputError::new(file, Place::Whole, "this", "that"));
        assert!(folder.load(3, refuse).is_err());
    }
}
