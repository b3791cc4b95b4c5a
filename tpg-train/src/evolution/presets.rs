//! The configurations included with the trainer, with a comment for every parameter.

use super::config::EvolutionConfig;
use crate::sac;
use clap::Args;
use tpg_graph::error::{InputError, Place};
use tpg_problems::ProblemName;
use tpg_problems::arm::arms::ARMS;
use tpg_problems::arm::chain::CHAINS;

/// Print a commented configuration.
#[derive(Clone, Debug, Args)]
pub struct ConfigArgs {
    /// The preset, or an arm, such as widowx, for the section that describes it; --list shows all of them
    #[arg(value_name = "NAME", default_value = "general")]
    pub name: String,
    /// A preset of `tpg-train sac` instead of `tpg-train tpg`
    #[arg(long)]
    pub sac: bool,
    /// Only the names, with what they are
    #[arg(long)]
    pub list: bool,
}

/// Prints a preset, or the list of all.
///
/// # Errors
/// If there is no preset with that name, or stdout is closed.
pub fn print_config(args: &ConfigArgs) -> Result<(), InputError> {
    let presets: &[Preset] = if args.sac { &sac::presets::PRESETS } else { &PRESETS };
    let arms = ARMS.iter().map(|arm| (arm.name, arm.about, arm.text.to_owned()));
    let chains = CHAINS.iter().map(|chain| (chain.name, chain.about, chain.text.to_owned()));
    let others = arms.chain(chains).filter(|_| !args.sac);
    let texts = presets.iter().map(|preset| (preset.name, preset.about, preset.text())).chain(others);
    let text = if args.list {
        texts.map(|(name, about, _)| format!("{name:18} {about}\n")).collect()
    } else {
        let named = texts.clone().find(|(name, ..)| *name == args.name);
        let (.., text) = named.ok_or_else(|| {
            let accepted = texts.map(|(name, ..)| name).collect::<Vec<_>>().join(", ");
            InputError::new("<command line>", Place::Whole, format!("the preset {:?}", args.name), accepted)
        })?;
        text
    };
    let written = tpg_graph::command::print(&text);
    written.map_err(|error| InputError::io("<stdout>".as_ref(), &error, "an open pipe"))
}

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

/// Every preset.
pub const PRESETS: [Preset; 14] = [
    Preset::new(
        "linear",
        "for any problem: some demes begin with weighted sums of the inputs, the others at random",
        include_str!("presets/linear.toml"),
    ),
    Preset::new(
        "frugal",
        "for any problem whose steps take long: few episodes for each decision",
        include_str!("presets/frugal.toml"),
    ),
    Preset::new("general", "for any problem with named actions", include_str!("presets/general.toml")),
    Preset::new(
        "continuous",
        "for any problem with outputs: some demes begin with products of two weighted sums",
        include_str!("presets/continuous.toml"),
    ),
    Preset::new(
        "kelly",
        "Kelly's parameters, GEGELATI's defaults, on the paper's fixed-start problem",
        include_str!("presets/kelly.toml"),
    ),
    Preset::new("paper-fs", "the paper's learning problem, fixed start", include_str!("presets/paper-fs.toml")),
    Preset::new("paper-rs", "the paper's learning problem, random start", include_str!("presets/paper-fs.toml"))
        .with(&[RANDOM_START, ("name = \"fs\"", "name = \"rs\""), ("max_actions = 1710", "max_actions = 3414")]),
    Preset::new(
        "raw-fs",
        "the paper's observation, actions and score, fixed start, with this project's search",
        include_str!("presets/raw-fs.toml"),
    ),
    Preset::new(
        "raw-rs",
        "the paper's observation, actions and score, random start, with this project's search",
        include_str!("presets/raw-fs.toml"),
    )
    .with(&[RANDOM_START, ("name = \"fs\"", "name = \"rs\""), ("max_actions = 1710", "max_actions = 3414")]),
    Preset::new("best-fs", "this project's, fixed start", include_str!("presets/best-fs.toml")),
    Preset::new(
        "polar-fs",
        "this project's, fixed start, with less knowledge of the arm than best-fs",
        include_str!("presets/polar-fs.toml"),
    ),
    Preset::new("best-rs", "this project's, random start", include_str!("presets/best-fs.toml")).with(&[
        RANDOM_START,
        ("name = \"fs\"", "name = \"rs\""),
        ("max_actions = 1707", "max_actions = 3414"),
        ("racing_share = 0.25", "racing_share = 0.5"),
    ]),
    Preset::new(
        "dodge",
        "this project's, for the arm among balls: few roots, many episodes",
        include_str!("presets/dodge.toml"),
    ),
    Preset::new(
        "dodge-hard",
        "as dodge, with balls up to twice as fast that are seen late, with noise, and without their velocities",
        include_str!("presets/dodge.toml"),
    )
    .with(&[
        ("# For `dodge`, the arm among balls.", "# For `dodge`, the arm among faster balls that are not seen well."),
        (
            "# A configuration can have a section [problem] with the problem's name and its settings; this one takes the problem of the\n\
             # command line.\n",
            "[problem]\n\
             # The problem; the other keys of this section are its settings.\n\
             name = \"dodge\"\n\
             # Least and greatest peak speed of a moving ball, mm a step.\n\
             speed = [0.3, 4.0]\n\
             # Standard deviation of each coordinate of a ball that is seen, mm.\n\
             noise = 3.0\n\
             # Steps that pass until a ball's place is seen.\n\
             delay = 2\n\
             # Whether a ball's displacement in a step is seen; otherwise it is found from its places.\n\
             velocities = false\n\
             # Clearance that the search keeps from a ball that moves, and from one that stays, mm.\n\
             keep = [8.0, 0.6]\n",
        ),
    ]),
];

