//! The built-in problems by name.

use crate::acrobot::{self, Acrobot};
use crate::arm::targets::Start;
use crate::arm::{self, ArmScalar};
use crate::cartpole::{self, CartPole};
use crate::dodge::{self, Dodge};
use crate::mountain_car::{self, MountainCar};
use crate::mountain_car_continuous::{self, MountainCarContinuous};
use crate::pendulum::{self, Pendulum};
use crate::physics::Constants;
use crate::varied::{Disturbance, Varied};
use serde::{Deserialize, de::DeserializeOwned};
use tpg_engine::{AnyEnvironment, Environment, erase};
use tpg_graph::error::{Finding, InputError};
use tpg_graph::{Graph, settings};

/// The levels of an output for a graph that chooses among named actions, where nothing else is said.
pub const USUAL_LEVELS: u16 = 3;

/// A built-in problem.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, clap::ValueEnum)]
pub enum ProblemName {
    /// A robot arm reaches for a target from its home position: the paper's fixed start
    Fs,
    /// A robot arm reaches for a target from anywhere: the paper's random start
    Rs,
    /// A robot arm reaches for a target among moving balls, by behaviours
    Dodge,
    /// A cart balances a pole: Gymnasium's CartPole-v1
    Cartpole,
    /// A motor between two links swings them up: Gymnasium's Acrobot-v1
    Acrobot,
    /// A weak car drives out of a valley by three pushes: Gymnasium's MountainCar-v0
    MountainCar,
    /// A weak motor swings a pendulum up: Gymnasium's Pendulum-v1
    Pendulum,
    /// A weak car drives out of a valley: Gymnasium's MountainCarContinuous-v0
    MountainCarContinuous,
}

impl ProblemName {
    /// Every built-in problem.
    pub const ALL: [Self; 8] = [
        Self::Fs,
        Self::Rs,
        Self::Dodge,
        Self::Cartpole,
        Self::Acrobot,
        Self::MountainCar,
        Self::Pendulum,
        Self::MountainCarContinuous,
    ];

    /// Returns the name used on the command line and in configurations.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Fs => "fs",
            Self::Rs => "rs",
            Self::Dodge => "dodge",
            Self::Cartpole => "cartpole",
            Self::Acrobot => "acrobot",
            Self::MountainCar => "mountain-car",
            Self::Pendulum => "pendulum",
            Self::MountainCarContinuous => "mountain-car-continuous",
        }
    }

    /// Finds the problem with the given [`name`](Self::name).
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|problem| problem.name() == name)
    }

    /// Returns the names of all problems, for messages.
    pub fn names() -> String {
        Self::ALL.map(Self::name).join(", ")
    }

    /// Returns the arm's start, if this is a problem of the arm.
    pub const fn start(self) -> Option<Start> {
        match self {
            Self::Fs => Some(Start::Fs),
            Self::Rs => Some(Start::Rs),
            Self::Dodge
            | Self::Cartpole
            | Self::Acrobot
            | Self::MountainCar
            | Self::Pendulum
            | Self::MountainCarContinuous => None,
        }
    }
}

impl From<Start> for ProblemName {
    fn from(start: Start) -> Self {
        match start {
            Start::Fs => Self::Fs,
            Start::Rs => Self::Rs,
        }
    }
}

/// A problem with its settings: the section `[problem]` of a configuration.
#[derive(Clone, Debug, PartialEq)]
pub enum Problem {
    /// The arm.
    Arm(Start, arm::Config),
    /// The arm among balls.
    Dodge(dodge::Config),
    /// The pole on a cart.
    Cartpole(cartpole::Config),
    /// The two links.
    Acrobot(acrobot::Config),
    /// The car in a valley, by three pushes.
    MountainCar(mountain_car::Config),
    /// The pendulum.
    Pendulum(pendulum::Config),
    /// The car in a valley, by a force.
    MountainCarContinuous(mountain_car_continuous::Config),
}

