//! The arm's network as one array of words: a [`tpg_runtime::net::Model`] of the arm's features, and its decision.
//!
//! [`Network::pack`] makes the words, at compile time in generated Rust and on the host for C. A packed network answers bit
//! for bit what [`Network::preferences`] does.

use super::fixed::{FixedDecision, Network, quantise_into};
use super::{FEATURE_CONTRACT, FEATURES, features};
use crate::arm::{Arm, JOINTS, Move};
use crate::frame::Frame;
use crate::observation::Observation;
use tpg_kernels::{COLUMNS, Kind, ROWS};
use tpg_runtime::net::{self, Layer, LayerRows, ModelError, OutputKind, Weights};
use tpg_runtime::policy::Policy;

const _: () = assert!(JOINTS == ROWS, "a preference for each joint in one block");

/// A checked model, borrowed from where it lies.
#[derive(Clone, Copy, Debug)]
pub struct Model<'a> {
    network: net::Model<'a>,
    decision: FixedDecision,
}

impl<'a> Model<'a> {
    /// Checks a model; words behind its end do not matter.
    ///
    /// # Errors
    /// See [`ModelError`]; [`ModelError::Meaning`] for a network that has not a preference for each joint, or was made for
    /// other features.
    pub fn parse(words: &'a [u32]) -> Result<Self, ModelError> {
        let network = net::Model::parse(words)?;
        match network.answer() {
            OutputKind::Preferences { flags }
                if network.outputs() == JOINTS && network.contract() == FEATURE_CONTRACT =>
            {
                Ok(Self { network, decision: FixedDecision::from_flags(flags) })
            }
            _ => Err(ModelError::Meaning),
        }
    }

    /// Values that the first layer reads.
    pub fn inputs(&self) -> usize {
        self.network.inputs()
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
    pub fn decision(&self) -> &FixedDecision {
        &self.decision
    }

    /// The move for what is seen; [`Move::STOP`] where `scratch` is too short.
    pub fn decide(&self, arm: &Arm<f32>, seen: &Observation<f32>, scratch: &mut [u32]) -> Move {
        if scratch.len() < self.scratch() {
            return Move::STOP;
        }
        let mut inputs = [0; FEATURES];
        quantise_into(&features(&Frame::new(arm, seen)), &mut inputs);
        self.decision.decide(self.preferences(&inputs, scratch), seen.pose, &arm.ranges)
    }
}

/// A packed network as a policy of an arm; `SCRATCH` words on the stack, [`Network::SCRATCH`] for one that was packed.
#[derive(Clone, Copy, Debug)]
pub struct PackedPolicy<'a, const SCRATCH: usize> {
    /// The arm whose geometry the features know.
    pub arm: &'a Arm<f32>,
    /// The model.
    pub model: Model<'a>,
}

impl<'a, const SCRATCH: usize> PackedPolicy<'a, SCRATCH> {
    /// A policy, if the model reads the runtime's features and `SCRATCH` is enough for it.
    pub fn new(arm: &'a Arm<f32>, model: Model<'a>) -> Option<Self> {
        (model.inputs() == FEATURES && model.scratch() <= SCRATCH).then_some(Self { arm, model })
    }
}

impl<const SCRATCH: usize> Policy for PackedPolicy<'_, SCRATCH> {
    type State = Observation<f32>;
    type Action = Move;

    fn decide(&self, seen: &Observation<f32>) -> Move {
        self.model.decide(self.arm, seen, &mut [0; SCRATCH])
    }
}

impl<const A: usize, const B: usize> Network<A, B> {
    /// Words of scratch memory that a packed form of it needs.
    pub const SCRATCH: usize = {
        let widest = if A > B { A } else { B };
        (if widest > FEATURES { widest } else { FEATURES }).next_multiple_of(COLUMNS)
    };

    /// Words of its packed form.
    pub const WORDS: usize = Self::words(Kind::W8A16);

    /// Words of its wide packed form.
    pub const WIDE_WORDS: usize = Self::words(Kind::W16A16);

    const fn words(kind: Kind) -> usize {
        let meaning = FixedDecision::from_flags(0).meaning();
        net::words(&[(FEATURES, A, kind), (A, B, kind), (B, JOINTS, kind)], &meaning)
    }

    /// The packed form. `WORDS` must be [`Self::WORDS`].
    ///
    /// # Panics
    /// At compile time, where generated code calls it: if `WORDS` is another number or a rescale has no multiplier.
    pub const fn pack<const WORDS: usize>(&self, decision: &FixedDecision) -> [u32; WORDS] {
        self.pack_as(decision, Kind::W8A16)
    }

    /// The packed form with 16 bits a weight: nearly twice the flash, a third fewer instructions on a core with DSP, the
    /// same answers. `WORDS` must be [`Self::WIDE_WORDS`].
    ///
    /// # Panics
    /// As [`pack`](Self::pack).
    pub const fn pack_wide<const WORDS: usize>(&self, decision: &FixedDecision) -> [u32; WORDS] {
        self.pack_as(decision, Kind::W16A16)
    }

    const fn pack_as<const WORDS: usize>(&self, decision: &FixedDecision, kind: Kind) -> [u32; WORDS] {
        const fn rows<const I: usize, const O: usize>(layer: &Layer<I, O>, kind: Kind) -> LayerRows<'_> {
            let weights = Weights::I8(layer.weights.as_flattened());
            LayerRows { inputs: I, kind, weights, bias: &layer.bias, rescale: &layer.rescale }
        }
        let mut words = [0; WORDS];
        let layers = [rows(&self.first, kind), rows(&self.second, kind), rows(&self.last, kind)];
        assert!(
            net::pack(&layers, &decision.meaning(), &mut words),
            "a rescale without a multiplier, or another number of words"
        );
        words
    }
}
