//! The configuration of a training run, and the presets.

use serde::{Deserialize, Serialize};
use tpg_arm::sac::{Actions, Mask};
use tpg_nn::Spread;
use tpg_problems::arm::targets::TOLERANCE;

/// The presets: name and TOML text, which says what every value means.
pub const PRESETS: [(&str, &str); 8] = [
    ("best-fs", include_str!("presets/best-fs.toml")),
    ("best-rs", include_str!("presets/best-rs.toml")),
    ("no-planner-fs", include_str!("presets/no-planner-fs.toml")),
    ("no-planner-rs", include_str!("presets/no-planner-rs.toml")),
    ("paper-fs", include_str!("presets/paper-fs.toml")),
    ("paper-rs", include_str!("presets/paper-rs.toml")),
    ("paper-fs-16-units", include_str!("presets/paper-fs-16-units.toml")),
    ("paper-fs-no-collision-in-training", include_str!("presets/paper-fs-no-collision-in-training.toml")),
];

/// A training run, without its seed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Config {
    /// Where episodes start and when they are cut off.
    pub task: Task,
    /// The actor: what it sees, its network, its actions.
    pub actor: Actor,
    /// The critics.
    pub critic: Critic,
    /// What is rewarded.
    pub reward: Reward,
    /// How it learns.
    pub learning: Learning,
    /// Episodes that begin where the actor failed; without it, none does.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub retry: Option<Retry>,
    /// How candidates are chosen.
    pub validation: Validation,
}

/// Where training episodes start and when they are cut off.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Task {
    /// The fraction of episodes that start at home; the others start anywhere.
    pub fixed_start_share: f64,
    /// After this many steps an episode is cut off, which is no failure.
    pub max_steps: u32,
    /// A decision is repeated for d / this many mm steps.
    pub repeat_per_mm: f32,
    /// The most steps a decision is repeated for. 1: no repeats.
    pub repeat_most: u32,
    /// Whether an invalid step ends an episode. The paper's training went on after it.
    pub invalid_ends: bool,
    /// Ticks of a coarse action in training. Tests always move by 3.
    #[serde(default = "ticks")]
    pub step: i8,
    /// In training an episode succeeds nearer than this, mm. In tests it is 3 mm.
    #[serde(default = "tolerance")]
    pub tolerance: f64,
}

fn ticks() -> i8 {
    3
}

fn tolerance() -> f64 {
    TOLERANCE
}

/// What an actor sees.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Inputs {
    /// The features of `tpg_arm::sac`.
    Features,
    /// The paper's 13 values, target, difference, hand, motors.
    PaperFs,
    /// The paper's 13 values, target, hand, difference, motors.
    PaperRs,
}

/// The actor.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Actor {
    /// What it sees.
    pub inputs: Inputs,
    /// Units of each hidden layer.
    pub hidden: Vec<usize>,
    /// Whether hidden layers are normalised.
    pub layer_norm: bool,
    /// What the second half of its outputs means.
    pub spread: Spread,
    /// "fine" or "coarse".
    #[serde(with = "actions_name")]
    pub actions: Actions,
    /// "none" or "joint-limits".
    #[serde(with = "mask_name")]
    pub mask: Mask,
    /// Whether the arm may rest; otherwise the strongest preference moves.
    pub may_rest: bool,
    /// How it decides outside of training.
    #[serde(default, skip_serializing_if = "Decides::is_by_mean")]
    pub decides: Decides,
}

/// How an actor decides outside of training.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Decides {
    /// By the mean of its distribution: always the same in the same state.
    #[default]
    ByMean,
    /// By a draw, as in training: the paper's tests. In a hybrid and in integers it decides by the mean.
    ByDraw,
}

impl Decides {
    fn is_by_mean(&self) -> bool {
        *self == Self::ByMean
    }
}

/// The critics.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Critic {
    /// Units of each hidden layer.
    pub hidden: Vec<usize>,
}

