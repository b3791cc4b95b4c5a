//! The problems included with the trainer, and the registry that finds them by name.
//!
//! ```
//! use tpg_problems::{Problem, ProblemName};
//!
//! let problem = Problem::from_toml("my.toml", "[problem]\nname = \"pendulum\"\nlevels = 5\n")?;
//! assert_eq!(problem.name(), ProblemName::Pendulum);
//! # Ok::<(), tpg_graph::error::InputError>(())
//! ```
//!
//! # Map
//!
//! | module | subject |
//! | --- | --- |
//! | [`registry`] | the table of problems, and their settings |
//! | [`arm`] | reaching with a robot arm: `fs` and `rs` |
//! | [`dodge`] | reaching with a robot arm among moving balls |
//! | [`cartpole`] | balancing a pole on a cart |
//! | [`acrobot`] | swinging two links up |
//! | [`mountain_car`] | driving out of a valley by three pushes |
//! | [`mountain_car_continuous`] | driving out of a valley by a force |
//! | [`pendulum`] | swinging a pendulum up |
//! | `rows` | tasks as CSV |
//! | `sight` | the features of images |
//! | `eye` | a camera that follows a ball |
//! | `minatar` | games of ten by ten cells: `breakout`, `asterix`, `space-invaders`, `freeway`, `seaquest` |
//! | [`eights`] | problems whose episodes are stepped eight at a time |
//! | [`varied`], [`physics`], [`amount`] | other constants, late actions, noise and hidden sources |

pub mod acrobot;
pub mod amount;
pub mod arm;
pub mod cartpole;
mod circle;
pub mod dodge;
pub mod eights;
pub mod eye;
mod minatar;
pub mod mountain_car;
pub mod mountain_car_continuous;
pub mod pendulum;
pub mod physics;
pub mod registry;
mod rows;
mod sight;
mod tested;
#[cfg(test)]
mod tests;
pub mod varied;

pub use acrobot::Acrobot;
pub use arm::targets::TEST_SEED;
pub use cartpole::CartPole;
pub use mountain_car::MountainCar;
pub use mountain_car_continuous::MountainCarContinuous;
pub use pendulum::Pendulum;
pub use registry::{DEFAULT_LEVELS, Number, PolicyKind, Problem, ProblemName, ProblemSettings};

use tpg_graph::SourceDocument;

/// Creates a source of one value.
fn source(name: &str, unit: &str, range: [f64; 2]) -> SourceDocument {
    SourceDocument::new(name, unit, vec![range])
}
