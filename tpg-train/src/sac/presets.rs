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
pub const PRESETS: [Preset; 10] = [
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
    Preset::new("paper-fs", "the paper's learning problem, fixed start", include_str!("presets/paper-fs.toml")),
    Preset::new("paper-rs", "the paper's learning problem, random start", include_str!("presets/paper-fs.toml")).with(
        &[
            ("its artifact): 13", "its artifact), random start: 13"),
            RANDOM_START,
            ("inputs = \"paper-fs\"", "inputs = \"paper-rs\""),
            ("fixed_start_share = 1.0", "fixed_start_share = 0.0"),
            ("max_steps = 1000", "max_steps = 2000"),
            (
                "step = 3                    # ticks of a coarse action in training;",
                "step = 5                    # ticks of an action in training, as in the artifact;",
            ),
            (
                "tolerance = 3.0             # in training an episode succeeds nearer than this, mm; in",
                "tolerance = 5.0             # an episode succeeds nearer than this, mm, in training, as in the artifact; in",
            ),
        ],
    ),
    Preset::new(
        "paper-fs-16-units",
        "as paper-fs, with layers of 16 units",
        include_str!("presets/paper-fs.toml"),
    )
    .with(&[("256-256", "16-16"), ("hidden = [256, 256]", "hidden = [16, 16]")]),
    Preset::new(
        "paper-fs-no-collision-in-training",
        "as paper-fs, where an invalid step ends training episodes too",
        include_str!("presets/paper-fs.toml"),
    )
    .with(&[
        ("update every 16 steps.", "update every 16 steps.\n# Variant: an invalid step ends a training episode."),
        (
            "invalid_ends = false        # training goes on after an invalid step; tests end",
            "invalid_ends = true",
        ),
        (
            "decisions = 10_000_000",
            "decisions = 2_500_000       # a quarter: the paper trained it for 7,200 s, the others for 28,800 s",
        ),
    ]),
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