/// A file with a section `[problem]`; the other sections belong to other readers.
#[derive(Deserialize)]
struct File<P> {
    problem: P,
}

/// Only the name.
#[derive(Deserialize)]
struct Name {
    name: String,
}

impl Problem {
    /// Returns a problem with its default settings.
    pub fn usual(name: ProblemName) -> Self {
        match name {
            ProblemName::Fs => Self::Arm(Start::Fs, arm::Config::default()),
            ProblemName::Rs => Self::Arm(Start::Rs, arm::Config::default()),
            ProblemName::Dodge => Self::Dodge(dodge::Config::default()),
            ProblemName::Cartpole => Self::Cartpole(cartpole::Config::default()),
            ProblemName::Acrobot => Self::Acrobot(acrobot::Config::default()),
            ProblemName::MountainCar => Self::MountainCar(mountain_car::Config::default()),
            ProblemName::Pendulum => Self::Pendulum(pendulum::Config::default()),
            ProblemName::MountainCarContinuous => {
                Self::MountainCarContinuous(mountain_car_continuous::Config::default())
            }
        }
    }

    /// Returns the problem's name.
    pub fn name(&self) -> ProblemName {
        match self {
            Self::Arm(start, _) => (*start).into(),
            Self::Dodge(_) => ProblemName::Dodge,
            Self::Cartpole(_) => ProblemName::Cartpole,
            Self::Acrobot(_) => ProblemName::Acrobot,
            Self::MountainCar(_) => ProblemName::MountainCar,
            Self::Pendulum(_) => ProblemName::Pendulum,
            Self::MountainCarContinuous(_) => ProblemName::MountainCarContinuous,
        }
    }

    /// Returns the number of levels of each output for policies that choose among named actions; `None` for policies that
    /// compute the outputs.
    pub fn levels(&self) -> Option<u16> {
        match self {
            Self::Pendulum(config) => config.levels,
            Self::Arm(..)
            | Self::Dodge(_)
            | Self::Cartpole(_)
            | Self::Acrobot(_)
            | Self::MountainCar(_)
            | Self::MountainCarContinuous(_) => None,
        }
    }

    /// Returns the number of levels for a graph: none for one that computes outputs, otherwise [`levels`](Self::levels), or
    /// [`USUAL_LEVELS`] where the settings name none.
    pub fn levels_for(&self, graph: &Graph) -> Option<u16> {
        graph.outputs().is_empty().then(|| self.levels().unwrap_or(USUAL_LEVELS))
    }

    /// Reads the section `[problem]` of a configuration.
    ///
    /// # Errors
    /// An unknown problem, an unknown key or a value that the problem does not accept, with its line.
    pub fn from_toml(file: &str, text: &str) -> Result<Self, InputError> {
        let name = named(file, text)?;
        let problem = match name {
            ProblemName::Fs => Self::Arm(Start::Fs, section(file, text)?),
            ProblemName::Rs => Self::Arm(Start::Rs, section(file, text)?),
            ProblemName::Dodge => Self::Dodge(section(file, text)?),
            ProblemName::Cartpole => Self::Cartpole(section(file, text)?),
            ProblemName::Acrobot => Self::Acrobot(section(file, text)?),
            ProblemName::MountainCar => Self::MountainCar(section(file, text)?),
            ProblemName::Pendulum => Self::Pendulum(section(file, text)?),
            ProblemName::MountainCarContinuous => Self::MountainCarContinuous(section(file, text)?),
        };
        problem.check().map_err(|finding| settings::place(file, text, finding))?;
        Ok(problem)
    }

