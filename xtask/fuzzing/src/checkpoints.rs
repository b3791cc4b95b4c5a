//! Checkpoints of both trainers.

use crate::accepted;
use std::fs;
use tempfile::TempDir;
use tpg_train::parts::{RunFolder, Trainer};

/// A version of checkpoints.
const VERSION: u32 = 1;

/// A sealed checkpoint file in a folder, with its seal.
pub fn file(data: &[u8]) {
    for trainer in [Trainer::Tpg, Trainer::Sac] {
        let place = TempDir::new().expect("a temporary folder");
        fs::write(place.path().join("checkpoint"), data).expect("the folder can be written");
        let folder = RunFolder::open(place.path(), trainer, true).expect("a folder of its own");
        if let Some(Some(length)) = accepted(folder.load(VERSION, |_, content| Ok(content.len()))) {
            assert!(length < data.len(), "a seal has a length");
        }
    }
}

/// Returns a sealed file: a seed.
///
/// # Panics
/// If it cannot be written.
pub fn sealed() -> Vec<u8> {
    let place = TempDir::new().expect("a temporary folder");
    let folder = RunFolder::open(place.path(), Trainer::Tpg, true).expect("a folder");
    folder.save(VERSION, b"{\"config\":\"\",\"state\":{}}".repeat(300)).expect("written");
    fs::read(place.path().join("checkpoint")).expect("a checkpoint")
}
