//! The built-in problems: one of [`ProblemName`] each.

use crate::acrobot::{self, Acrobot};
use crate::arm::ArmConfig;
use crate::arm::drawing::picture;
use crate::arm::evaluation::figures;
use crate::arm::motors::{Motors, MotorsConfig};
use crate::arm::targets::Start;
use crate::cartpole::{self, CartPole};
use crate::dodge::{Dodge, DodgeConfig};
use crate::eye::Eye;
use crate::minatar::{Asterix, Breakout, Freeway, MinAtar, Seaquest, SpaceInvaders};
use crate::mountain_car::{self, MountainCar};
use crate::mountain_car_continuous::{self, MountainCarContinuous};
use crate::pendulum::PendulumConfig;
use crate::varied::VariedSettings;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use tpg_arm::kinematics::Lattice;
use tpg_arm::{Arm, WIDOWX};
use tpg_engine::{AnyEnvironment, EpisodeResult, erase};
use tpg_graph::error::{Finding, InputError, Place};
use tpg_graph::{Graph, settings};
use tpg_runtime::named;

/// The levels of an output for a graph that chooses among named actions, where the settings name none.
pub const DEFAULT_LEVELS: u16 = 3;

named! {
    /// A built-in problem, with its name on the command line and in configurations.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, clap::ValueEnum)]
    pub enum ProblemName {
        /// A robot arm reaches for a target from its home position: the paper's fixed start
        Fs = "fs",
        /// A robot arm reaches for a target from anywhere: the paper's random start
        Rs = "rs",
        /// A robot arm reaches for a target among moving balls, by behaviours
        Dodge = "dodge",
        /// A cart balances a pole: Gymnasium's CartPole-v1
        Cartpole = "cartpole",
        /// A motor between two links swings them up: Gymnasium's Acrobot-v1
        Acrobot = "acrobot",
        /// A weak car drives out of a valley by three pushes: Gymnasium's MountainCar-v0
        MountainCar = "mountain-car",
        /// A weak motor swings a pendulum up: Gymnasium's Pendulum-v1
        Pendulum = "pendulum",
        /// A weak car drives out of a valley: Gymnasium's MountainCarContinuous-v0
        MountainCarContinuous = "mountain-car-continuous",
        /// A paddle keeps a ball in play: MinAtar's Breakout
        Breakout = "breakout",
        /// A player takes gold and avoids enemies: MinAtar's Asterix
        Asterix = "asterix",
        /// A cannon shoots aliens: MinAtar's Space Invaders
        SpaceInvaders = "space-invaders",
        /// A chicken crosses a road: MinAtar's Freeway
        Freeway = "freeway",
        /// A submarine shoots enemies and rescues divers: MinAtar's Seaquest
        Seaquest = "seaquest",
        /// A camera follows a ball that is lighter or darker than what is behind it
        Eye = "eye",
    }
}

/// The kind of policies that a problem is set up for: only the arm differs between them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PolicyKind {
    /// Graphs, which may choose among named actions.
    Graph,
    /// Networks, which answer a value for each output: they drive the arm by its motors.
    Network,
}

type PathError = serde_path_to_error::Error<toml::de::Error>;

impl ProblemName {
    /// Returns the arm's start, if this is a problem of the arm.
    pub(crate) fn start(self) -> Option<Start> {
        match self {
            Self::Fs => Some(Start::Fs),
            Self::Rs => Some(Start::Rs),
            _ => None,
        }
    }

    /// Returns the names of all problems, for messages.
    pub fn names() -> String {
        Self::ALL.map(Self::name).join(", ")
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
pub struct Problem {
    name: ProblemName,
    /// The settings.
    pub settings: ProblemSettings,
}

/// The settings of a problem.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum ProblemSettings {
    /// The arm.
    Arm(ArmConfig),
    /// The arm by its motors.
    Motors(MotorsConfig),
    /// The arm among balls.
    Dodge(DodgeConfig),
    /// The pole on a cart.
    Cartpole(VariedSettings<cartpole::Amounts>),
    /// The two links.
    Acrobot(VariedSettings<acrobot::Amounts>),
    /// The car in a valley, by three pushes.
    MountainCar(VariedSettings<mountain_car::Amounts>),
    /// The pendulum.
    Pendulum(PendulumConfig),
    /// The car in a valley, by a force.
    MountainCarContinuous(VariedSettings<mountain_car_continuous::Amounts>),
    /// A problem that cannot be changed: a game of MinAtar, or the camera.
    Fixed(NoSettings),
}

/// The section `[problem]` of a configuration for a problem without settings.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NoSettings {}

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

/// The description of what is accepted in the section.
const ACCEPTED: &str = "the settings that `tpg-train config` prints";

impl Problem {
    /// Returns a problem with its default settings, for graphs.
    pub fn new(name: ProblemName) -> Self {
        Self::new_for(name, PolicyKind::Graph)
    }

