//! From an actor's preferences to a move of the arm.

use super::Config;
use tpg_arm::sac::{Actions, Decision, TRAINED_COARSE, TRAINED_FINE};
use tpg_arm::{JOINTS, JointRange, Move, Pose};

/// The decision behind an actor, for either set of actions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Discretiser {
    /// −3 to 3 ticks.
    Fine(Decision<f32, 3>),
    /// −3, 0 or 3 ticks.
    Coarse(Decision<f32, 1>),
}

impl Discretiser {
    /// The decision that a configuration asks for.
    pub fn new(config: &Config) -> Self {
        let (mask, may_rest) = (config.mask, config.may_rest);
        match config.actions {
            Actions::Fine => Self::Fine(Decision { steps: TRAINED_FINE, mask, may_rest }),
            Actions::Coarse => Self::Coarse(Decision { steps: TRAINED_COARSE, mask, may_rest }),
        }
    }

    /// The move for preferences before the tanh, of an arm of those ranges.
    pub fn decide(&self, preferences: [f32; JOINTS], pose: Pose, ranges: &[JointRange; JOINTS]) -> Move {
        match self {
            Self::Fine(decision) => decision.decide(preferences, pose, ranges),
            Self::Coarse(decision) => decision.decide(preferences, pose, ranges),
        }
    }
}
