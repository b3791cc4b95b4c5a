//! The content of a checkpoint: everything a run needs to end with the same bytes as if it had never stopped.

use super::config::EvolutionConfig;
use super::state::State;
use crate::configuration::Configuration as _;
use serde::{Deserialize, Serialize, de::DeserializeOwned};
use tpg_engine::Environment;
use tpg_graph::error::{InputError, Place};
use tpg_runtime::scalar::Scalar;

/// Trainer and version, which is incremented with every change to the content or meaning of checkpoints.
pub(super) const FORM: &str = "tpg-train tpg, checkpoint version 17";

/// The serialised form, one line of JSON.
#[derive(Debug, Serialize, Deserialize)]
#[serde(bound(deserialize = "Task: DeserializeOwned"), deny_unknown_fields)]
struct Checkpoint<Task> {
    config: String,
    /// The names of what policies read and answer.
    names: Vec<String>,
    state: State<Task>,
}

/// Returns the content of a checkpoint.
///
/// # Errors
/// If a task of the environment cannot be written as JSON; `file` is named in the error.
pub(super) fn to_bytes<S: Scalar, E: Environment<S>>(
    file: &str,
    config: &EvolutionConfig,
    state: &State<E::Task>,
    environment: &E,
) -> Result<Vec<u8>, InputError> {
    let checkpoint = Checkpoint { config: config.to_toml(), names: names(environment), state: state.clone() };
    serde_json::to_vec(&checkpoint)
        .map_err(|error| InputError::new(file, Place::Whole, error.to_string(), "a task that can be written as JSON"))
}

/// Returns a name for each value that policies read, and each that they answer.
fn names<S: Scalar>(environment: &impl Environment<S>) -> Vec<String> {
    let sources = environment.sources().into_iter();
    let read = sources.flat_map(|source| vec![source.name; source.length as usize]);
    read.chain(environment.actions().names().map(str::to_owned)).collect()
}

/// Reads the content of a checkpoint.
///
/// # Errors
/// If it is not a checkpoint, or belongs to another configuration (the error shows the difference), environment or seed.
pub(super) fn from_bytes<S: Scalar, E: Environment<S>>(
    file: &str,
    content: &[u8],
    config: &EvolutionConfig,
    seed: u64,
    environment: &E,
) -> Result<State<E::Task>, InputError> {
    let refuse = |found: String, accepted: &str| InputError::new(file, Place::Whole, found, accepted);
    let damaged =
        |error| refuse(format!("not a checkpoint: {error}"), "a checkpoint written by this version of tpg-train");
    let checkpoint: Checkpoint<E::Task> = serde_json::from_slice(content).map_err(damaged)?;
    // Read and written again: a key added since then has its default and does not count as a difference. A run may be
    // extended by more generations.
    let generations = config.learning.nb_generations;
    let own = toml::from_str::<EvolutionConfig>(&checkpoint.config).map_or(checkpoint.config, |mut own| {
        own.learning.nb_generations = generations;
        own.to_toml()
    });
    let difference = difference(&own, &config.to_toml());
    if !difference.is_empty() {
        let found = format!("a checkpoint of another configuration:\n{}", difference.join("\n"));
        return Err(refuse(found, "the configuration that the run began with, or another --out"));
    }
    let (state, names) = (checkpoint.state, names(environment));
    if checkpoint.names != names {
        return Err(refuse(
            format!("a checkpoint of an environment with {}", checkpoint.names.join(" ")),
            &names.join(" "),
        ));
    }
    if state.seed != seed {
        return Err(refuse(format!("a checkpoint of seed {}", state.seed), &format!("seed {seed}")));
    }
    Ok(state)
}

/// Returns the lines in which two configurations differ, with their sections.
fn difference(of_checkpoint: &str, given: &str) -> Vec<String> {
    let entries = |text: &str| {
        let mut section = String::new();
        let mut entries = Vec::new();
        for line in text.lines() {
            if line.starts_with('[') {
                section = line.trim_matches(['[', ']']).to_owned();
            } else if !line.is_empty() {
                entries.push(format!("{section}.{line}"));
            }
        }
        entries
    };
    let (old, new) = (entries(of_checkpoint), entries(given));
    let only = |these: &[String], those: &[String], sign: char| {
        these.iter().filter(|line| !those.contains(line)).map(|line| format!("  {sign} {line}")).collect::<Vec<_>>()
    };
    [only(&old, &new, '-'), only(&new, &old, '+')].concat()
}

#[cfg(test)]
mod tests;