    /// Returns a problem with its default settings.
    ///
    /// # Panics
    /// Never: every setting has a default.
    pub fn new_for(name: ProblemName, kind: PolicyKind) -> Self {
        Self::parse(name, kind, toml::Table::new()).expect("every setting has a default")
    }

    fn parse(name: ProblemName, kind: PolicyKind, table: toml::Table) -> Result<Self, PathError> {
        fn read<T: DeserializeOwned>(table: toml::Table) -> Result<T, PathError> {
            serde_path_to_error::deserialize(toml::Value::Table(table))
        }
        let settings = match name {
            ProblemName::Fs | ProblemName::Rs if kind == PolicyKind::Network => ProblemSettings::Motors(read(table)?),
            ProblemName::Fs | ProblemName::Rs => ProblemSettings::Arm(read(table)?),
            ProblemName::Dodge => ProblemSettings::Dodge(read(table)?),
            ProblemName::Cartpole => ProblemSettings::Cartpole(read(table)?),
            ProblemName::Acrobot => ProblemSettings::Acrobot(read(table)?),
            ProblemName::MountainCar => ProblemSettings::MountainCar(read(table)?),
            ProblemName::Pendulum => ProblemSettings::Pendulum(read(table)?),
            ProblemName::MountainCarContinuous => ProblemSettings::MountainCarContinuous(read(table)?),
            ProblemName::Breakout
            | ProblemName::Asterix
            | ProblemName::SpaceInvaders
            | ProblemName::Freeway
            | ProblemName::Seaquest
            | ProblemName::Eye => ProblemSettings::Fixed(read(table)?),
        };
        Ok(Self { name, settings })
    }

    /// Returns the problem's name.
    pub fn name(&self) -> ProblemName {
        self.name
    }

    /// Returns the arm's start; the fixed one for a problem without one.
    pub(crate) fn start(&self) -> Start {
        self.name.start().unwrap_or(Start::Fs)
    }

    /// Returns the problem of another name: the arm by its motors keeps its settings with another start.
    #[must_use]
    pub fn renamed(self, name: ProblemName, kind: PolicyKind) -> Self {
        match &self.settings {
            ProblemSettings::Motors(_) if name.start().is_some() => Self { name, ..self },
            _ if self.name == name => self,
            _ => Self::new_for(name, kind),
        }
    }

    /// Returns the number of levels of each output for policies that choose among named actions; `None` for policies that
    /// compute the outputs.
    pub fn levels(&self) -> Option<u16> {
        if let ProblemSettings::Pendulum(config) = &self.settings { config.levels } else { None }
    }

    /// Returns the number of levels for a graph: none for one that computes outputs, otherwise [`levels`](Self::levels), or
    /// [`DEFAULT_LEVELS`] where the settings name none.
    pub fn levels_for(&self, graph: &Graph) -> Option<u16> {
        graph.outputs().is_empty().then(|| self.levels().unwrap_or(DEFAULT_LEVELS))
    }

    /// Reads the section `[problem]` of a configuration for graphs.
    ///
    /// # Errors
    /// An unknown problem, an unknown key or a value that the problem does not accept, with its line.
    pub fn from_toml(file: &str, text: &str) -> Result<Self, InputError> {
        Self::read(file, text, PolicyKind::Graph)
    }

    /// Reads the section `[problem]` of a configuration.
    ///
    /// # Errors
    /// As [`from_toml`](Self::from_toml).
    pub fn read(file: &str, text: &str, kind: PolicyKind) -> Result<Self, InputError> {
        let header: File<Name> = settings::from_toml(file, text, "a section [problem] with a name")?;
        let found = header.problem.name;
        let name = ProblemName::from_name(&found).ok_or_else(|| {
            let accepted = format!("one of {}", ProblemName::names());
            settings::place(file, text, Finding::new("problem.name", format!("{found:?}"), accepted))
        })?;
        let mut table = settings::from_toml::<File<toml::Table>>(file, text, ACCEPTED)?.problem;
        table.remove("name");
        let problem = Self::parse(name, kind, table).map_err(|error| {
            let key = match error.path().to_string() {
                path if path == "." => "problem".to_owned(),
                path => format!("problem.{path}"),
            };
            let found = error.inner().message().trim().to_owned();
            InputError { found, ..settings::place(file, text, Finding::new(key, "", ACCEPTED)) }
        })?;
        problem.check().map_err(|finding| settings::place(file, text, finding))?;
        Ok(problem)
    }

