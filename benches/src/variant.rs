//! The ways to run a graph.

use Profile::*;
use tpg_codegen::emit::{Language, Options, Profile, Style};

/// A way to run a graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variant {
    /// The interpreter of `tpg-codegen`, which follows the semantics line by line.
    Interpreter,
    /// C in the shape of GEGELATI's own generated code: the baseline of all comparisons.
    Gegelati,
    /// C or Rust in one of the profiles.
    Generated(Language, Profile),
}

impl Variant {
    /// All variants, the baseline first.
    pub const ALL: [Self; 10] = [
        Self::Gegelati,
        Self::Interpreter,
        Self::Generated(Language::C, Fast),
        Self::Generated(Language::C, Balanced),
        Self::Generated(Language::C, Small),
        Self::Generated(Language::C, ConstantTime),
        Self::Generated(Language::Rust, Fast),
        Self::Generated(Language::Rust, Balanced),
        Self::Generated(Language::Rust, Small),
        Self::Generated(Language::Rust, ConstantTime),
    ];

    /// Returns the name of the variant.
    pub fn name(self) -> String {
        match self {
            Self::Interpreter => "interpreter".to_owned(),
            Self::Gegelati => "C gegelati".to_owned(),
            Self::Generated(language, profile) => format!("{language:?} {}", profile.name()),
        }
    }

    /// Returns the options for emission; `None` for the interpreter.
    pub fn emission(self) -> Option<(Language, Options)> {
        let options = Options::new("timed".parse().expect("a prefix"));
        match self {
            Self::Interpreter => None,
            Self::Gegelati => Some((Language::C, Options { style: Style::Gegelati, ..options })),
            Self::Generated(language, profile) => Some((language, Options { profile: Some(profile), ..options })),
        }
    }
}
