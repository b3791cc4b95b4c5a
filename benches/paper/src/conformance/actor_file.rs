//! Weights of an actor in PyTorch's format: a zip archive with the numbers of each tensor in a file.

use super::artifact::read;
use crate::actor::RecordedActor;
use serde_json::json;
use std::io::{Cursor, Read as _};
use std::path::Path;
use tpg_graph::error::{InputError, Place};
use tpg_problems::arm::targets::Start;
use zip::ZipArchive;

/// The archive's files in the order of this project's weights, and their numbers: the layers come first there, then the
/// norms, here each norm follows its layer.
const PARTS: [(usize, usize); 12] = [
    (0, 256 * 13),
    (1, 256),
    (4, 256),
    (5, 256),
    (2, 256 * 256),
    (3, 256),
    (6, 256),
    (7, 256),
    (8, 4 * 256),
    (9, 4),
    (10, 4 * 256),
    (11, 4),
];

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
    for (number, length) in PARTS {
        let before = weights.len();
        let read = archive
            .by_name(&format!("actor/data/{number}"))
            .map_err(|error| error.to_string())
            .and_then(|file| file.take(1 << 20).read_to_end(&mut weights).map_err(|error| error.to_string()));
        match read {
            Ok(_) if weights.len() - before == 4 * length => {}
            Ok(bytes) => return refuse(format!("{bytes} bytes of tensor {number}")),
            Err(error) => return refuse(format!("tensor {number}: {error}")),
        }
    }
    Ok(weights)
}

/// Returns the description of an actor's weights.
pub(super) fn description(start: Start) -> String {
    let mut offset = 0;
    let layout: Vec<_> = RecordedActor::layout()
        .map(|(name, shape)| {
            let part = json!({"name": name, "shape": shape, "offset": offset});
            offset += shape.iter().product::<usize>();
            part
        })
        .collect();
    let order = match start {
        Start::Fs => "target/100,diff/100,hand/100,motors",
        Start::Rs => "target/100,hand/100,diff/100,motors",
    };
    json!({
        "dtype": "f32 little endian",
        "layout": layout,
        "activation": "fc1->relu->ln1->fc2->relu->ln2->{mu,sigma}; LayerNorm eps 1e-5, sigma=clamp(raw,1e-6,1)",
        "state_order": order,
    })
    .to_string()
}