    /// Reads the section as [`to_table`](Self::to_table) wrote it; `file` is the file that it was kept in.
    ///
    /// # Errors
    /// As [`from_toml`](Self::from_toml).
    pub fn from_table(file: &str, table: &toml::Table, kind: PolicyKind) -> Result<Self, InputError> {
        let whole = toml::Table::from_iter([("problem".to_owned(), table.clone().into())]).to_string();
        let place = || Place::Path("problem".to_owned());
        Self::read(file, &whole, kind).map_err(|error| InputError { place: place(), ..error })
    }

    fn check(&self) -> Result<(), Finding> {
        Finding::range("problem.levels", self.levels().unwrap_or(DEFAULT_LEVELS), 2, 1001)?;
        match &self.settings {
            ProblemSettings::Arm(config) => config.check(),
            ProblemSettings::Motors(config) => config.check(),
            ProblemSettings::Dodge(config) => config.check(),
            ProblemSettings::Cartpole(it) => it.around(CartPole).check(),
            ProblemSettings::Acrobot(it) => it.around(Acrobot).check(),
            ProblemSettings::MountainCar(it) => it.around(MountainCar).check(),
            ProblemSettings::Pendulum(it) => it.environment().check(),
            ProblemSettings::MountainCarContinuous(it) => it.around(MountainCarContinuous).check(),
            ProblemSettings::Fixed(_) => Ok(()),
        }
    }

    /// Returns the section `[problem]` with every setting written out.
    ///
    /// # Panics
    /// Never: every setting can be written.
    pub fn to_table(&self) -> toml::Table {
        let mut table = toml::Table::try_from(&self.settings).expect("settings are plain data");
        table.insert("name".to_owned(), self.name.name().into());
        table
    }

    /// Creates the problem's environment. Its actions are the problem's own: a box if it has outputs.
    ///
    /// ```
    /// use tpg_problems::{Problem, ProblemName};
    ///
    /// let environment = Problem::new(ProblemName::Cartpole).environment::<f32>();
    /// assert_eq!(environment.time_limit(), 500);
    /// ```
    pub fn environment<S: Number>(&self) -> AnyEnvironment<S> {
        S::environment(self)
    }

    fn create<S: Number>(&self) -> AnyEnvironment<S> {
        match &self.settings {
            ProblemSettings::Arm(config) => erase(config.environment::<S>(self.start())),
            // The arm as graphs share it with a network.
            ProblemSettings::Motors(config) => {
                let network = Some(Box::new(config.clone()));
                let config = ArmConfig { arm: config.arm.clone(), network, ..ArmConfig::default() };
                erase(config.environment::<S>(self.start()))
            }
            ProblemSettings::Dodge(config) => erase(Dodge::new(config)),
            ProblemSettings::Cartpole(it) => erase(it.around(CartPole)),
            ProblemSettings::Acrobot(it) => erase(it.around(Acrobot)),
            ProblemSettings::MountainCar(it) => erase(it.around(MountainCar)),
            ProblemSettings::Pendulum(it) => erase(it.environment()),
            ProblemSettings::MountainCarContinuous(it) => erase(it.around(MountainCarContinuous)),
            ProblemSettings::Fixed(_) => match self.name {
                ProblemName::Breakout => erase(MinAtar::<Breakout>::default()),
                ProblemName::Asterix => erase(MinAtar::<Asterix>::default()),
                ProblemName::SpaceInvaders => erase(MinAtar::<SpaceInvaders>::default()),
                ProblemName::Freeway => erase(MinAtar::<Freeway>::default()),
                ProblemName::Seaquest => erase(MinAtar::<Seaquest>::default()),
                _ => erase(Eye::default()),
            },
        }
    }

    /// Returns the settings that the integers of a network keep: those of the arm's decision.
    pub fn kept_settings(&self) -> Option<toml::Table> {
        let ProblemSettings::Motors(_) = &self.settings else { return None };
        let mut table = self.to_table();
        table.retain(|key, _| ["actions", "mask", "may_rest"].contains(&key));
        Some(table)
    }

    /// Returns the problem's own figures of some episodes.
    pub fn figures(&self, endings: &[EpisodeResult]) -> Map<String, Value> {
        match self.settings {
            ProblemSettings::Arm(_) | ProblemSettings::Motors(_) => figures(endings),
            _ => Map::new(),
        }
    }

