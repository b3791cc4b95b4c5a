//! What to generate: the language, the interface, the profile, the name.

mod prefix;

pub use prefix::Prefix;

use crate::passes::interval::Assumption;
use tpg_graph::conversion::Conversion;
use tpg_graph::states::StateSet;

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

/// What the code is good at.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, clap::ValueEnum)]
pub enum Profile {
    /// Least mean time: a function for each team, which computes expensive bids only where they can win.
    Fast,
    /// Least flash: tables, and one small evaluator.
    Small,
    /// The same instructions for every state: everything is computed, nothing branches.
    ConstantTime,
}

impl Profile {
    /// Every profile.
    pub const ALL: [Self; 3] = [Self::Fast, Self::Small, Self::ConstantTime];

    /// The name on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Fast => "fast",
            Self::Small => "small",
            Self::ConstantTime => "constant-time",
        }
    }

    /// What a language gets where nothing is asked for.
    pub const fn default_of(language: Language) -> Self {
        match language {
            Language::C => Self::Fast,
            Language::Rust => Self::ConstantTime,
        }
    }
}

/// What to emit and what to call it.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// The prefix of every name.
    pub prefix: Prefix,
    /// The interface of C.
    pub style: Style,
    /// The profile; each language has its default. GEGELATI's style has none.
    pub profile: Option<Profile>,
    /// What is believed of the inputs.
    pub assumption: Assumption,
    /// What the graph was before its scalar type was changed, where it was.
    pub conversion: Option<Conversion>,
    /// Recorded states: [`Profile::Fast`] looks first at the bids that win most often along them.
    pub trace: Option<StateSet>,
}

impl Options {
    /// The default options.
    pub fn new(prefix: Prefix) -> Self {
        Self {
            prefix,
            style: Style::Pure,
            profile: None,
            assumption: Assumption::Nothing,
            conversion: None,
            trace: None,
        }
    }

    /// The profile in a language.
    pub fn profile_in(&self, language: Language) -> Profile {
        self.profile.unwrap_or(Profile::default_of(language))
    }

    /// The recorded states by which a language's code orders its bids.
    pub(crate) fn ordered_by(&self, language: Language) -> Option<&StateSet> {
        let is_fast = self.profile_in(language) == Profile::Fast;
        let has_profile = language == Language::Rust || self.style == Style::Pure;
        self.trace.as_ref().filter(|_| is_fast && has_profile)
    }

    /// Flat states that were recorded; none where nothing was.
    pub(crate) fn recorded(&self) -> &[f64] {
        self.trace.as_ref().map_or(&[], |trace| &trace.states)
    }
}
