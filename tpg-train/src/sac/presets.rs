//! The configurations included with the trainer, with a comment for every setting.

use super::config::SacConfig;
use tpg_graph::error::InputError;
use tpg_problems::ProblemName;

/// A configuration included with the trainer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Preset {
    /// Its name.
    pub name: &'static str,
    /// One-line description.
    pub about: &'static str,
    /// The file that its text is made from.
    file: &'static str,
    /// Replacements that its text has for words of the file, wherever these stand: old words, new words.
    changes: &'static [(&'static str, &'static str)],
}

impl Preset {
    /// Creates a preset whose text is a file.
    const fn new(name: &'static str, about: &'static str, file: &'static str) -> Self {
        Self { name, about, file, changes: &[] }
    }

    /// Changes words of the file.
    const fn with(self, changes: &'static [(&'static str, &'static str)]) -> Self {
        Self { changes, ..self }
    }

    /// Returns its commented text.
    pub fn text(&self) -> String {
        self.changes.iter().fold(self.file.to_owned(), |text, (old, new)| text.replace(old, new))
    }
}

/// Every preset.
pub const PRESETS: [Preset; 6] = [
    Preset::new("general", "for any problem with outputs", include_str!("presets/general.toml")),
    Preset::new("long", "for episodes of hundreds of steps", include_str!("presets/long.toml")),
    Preset::new("best-fs", "ours, the arm from its home position", include_str!("presets/best-fs.toml")),
    Preset::new("best-rs", "ours, the arm from anywhere", include_str!("presets/best-fs.toml")).with(&[
        ("for the fixed start.", "for both starts, chosen on random starts."),
        RANDOM_START,
        MOSTLY_ANYWHERE,
    ]),
    Preset::new(
        "no-planner-fs",
        "as best-fs, without a reward that knows solving poses",
        include_str!("presets/no-planner-fs.toml"),
    ),
    Preset::new(
        "no-planner-rs",
        "as best-rs, without a reward that knows solving poses",
        include_str!("presets/no-planner-fs.toml"),
    )
    .with(&[RANDOM_START, MOSTLY_ANYWHERE]),
];

/// The start that chooses the best candidate.
const RANDOM_START: (&str, &str) = ("name = \"fs\"", "name = \"rs\"");
/// Which episodes train.
const MOSTLY_ANYWHERE: (&str, &str) = ("fixed_start_share = 0.7", "fixed_start_share = 0.3");

/// Finds a preset by name.
pub fn find(name: &str) -> Option<&'static Preset> {
    PRESETS.iter().find(|preset| preset.name == name)
}

/// Returns the name of the preset used for a problem by default.
pub fn usual(problem: ProblemName) -> &'static str {
    match problem {
        ProblemName::Fs => "best-fs",
        ProblemName::Rs => "best-rs",
        _ => "general",
    }
}

/// Returns the configuration of a preset.
///
/// # Errors
/// None: a test reads every preset.
pub fn config(preset: &Preset) -> Result<SacConfig, InputError> {
    SacConfig::from_toml(&format!("<preset {}>", preset.name), &preset.text())
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
                let problem =
                    ContinuousProblem::from_toml(preset.name, &preset.text()).expect("a problem of the registry");
                assert_eq!(problem.to_table().len(), config.problem.len(), "{}: every setting is said", preset.name);
            }
            assert_eq!(SacConfig::from_toml("written", &config.to_toml()), Ok(config));
        }
    }
}