    /// Returns the [moments](tpg_engine::Environment::moment) of an episode as SVG; `None` for a problem without pictures.
    pub fn picture(&self, moments: &[Vec<f64>]) -> Option<String> {
        let arm = match &self.settings {
            ProblemSettings::Arm(config) => config.arm(),
            ProblemSettings::Motors(config) => config.arm(),
            ProblemSettings::Dodge(_) => WIDOWX,
            _ => return None,
        };
        Some(picture(&arm, moments))
    }

    /// Creates the environment in which a network acts alone: the [joined](Self::joined) one, or one that is trained. The arm's
    /// tasks come from the sample of the space that `seed` draws.
    pub fn network_environment(&self, seed: u64) -> AnyEnvironment<f32> {
        match &self.settings {
            ProblemSettings::Motors(config) => erase(Motors::new(self.start(), config.clone(), seed)),
            ProblemSettings::Arm(config) => {
                let network = config.network.as_deref().cloned().unwrap_or_default();
                erase(Motors::new(self.start(), network, seed).with_tests(config.problem(self.start())))
            }
            _ => self.environment(),
        }
    }
}

/// Number types of the problems in the registry.
///
/// Its methods are not generic functions, so that the problems are compiled in this crate and not once more in every crate that
/// uses them.
pub trait Number: Lattice {
    /// Rounds the arm to this number type.
    fn arm(arm: &Arm<f64>) -> Arm<Self>;

    /// Implements [`Problem::environment`].
    fn environment(problem: &Problem) -> AnyEnvironment<Self>;
}

impl Number for f32 {
    fn arm(arm: &Arm<f64>) -> Arm<f32> {
        arm.to_f32()
    }
    fn environment(problem: &Problem) -> AnyEnvironment<f32> {
        problem.create()
    }
}

impl Number for f64 {
    fn arm(arm: &Arm<f64>) -> Arm<f64> {
        *arm
    }
    fn environment(problem: &Problem) -> AnyEnvironment<f64> {
        problem.create()
    }
}

#[cfg(test)]
mod tests {
    use super::{PolicyKind, Problem, ProblemName, ProblemSettings};
    use tpg_graph::error::Place;

    #[test]
    fn a_section_gives_back_the_same_problem() {
        for name in ProblemName::ALL {
            for kind in [PolicyKind::Graph, PolicyKind::Network] {
                let problem = Problem::new_for(name, kind);
                assert_eq!(Problem::from_table("x.toml", &problem.to_table(), kind), Ok(problem));
            }
            assert_eq!(ProblemName::from_name(name.name()), Some(name));
        }
    }

    #[test]
    fn a_wrong_setting_is_refused_with_its_line() {
        for (text, line, found) in [
            ("[problem]\nname = \"pendulum\"\ntolerance = 3.0\n", 3, "unknown field `tolerance`"),
            ("[problem]\nname = \"pendulum\"\nlevels = 1\n", 3, "problem.levels = 1"),
            ("[problem]\nname = \"pendulum\"\nlevels = \"many\"\n", 3, "invalid type"),
            ("[problem]\nname = \"fs\"\nstep = 5\nbacklash = 201\n", 4, "problem.backlash = 201"),
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

    #[test]
    fn the_arm_keeps_its_settings_with_another_start() {
        let kind = PolicyKind::Network;
        let mut problem = Problem::new_for(ProblemName::Fs, kind);
        if let ProblemSettings::Motors(config) = &mut problem.settings {
            config.max_steps = 77;
        }
        let renamed = problem.clone().renamed(ProblemName::Rs, kind);
        assert!(matches!(&renamed.settings, ProblemSettings::Motors(config) if config.max_steps == 77));
        assert_eq!(renamed.name(), ProblemName::Rs);
        let other = Problem::new_for(ProblemName::Pendulum, kind);
        assert_eq!(problem.renamed(ProblemName::Pendulum, kind), other);
    }

    #[test]
    fn a_wrong_setting_of_the_motors_is_refused_with_its_line() {
        for (text, line, found) in [
            ("[problem]\nname = \"fs\"\nactions = \"medium\"\n", 3, "unknown variant"),
            ("[problem]\nname = \"fs\"\nsources = [\"stance\"]\n", 3, "unknown field"),
            ("[problem]\nname = \"rs\"\nrepeat_most = 0\n", 3, "problem.repeat_most = 0"),
            ("[problem]\nname = \"rs\"\n\nfixed_start_share = 2.0\n", 4, "problem.fixed_start_share = 2"),
        ] {
            let error = Problem::read("x.toml", text, PolicyKind::Network).expect_err(text);
            assert_eq!(error.place, Place::Line(line), "{error}");
            assert!(error.found.starts_with(found), "{error}");
        }
    }
}