/// The reward of one decision; d is the distance in mm, 0 before and 1 after it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Reward {
    /// For each step.
    pub step: f32,
    /// Times ln((d0 + 3)/(d1 + 3)).
    pub log_distance: f32,
    /// Times (d0 − d1).
    pub distance: f32,
    /// Times (D0 − D1), D being the steps to the nearest pose that solves the task: privileged knowledge.
    pub steps_to_goal: f32,
    /// Times d1, unless the decision ended the episode.
    pub remaining_distance: f32,
    /// On success.
    pub success: f32,
    /// On an invalid step.
    pub invalid: f32,
    /// All of it is multiplied by this.
    pub scale: f32,
}

/// Which algorithm learns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Algorithm {
    /// Two critics with slow copies and a learned temperature.
    TwinCritics,
    /// Two critics, a value network with a slow copy, a fixed temperature of 1: the paper's.
    ValueNetwork,
}

/// How it learns.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Learning {
    /// Which algorithm.
    pub algorithm: Algorithm,
    /// The run's length, in decisions of all lanes together.
    pub decisions: u64,
    /// Environments side by side.
    pub lanes: usize,
    /// Decisions between two updates.
    pub decisions_per_update: u64,
    /// Random decisions before the first update.
    pub random_decisions: u64,
    /// Transitions in an update.
    pub batch: usize,
    /// Transitions remembered.
    pub replay: usize,
    /// Adam's step at the start.
    pub rate: f64,
    /// The fraction of it that is left at the end; it falls linearly.
    pub final_rate: f64,
    /// γ for each step.
    pub discount: f64,
    /// τ.
    pub follow: f64,
    /// Nats. Only with a learned temperature.
    pub target_entropy: f64,
    /// ln α at the start. Only with a learned temperature.
    pub log_temperature: f64,
    /// Adam's step for ln α. Only with a learned temperature.
    pub temperature_rate: f64,
    /// The actor that is validated and kept is an average: after each update it follows the one that learns by this fraction.
    /// Without it, the two are one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub average: Option<f64>,
}

/// Episodes that begin where the actor failed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Retry {
    /// The fraction of training episodes that begin there, once a failure is known.
    pub share: f64,
    /// Decisions between two looks for failures.
    pub every: u64,
    /// Fresh training tasks from home in each look.
    pub fixed_starts: usize,
    /// Fresh training tasks from anywhere in each look.
    pub random_starts: usize,
    /// Places remembered: the latest so many.
    pub remembered: usize,
}

/// How candidates are chosen: on validation tasks, never on test tasks.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Validation {
    /// Decisions between two validations.
    pub every: u64,
    /// Episodes of each problem.
    pub episodes: usize,
    /// A run ends early when its curve is flat: when over the last so many validations, against as many before them,
    /// the mean success has not risen and the mean distance has not fallen. 0: never.
    pub flat_after: usize,
}

impl Config {
    /// The preset of that name.
    pub fn preset(name: &str) -> Option<Self> {
        let (_, text) = PRESETS.iter().find(|(preset, _)| *preset == name)?;
        toml::from_str(text).ok()
    }

