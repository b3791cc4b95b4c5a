//! Options of the generated code: language, interface, profile, prefix.

mod prefix;

pub use prefix::Prefix;

use tpg_graph::conversion::Conversion;

/// A language to emit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, clap::ValueEnum)]
pub enum Language {
    /// C99, compiling as C++11 too.
    C,
    /// Rust, `no_std`.
    Rust,
}

impl Language {
    /// The name for people.
    pub const fn name(self) -> &'static str {
        match self {
            Self::C => "C",
            Self::Rust => "Rust",
        }
    }
}

/// The interface of the C that is emitted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Style {
    /// A pure, reentrant function over a const state; every symbol prefixed.
    #[default]
    Pure,
    /// GEGELATI's own entry points, `inferenceTPG()` over the globals `in1`, `in2`, …: a drop-in for its output.
    Gegelati,
}

/// The goal of the optimisation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, clap::ValueEnum)]
pub enum Profile {
    /// Lowest mean time: one function per team; expensive bids are computed only if they can win.
    Fast,
    /// A compromise: tables of teams and native bids; expensive bids are computed only if they can win.
    Balanced,
    /// Smallest flash: tables, and one small evaluator.
    Small,
    /// The same instructions for every state: everything is computed, nothing branches.
    ConstantTime,
}

impl Profile {
    /// Every profile.
    pub const ALL: [Self; 4] = [Self::Fast, Self::Balanced, Self::Small, Self::ConstantTime];

    /// The name on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Fast => "fast",
            Self::Balanced => "balanced",
            Self::Small => "small",
            Self::ConstantTime => "constant-time",
        }
    }

    /// The default profile of a language.
    const fn default_of(language: Language) -> Self {
        match language {
            Language::C => Self::Fast,
            Language::Rust => Self::ConstantTime,
        }
    }
}

/// The options of a compilation.
///
/// ```
/// use tpg_codegen::emit::{Language, Options, Profile};
///
/// let options = Options::new("arm".parse()?);
/// assert_eq!(options.profile_in(Language::C), Profile::Fast);
/// let small = Options { profile: Some(Profile::Small), ..options };
/// assert_eq!(small.profile_in(Language::Rust), Profile::Small);
/// # Ok::<(), String>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// The prefix of every name.
    pub prefix: Prefix,
    /// The interface of C.
    pub style: Style,
    /// The profile; each language has its default. GEGELATI's style has none.
    pub profile: Option<Profile>,
    /// The graph's original scalar type and maths, if they were changed.
    pub conversion: Option<Conversion>,
}

impl Options {
    /// The default options.
    pub fn new(prefix: Prefix) -> Self {
        Self { prefix, style: Style::Pure, profile: None, conversion: None }
    }

    /// The profile in a language.
    pub fn profile_in(&self, language: Language) -> Profile {
        self.profile.unwrap_or(Profile::default_of(language))
    }
}