/// The start in the first line of a preset.
const RANDOM_START: (&str, &str) = (" fixed start", " random start");

impl Preset {
    /// Creates a preset whose text is a file.
    pub(crate) const fn new(name: &'static str, about: &'static str, file: &'static str) -> Self {
        Self { name, about, file, changes: &[] }
    }

    /// Changes words of the file.
    pub(crate) const fn with(self, changes: &'static [(&'static str, &'static str)]) -> Self {
        Self { changes, ..self }
    }

    /// Finds a preset by name.
    pub fn find(name: &str) -> Option<&'static Self> {
        PRESETS.iter().find(|preset| preset.name == name)
    }

    /// Returns the preset used for a problem by default.
    ///
    /// # Panics
    /// Never: each of these presets is in the list.
    pub fn usual(problem: ProblemName) -> &'static Self {
        let name = match problem {
            ProblemName::Fs => "best-fs",
            ProblemName::Rs => "best-rs",
            ProblemName::Dodge => "dodge",
            ProblemName::Cartpole
            | ProblemName::Acrobot
            | ProblemName::MountainCar
            | ProblemName::MountainCarContinuous => "linear",
            ProblemName::Pendulum => "continuous",
        };
        Self::find(name).expect("it is in the list")
    }

    /// Returns its commented text.
    pub fn text(&self) -> String {
        self.changes.iter().fold(self.file.to_owned(), |text, (old, new)| text.replace(old, new))
    }

    /// Returns the preset's name in messages, and its text.
    pub fn file(&self) -> (String, String) {
        (format!("<preset {}>", self.name), self.text())
    }

    /// Returns the configuration.
    ///
    /// # Errors
    /// None: a test reads every preset.
    pub fn config(&self) -> Result<EvolutionConfig, InputError> {
        let (file, text) = self.file();
        EvolutionConfig::from_toml(&file, &text)
    }
}

#[cfg(test)]
mod tests {
    use super::PRESETS;

    #[test]
    fn every_preset_is_accepted_and_comments_every_parameter() {
        for preset in PRESETS {
            let config = preset.config().unwrap_or_else(|error| panic!("{error}"));
            assert_eq!(crate::evolution::config::EvolutionConfig::from_toml("written", &config.to_toml()), Ok(config));
            let text = preset.text();
            let lines: Vec<&str> = text.lines().collect();
            for (place, line) in lines.iter().enumerate() {
                let key = !line.starts_with(['#', '[', ' ', ']']) && line.contains('=');
                assert!(!key || lines[place - 1].starts_with('#'), "{}: {line} has no comment", preset.name);
            }
        }
    }

    #[test]
    fn every_change_of_a_preset_has_its_words() {
        for preset in PRESETS.iter().chain(&crate::sac::presets::PRESETS) {
            for (old, _) in preset.changes {
                assert!(preset.file.contains(old), "{}: {old}", preset.name);
            }
        }
    }

    #[test]
    fn a_large_first_population_shrinks_as_in_gegelati_or_at_once() {
        let config = |name: &str| super::Preset::find(name).expect("it is there").config().expect("it is accepted");
        let at_once = config("paper-fs");
        assert_eq!(at_once.survivors(), 8, "352 of 360 are deleted");
        assert_eq!(at_once.survivors_of(at_once.tpg.init_nb_roots), 8);
        let mut gegelati = at_once;
        gegelati.learning.cut_first_population = false;
        let sizes: Vec<usize> = std::iter::successors(Some(gegelati.tpg.init_nb_roots), |&roots| {
            (roots > gegelati.tpg.nb_roots).then(|| gegelati.survivors_of(roots))
        })
        .collect();
        assert_eq!((sizes.len() - 1, sizes[1], sizes[sizes.len() - 1]), (20, 6848, 160), "352 of them a generation");
    }
}