    /// Checks what types cannot; the error names the key, the value found and what is accepted.
    ///
    /// # Errors
    /// If a value would make training impossible.
    pub fn check(&self) -> Result<(), String> {
        let Self { task, actor, critic, learning, retry, validation, .. } = self;
        let share = (0.0..=1.0).contains(&task.fixed_start_share);
        let average = learning.average.unwrap_or(1.0);
        let (retries, retry_every) = retry.map_or((0.0, 1), |retry| (retry.share, retry.every));
        let widths = |hidden: &[usize]| hidden.iter().all(|width| (1..=4096).contains(width)) && hidden.len() <= 8;
        let checks = [
            (share, "task.fixed_start_share", format!("{}", task.fixed_start_share), "0 to 1"),
            (task.max_steps > 0, "task.max_steps", format!("{}", task.max_steps), "1 or more"),
            (task.repeat_per_mm > 0.0, "task.repeat_per_mm", format!("{}", task.repeat_per_mm), "more than 0"),
            (
                task.step == ticks() || task.step > 0 && actor.actions == Actions::Coarse,
                "task.step",
                format!("{}", task.step),
                "3; with coarse actions, 1 to 127",
            ),
            (
                task.tolerance > 0.0 && task.tolerance.is_finite(),
                "task.tolerance",
                format!("{}", task.tolerance),
                "more than 0",
            ),
            (task.repeat_most > 0, "task.repeat_most", format!("{}", task.repeat_most), "1 or more"),
            (widths(&actor.hidden), "actor.hidden", format!("{:?}", actor.hidden), "up to 8 layers of 1 to 4096 units"),
            (
                widths(&critic.hidden),
                "critic.hidden",
                format!("{:?}", critic.hidden),
                "up to 8 layers of 1 to 4096 units",
            ),
            (learning.lanes > 0, "learning.lanes", format!("{}", learning.lanes), "1 or more"),
            (learning.batch > 0, "learning.batch", format!("{}", learning.batch), "1 or more"),
            (learning.replay > 0, "learning.replay", format!("{}", learning.replay), "1 or more"),
            (
                learning.decisions_per_update > 0,
                "learning.decisions_per_update",
                format!("{}", learning.decisions_per_update),
                "1 or more",
            ),
            (learning.random_decisions > 0, "learning.random_decisions", "0".to_owned(), "1 or more"),
            (average > 0.0 && average <= 1.0, "learning.average", format!("{average}"), "more than 0, up to 1"),
            ((0.0..=1.0).contains(&retries), "retry.share", format!("{retries}"), "0 to 1"),
            (retry_every > 0, "retry.every", "0".to_owned(), "1 or more"),
            (validation.every > 0, "validation.every", "0".to_owned(), "1 or more"),
            (validation.episodes > 0, "validation.episodes", "0".to_owned(), "1 or more"),
        ];
        match checks.into_iter().find(|(good, ..)| !good) {
            None => Ok(()),
            Some((_, key, found, accepted)) => Err(format!("{key} = {found}; accepted: {accepted}")),
        }
    }
}

macro_rules! by_name {
    ($module:ident, $type:ty, $accepted:expr) => {
        mod $module {
            use serde::de::{Deserialize, Deserializer, Error};
            use serde::ser::Serializer;

            pub(super) fn serialize<S: Serializer>(value: &$type, to: S) -> Result<S::Ok, S::Error> {
                to.serialize_str(value.name())
            }

            pub(super) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<$type, D::Error> {
                let name = String::deserialize(from)?;
                <$type>::from_name(&name).ok_or_else(|| D::Error::unknown_variant(&name, &$accepted))
            }
        }
    };
}
by_name!(actions_name, tpg_arm::sac::Actions, ["fine", "coarse"]);
by_name!(mask_name, tpg_arm::sac::Mask, ["none", "joint-limits"]);

#[cfg(test)]
mod tests {
    use super::{Config, PRESETS};

    #[test]
    fn every_preset_is_read_and_sound() {
        for (name, text) in PRESETS {
            let config: Config = toml::from_str(text).unwrap_or_else(|error| panic!("{name}: {error}"));
            assert_eq!(config.check(), Ok(()), "{name}");
            assert_eq!(Config::preset(name), Some(config));
        }
    }

    #[test]
    fn a_value_that_cannot_work_is_named() {
        let mut config = Config::preset("best-fs").expect("a preset");
        config.learning.average = Some(0.0);
        assert_eq!(config.check(), Err("learning.average = 0; accepted: more than 0, up to 1".to_owned()));
        config.learning.lanes = 0;
        assert_eq!(config.check(), Err("learning.lanes = 0; accepted: 1 or more".to_owned()));
    }

    #[test]
    fn unknown_keys_and_names_are_refused() {
        let text = PRESETS[0].1;
        for (from, to) in [("[reward]", "[reward]\nfun = 1"), ("\"fine\"", "\"medium\"")] {
            let wrong = text.replacen(from, to, 1);
            assert_ne!(wrong, text);
            assert!(toml::from_str::<Config>(&wrong).is_err(), "{to}");
        }
    }
}
