//! The configurations included with the trainer, with a comment for every setting.

use super::config::SacConfig;
use crate::evolution::presets::Preset;
use tpg_graph::error::InputError;
use tpg_problems::ProblemName;

macro_rules! preset {
    ($name:literal, $about:literal) => {
        Preset { name: $name, about: $about, text: include_str!(concat!("presets/", $name, ".toml")) }
    };
}

/// Every preset.
pub const PRESETS: [Preset; 9] = [
    preset!("general", "for any problem with outputs"),
    preset!("best-fs", "ours, the arm from its home position"),
    preset!("best-rs", "ours, the arm from anywhere"),
    preset!("no-planner-fs", "as best-fs, without a reward that knows solving poses"),
    preset!("no-planner-rs", "as best-rs, without a reward that knows solving poses"),
    preset!("paper-fs", "the paper's learning problem, fixed start"),
    preset!("paper-rs", "the paper's learning problem, random start"),
    preset!("paper-fs-16-units", "as paper-fs, with layers of 16 units"),
    preset!("paper-fs-no-collision-in-training", "as paper-fs, where an invalid step ends training episodes too"),
];

/// Finds a preset by name.
pub fn find(name: &str) -> Option<&'static Preset> {
    PRESETS.iter().find(|preset| preset.name == name)
}

/// Returns the preset used for a problem by default.
///
/// # Panics
/// Never: each of these presets is in the list.
pub fn usual(problem: ProblemName) -> &'static Preset {
    let name = match problem {
        ProblemName::Fs => "best-fs",
        ProblemName::Rs => "best-rs",
        _ => "general",
    };
    find(name).expect("it is in the list")
}

/// Returns the configuration of a preset.
///
/// # Errors
/// None: a test reads every preset.
pub fn config(preset: &Preset) -> Result<SacConfig, InputError> {
    let (file, text) = preset.file();
    SacConfig::from_toml(&file, &text)
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
                    ContinuousProblem::from_toml(preset.name, preset.text).expect("a problem of the registry");
                assert_eq!(problem.to_table().len(), config.problem.len(), "{}: every setting is said", preset.name);
            }
            assert_eq!(SacConfig::from_toml("written", &config.to_toml()), Ok(config));
        }
    }
}
