//! Studies: every pair of a graph and a network under every setting, in parallel.

use super::cells::{Cell, Subject};
use crate::csv_text::to_csv;
use crate::folder::RunFolder;
use rayon::ThreadPool;
use rayon::prelude::*;
use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};
use tpg_graph::error::{InputError, Place};
use tpg_graph::files::write_atomically;
use tpg_graph::progress::Bar;

/// Computes all cells: a row of `cells.csv` for each pair and setting.
///
/// # Errors
/// If a policy does not fit the problem, or the file cannot be written.
pub(crate) fn run(study: &Subject<'_>, folder: &RunFolder, threads: &ThreadPool) -> Result<Vec<Cell>, InputError> {
    let pairs = (0..study.graphs.len()).flat_map(|tpg| (0..study.networks.len()).map(move |sac| (tpg, sac)));
    let all: Vec<_> = pairs.flat_map(|pair| study.settings.iter().map(move |setting| (pair, setting))).collect();
    let (progress, done) = (Bar::begin(), AtomicU64::new(0));
    let cells: Result<Vec<Cell>, InputError> = threads.install(|| {
        let cell = |&((tpg, sac), setting)| {
            let cell = study.cell(tpg, sac, setting)?;
            progress.show(done.fetch_add(1, Ordering::Relaxed) + 1, all.len() as u64, String::new);
            Ok(cell)
        };
        all.par_iter().map(cell).collect()
    });
    let cells = cells?;
    write_atomically(&folder.file("cells.csv"), &to_csv(cells.iter().map(|cell| (&cell.setting, cell))))?;
    Ok(cells)
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
