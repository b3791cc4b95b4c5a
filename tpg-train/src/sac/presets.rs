//! The configurations included with the trainer: `general`, and the differences of the others.

use crate::configuration::Preset;

/// Every preset.
pub(crate) const PRESETS: [Preset; 6] = [
    Preset::base(
        "general",
        "for any problem with outputs: small networks that learn in minutes on one core",
        include_str!("presets/general.toml"),
    ),
    Preset::new("long", "for episodes of hundreds of steps", "general", include_str!("presets/long.toml")),
    Preset::new("best-fs", "ours, the arm from its home position", "general", include_str!("presets/best-fs.toml")),
    Preset::new("best-rs", "ours, the arm from anywhere", "best-fs", RANDOM_START),
    Preset::new(
        "no-planner-fs",
        "as best-fs, without a reward that knows solving poses",
        "best-fs",
        include_str!("presets/no-planner-fs.toml"),
    ),
    Preset::new(
        "no-planner-rs",
        "as best-rs, without a reward that knows solving poses",
        "no-planner-fs",
        RANDOM_START,
    ),
];

/// The start that chooses the best candidate, and the share of training episodes that start at home.
const RANDOM_START: &str = "[problem]\nname = \"rs\"\nfixed_start_share = 0.3\n";

#[cfg(test)]
mod tests {
    use crate::configuration::Configuration as _;
    use crate::sac::config::SacConfig;
    use tpg_problems::Problem;

    #[test]
    fn every_preset_is_accepted_and_written_as_it_was_read() {
        for preset in SacConfig::PRESETS {
            let config = SacConfig::preset(preset.name).unwrap_or_else(|error| panic!("{error}"));
            if !config.problem.is_empty() {
                Problem::from_table(preset.name, &config.problem, SacConfig::KIND).expect("a built-in problem");
            }
            assert_eq!(SacConfig::from_toml("written", &config.to_toml()), Ok(config));
        }
    }
}
