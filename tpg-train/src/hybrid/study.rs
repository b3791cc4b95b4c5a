//! Studies: every pair of a graph and a network under every setting, in parallel and resumable.

use super::cells::{Cell, Key, Subject, key};
use super::setting::Setting;
use crate::folder::frame::checksum;
use crate::folder::{RunFolder, Trainer};
use crate::interrupt;
use crate::progress::Bar;
use rayon::ThreadPool;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};
use tpg_graph::error::{InputError, Place};
use tpg_graph::files::{read_text, write_atomically};

/// Incremented with every change to the content or meaning of checkpoints: the finished cells as CSV.
pub(crate) const VERSION: u32 = 1;

/// Interval between saves of finished cells.
const SAVE_EVERY: Duration = Duration::from_secs(10);

/// Computes all cells that the folder's checkpoint does not hold yet; `cells.csv` always contains whole rows of finished
/// cells, in order. `None` if the user stopped it before all were done.
///
/// # Errors
/// If the checkpoint does not belong to a study, a policy does not fit the problem, or a file cannot be written.
pub(crate) fn run(
    study: &Subject<'_>,
    folder: &RunFolder,
    threads: &ThreadPool,
) -> Result<Option<Vec<Cell>>, InputError> {
    let stop = interrupt::watch();
    let known = folder.load(VERSION, read)?.unwrap_or_default();
    let finished: BTreeMap<Key, Cell> = known.into_iter().map(|cell| (cell.key(), cell)).collect();
    let pairs = (0..study.graphs.len()).flat_map(|tpg| (0..study.networks.len()).map(move |sac| (tpg, sac)));
    let all: Vec<(usize, usize, &Setting)> =
        pairs.flat_map(|(tpg, sac)| study.settings.iter().map(move |setting| (tpg, sac, setting))).collect();
    let open: Vec<_> =
        all.iter().filter(|&&(tpg, sac, setting)| !finished.contains_key(&key(tpg, sac, setting))).collect();
    let progress = Bar::new();
    let done = Mutex::new((finished, Instant::now()));
    threads.install(|| {
        open.par_iter().try_for_each(|&&(tpg, sac, setting)| {
            if stop.load(Ordering::Relaxed) {
                return Ok(());
            }
            let cell = study.cell(tpg, sac, setting)?;
            let mut done = done.lock().unwrap_or_else(PoisonError::into_inner);
            let (finished, saved) = &mut *done;
            finished.insert(cell.key(), cell);
            progress.show(finished.len() as u64, all.len() as u64, String::new);
            if saved.elapsed() > SAVE_EVERY {
                write(folder, finished.values())?;
                *saved = Instant::now();
            }
            Ok(())
        })
    })?;
    let (finished, _) = done.into_inner().unwrap_or_else(PoisonError::into_inner);
    write(folder, finished.values())?;
    Ok((finished.len() == all.len()).then(|| finished.into_values().collect()))
}

/// Writes rows as CSV.
pub(crate) fn to_csv<'a, T: Serialize + 'a>(rows: impl Iterator<Item = &'a T>) -> Vec<u8> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    rows.for_each(|row| writer.serialize(row).expect("plain data in memory"));
    writer.into_inner().expect("memory can be written")
}

fn write<'a>(folder: &RunFolder, cells: impl Iterator<Item = &'a Cell>) -> Result<(), InputError> {
    let cells = to_csv(cells);
    write_atomically(&folder.file("cells.csv"), &cells)?;
    folder.save(VERSION, cells)
}

/// Reads finished cells.
fn read(name: &str, cells: &[u8]) -> Result<Vec<Cell>, InputError> {
    let mut reader = csv::Reader::from_reader(cells);
    let cells: Result<Vec<Cell>, csv::Error> = reader.deserialize().collect();
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
        let sha256 = checksum(&bytes);
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
