//! The section `[problem]` of a configuration, for the arm among balls.

use crate::amount::Amount;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tpg_arm::dodge::DodgerSettings;
use tpg_graph::error::Finding;

/// The section `[problem]` for the arm among balls. Lengths in mm, times in steps.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct DodgeConfig {
    /// Minimum and maximum number of balls, 1 to 3; uniformly drawn.
    pub balls: [u8; 2],
    /// Minimum and maximum radius.
    pub radius: [f64; 2],
    /// Minimum and maximum peak speed of a moving ball, mm per step.
    pub speed: [f64; 2],
    /// Distance below which the hand has reached its target.
    pub tolerance: f32,
    /// Budget of a control step, in Cortex-M4 instructions; the search takes what the rest leaves.
    pub effort: u16,
}

impl Default for DodgeConfig {
    fn default() -> Self {
        let DodgerSettings { effort, .. } = DodgerSettings::DEFAULT;
        Self { balls: [1, 3], radius: [30.0, 60.0], speed: [0.3, 2.0], tolerance: 3.0, effort }
    }
}

impl DodgeConfig {
    /// Checks every value.
    ///
    /// # Errors
    /// The first value that is not accepted.
    pub fn check(&self) -> Result<(), Finding> {
        let [fewest, most] = self.balls;
        if !(1..=3).contains(&fewest) || !(fewest..=3).contains(&most) {
            let found = format!("{:?}", self.balls);
            return Err(Finding::new(
                "problem.balls",
                found,
                "two whole numbers from 1 to 3, the first not above the second",
            ));
        }
        Amount::Between(self.radius).check("problem.radius", 1.0, 200.0)?;
        Amount::Between(self.speed).check("problem.speed", 0.01, 20.0)?;
        Finding::range("problem.tolerance", self.tolerance, 2.7, 1000.0)?;
        Finding::range("problem.effort", self.effort, 4000, 60_000)
    }

    /// Returns the settings of the control step.
    pub fn settings(&self) -> DodgerSettings {
        DodgerSettings { effort: self.effort, ..DodgerSettings::DEFAULT }
    }
}
