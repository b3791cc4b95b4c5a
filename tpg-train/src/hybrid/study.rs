//! Studies: every pair of a graph and a network under every setting, in parallel and resumable.

use crate::folder::{RunFolder, Trainer};
use crate::interrupt;
use crate::progress::Bar;
use rayon::ThreadPool;
use rayon::prelude::*;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};
use tpg_graph::error::{InputError, Place};
use tpg_graph::files::{read_text, write_atomically};

/// A study: its settings, and a cell for each pair and setting.
pub(crate) trait Study: Sync {
    /// A setting.
    type Setting: Sync;
    /// One row of `cells.csv`.
    type Cell: Serialize + DeserializeOwned + Send;
    /// Identity of a cell; `cells.csv` is in this order.
    type Key: Ord + Send;

    /// Returns the number of graphs and of networks.
    fn policies(&self) -> [usize; 2];

    /// Returns the settings.
    fn settings(&self) -> &[Self::Setting];

    /// Returns the identity of the cell of a graph, a network and a setting.
    fn key(&self, tpg: usize, sac: usize, setting: &Self::Setting) -> Self::Key;

    /// Returns the identity of a cell.
    fn key_of(&self, cell: &Self::Cell) -> Self::Key;

    /// Computes a cell.
    ///
    /// # Errors
    /// If a policy does not fit the problem.
    fn cell(&self, tpg: usize, sac: usize, setting: &Self::Setting) -> Result<Self::Cell, InputError>;

    /// Returns the number of cells.
    fn size(&self) -> usize {
        self.policies().iter().product::<usize>() * self.settings().len()
    }
}

/// Incremented with every change to the content or meaning of checkpoints: the finished cells as CSV.
pub(crate) const VERSION: u32 = 1;

/// Interval between saves of finished cells.
const SAVE_EVERY: Duration = Duration::from_secs(10);

/// Returns graph, network and setting of the cell with a number.
fn place<T: Study>(study: &T, number: u64) -> (usize, usize, usize) {
    let (number, settings, [_, sacs]) = (number as usize, study.settings().len(), study.policies());
    (number / settings / sacs, number / settings % sacs, number % settings)
}

/// Computes all cells that the folder's checkpoint does not hold yet; `cells.csv` always contains whole rows of finished
/// cells, in order. `None` if `stop` was set before all were done.
///
/// # Errors
/// If the checkpoint does not belong to a study, a policy does not fit the problem, or a file cannot be written.
pub(crate) fn run<T: Study>(
    study: &T,
    folder: &RunFolder,
    threads: &ThreadPool,
    stop: &AtomicBool,
) -> Result<Option<Vec<T::Cell>>, InputError> {
    let known = folder.load(VERSION, read::<T::Cell>)?.unwrap_or_default();
    let finished: BTreeMap<T::Key, T::Cell> = known.into_iter().map(|cell| (study.key_of(&cell), cell)).collect();
    let is_open = |&number: &u64| {
        let (tpg, sac, setting) = place(study, number);
        !finished.contains_key(&study.key(tpg, sac, &study.settings()[setting]))
    };
    let open: Vec<u64> = (0..study.size() as u64).filter(is_open).collect();
    let progress = Bar::new();
    let done = Mutex::new((finished, Instant::now()));
    threads.install(|| {
        open.par_iter().try_for_each(|&number| {
            if stop.load(Ordering::Relaxed) {
                return Ok(());
            }
            let (tpg, sac, setting) = place(study, number);
            let cell = study.cell(tpg, sac, &study.settings()[setting])?;
            let mut done = done.lock().unwrap_or_else(PoisonError::into_inner);
            let (finished, saved) = &mut *done;
            finished.insert(study.key_of(&cell), cell);
            progress.show(finished.len() as u64, study.size() as u64, String::new);
            if saved.elapsed() > SAVE_EVERY {
                write(folder, finished.values())?;
                *saved = Instant::now();
            }
            Ok(())
        })
    })?;
    let (finished, _) = done.into_inner().unwrap_or_else(PoisonError::into_inner);
    write(folder, finished.values())?;
    Ok((finished.len() == study.size()).then(|| finished.into_values().collect()))
}

