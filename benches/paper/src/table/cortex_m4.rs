//! Instruction counts on a Cortex-M4, measured by `cargo xtask qemu` and stored in `c-harness/costs.toml`.

use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::Path;
use tpg_graph::error::{InputError, Place};
use tpg_problems::arm::targets::Start;
use tpg_train::files::read_text;

/// Instruction count of one subject.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Count {
    /// Number of decisions.
    pub actions: u64,
    /// Total number of instructions.
    pub instructions: u64,
    /// Maximum number of instructions of one decision.
    pub worst: u64,
}

impl Count {
    /// Returns the mean number of instructions of a decision.
    pub fn mean(&self) -> f64 {
        self.instructions as f64 / self.actions.max(1) as f64
    }
}

/// All instruction counts.
#[derive(Clone, Debug, Deserialize)]
pub struct Counts {
    #[serde(rename = "cost")]
    counts: BTreeMap<String, Count>,
}

impl Counts {
    /// Reads `costs.toml`.
    ///
    /// # Errors
    /// If it cannot be read or has a different format.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        let text = read_text(path, "instruction counts written by `cargo xtask qemu --update`")?;
        toml::from_str(&text).map_err(|error| {
            let line = error.span().map_or(0, |span| text[..span.start].lines().count().max(1));
            InputError::new(path.display().to_string(), Place::Line(line), error.message(), "[cost.\"…\"] tables")
        })
    }

    /// Returns the count of a part of the shipped hybrid (`hybrid`, `graph`, `network`) in a language's firmware.
    pub fn part(&self, language: &str, start: Start, part: &str) -> Option<Count> {
        let problem = match start {
            Start::Fs => "fs",
            Start::Rs => "rs",
        };
        self.named(&format!("{language} {problem} {part}"))
    }

    /// Returns the count with the given name.
    pub fn named(&self, name: &str) -> Option<Count> {
        self.counts.get(name).copied()
    }
}
