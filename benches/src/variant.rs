//! The ways to run a graph.

use tpg_codegen::emit::{Language, Options, Profile, Style};

/// A way to run a graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variant {
    /// The interpreter of `tpg-codegen`: what the semantics say, line by line.
    Interpreter,
    /// C in the shape of GEGELATI's own generated code: what everything is measured against.
    Gegelati,
    /// C or Rust of a profile.
    Generated(Language, Profile),
}

impl Variant {
    /// Every one, the yardstick first.
    pub const ALL: [Self; 8] = [
        Self::Gegelati,
        Self::Interpreter,
        Self::Generated(Language::C, Profile::Fast),
        Self::Generated(Language::C, Profile::Small),
        Self::Generated(Language::C, Profile::ConstantTime),
        Self::Generated(Language::Rust, Profile::Fast),
        Self::Generated(Language::Rust, Profile::Small),
        Self::Generated(Language::Rust, Profile::ConstantTime),
    ];

    /// What it is called.
    pub fn name(self) -> String {
        match self {
            Self::Interpreter => "interpreter".to_owned(),
            Self::Gegelati => "C gegelati".to_owned(),
            Self::Generated(language, profile) => format!("{language:?} {}", profile.name()),
        }
    }

    /// How it is emitted; the interpreter is not.
    pub fn emission(self) -> Option<(Language, Options)> {
        let options = Options::new("timed".parse().expect("a prefix"));
        match self {
            Self::Interpreter => None,
            Self::Gegelati => Some((Language::C, Options { style: Style::Gegelati, ..options })),
            Self::Generated(language, profile) => Some((language, Options { profile: Some(profile), ..options })),
        }
    }
}
