//! The log of a run: a row for each validation, without a clock, so that equal runs have equal logs.

use super::training::{Recent, Training};
use serde_json::{Value, json};
use tpg_engine::{Environment, Summary};

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