/// Writes rows as CSV.
pub(crate) fn to_csv<'a, T: Serialize + 'a>(rows: impl Iterator<Item = &'a T>) -> Vec<u8> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    rows.for_each(|row| writer.serialize(row).expect("plain data in memory"));
    writer.into_inner().expect("memory can be written")
}

fn write<'a, T: Serialize + 'a>(folder: &RunFolder, cells: impl Iterator<Item = &'a T>) -> Result<(), InputError> {
    let cells = to_csv(cells);
    write_atomically(&folder.file("cells.csv"), &cells)?;
    folder.save(VERSION, cells)
}

/// Reads finished cells.
fn read<T: DeserializeOwned>(name: &str, cells: &[u8]) -> Result<Vec<T>, InputError> {
    let mut reader = csv::Reader::from_reader(cells);
    let cells: Result<Vec<T>, csv::Error> = reader.deserialize().collect();
    cells.map_err(|error| {
        let line = error.position().map_or(1, |position| position.line() as usize);
        InputError::new(name, Place::Line(line), error.to_string(), "a row of a study")
    })
}

/// An input file with its content.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Input {
    file: String,
    /// Checksum of its bytes, in hexadecimal digits.
    pub(super) sha256: String,
}

impl Input {
    /// Reads files.
    ///
    /// # Errors
    /// If one cannot be read.
    pub(crate) fn read_all(paths: &[PathBuf]) -> Result<Vec<Self>, InputError> {
        paths.iter().map(|path| Self::read(path)).collect()
    }

    /// Reads a file.
    ///
    /// # Errors
    /// If it cannot be read.
    pub(crate) fn read(path: &Path) -> Result<Self, InputError> {
        let bytes = fs::read(path).map_err(|error| InputError::io(path, &error, "a graph or an actor"))?;
        let sha256 = Sha256::digest(&bytes).iter().map(|byte| format!("{byte:02x}")).collect();
        Ok(Self { file: path.display().to_string(), sha256 })
    }
}

/// Starts or resumes a study in a folder; `asked` is the content of its `study.toml`.
///
/// # Errors
/// If the folder holds another study, or one that is not to be resumed, is in use, or cannot be written.
pub(crate) fn open_folder(folder: &Path, resume: bool, asked: &impl Serialize) -> Result<RunFolder, InputError> {
    let opened = RunFolder::open(folder, Trainer::Hybrid, resume)?;
    let path = folder.join("study.toml");
    let text = toml::to_string(asked).expect("plain data");
    if path.exists() && read_text(&path, "a study.toml")? != text {
        let accepted = "the same arguments and the same files as at the start";
        return Err(InputError::new(path.display().to_string(), Place::Whole, "another study", accepted));
    }
    write_atomically(&path, text.as_bytes())?;
    Ok(opened)
}

/// Computes the cells of a study in its folder; `None` if it was interrupted.
///
/// # Errors
/// As [`run`].
pub(crate) fn in_folder<T: Study>(
    study: &T,
    folder: &RunFolder,
    threads: &ThreadPool,
) -> Result<Option<Vec<T::Cell>>, InputError> {
    let stop = interrupt::watch();
    run(study, folder, threads, &stop)
}

/// Starts threads; 0 for one per core.
///
/// # Errors
/// If they cannot be started.
pub(crate) fn threads(count: usize) -> Result<ThreadPool, InputError> {
    rayon::ThreadPoolBuilder::new().num_threads(count).build().map_err(|error| {
        InputError::new("--threads", Place::Whole, error.to_string(), "a number of threads that can be started")
    })
}

/// Returns the absolute path of a file.
pub(crate) fn absolute(path: &Path) -> String {
    path.canonicalize().unwrap_or_else(|_| path.to_owned()).display().to_string()
}