    fn check(&self) -> Result<(), Finding> {
        match self {
            Self::Arm(_, config) => config.check(),
            Self::Dodge(config) => config.check(),
            Self::Cartpole(config) => check(CartPole, &config.physics, &config.disturbance),
            Self::Acrobot(config) => check(Acrobot, &config.physics, &config.disturbance),
            Self::MountainCar(config) => check(MountainCar, &config.physics, &config.disturbance),
            Self::MountainCarContinuous(config) => check(MountainCarContinuous, &config.physics, &config.disturbance),
            Self::Pendulum(config) => {
                config.check()?;
                check(Pendulum, &config.physics, &config.disturbance)
            }
        }
    }

    /// Returns the section `[problem]` with every setting written out.
    ///
    /// # Panics
    /// Never: every setting can be written.
    pub fn to_table(&self) -> toml::Table {
        let mut table = match self {
            Self::Arm(_, config) => toml::Table::try_from(config),
            Self::Dodge(config) => toml::Table::try_from(config),
            Self::Cartpole(config) => toml::Table::try_from(config),
            Self::Acrobot(config) => toml::Table::try_from(config),
            Self::MountainCar(config) => toml::Table::try_from(config),
            Self::Pendulum(config) => toml::Table::try_from(config),
            Self::MountainCarContinuous(config) => toml::Table::try_from(config),
        }
        .expect("settings are plain data");
        table.insert("name".to_owned(), self.name().name().into());
        table
    }

    /// Creates the problem's environment. Its actions are the problem's own: a box if it has outputs.
    ///
    /// ```
    /// use tpg_problems::{Problem, ProblemName};
    ///
    /// let environment = Problem::usual(ProblemName::Cartpole).environment::<f32>();
    /// assert_eq!(environment.time_limit(), 500);
    /// ```
    pub fn environment<S: Number>(&self) -> AnyEnvironment<S> {
        S::environment(self)
    }

    fn create<S: ArmScalar>(&self) -> AnyEnvironment<S> {
        match self {
            Self::Arm(start, config) => erase(config.environment::<S>(*start)),
            Self::Dodge(config) => erase(Dodge::new(config)),
            Self::Cartpole(config) => erase(Varied::new(CartPole, config.physics, config.disturbance.clone())),
            Self::Acrobot(config) => erase(Varied::new(Acrobot, config.physics, config.disturbance.clone())),
            Self::MountainCar(config) => erase(Varied::new(MountainCar, config.physics, config.disturbance.clone())),
            Self::Pendulum(config) => erase(Varied::new(Pendulum, config.physics, config.disturbance.clone())),
            Self::MountainCarContinuous(config) => {
                erase(Varied::new(MountainCarContinuous, config.physics, config.disturbance.clone()))
            }
        }
    }
}

/// Checks the constants and the disturbances of a problem.
fn check(
    environment: impl Environment<f64>,
    physics: &impl Constants,
    disturbance: &Disturbance,
) -> Result<(), Finding> {
    physics.check()?;
    disturbance.check(&environment.sources())
}

/// The problem that the section `[problem]` names.
pub(crate) fn named(file: &str, text: &str) -> Result<ProblemName, InputError> {
    let header: File<Name> = settings::from_toml(file, text, "a section [problem] with a name")?;
    let found = header.problem.name;
    ProblemName::from_name(&found).ok_or_else(|| {
        let accepted = format!("one of {}", ProblemName::names());
        settings::place(file, text, Finding::new("problem.name", format!("{found:?}"), accepted))
    })
}

/// Reads the settings of one kind of problem: the section without the name, strictly.
pub(crate) fn section<Settings: DeserializeOwned>(file: &str, text: &str) -> Result<Settings, InputError> {
    const ACCEPTED: &str = "the settings that `tpg-train config` prints";
    let mut table = settings::from_toml::<File<toml::Table>>(file, text, ACCEPTED)?.problem;
    table.remove("name");
    serde_path_to_error::deserialize(toml::Value::Table(table)).map_err(|error| {
        let key = match error.path().to_string() {
            path if path == "." => "problem".to_owned(),
            path => format!("problem.{path}"),
        };
        let found = error.inner().message().trim().to_owned();
        InputError { found, ..settings::place(file, text, Finding::new(key, "", ACCEPTED)) }
    })
}

