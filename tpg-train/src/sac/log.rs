//! The log of a run: a row for each validation, without a clock, so that equal runs have equal logs.

use super::training::{Recent, Training};
use crate::evolution::logs::cpu_seconds;
use serde_json::{Value, json};
use std::path::Path;
use std::time::Instant;
use tpg_engine::{Environment, Summary};
use tpg_graph::error::InputError;
use tpg_graph::files::write_atomically;

/// Returns the row of a validation.
pub(crate) fn row<E: Environment<f32>>(
    training: &Training<'_, E>,
    recent: &Recent,
    result: &Summary,
    environment: &E,
) -> Value {
    let means = recent.means();
    let mut row = json!({
        "decisions": training.decisions,
        "updates": training.updates,
        "steps": recent.steps,
        "critic_loss": means.critic_loss,
        "actor_loss": means.actor_loss,
        "entropy": means.entropy,
        "temperature": means.temperature,
        "score": result.score,
        "mean_actions": result.actions,
    });
    if let Some(success) = result.success {
        row["success"] = json!(success);
    }
    if environment.measure().is_some() {
        row["measure"] = json!(result.measure);
    }
    for (name, count) in environment.outcomes().iter().zip(&recent.ends) {
        row[format!("ended: {name}")] = json!(count);
    }
    row
}

/// Writes `log.jsonl` and `time.json`: the time of this process, which began its part of the run at `began`.
///
/// # Errors
/// If they cannot be written.
pub(crate) fn write(folder: &Path, rows: &[Value], began: Instant) -> Result<(), InputError> {
    let lines = rows.iter().map(|row| format!("{row}\n"));
    write_atomically(&folder.join("log.jsonl"), lines.collect::<String>().as_bytes())?;
    let time = json!({ "cpu_seconds_of_this_process": cpu_seconds(), "seconds": began.elapsed().as_secs_f64() });
    write_atomically(&folder.join("time.json"), format!("{time}\n").as_bytes())
}
