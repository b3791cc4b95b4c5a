//! The configurations included with the trainer. `thorough` is the default of every setting; the others hold differences only.

use super::config::EvolutionConfig;
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
    /// The preset that it differs from; none for the defaults.
    extends: Option<&'static str>,
    /// The differences, as TOML.
    text: &'static str,
}

const fn preset(name: &'static str, about: &'static str, extends: &'static str, text: &'static str) -> Preset {
    Preset { name, about, extends: Some(extends), text }
}

/// Every preset.
pub const PRESETS: [Preset; 11] = [
    Preset { name: "thorough", about: "for any problem; the default of built-in ones", extends: None, text: "" },
    preset(
        "quick",
        "few episodes for each decision: for steps that take long",
        "thorough",
        include_str!("presets/quick.toml"),
    ),
    preset(
        "gegelati",
        "GEGELATI's parameters and algorithm, for comparison",
        "thorough",
        include_str!("presets/gegelati.toml"),
    ),
    preset("paper-fs", "the paper's learning problem, fixed start", "gegelati", include_str!("presets/paper-fs.toml")),
    preset("paper-rs", "the paper's learning problem, random start", "paper-fs", RANDOM_START),
    preset(
        "raw-fs",
        "the paper's observation and score with this search, fixed start",
        "thorough",
        include_str!("presets/raw-fs.toml"),
    ),
    preset("raw-rs", "the paper's observation and score with this search, random start", "raw-fs", RANDOM_START),
    preset("best-fs", "this project's, fixed start", "thorough", include_str!("presets/best-fs.toml")),
    preset("best-rs", "this project's, random start", "best-fs", RANDOM_START),
    preset("dodge", "the arm among balls: few roots, many episodes", "thorough", include_str!("presets/dodge.toml")),
    preset(
        "dodge-hard",
        "faster balls that are seen late, with noise, and without their velocities",
        "dodge",
        include_str!("presets/dodge-hard.toml"),
    ),
];

/// The start of an episode anywhere, and the time that it takes.
const RANDOM_START: &str = "[problem]\nname = \"rs\"\nmax_actions = 3414\n";

/// Returns the name of the preset used for a problem by default.
pub fn default_for(problem: ProblemName) -> &'static str {
    match problem {
        ProblemName::Fs => "best-fs",
        ProblemName::Rs => "best-rs",
        ProblemName::Dodge => "dodge",
        _ => "thorough",
    }
}

impl Preset {
    /// Finds a preset by name.
    pub fn find(name: &str) -> Option<&'static Self> {
        PRESETS.iter().find(|preset| preset.name == name)
    }

    /// Returns all settings.
    ///
    /// # Panics
    /// Never: a test reads every preset.
    pub fn table(&self) -> toml::Table {
        let mut table = match self.extends.and_then(Self::find) {
            Some(base) => base.table(),
            None => toml::Table::try_from(EvolutionConfig::default()).expect("plain data"),
        };
        merge(&mut table, &self.text.parse().expect("a preset is TOML"));
        table
    }

    /// Returns the configuration.
    ///
    /// # Errors
    /// None: a test reads every preset.
    pub fn config(&self) -> Result<EvolutionConfig, InputError> {
        EvolutionConfig::from_toml(&format!("<preset {}>", self.name), &self.table().to_string())
    }
}

#[cfg(test)]
mod tests {
    use super::{PRESETS, default_for};
    use crate::configuration::schema::{description, properties, resolved, schema};
    use crate::evolution::config::EvolutionConfig;
    use tpg_problems::{Problem, ProblemName};

    #[test]
    fn every_preset_is_accepted_and_written_as_it_was_read() {
        for preset in PRESETS {
            let config = preset.config().unwrap_or_else(|error| panic!("{error}"));
            assert_eq!(EvolutionConfig::from_toml("written", &config.to_toml()), Ok(config), "{}", preset.name);
            let table = preset.table();
            if table.contains_key("problem") {
                Problem::from_toml(preset.name, &table.to_string()).unwrap_or_else(|error| panic!("{error}"));
            }
        }
        assert!(ProblemName::ALL.map(default_for).iter().all(|name| super::Preset::find(name).is_some()));
    }

    #[test]
    fn settings_are_few_and_each_has_a_description() {
        let schema = schema::<EvolutionConfig>();
        let sections = properties(&schema).filter(|(section, _)| *section != "problem");
        let settings: Vec<_> = sections.flat_map(|(_, section)| properties(resolved(&schema, section))).collect();
        assert!((30..=40).contains(&settings.len()), "{} settings", settings.len());
        for (key, setting) in settings {
            assert!(description(&schema, setting).len() > 10, "{key}");
        }
    }
}
