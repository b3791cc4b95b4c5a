//! Checkpoints of both trainers.

use crate::accepted;
use std::fs;
use tempfile::TempDir;
use tpg_train::parts::RunFolder;

/// A form of checkpoints.
const FORM: &str = "tpg-train tpg, checkpoint version 1";

/// A sealed checkpoint file in a folder, with its seal.
pub fn file(data: &[u8]) {
    let place = TempDir::new().expect("a temporary folder");
    fs::write(place.path().join("checkpoint"), data).expect("the folder can be written");
    let folder = RunFolder::open(place.path(), true).expect("a folder of its own");
    if let Some(Some(length)) = accepted(folder.load(FORM, |_, content| Ok(content.len()))) {
        assert!(length < data.len(), "a seal has a length");
    }
}
