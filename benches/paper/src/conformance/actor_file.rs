//! Weights of an actor in PyTorch's format: a zip archive with the numbers of each tensor in a file.

use super::artifact::read;
use crate::actor::LAYOUT;
use std::io::{Cursor, Read as _};
use std::path::Path;
use tpg_graph::error::{InputError, Place};
use zip::ZipArchive;

/// The archive's files in the order of this project's weights: the layers come first there, then the norms, here each norm
/// follows its layer.
const PARTS: [usize; LAYOUT.len()] = [0, 1, 4, 5, 2, 3, 6, 7, 8, 9, 10, 11];

/// Returns the weights, `f32` in little endian.
pub(super) fn weights(path: &Path) -> Result<Vec<u8>, InputError> {
    let refuse = |found: String| {
        Err(InputError::new(
            path.display().to_string(),
            Place::Whole,
            found,
            "an actor of the artifact, saved by PyTorch",
        ))
    };
    let mut archive = match ZipArchive::new(Cursor::new(read(path)?)) {
        Ok(archive) => archive,
        Err(error) => return refuse(error.to_string()),
    };
    let mut weights = Vec::new();
    for (number, (rows, columns)) in PARTS.into_iter().zip(LAYOUT) {
        let before = weights.len();
        let read = archive
            .by_name(&format!("actor/data/{number}"))
            .map_err(|error| error.to_string())
            .and_then(|file| file.take(1 << 20).read_to_end(&mut weights).map_err(|error| error.to_string()));
        match read {
            Ok(_) if weights.len() - before == 4 * rows * columns => {}
            Ok(bytes) => return refuse(format!("{bytes} bytes of tensor {number}")),
            Err(error) => return refuse(format!("tensor {number}: {error}")),
        }
    }
    Ok(weights)
}
