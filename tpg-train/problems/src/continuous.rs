//! The built-in problems for policies with outputs, which do not choose among named actions.

use crate::arm::motors::{self, Motors};
use crate::arm::targets::Start;
use crate::registry::{Problem, ProblemName, named, section};
use tpg_engine::{AnyEnvironment, erase};
use tpg_graph::error::{InputError, Place};
use tpg_graph::settings;

/// A problem as a policy with outputs sees it: the arm by its four motors, every other problem as it is.
#[derive(Clone, Debug, PartialEq)]
pub enum ContinuousProblem {
    /// The arm by its motors.
    Motors(Start, motors::Config),
    /// Any other problem.
    Other(Problem),
}

impl ContinuousProblem {
    /// Returns a problem with its default settings.
    pub fn usual(name: ProblemName) -> Self {
        match name.start() {
            Some(start) => Self::Motors(start, motors::Config::default()),
            None => Self::Other(Problem::usual(name)),
        }
    }

    /// Returns the problem's name.
    pub fn name(&self) -> ProblemName {
        match self {
            Self::Motors(start, _) => (*start).into(),
            Self::Other(problem) => problem.name(),
        }
    }

    /// Returns the problem of another name: the arm keeps its settings with another start.
    #[must_use]
    pub fn renamed(self, name: ProblemName) -> Self {
        match (self, name.start()) {
            (Self::Motors(_, config), Some(start)) => Self::Motors(start, config),
            (problem, _) if problem.name() == name => problem,
            _ => Self::usual(name),
        }
    }

    /// Reads the section `[problem]` of a configuration.
    ///
    /// # Errors
    /// An unknown problem, an unknown key or a value that the problem does not accept, with its line.
    pub fn from_toml(file: &str, text: &str) -> Result<Self, InputError> {
        let Some(start) = named(file, text)?.start() else { return Problem::from_toml(file, text).map(Self::Other) };
        let config: motors::Config = section(file, text)?;
        config.check().map_err(|finding| settings::place(file, text, finding))?;
        Ok(Self::Motors(start, config))
    }

    /// Reads the section as [`to_table`](Self::to_table) wrote it; `file` is the file that it was kept in.
    ///
    /// # Errors
    /// As [`from_toml`](Self::from_toml).
    pub fn from_table(file: &str, table: &toml::Table) -> Result<Self, InputError> {
        let whole = toml::Table::from_iter([("problem".to_owned(), table.clone().into())]).to_string();
        Self::from_toml(file, &whole).map_err(|error| {
            let place = Place::Path("problem".to_owned());
            InputError { place, ..error }
        })
    }

    /// Returns the section `[problem]` with every setting written out.
    ///
    /// # Panics
    /// Never: every setting can be written.
    pub fn to_table(&self) -> toml::Table {
        match self {
            Self::Motors(start, config) => {
                let mut table = toml::Table::try_from(config).expect("settings are plain data");
                table.insert("name".to_owned(), ProblemName::from(*start).name().into());
                table
            }
            Self::Other(problem) => problem.to_table(),
        }
    }

    /// Creates the problem's environment. The arm's tasks come from the sample of the space that `seed` draws.
    pub fn environment(&self, seed: u64) -> AnyEnvironment<f32> {
        match self {
            Self::Motors(start, config) => erase(Motors::new(*start, config.clone(), seed)),
            Self::Other(problem) => problem.environment(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::ContinuousProblem;
    use crate::registry::ProblemName;
    use tpg_graph::error::Place;

    #[test]
    fn a_table_gives_back_the_same_problem() {
        for name in ProblemName::ALL {
            let problem = ContinuousProblem::usual(name);
            assert_eq!(ContinuousProblem::from_table("x.toml", &problem.to_table()), Ok(problem));
        }
    }

    #[test]
    fn the_arm_keeps_its_settings_with_another_start() {
        let mut problem = ContinuousProblem::usual(ProblemName::Fs);
        if let ContinuousProblem::Motors(_, config) = &mut problem {
            config.max_steps = 77;
        }
        let renamed = problem.clone().renamed(ProblemName::Rs);
        assert!(matches!(&renamed, ContinuousProblem::Motors(_, config) if config.max_steps == 77));
        assert_eq!(renamed.name(), ProblemName::Rs);
        let other = ContinuousProblem::usual(ProblemName::Pendulum);
        assert_eq!(problem.renamed(ProblemName::Pendulum), other);
    }

    #[test]
    fn a_wrong_setting_of_the_motors_is_refused_with_its_line() {
        for (text, line, found) in [
            ("[problem]\nname = \"fs\"\nactions = \"medium\"\n", 3, "unknown variant"),
            ("[problem]\nname = \"fs\"\nsources = [\"stance\"]\n", 3, "unknown field"),
            ("[problem]\nname = \"rs\"\nstep = 5\n", 3, "problem.step = 5"),
            ("[problem]\nname = \"rs\"\n\nfixed_start_share = 2.0\n", 4, "problem.fixed_start_share = 2"),
        ] {
            let error = ContinuousProblem::from_toml("x.toml", text).expect_err(text);
            assert_eq!(error.place, Place::Line(line), "{error}");
            assert!(error.found.starts_with(found), "{error}");
        }
    }
}
