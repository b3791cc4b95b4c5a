//! The configuration of a run, strictly read.
//!
//! The section `[problem]` belongs to the problem, which reads and checks it.

use super::presets;
use crate::configuration::{Configuration, Preset};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tpg_graph::error::Finding;
use tpg_problems::{PolicyKind, ProblemName};

/// Everything that decides a run, but for its seed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SacConfig {
    /// The problem's own settings, as the problem wrote them; empty where a program brings its own environment.
    #[serde(default, skip_serializing_if = "toml::Table::is_empty")]
    #[schemars(with = "serde_json::Map<String, serde_json::Value>")]
    pub problem: toml::Table,
    /// The actor.
    pub actor: Actor,
    /// The critics.
    pub critic: Critic,
    /// The parameters of the algorithm.
    pub learning: Learning,
    /// Episodes that begin where the actor failed; optional.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub retry: Option<Retry>,
    /// The choice among candidates.
    pub validation: Validation,
}

/// The actor.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Actor {
    /// Scales inputs by their declared ranges, where both ends are known.
    pub scaled_inputs: bool,
    /// Units of each hidden layer.
    pub hidden: Vec<usize>,
}

/// The critics.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Critic {
    /// Units of each hidden layer.
    pub hidden: Vec<usize>,
}

/// The parameters of the algorithm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Learning {
    /// Decisions of the run, all lanes together.
    pub decisions: u64,
    /// Episodes side by side.
    pub lanes: usize,
    /// Steps of the environment that a decision lasts in training; otherwise one. Longer decisions explore farther.
    #[serde(default = "one", skip_serializing_if = "is_one")]
    pub decision_lasts: u32,
    /// Decisions between two updates.
    pub decisions_per_update: u64,
    /// Random decisions before the first update.
    pub random_decisions: u64,
    /// Scales inputs again after the random decisions, by mean and standard deviation of what was seen.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub measured_inputs: bool,
    /// Transitions in an update.
    pub batch: usize,
    /// Transitions remembered.
    pub replay: usize,
    /// Adam's initial step.
    pub rate: f64,
    /// Fraction of `rate` that is left at the end; it falls linearly.
    pub final_rate: f64,
    /// Discount per step, γ.
    pub discount: f64,
    /// Fraction by which slow copies follow after each update, τ.
    pub follow: f64,
    /// Target entropy, nats; by default minus the number of outputs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub target_entropy: Option<f64>,
    /// Initial target entropy of each output, nats; it falls linearly to the final one. By default constant.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub exploring_entropy: Option<f64>,
    /// Initial logarithm of the temperature, ln α.
    pub log_temperature: f64,
    /// Adam's step for ln α.
    pub temperature_rate: f64,
    /// Fraction by which the kept actor follows the learning one after each update; by default they are one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub average: Option<f64>,
}

fn one() -> u32 {
    1
}

fn is_one(&value: &u32) -> bool {
    value == 1
}

/// Episodes that begin where the actor failed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Retry {
    /// Fraction of training episodes that begin there, once a failure is known.
    pub share: f64,
    /// Decisions between two looks for failures.
    pub every: u64,
    /// Fresh tasks in each look.
    pub episodes: usize,
    /// Number of latest failures that are remembered.
    pub remembered: usize,
}

/// The choice among candidates: on validation tasks, never on test tasks.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Validation {
    /// Decisions between two validations.
    pub every: u64,
    /// Episodes of a validation.
    pub episodes: usize,
}

impl Configuration for SacConfig {
    const PRESETS: &'static [Preset] = &presets::PRESETS;
    const KIND: PolicyKind = PolicyKind::Network;
    const PRINTED_BY: &'static str = "tpg-train config --sac";

    fn default_preset(problem: ProblemName) -> &'static str {
        match problem {
            ProblemName::Fs => "best-fs",
            ProblemName::Rs => "best-rs",
            _ => "general",
        }
    }

    fn problem(&mut self) -> &mut toml::Table {
        &mut self.problem
    }

    fn check(&self) -> Result<(), Finding> {
        let Self { actor, critic, learning, retry, validation, .. } = self;
        check_widths("actor.hidden", &actor.hidden)?;
        check_widths("critic.hidden", &critic.hidden)?;
        for (key, value) in [
            ("learning.lanes", learning.lanes as u64),
            ("learning.batch", learning.batch as u64),
            ("learning.replay", learning.replay as u64),
            ("learning.decisions_per_update", learning.decisions_per_update),
            ("learning.random_decisions", learning.random_decisions),
            ("learning.decision_lasts", u64::from(learning.decision_lasts)),
            ("validation.every", validation.every),
            ("validation.episodes", validation.episodes as u64),
        ] {
            Finding::range(key, value, 1, 1 << 40)?;
        }
        for (key, value) in [
            ("learning.rate", learning.rate),
            ("learning.final_rate", learning.final_rate),
            ("learning.temperature_rate", learning.temperature_rate),
            ("learning.discount", learning.discount),
            ("learning.follow", learning.follow),
        ] {
            Finding::range(key, value, 0.0, 1.0)?;
        }
        let average = learning.average.unwrap_or(1.0);
        if !(average > 0.0 && average <= 1.0) {
            return Err(Finding::new("learning.average", average, "more than 0, up to 1"));
        }
        let Some(retry) = retry else { return Ok(()) };
        Finding::range("retry.share", retry.share, 0.0, 1.0)?;
        Finding::range("retry.every", retry.every, 1, u64::MAX)
    }
}

/// Checks the sizes of a network's hidden layers.
///
/// # Errors
/// If there are more than 8, or one has no units or more than 4096.
pub(crate) fn check_widths(key: &str, hidden: &[usize]) -> Result<(), Finding> {
    if hidden.len() <= 8 && hidden.iter().all(|width| (1..=4096).contains(width)) {
        return Ok(());
    }
    Err(Finding::new(key, format!("{hidden:?}"), "up to 8 layers of 1 to 4096 units"))
}

#[cfg(test)]
mod tests {
    use super::SacConfig;
    use crate::configuration::Configuration as _;
    use tpg_graph::error::Place;

    #[test]
    fn a_wrong_value_is_refused_with_its_line() {
        let text = SacConfig::table("best-fs").expect("a preset").to_string();
        for (from, to, found) in [
            ("average = 0.001", "average = 0.0", "learning.average = 0"),
            ("lanes = 64", "lanes = 0", "learning.lanes = 0"),
            ("share = 0.5", "share = 1.5", "retry.share = 1.5"),
            ("scaled_inputs", "fun = 1\nscaled_inputs", "unknown field `fun`"),
        ] {
            let at = text.find(from).expect("a preset has it");
            let line = 1 + text[..at].lines().count() - usize::from(!text[..at].ends_with('\n'));
            let error = SacConfig::from_toml("x.toml", &text.replacen(from, to, 1)).expect_err(to);
            assert!(error.found.starts_with(found), "{error}");
            assert_eq!(error.place, Place::Line(line), "{error}");
        }
    }
}
