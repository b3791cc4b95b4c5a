//! Checkpoints: everything a run needs to end with the same bytes as if it had never stopped.

use super::config::Config;
use super::state::State;
use crate::files::{read_text, write_atomically};
use serde::{Deserialize, Serialize, de::DeserializeOwned};
use std::fs;
use std::io::ErrorKind;
use std::path::Path;
use tpg_graph::error::{InputError, Place};

/// The value of [`Checkpoint::format`].
const FORMAT: &str = "tpg-train checkpoint";
/// Incremented with every change to the content or meaning of checkpoints.
const VERSION: u32 = 2;

/// The serialised form.
#[derive(Debug, Serialize, Deserialize)]
#[serde(bound(deserialize = "Task: DeserializeOwned"))]
struct Checkpoint<Task> {
    format: String,
    version: u32,
    config: String,
    state: State<Task>,
}

/// Writes a checkpoint; the previous one is kept until the new one is complete.
///
/// # Errors
/// If it cannot be written.
pub fn save<Task: Serialize + Clone>(path: &Path, config: &Config, state: &State<Task>) -> Result<(), InputError> {
    let checkpoint =
        Checkpoint { format: FORMAT.to_owned(), version: VERSION, config: config.to_toml(), state: state.clone() };
    let text = serde_json::to_string(&checkpoint)
        .map_err(|error| InputError::io(path, &error.into(), "a task that can be written as JSON"))?;
    write_atomically(path, text.as_bytes())
}

/// Reads a checkpoint: its configuration and the state at the end of a generation.
///
/// # Errors
/// If it cannot be read or is not a checkpoint of this version.
pub fn open<Task: DeserializeOwned>(path: &Path) -> Result<(Config, State<Task>), InputError> {
    let file = path.display().to_string();
    let text = read_text(path, "a checkpoint")?;
    let checkpoint: Checkpoint<Task> = parse(&file, &text)?;
    let config = Config::of_run(&format!("{file}, config"), &checkpoint.config)?;
    Ok((config, checkpoint.state))
}

fn parse<Task: DeserializeOwned>(file: &str, text: &str) -> Result<Checkpoint<Task>, InputError> {
    let refuse = |found: String, accepted: &str| InputError::new(file, Place::Whole, found, accepted);
    let checkpoint: Checkpoint<Task> = serde_json::from_str(text).map_err(|error| {
        refuse(format!("not a checkpoint: {error}"), "a checkpoint written by this version of tpg-train")
    })?;
    if checkpoint.format != FORMAT || checkpoint.version != VERSION {
        let found = format!("{:?}, version {}", checkpoint.format, checkpoint.version);
        return Err(refuse(found, &format!("{FORMAT:?}, version {VERSION}")));
    }
    Ok(checkpoint)
}

/// Reads a checkpoint; `None` if there is none.
///
/// # Errors
/// If it cannot be read, is not a checkpoint, or belongs to another configuration or seed; the error shows the
/// difference.
pub fn load<Task: DeserializeOwned>(
    path: &Path,
    config: &Config,
    seed: u64,
) -> Result<Option<State<Task>>, InputError> {
    let text = match fs::read_to_string(path) {
        Ok(text) => text,
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(InputError::io(path, &error, "a checkpoint that can be read")),
    };
    let refuse =
        |found: String, accepted: &str| InputError::new(path.display().to_string(), Place::Whole, found, accepted);
    let checkpoint: Checkpoint<Task> = parse(&path.display().to_string(), &text)?;
    // Read and written again: a key added since then has its default and does not count as a difference. A run may be
    // extended by more generations.
    let generations = config.learning.nb_generations;
    let own = toml::from_str::<Config>(&checkpoint.config).map_or(checkpoint.config, |mut own| {
        own.learning.nb_generations = generations;
        own.to_toml()
    });
    let difference = difference(&own, &config.to_toml());
    if !difference.is_empty() {
        let found = format!("a checkpoint of another configuration:\n{}", difference.join("\n"));
        return Err(refuse(found, "the configuration that the run began with, or another --out"));
    }
    if checkpoint.state.seed != seed {
        return Err(refuse(format!("a checkpoint of seed {}", checkpoint.state.seed), &format!("seed {seed}")));
    }
    Ok(Some(checkpoint.state))
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