/// Number types of the problems in the registry.
///
/// Its method is not a generic function, so that the problems are compiled in this crate and not once more in every crate that
/// uses them.
pub trait Number: ArmScalar {
    /// Implements [`Problem::environment`].
    fn environment(problem: &Problem) -> AnyEnvironment<Self>;
}

impl Number for f32 {
    fn environment(problem: &Problem) -> AnyEnvironment<f32> {
        problem.create()
    }
}

impl Number for f64 {
    fn environment(problem: &Problem) -> AnyEnvironment<f64> {
        problem.create()
    }
}

#[cfg(test)]
mod tests {
    use super::{Problem, ProblemName};
    use tpg_graph::error::Place;

    #[test]
    fn a_section_gives_back_the_same_problem() {
        for name in ProblemName::ALL {
            let problem = Problem::usual(name);
            let mut file = toml::Table::new();
            file.insert("problem".to_owned(), problem.to_table().into());
            assert_eq!(Problem::from_toml("x.toml", &file.to_string()), Ok(problem));
            assert_eq!(ProblemName::from_name(name.name()), Some(name));
        }
    }

    #[test]
    fn a_wrong_setting_is_refused_with_its_line() {
        for (text, line, found) in [
            ("[problem]\nname = \"pendulum\"\ntolerance = 3.0\n", 3, "unknown field `tolerance`"),
            ("[problem]\nname = \"pendulum\"\nlevels = 1\n", 3, "problem.levels = 1"),
            ("[problem]\nname = \"pendulum\"\nlevels = \"many\"\n", 3, "invalid type"),
            ("[problem]\nname = \"fs\"\nstep = 5\nshield = \"limits\"\n", 4, "problem.shield = \"limits\""),
            ("[problem]\nname = \"cartpole\"\n[problem.physics]\nlength = 0.0\n", 4, "problem.physics.length = 0"),
            (
                "[problem]\nname = \"acrobot\"\n[problem.physics]\nmass_2 = [2, 1]\n",
                4,
                "problem.physics.mass_2 = [2.0, 1.0]",
            ),
            (
                "[problem]\nname = \"cartpole\"\n[problem.physics]\nforce = \"strong\"\n",
                4,
                "a number, or [lowest, highest]",
            ),
            (
                "[problem]\nname = \"pendulum\"\n[problem.disturbance]\nhidden = [\"speed\"]\n",
                4,
                "problem.disturbance.hidden",
            ),
            (
                "[problem]\nname = \"mountain-car\"\n[problem.disturbance]\ndelay = 101\n",
                4,
                "problem.disturbance.delay",
            ),
            (
                "[problem]\nname = \"pendulum\"\n[problem.disturbance.noise]\nomega = -1\n",
                4,
                "problem.disturbance.noise.omega",
            ),
            ("[problem]\nname = \"rs\"\nbacklash = 201\n", 3, "problem.backlash = 201"),
            ("[problem]\nname = \"dodge\"\nballs = [2, 4]\n", 3, "problem.balls = [2, 4]"),
            ("[problem]\nname = \"dodge\"\n\nspeed = [2.0, 0.3]\n", 4, "problem.speed = [2.0, 0.3]"),
            ("[problem]\nname = \"dodge\"\neffort = 10\n", 3, "problem.effort = 10"),
            ("[problem]\nname = \"lander\"\n", 2, "problem.name = \"lander\""),
            ("[problem]\nname = \"rs\"\n[problem.arm]\nhome = 3\n", 4, "invalid type"),
        ] {
            let error = Problem::from_toml("x.toml", text).expect_err(text);
            assert_eq!(error.place, Place::Line(line), "{error}");
            assert!(error.found.starts_with(found), "{error}");
        }
    }
}
