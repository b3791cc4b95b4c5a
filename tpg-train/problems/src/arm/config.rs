//! The section `[problem]` of a configuration, for the arm.

use super::arms;
use super::description::ArmDescription;
use super::environment::ArmEnvironment;
use super::motors::MotorsConfig;
use super::problem::ArmProblem;
use super::targets::{Start, TOLERANCE};
use crate::registry::Number;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tpg_arm::observation::{STEP, Source};
use tpg_arm::{Arm, WIDOWX};
use tpg_graph::error::Finding;

/// The section `[problem]` for the arm: the task, the sources that programs read, and the scoring.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct ArmConfig {
    /// Sources that programs read, in order.
    pub sources: Vec<String>,
    /// Distance below which the hand has reached its target, mm.
    pub tolerance: f64,
    /// Backlash: maximum ticks between a joint and its motor, drawn for each episode. It affects only the hand.
    #[serde(skip_serializing_if = "is_none")]
    pub backlash: i16,
    /// Ticks moved by one action.
    pub step: i8,
    /// Adds an action that ends the episode.
    pub may_stop: bool,
    /// Maximum actions of an episode; by default the problem's.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max_actions: Option<u32>,
    /// Score of a success; a failure scores minus the distance in mm.
    pub bonus_success: f64,
    /// Bonus of a success for each unused action.
    pub coef_reward_multiplication: f64,
    /// The arm: a section, or the name of an arm that `tpg-train config --list` shows; the WidowX if omitted.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "arms::named_or_own")]
    #[schemars(with = "Option<ArmDescription>")]
    pub arm: Option<ArmDescription>,
    /// True for tests: policies read and do whatever the arm knows.
    #[serde(skip)]
    pub tests: bool,
    /// How the network drives that shares or has the arm.
    #[serde(skip)]
    pub network: Option<Box<MotorsConfig>>,
}

/// Returns true for joints without play, which need not be written.
pub(super) fn is_none(backlash: &i16) -> bool {
    *backlash == 0
}

/// Checks the setting `problem.backlash`.
pub(super) fn check_backlash(ticks: i16) -> Result<(), Finding> {
    Finding::range("problem.backlash", ticks, 0, MOST_BACKLASH)
}

/// Most ticks of play: 18 degrees.
const MOST_BACKLASH: i16 = 200;

impl Default for ArmConfig {
    /// Returns the paper's problem, with the pose that solves the task and the height above the table as sources.
    fn default() -> Self {
        Self {
            sources: [Source::Stance, Source::Floor].map(|source| source.name().to_owned()).to_vec(),
            tolerance: TOLERANCE,
            backlash: 0,
            step: STEP,
            may_stop: false,
            max_actions: None,
            bonus_success: 10.0,
            coef_reward_multiplication: 0.001,
            arm: None,
            tests: false,
            network: None,
        }
    }
}

impl ArmConfig {
    /// Checks ranges, names and consistency.
    ///
    /// # Errors
    /// The first invalid setting.
    pub fn check(&self) -> Result<(), Finding> {
        self.check_sources()?;
        if let Some(arm) = &self.arm {
            arm.check()?;
        }
        Finding::range("problem.tolerance", self.tolerance, 1e-3, 1e3)?;
        check_backlash(self.backlash)?;
        Finding::range("problem.step", self.step, 1, 127)?;
        Finding::range("problem.max_actions", self.max_actions.unwrap_or(1), 1, 1_000_000)?;
        Finding::range("problem.bonus_success", self.bonus_success, 0.0, 1e9)?;
        Finding::range("problem.coef_reward_multiplication", self.coef_reward_multiplication, 0.0, 1e3)
    }

    /// Checks that each source exists and occurs once.
    fn check_sources(&self) -> Result<(), Finding> {
        let known: Vec<&str> = Source::ALL.iter().map(|source| source.name()).collect();
        let accepted = || format!("one or more of {}, each once", known.join(", "));
        if self.sources.is_empty() {
            return Err(Finding::new("problem.sources", "an empty list", accepted()));
        }
        let wrong =
            |(place, name): &(usize, &String)| !known.contains(&name.as_str()) || self.sources[..*place].contains(name);
        match self.sources.iter().enumerate().find(wrong) {
            Some((_, name)) => Err(Finding::new("problem.sources", format!("{name:?}"), accepted())),
            None => Ok(()),
        }
    }

    /// Returns the arm.
    pub fn arm(&self) -> Arm<f64> {
        self.arm.as_ref().map_or(WIDOWX, Arm::from)
    }

    /// Returns the problem with the given start.
    pub fn problem(&self, start: Start) -> ArmProblem {
        let sources = self.sources.iter().filter_map(|name| Source::from_name(name));
        ArmProblem {
            start,
            tolerance: self.tolerance,
            max_actions: self.max_actions.unwrap_or(start.max_actions()),
            backlash: self.backlash,
            step: self.step,
            may_stop: self.may_stop || self.tests,
            sources: if self.tests { Source::ALL.to_vec() } else { sources.collect() },
            bonus: self.bonus_success,
            per_unused_action: self.coef_reward_multiplication,
        }
    }

    /// Returns the environment with the given start.
    pub fn environment<S: Number>(&self, start: Start) -> ArmEnvironment<S> {
        let environment = ArmEnvironment::new(&self.arm(), self.problem(start));
        match &self.network {
            Some(network) => environment.with_network(network),
            None => environment,
        }
    }
}
