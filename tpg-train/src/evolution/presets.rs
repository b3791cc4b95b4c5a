//! The configurations included with the trainer. `thorough` is the default of every setting; the others hold differences only.

use crate::configuration::Preset;

/// Every preset.
pub(crate) const PRESETS: [Preset; 12] = [
    Preset::base("thorough", "for any problem; the default of built-in ones", ""),
    Preset::new(
        "quick",
        "few episodes for each decision: for steps that take long",
        "thorough",
        include_str!("presets/quick.toml"),
    ),
    Preset::new(
        "gegelati",
        "GEGELATI's parameters and algorithm, for comparison",
        "thorough",
        include_str!("presets/gegelati.toml"),
    ),
    Preset::new(
        "labels",
        "samples of classes: an episode is one decision",
        "quick",
        include_str!("presets/labels.toml"),
    ),
    Preset::new("images", "features of images: many short programs", "thorough", include_str!("presets/images.toml")),
    Preset::new(
        "paper-fs",
        "the paper's learning problem, fixed start",
        "gegelati",
        include_str!("presets/paper-fs.toml"),
    ),
    Preset::new("paper-rs", "the paper's learning problem, random start", "paper-fs", RANDOM_START),
    Preset::new(
        "raw-fs",
        "the paper's observation and score with this search, fixed start",
        "thorough",
        include_str!("presets/raw-fs.toml"),
    ),
    Preset::new("raw-rs", "the paper's observation and score with this search, random start", "raw-fs", RANDOM_START),
    Preset::new("best-fs", "this project's, fixed start", "thorough", include_str!("presets/best-fs.toml")),
    Preset::new("best-rs", "this project's, random start", "best-fs", RANDOM_START),
    Preset::new(
        "dodge",
        "the arm among balls: few roots, many episodes",
        "thorough",
        include_str!("presets/dodge.toml"),
    ),
];

/// The start of an episode anywhere, and the time that it takes.
const RANDOM_START: &str = "[problem]\nname = \"rs\"\nmax_actions = 3414\n";

#[cfg(test)]
mod tests {
    use crate::configuration::Configuration as _;
    use crate::configuration::schema::{description, properties, resolved, schema};
    use crate::evolution::config::EvolutionConfig;
    use tpg_problems::{Problem, ProblemName};

    #[test]
    fn every_preset_is_accepted_and_written_as_it_was_read() {
        for preset in EvolutionConfig::PRESETS {
            let config = EvolutionConfig::preset(preset.name).unwrap_or_else(|error| panic!("{error}"));
            if !config.problem.is_empty() {
                Problem::from_toml(preset.name, &config.to_toml()).unwrap_or_else(|error| panic!("{error}"));
            }
            assert_eq!(EvolutionConfig::from_toml("written", &config.to_toml()), Ok(config), "{}", preset.name);
        }
        assert!(
            ProblemName::ALL.iter().all(|name| EvolutionConfig::table(EvolutionConfig::default_preset(*name)).is_ok())
        );
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
