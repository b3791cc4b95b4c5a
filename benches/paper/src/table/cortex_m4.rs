//! Instructions on a Cortex-M4, as `cargo xtask qemu` counted them and `c-harness/costs.toml` keeps them.

use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::Path;
use tpg_graph::error::{InputError, Place};
use tpg_problems::arm::targets::Start;
use tpg_train::files::read_text;

/// One thing that was counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Count {
    /// Decisions.
    pub actions: u64,
    /// Instructions of all of them.
    pub instructions: u64,
    /// Most instructions of one.
    pub worst: u64,
}

impl Count {
    /// Instructions of a mean decision.
    pub fn mean(&self) -> f64 {
        self.instructions as f64 / self.actions.max(1) as f64
    }
}

/// All that was counted.
#[derive(Clone, Debug, Deserialize)]
pub struct Counts {
    #[serde(rename = "cost")]
    counts: BTreeMap<String, Count>,
}

impl Counts {
    /// Reads `costs.toml`.
    ///
    /// # Errors
    /// If it cannot be read or holds something else.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        let text = read_text(path, "counted instructions, as `cargo xtask qemu --update` writes them")?;
        toml::from_str(&text).map_err(|error| {
            let line = error.span().map_or(0, |span| text[..span.start].lines().count().max(1));
            InputError::new(path.display().to_string(), Place::Line(line), error.message(), "[cost.\"…\"] tables")
        })
    }

    /// A part of the shipped hybrid (`hybrid`, `graph`, `network`) in a language's firmware.
    pub fn part(&self, language: &str, start: Start, part: &str) -> Option<Count> {
        let problem = match start {
            Start::Fs => "fs",
            Start::Rs => "rs",
        };
        self.named(&format!("{language} {problem} {part}"))
    }

    /// What was counted under that name.
    pub fn named(&self, name: &str) -> Option<Count> {
        self.counts.get(name).copied()
    }
}
