//! The configurations included with the trainer: `general`, and the differences of the others.

use super::config::SacConfig;
use crate::configuration::merge;
use tpg_graph::error::InputError;
use tpg_problems::ProblemName;

/// A configuration included with the trainer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Preset {
    /// Its name.
    pub name: &'static str,
    /// One-line description.
    pub about: &'static str,
    /// The preset that it differs from.
    extends: Option<&'static str>,
    /// The differences, as TOML.
    text: &'static str,
}

const fn preset(name: &'static str, about: &'static str, extends: &'static str, text: &'static str) -> Preset {
    Preset { name, about, extends: Some(extends), text }
}

/// Every preset.
pub const PRESETS: [Preset; 6] = [
    Preset {
        name: "general",
        about: "for any problem with outputs: small networks that learn in minutes on one core",
        extends: None,
        text: include_str!("presets/general.toml"),
    },
    preset("long", "for episodes of hundreds of steps", "general", include_str!("presets/long.toml")),
    preset("best-fs", "ours, the arm from its home position", "general", include_str!("presets/best-fs.toml")),
    preset("best-rs", "ours, the arm from anywhere", "best-fs", RANDOM_START),
    preset(
        "no-planner-fs",
        "as best-fs, without a reward that knows solving poses",
        "best-fs",
        include_str!("presets/no-planner-fs.toml"),
    ),
    preset("no-planner-rs", "as best-rs, without a reward that knows solving poses", "no-planner-fs", RANDOM_START),
];

/// The start that chooses the best candidate, and the share of training episodes that start at home.
const RANDOM_START: &str = "[problem]\nname = \"rs\"\nfixed_start_share = 0.3\n";

/// Finds a preset by name.
pub fn find(name: &str) -> Option<&'static Preset> {
    PRESETS.iter().find(|preset| preset.name == name)
}

/// Returns the name of the preset used for a problem by default.
pub fn default_for(problem: ProblemName) -> &'static str {
    match problem {
        ProblemName::Fs => "best-fs",
        ProblemName::Rs => "best-rs",
        _ => "general",
    }
}

impl Preset {
    /// Returns all settings.
    ///
    /// # Panics
    /// Never: a test reads every preset.
    pub fn table(&self) -> toml::Table {
        let mut table = self.extends.and_then(find).map(Self::table).unwrap_or_default();
        merge(&mut table, &self.text.parse().expect("a preset is TOML"));
        table
    }
}

/// Returns the configuration of a preset.
///
/// # Errors
/// None: a test reads every preset.
pub fn config(preset: &Preset) -> Result<SacConfig, InputError> {
    SacConfig::from_toml(&format!("<preset {}>", preset.name), &preset.table().to_string())
}

#[cfg(test)]
mod tests {
    use super::{PRESETS, config};
    use crate::sac::config::SacConfig;
    use tpg_problems::ContinuousProblem;

    #[test]
    fn every_preset_is_accepted_and_written_as_it_was_read() {
        for preset in PRESETS {
            let config = config(&preset).unwrap_or_else(|error| panic!("{error}"));
            if !config.problem.is_empty() {
                ContinuousProblem::from_toml(preset.name, &preset.table().to_string())
                    .expect("a problem of the registry");
            }
            assert_eq!(SacConfig::from_toml("written", &config.to_toml()), Ok(config));
        }
    }
}
