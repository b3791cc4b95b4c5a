//! Runs at several prices of an ask: their folders, and their front.

use crate::evolution::config::EvolutionConfig;
use crate::evolution::sweep;
use crate::files::read_text;
use crate::hybrid::front::{figure, files};
use crate::picture::Section;
use std::path::{Path, PathBuf};
use tpg_graph::error::InputError;

/// Returns the folders of the runs of a sweep: without asking, then by price, as they were asked for.
pub(super) fn folders(folder: &Path) -> Result<Vec<PathBuf>, InputError> {
    let path = folder.join("sweep.toml");
    let config = EvolutionConfig::of_run(&path.display().to_string(), &read_text(&path, "the sweep.toml of a run")?)?;
    let prices = config.ask.iter().flat_map(|ask| ask.price.all());
    let names = [sweep::ALONE.to_owned()].into_iter().chain(prices.map(|&price| sweep::at_price(price)));
    Ok(names.map(|name| folder.join(name)).collect())
}

/// Returns a section for each of the folders that holds a front.
pub(super) fn sections(folders: &[PathBuf]) -> Result<Vec<Section>, InputError> {
    let fronts = folders.iter().map(|folder| folder.join(files::JSON)).filter(|path| path.exists());
    fronts.map(|path| files::read(&path).map(|front| figure::section(&front))).collect()
}
