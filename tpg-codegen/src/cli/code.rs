//! The options that select code, shared by `generate` and `verify`.

use super::numbers::{Chosen, NumbersArgs};
use crate::emit::Code;
use crate::options::{Language, Options, Prefix, Profile, Style};
use clap::{Args, ValueEnum};
use tpg_graph::Graph;
use tpg_graph::command::CommandError;
use tpg_graph::error::{InputError, Place};

/// A graph, and the code to generate from it.
#[derive(Clone, Debug, Args)]
pub(super) struct CodeArgs {
    #[command(flatten)]
    numbers: NumbersArgs,
    /// The language
    #[arg(long, value_enum, default_value_t = LanguageArg::All)]
    pub(super) lang: LanguageArg,
    /// The interface of the C [default: pure; verify: both]
    #[arg(long, value_enum, conflicts_with = "fixed")]
    pub(super) style: Option<Style>,
    /// The goal of the optimisation [default: fast in C, constant-time in Rust; verify: every profile]
    #[arg(long, value_enum)]
    pub(super) profile: Option<Profile>,
    /// The prefix of every generated name [default: from the file's name]
    #[arg(long, value_name = "NAME")]
    prefix: Option<Prefix>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum LanguageArg {
    C,
    Rust,
    All,
}

impl LanguageArg {
    pub(super) fn languages(self) -> &'static [Language] {
        match self {
            Self::C => &[Language::C],
            Self::Rust => &[Language::Rust],
            Self::All => &[Language::C, Language::Rust],
        }
    }
}

impl CodeArgs {
    /// The graph, in the requested scalar type, and the options.
    pub(super) fn load(&self) -> Result<(Graph, Options), CommandError> {
        let Chosen { graph, conversion, whole } = self.numbers.load()?;
        let graph = whole.unwrap_or(graph);
        let options = Options {
            style: self.style.unwrap_or_default(),
            profile: self.profile,
            conversion,
            ..Options::new(self.prefix.clone().unwrap_or_else(|| Prefix::of_file(&self.numbers.graph.graph)))
        };
        if options.style == Style::Gegelati && (!graph.outputs().is_empty() || graph.has_counts()) {
            let what = if graph.has_counts() { "in integers" } else { "with outputs" };
            let found = format!("--style gegelati for a policy {what}");
            let accepted = "--style pure: GEGELATI's computes in floating point and answers an action";
            return Err(InputError::new(self.numbers.graph.name(), Place::Whole, found, accepted).into());
        }
        Ok((graph, options))
    }

    /// The code in a language.
    pub(super) fn code<'g>(
        &self,
        graph: &'g Graph,
        options: &Options,
        language: Language,
    ) -> Result<Code<'g>, InputError> {
        Code::of_graph(&self.numbers.graph.name(), graph, options, language)
    }

    /// Every combination of language, style and profile that the arguments and the graph admit.
    pub(super) fn shapes(&self, graph: &Graph) -> Vec<(Language, Style, Option<Profile>)> {
        let is_integers = graph.has_counts();
        // Integers have the same text in every profile.
        let all = if is_integers { vec![Profile::Fast] } else { Profile::ALL.to_vec() };
        let profiles = self.profile.map_or(all, |profile| vec![profile]);
        let pure = |language| profiles.iter().map(move |&profile| (language, Style::Pure, Some(profile)));
        let mut shapes = Vec::new();
        for &language in self.lang.languages() {
            let (with_gegelati, with_pure) = match (language, self.style) {
                (Language::Rust, _) | (Language::C, Some(Style::Pure)) => (false, true),
                (Language::C, Some(Style::Gegelati)) => (true, false),
                // GEGELATI's style has no profile.
                (Language::C, None) => (!is_integers && self.profile.is_none() && graph.outputs().is_empty(), true),
            };
            shapes.extend(with_gegelati.then_some((language, Style::Gegelati, None)));
            shapes.extend(pure(language).filter(|_| with_pure));
        }
        shapes
    }
}
