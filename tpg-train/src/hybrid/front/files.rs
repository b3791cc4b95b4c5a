//! The files of a front.

use super::{Front, Kind, Outcome, Point, Trained};
use crate::csv_text::table;
use crate::files::{read_text, write_atomically};
use crate::hybrid::setting::{HybridFile, Setting};
use crate::hybrid::study::absolute;
use std::path::Path;
use tpg_graph::error::{InputError, Place};

/// The name of the file that [`read`] reads.
pub const JSON: &str = "front.json";

/// Writes `front.json`, `front.csv`, and the chosen price's best seed as `hybrid.toml`.
///
/// # Errors
/// If a file cannot be written.
pub fn write(front: &Front, trained: &Trained<'_>, folder: &Path) -> Result<(), InputError> {
    let json = serde_json::to_string_pretty(front).expect("plain data") + "\n";
    write_atomically(&folder.join(JSON), json.as_bytes())?;
    write_atomically(&folder.join("front.csv"), &csv(front))?;
    let Some(hybrid) = hybrid(front, trained) else { return Ok(()) };
    write_atomically(&folder.join("hybrid.toml"), toml::to_string(&hybrid).expect("plain data").as_bytes())
}

/// Reads a `front.json`.
///
/// # Errors
/// If it cannot be read, or is none.
pub fn read(path: &Path) -> Result<Front, InputError> {
    const ACCEPTED: &str = "the front.json of a run with several prices";
    serde_json::from_str(&read_text(path, ACCEPTED)?).map_err(|error| {
        InputError::new(path.display().to_string(), Place::Line(error.line()), error.to_string(), ACCEPTED)
    })
}

/// A row for each point, and one for each of its seeds.
fn csv(front: &Front) -> Vec<u8> {
    let header = [
        "kind",
        "setting",
        "seed",
        "score",
        "score_error",
        "network_actions",
        "actions",
        "mean_operations",
        "most_operations",
        "on_front",
        "chosen",
    ];
    let row = |point: &Point, seed: String, result: &Outcome| {
        [
            point.kind.name().to_owned(),
            point.setting.clone(),
            seed,
            result.score.to_string(),
            result.score_error.to_string(),
            result.network_actions.to_string(),
            result.actions.to_string(),
            result.operations.mean.to_string(),
            result.operations.worst.to_string(),
            point.on_front.to_string(),
            point.chosen.to_string(),
        ]
    };
    let of_point = |point: &Point| {
        let seeds = front.seeds.iter().map(u64::to_string).zip(&point.seeds).filter(|_| point.kind != Kind::Network);
        let mut rows = vec![row(point, "mean".to_owned(), &point.mean)];
        rows.extend(seeds.map(|(seed, result)| row(point, seed, result)));
        rows
    };
    table(header, front.points.iter().flat_map(of_point))
}

/// The best graph of the chosen price with the network, without rules.
fn hybrid(front: &Front, trained: &Trained<'_>) -> Option<HybridFile> {
    let prices = front.points.iter().filter(|point| point.kind == Kind::Asking);
    let (point, (_, graphs)) = prices.zip(&trained.asking).find(|(point, _)| point.chosen)?;
    let of_seeds = point.seeds.iter().zip(graphs).rev();
    let (_, (graph, _)) = of_seeds.max_by(|a, b| a.0.score.total_cmp(&b.0.score))?;
    let Setting { hand_back_after, separation, patience, detector: cycle_detector } = Setting::ONLY_ASKS;
    Some(HybridFile {
        problem: front.problem.clone(),
        graph: graph.clone(),
        actor: absolute(front.network.as_ref()),
        hand_back_after,
        separation,
        patience,
        cycle_detector,
    })
}
