//! The arm's network as one array of words: a [`tpg_runtime::net::Model`] of the arm's features, and its decision.

use super::fixed::quantise;
use super::{Decision, FEATURE_CONTRACT, FEATURES, features};
use crate::arm::{Arm, JOINTS, Move};
use crate::frame::Frame;
use crate::observation::Observation;
use tpg_runtime::net::{self, ModelError, OutputKind, ROWS};
use tpg_runtime::policy::Policy;

const _: () = assert!(JOINTS == ROWS, "a preference for each joint in one block");

/// A checked model, borrowed from where it lies.
#[derive(Clone, Copy, Debug)]
pub struct Model<'a> {
    network: net::Model<'a>,
    decision: Decision<i32>,
}

impl<'a> Model<'a> {
    /// Checks a model; words behind its end do not matter.
    ///
    /// # Errors
    /// See [`ModelError`]; [`ModelError::Meaning`] for a network that has not a preference for each joint, or does not read the
    /// runtime's features.
    pub fn parse(words: &'a [u32]) -> Result<Self, ModelError> {
        let network = net::Model::parse(words)?;
        match network.answer() {
            OutputKind::Preferences { flags }
                if network.outputs() == JOINTS
                    && network.inputs() == FEATURES
                    && network.contract() == FEATURE_CONTRACT =>
            {
                Ok(Self { network, decision: Decision::from_flags(flags) })
            }
            _ => Err(ModelError::Meaning),
        }
    }

    /// Words of scratch memory that a decision needs.
    pub fn scratch(&self) -> usize {
        self.network.scratch()
    }

    /// The preferences, in multiples of 1/2048; zeros where `scratch` has fewer words than [`scratch`](Self::scratch).
    ///
    /// Inputs are multiples of 1/4096; missing ones count as 0, surplus ones are not read.
    #[inline(always)]
    pub fn preferences(&self, inputs: &[i16], scratch: &mut [u32]) -> [i32; JOINTS] {
        self.network.first(inputs, scratch)
    }

    /// The decision behind the network.
    pub fn decision(&self) -> &Decision<i32> {
        &self.decision
    }

    /// The move for what is seen; [`Move::STOP`] where `scratch` is too short.
    pub fn decide(&self, arm: &Arm<f32>, seen: &Observation<f32>, scratch: &mut [u32]) -> Move {
        if scratch.len() < self.scratch() {
            return Move::STOP;
        }
        let inputs = quantise(&features(&Frame::new(arm, seen)));
        self.decision.decide(self.preferences(&inputs, scratch), seen.pose, &arm.ranges)
    }
}

/// A packed network as a policy of an arm; `SCRATCH` words on the stack, which generated code names.
#[derive(Clone, Copy, Debug)]
pub struct PackedPolicy<'a, const SCRATCH: usize> {
    /// The arm whose geometry the features know.
    pub arm: &'a Arm<f32>,
    /// The model.
    pub model: Model<'a>,
}

impl<'a, const SCRATCH: usize> PackedPolicy<'a, SCRATCH> {
    /// A policy, if `SCRATCH` is enough for the model.
    pub fn new(arm: &'a Arm<f32>, model: Model<'a>) -> Option<Self> {
        (model.scratch() <= SCRATCH).then_some(Self { arm, model })
    }
}

impl<const SCRATCH: usize> Policy for PackedPolicy<'_, SCRATCH> {
    type State = Observation<f32>;
    type Action = Move;

    fn decide(&self, seen: &Observation<f32>) -> Move {
        self.model.decide(self.arm, seen, &mut [0; SCRATCH])
    }
}
