//! The section `[problem]` of a configuration, for the arm among balls.

use super::sensing::Sensing;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tpg_arm::WIDOWX;
use tpg_arm::dodge::{Body, DodgerSettings, SCOUT, ScoutSettings, WIDOWX_RADII};
use tpg_graph::error::Finding;

/// The section `[problem]` for the arm among balls. Lengths in mm, times in steps.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Config {
    /// Minimum and maximum number of balls, 1 to 3; uniformly drawn.
    pub balls: [u8; 2],
    /// Minimum and maximum radius.
    pub radius: [f64; 2],
    /// Minimum and maximum peak speed of a moving ball, mm per step.
    pub speed: [f64; 2],
    /// Share of balls that do not move.
    pub share_static: f64,
    /// Share of balls that cross the arm's straight walk: the first ball, and the others.
    pub aimed: [f64; 2],
    /// Maximum distance of an aimed ball's path from a point of the arm.
    pub pass_by: f64,
    /// Minimum and maximum way of a ball to either side of a point that it passes.
    pub path: [f64; 2],
    /// Minimum clearance from the arm at step 0.
    pub clear_at_start: f32,
    /// Steps for which an arm at its start is not hit.
    pub rest_free: u16,
    /// Maximum number of plans that are tried to solve a scene; one without a solution is drawn anew.
    pub tries: u32,
    /// Clearance that a solving plan keeps.
    pub margin: f32,
    /// Distance below which the hand has reached its target.
    pub tolerance: f32,
    /// Radii of the arm's capsules: shoulder to bracket, bracket to elbow, forearm, hand.
    pub capsules: [f32; 4],
    /// Standard deviation of each seen coordinate of a ball.
    pub noise: f32,
    /// Steps until a ball's place is seen, at most 20.
    pub delay: u8,
    /// A ball's displacement is seen; otherwise it is estimated from places.
    pub velocities: bool,
    /// Clearance that the search keeps from a moving ball, and from a resting one.
    pub keep: [f64; 2],
    /// A guard replaces steps that would be hit.
    pub guard: bool,
    /// Budget of a control step, in Cortex-M4 instructions; the search takes what the rest leaves.
    pub effort: u16,
}

impl Default for Config {
    fn default() -> Self {
        Self {
            balls: [1, 3],
            radius: [30.0, 60.0],
            speed: [0.3, 2.0],
            share_static: 0.15,
            aimed: [0.85, 0.6],
            pass_by: 90.0,
            path: [120.0, 350.0],
            clear_at_start: 40.0,
            rest_free: 40,
            tries: 1500,
            margin: 1.0,
            tolerance: 3.0,
            capsules: WIDOWX_RADII,
            noise: 0.0,
            delay: 0,
            velocities: true,
            keep: [4.0, 0.6],
            guard: true,
            effort: SCOUT.effort,
        }
    }
}

impl Config {
    /// Checks ranges.
    ///
    /// # Errors
    /// The first invalid setting.
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
        ordered("problem.radius", self.radius, [1.0, 200.0])?;
        ordered("problem.speed", self.speed, [0.01, 20.0])?;
        ordered("problem.path", self.path, [1.0, 2000.0])?;
        Finding::range("problem.share_static", self.share_static, 0.0, 1.0)?;
        for share in self.aimed {
            Finding::range("problem.aimed", share, 0.0, 1.0)?;
        }
        Finding::range("problem.pass_by", self.pass_by, 0.0, 1000.0)?;
        Finding::range("problem.clear_at_start", self.clear_at_start, 0.0, 200.0)?;
        Finding::range("problem.rest_free", self.rest_free, 0, 1000)?;
        Finding::range("problem.tries", self.tries, 1, 1_000_000)?;
        Finding::range("problem.margin", self.margin, 0.0, 100.0)?;
        Finding::range("problem.tolerance", self.tolerance, 2.7, 1000.0)?;
        for radius in self.capsules {
            Finding::range("problem.capsules", radius, 1.0, 100.0)?;
        }
        Finding::range("problem.noise", self.noise, 0.0, 100.0)?;
        Finding::range("problem.delay", self.delay, 0, 20)?;
        for clearance in self.keep {
            Finding::range("problem.keep", clearance, 0.0, 100.0)?;
        }
        Finding::range("problem.effort", self.effort, 4000, 60_000)
    }

    /// Returns the settings of what stands around a policy.
    pub fn settings(&self) -> DodgerSettings {
        let [margin, still] = self.keep.map(|mm| mm as f32);
        DodgerSettings { scout: ScoutSettings { effort: self.effort, margin, still, ..SCOUT }, guard: self.guard }
    }

    /// Returns how balls are seen.
    pub fn sensing(&self) -> Sensing {
        Sensing { noise: self.noise, delay: self.delay, velocities: self.velocities }
    }

    /// Returns the arm with its capsules.
    pub fn body(&self) -> Body {
        Body::new(WIDOWX.to_f32(), self.capsules)
    }
}

/// Checks that two numbers are ordered and within limits.
fn ordered(key: &str, [low, high]: [f64; 2], [least, most]: [f64; 2]) -> Result<(), Finding> {
    if least <= low && low <= high && high <= most {
        return Ok(());
    }
    let accepted = format!("two numbers from {least} to {most}, the first not above the second");
    Err(Finding::new(key, format!("{:?}", [low, high]), accepted))
}
