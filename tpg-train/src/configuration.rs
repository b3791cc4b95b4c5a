//! The configuration and the problem that the arguments of a run ask for, the same way for every trainer.

use crate::evolution::presets::Preset;
use crate::files::read_text;
use crate::run_args::{RunArgs, command_line};
use tpg_graph::error::InputError;
use tpg_problems::{ContinuousProblem, Problem, ProblemName};

/// A trainer's configuration.
pub trait Configuration: Sized {
    /// The problems that it can be for.
    type Problem: AnyProblem;
    /// The presets.
    const PRESETS: &'static [Preset];
    /// The command that prints a configuration, for messages.
    const PRINTED_BY: &'static str;

    /// Returns the preset used for a problem by default.
    fn usual(problem: ProblemName) -> &'static Preset;

    /// Reads and checks a configuration, except for its section `problem`.
    ///
    /// # Errors
    /// An unknown key or a value that is not accepted, with its line.
    fn from_toml(file: &str, text: &str) -> Result<Self, InputError>;

    /// Returns the section `problem`.
    fn problem(&mut self) -> &mut toml::Table;
}

/// A problem with its settings, of either registry.
pub trait AnyProblem: Sized {
    /// Returns a problem with its default settings.
    fn usual(name: ProblemName) -> Self;
    /// Returns the problem's name.
    fn name(&self) -> ProblemName;
    /// Reads the section `problem` of a configuration.
    ///
    /// # Errors
    /// A value that the problem does not accept, with its line.
    fn from_toml(file: &str, text: &str) -> Result<Self, InputError>;
    /// Returns the section `problem` with every setting written out.
    fn to_table(&self) -> toml::Table;
    /// Returns the problem of another name, with as many of the settings as it shares.
    #[must_use]
    fn renamed(self, name: ProblemName) -> Self;
}

impl AnyProblem for Problem {
    fn usual(name: ProblemName) -> Self {
        Self::usual(name)
    }
    fn name(&self) -> ProblemName {
        self.name()
    }
    fn from_toml(file: &str, text: &str) -> Result<Self, InputError> {
        Self::from_toml(file, text)
    }
    fn to_table(&self) -> toml::Table {
        self.to_table()
    }
    fn renamed(self, name: ProblemName) -> Self {
        Self::usual(name)
    }
}

impl AnyProblem for ContinuousProblem {
    fn usual(name: ProblemName) -> Self {
        Self::usual(name)
    }
    fn name(&self) -> ProblemName {
        self.name()
    }
    fn from_toml(file: &str, text: &str) -> Result<Self, InputError> {
        Self::from_toml(file, text)
    }
    fn to_table(&self) -> toml::Table {
        self.to_table()
    }
    fn renamed(self, name: ProblemName) -> Self {
        self.renamed(name)
    }
}

/// A configuration and its problem.
#[derive(Clone, Debug)]
pub struct Chosen<C: Configuration> {
    /// Name of the preset; none for a file.
    pub preset: Option<&'static str>,
    /// The configuration, with the problem written out in its section.
    pub config: C,
    /// The problem.
    pub problem: C::Problem,
}

impl<C: Configuration> Chosen<C> {
    /// Returns what the arguments ask for: a file, a preset, or the problem's usual preset.
    ///
    /// # Errors
    /// If the configuration cannot be read or is rejected, or nothing names a problem.
    pub fn by(run: &RunArgs, problem: Option<ProblemName>) -> Result<Self, InputError> {
        let (preset, file, text) = match (&run.config, &run.preset, problem) {
            (Some(path), _, _) => {
                let accepted = format!("a configuration as `{}` prints", C::PRINTED_BY);
                (None, path.display().to_string(), read_text(path, &accepted)?)
            }
            (None, Some(name), _) => of_preset(find(C::PRESETS, name)?),
            (None, None, Some(problem)) => of_preset(C::usual(problem)),
            (None, None, None) => {
                let accepted = format!("--problem {}, --preset NAME or --config FILE", ProblemName::names());
                return Err(command_line("no problem", accepted));
            }
        };
        let mut config = C::from_toml(&file, &text)?;
        let own = (!config.problem().is_empty()).then(|| C::Problem::from_toml(&file, &text)).transpose()?;
        let problem = problem_of(own, problem, &file, run.config.is_some())?;
        *config.problem() = problem.to_table();
        Ok(Self { preset, config, problem })
    }
}

fn of_preset(preset: &'static Preset) -> (Option<&'static str>, String, String) {
    let (file, text) = preset.file();
    (Some(preset.name), file, text)
}

fn find(presets: &'static [Preset], name: &str) -> Result<&'static Preset, InputError> {
    presets.iter().find(|preset| preset.name == name).ok_or_else(|| {
        let accepted = presets.iter().map(|preset| preset.name).collect::<Vec<_>>().join(", ");
        command_line(format!("the preset {name:?}"), accepted)
    })
}

/// Returns the problem of a configuration, or of the command line. A preset made for another problem supplies only its
/// parameters.
fn problem_of<P: AnyProblem>(
    own: Option<P>,
    asked: Option<ProblemName>,
    file: &str,
    is_file: bool,
) -> Result<P, InputError> {
    match (own, asked) {
        (Some(problem), None) => Ok(problem),
        (Some(problem), Some(name)) if problem.name() == name => Ok(problem),
        (Some(problem), Some(name)) if is_file => {
            let found = format!("--problem {} with a configuration for {}", name.name(), problem.name().name());
            Err(command_line(found, "the same problem twice, or no --problem"))
        }
        (Some(problem), Some(name)) => Ok(problem.renamed(name)),
        (None, Some(name)) => Ok(P::usual(name)),
        (None, None) => {
            let accepted = format!("--problem {}, or a section [problem] with a name", ProblemName::names());
            Err(command_line(format!("no problem, neither in the arguments nor in {file}"), accepted))
        }
    }
}
