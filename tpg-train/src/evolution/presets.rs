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
    let arms = ARMS.iter().map(|arm| (arm.name, arm.about, arm.text));
    let arms = arms.chain(CHAINS.iter().map(|chain| (chain.name, chain.about, chain.text))).filter(|_| !args.sac);
    let texts = presets.iter().map(|preset| (preset.name, preset.about, preset.text)).chain(arms);
    let text = if args.list {
        texts.map(|(name, about, _)| format!("{name:18} {about}\n")).collect()
    } else {
        let named = texts.clone().find(|(name, ..)| *name == args.name);
        let (.., text) = named.ok_or_else(|| {
            let accepted = texts.map(|(name, ..)| name).collect::<Vec<_>>().join(", ");
            InputError::new("<command line>", Place::Whole, format!("the preset {:?}", args.name), accepted)
        })?;
        text.to_owned()
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
    /// Its commented text.
    pub text: &'static str,
}

/// Every preset.
pub const PRESETS: [Preset; 13] = [
    Preset {
        name: "linear",
        about: "for any problem: some demes begin with weighted sums of the inputs, the others at random",
        text: include_str!("presets/linear.toml"),
    },
    Preset {
        name: "frugal",
        about: "for any problem whose steps take long: few episodes for each decision",
        text: include_str!("presets/frugal.toml"),
    },
    Preset { name: "general", about: "for any problem with named actions", text: include_str!("presets/general.toml") },
    Preset {
        name: "continuous",
        about: "for any problem with outputs: some demes begin with products of two weighted sums",
        text: include_str!("presets/continuous.toml"),
    },
    Preset {
        name: "kelly",
        about: "Kelly's parameters, GEGELATI's defaults, on the paper's fixed-start problem",
        text: include_str!("presets/kelly.toml"),
    },
    Preset {
        name: "paper-fs",
        about: "the paper's learning problem, fixed start",
        text: include_str!("presets/paper-fs.toml"),
    },
    Preset {
        name: "paper-rs",
        about: "the paper's learning problem, random start",
        text: include_str!("presets/paper-rs.toml"),
    },
    Preset {
        name: "raw-fs",
        about: "the paper's observation, actions and score, fixed start, with this project's search",
        text: concat!(include_str!("presets/raw-fs.toml"), include_str!("presets/raw.toml")),
    },
    Preset {
        name: "raw-rs",
        about: "the paper's observation, actions and score, random start, with this project's search",
        text: concat!(include_str!("presets/raw-rs.toml"), include_str!("presets/raw.toml")),
    },
    Preset { name: "best-fs", about: "this project's, fixed start", text: include_str!("presets/best-fs.toml") },
    Preset {
        name: "polar-fs",
        about: "this project's, fixed start, with less knowledge of the arm than best-fs",
        text: include_str!("presets/polar-fs.toml"),
    },
    Preset { name: "best-rs", about: "this project's, random start", text: include_str!("presets/best-rs.toml") },
    Preset {
        name: "dodge",
        about: "this project's, for the arm among balls: few roots, many episodes",
        text: include_str!("presets/dodge.toml"),
    },
];

impl Preset {
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

    /// Returns the preset's name in messages, and its text.
    pub fn file(&self) -> (String, String) {
        (format!("<preset {}>", self.name), self.text.to_owned())
    }

    /// Returns the configuration.
    ///
    /// # Errors
    /// None: a test reads every preset.
    pub fn config(&self) -> Result<EvolutionConfig, InputError> {
        EvolutionConfig::from_toml(&format!("<preset {}>", self.name), self.text)
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
            let lines: Vec<&str> = preset.text.lines().collect();
            for (place, line) in lines.iter().enumerate() {
                let key = !line.starts_with(['#', '[', ' ', ']']) && line.contains('=');
                assert!(!key || lines[place - 1].starts_with('#'), "{}: {line} has no comment", preset.name);
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
