//! The section `[problem]` of a configuration for the arm by its motors.

use crate::arm::config::{check_backlash, is_none};
use crate::arm::targets::{Start, TOLERANCE};
use crate::arm::{ArmDescription, ArmProblem, arms};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tpg_arm::sac::{Actions, Decision, Mask};
use tpg_arm::{Arm, WIDOWX};
use tpg_graph::error::Finding;

/// The section `[problem]` for the arm by its motors: inputs, decision, rules and reward of training.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct MotorsConfig {
    /// Moves of a motor: "fine" or "coarse".
    #[serde(with = "actions_name")]
    #[schemars(with = "String")]
    pub actions: Actions,
    /// Moves that the policy refuses: "none" or "joint-limits".
    #[serde(with = "mask_name")]
    #[schemars(with = "String")]
    pub mask: Mask,
    /// Lets the arm rest; otherwise the strongest preference moves.
    pub may_rest: bool,
    /// Fraction of training episodes that start at home.
    pub fixed_start_share: f64,
    /// The same fraction of episodes that look for failures.
    pub trial_fixed_share: f64,
    /// Steps after which a training episode is cut off, without failure.
    pub max_steps: u32,
    /// Millimetres of distance for each repetition of an action in training.
    pub repeat_per_mm: f32,
    /// Maximum steps of a repeated action; 1: no repeats.
    pub repeat_most: u32,
    /// Distance below which a training episode succeeds, mm.
    pub tolerance: f64,
    /// `tolerance` of tests; 3 mm by default.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub test_tolerance: Option<f64>,
    /// Backlash: maximum ticks between a joint and its motor, drawn for each episode. It affects only the hand.
    #[serde(skip_serializing_if = "is_none")]
    pub backlash: i16,
    /// The reward of training.
    pub reward: Reward,
    /// The arm: a section, or the name of an arm that `tpg-train config --list` shows; the WidowX if omitted.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "arms::named_or_own")]
    #[schemars(with = "Option<ArmDescription>")]
    pub arm: Option<ArmDescription>,
}

/// The reward of one action in training; d is the distance in mm, 0 before and 1 after it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Reward {
    /// For each step.
    pub step: f32,
    /// Times ln((d0 + 3)/(d1 + 3)).
    pub log_distance: f32,
    /// Times (d0 − d1).
    pub distance: f32,
    /// Times (D0 − D1), D being the steps to the nearest solving pose.
    pub steps_to_goal: f32,
    /// Times (A0 − A1), A being the steps until the base faces the target.
    #[serde(default)]
    pub azimuth: f32,
    /// On success.
    pub success: f32,
    /// On an invalid step.
    pub invalid: f32,
}

impl Reward {
    /// True if the reward knows poses that solve the task.
    pub(crate) fn knows_goals(&self) -> bool {
        self.steps_to_goal != 0.0
    }
}

impl Default for MotorsConfig {
    /// The project's own: features, fine actions, a reward that knows solving poses.
    fn default() -> Self {
        Self {
            actions: Actions::Fine,
            mask: Mask::JointLimits,
            may_rest: false,
            fixed_start_share: 0.3,
            trial_fixed_share: 0.25,
            max_steps: 1000,
            repeat_per_mm: 12.0,
            repeat_most: 8,
            tolerance: TOLERANCE,
            test_tolerance: None,
            backlash: 0,
            reward: Reward {
                step: -0.05,
                log_distance: 2.0,
                distance: 0.0,
                steps_to_goal: 0.1,
                azimuth: 0.0,
                success: 5.0,
                invalid: -5.0,
            },
            arm: None,
        }
    }
}

impl MotorsConfig {
    /// Checks ranges and contradictions.
    ///
    /// # Errors
    /// The first setting that is wrong.
    pub fn check(&self) -> Result<(), Finding> {
        Finding::range("problem.fixed_start_share", self.fixed_start_share, 0.0, 1.0)?;
        Finding::range("problem.trial_fixed_share", self.trial_fixed_share, 0.0, 1.0)?;
        Finding::range("problem.max_steps", self.max_steps, 1, 1_000_000)?;
        Finding::range("problem.repeat_per_mm", self.repeat_per_mm, 1e-3, 1e6)?;
        Finding::range("problem.repeat_most", self.repeat_most, 1, 1_000_000)?;
        Finding::range("problem.tolerance", self.tolerance, 1e-3, 1e3)?;
        Finding::range("problem.test_tolerance", self.test_tolerance.unwrap_or(TOLERANCE), 1e-3, 1e3)?;
        check_backlash(self.backlash)?;
        if let Some(arm) = &self.arm {
            arm.check()?;
        }
        Ok(())
    }

    /// Returns the arm.
    pub fn arm(&self) -> Arm<f64> {
        self.arm.as_ref().map_or(WIDOWX, Arm::from)
    }

    /// Returns the decision behind a network.
    pub(in crate::arm) fn decision(&self) -> Decision<f32> {
        Decision::<f32>::new(self.actions, self.mask, self.may_rest)
    }

    /// Returns the rules of tests that begin at that start.
    pub fn tests(&self, start: Start) -> ArmProblem {
        let problem = ArmProblem::from(start);
        let tolerance = self.test_tolerance.unwrap_or(problem.tolerance);
        ArmProblem { tolerance, backlash: self.backlash, ..problem }
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
