//! A network in integers as one array of words: what lies in a target's flash and what the kernels read.
//!
//! [`Network::pack`] makes it, at compile time in generated Rust and on the host for C; [`Model::parse`] checks one and
//! borrows it. The same array serves C and Rust, and its weights lie as [`tpg_kernels`] wants them.
//!
//! | word | what |
//! | --- | --- |
//! | 0 | [`MAGIC`] |
//! | 1 | version 1; layers << 8; actions << 16 (0 coarse, 1 fine); 1 << 24 if joints stop at their limits; 1 << 25 if the arm may rest |
//! | 2 | number of words |
//! | 3 | CRC-32 (IEEE 802.3) of all words behind this one, low byte first |
//! | 4 | [`FEATURE_CONTRACT`] |
//! | 5, 6 | of the first layer: inputs + (outputs << 16), code of its [`Kind`]; two words for each further layer |
//! | then | the layers' blocks, one after another, rows padded to the next layer's columns |
//!
//! A packed network answers bit for bit what [`Network::preferences`] does: multipliers are the factors shifted so that
//! every shift is 32 ([`Rescale::multiplier`]).

use super::fixed::{FixedDecision, LAST, Layer, Network, Rescale};
use super::{Actions, FEATURE_NAMES, FEATURES, Mask, features};
use crate::arm::{Arm, JOINTS, Move};
use crate::frame::Frame;
use crate::observation::Observation;
use tpg_kernels::{COLUMNS, Form, ROWS};
use tpg_runtime::policy::Policy;

mod crc;
mod pack;

pub use pack::{LayerRows, Weights, pack, words};
pub use tpg_kernels::Kind;

/// "TPGS" in memory.
pub const MAGIC: u32 = u32::from_le_bytes(*b"TPGS");
/// Changes with every change of the layout.
pub const VERSION: u32 = 1;
/// The most layers a model may have.
pub const LAYERS: usize = 4;
/// The most inputs or outputs a layer may have.
pub const WIDTH: usize = 512;
/// CRC-32 of the features' names, each with a line feed behind it: a model of other features is refused.
pub const FEATURE_CONTRACT: u32 = crc::of_names(&FEATURE_NAMES);

const HEADER: usize = 5;

/// Why words are not a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ModelError {
    /// They do not begin with [`MAGIC`] and [`VERSION`].
    NotAModel,
    /// There are fewer words than the model says it has.
    Short,
    /// A damaged word.
    Checksum,
    /// Made for other features.
    Features,
    /// Layers that do not fit each other or exceed [`LAYERS`] or [`WIDTH`], or an unknown kind.
    Layers,
}

#[derive(Clone, Copy, Debug)]
struct View<'a> {
    blocks: &'a [u32],
    kind: Kind,
    /// Padded inputs, in words of two columns.
    inputs: usize,
    /// Padded outputs, in words of two.
    outputs: usize,
}

/// A checked model, borrowed from where it lies.
#[derive(Clone, Copy, Debug)]
pub struct Model<'a> {
    decision: FixedDecision,
    hidden: [View<'a>; LAYERS - 1],
    count: usize,
    last: View<'a>,
    inputs: usize,
    width: usize,
}

impl<'a> Model<'a> {
    /// Checks a model; words behind its end do not matter.
    ///
    /// # Errors
    /// See [`ModelError`].
    pub fn parse(words: &'a [u32]) -> Result<Self, ModelError> {
        let Some(&[magic, kinds, length, checksum, contract]) = words.first_chunk::<HEADER>() else {
            return Err(if words.first() == Some(&MAGIC) { ModelError::Short } else { ModelError::NotAModel });
        };
        if magic != MAGIC || kinds & 0xff != VERSION {
            return Err(ModelError::NotAModel);
        }
        let words = words.get(..length as usize).ok_or(ModelError::Short)?;
        let body = words.get(HEADER - 1..).ok_or(ModelError::Short)?;
        if crc::of_words(body) != checksum {
            return Err(ModelError::Checksum);
        }
        if contract != FEATURE_CONTRACT {
            return Err(ModelError::Features);
        }
        let [_, layers, actions, flags] = kinds.to_le_bytes();
        let layers = usize::from(layers);
        let heads = words.get(HEADER..HEADER + 2 * layers).ok_or(ModelError::Layers)?;
        let mut blocks = words.get(HEADER + 2 * layers..).ok_or(ModelError::Layers)?;
        let empty = View { blocks: &[], kind: Kind::W8A16, inputs: 0, outputs: 0 };
        let mask = if flags & 1 == 0 { Mask::None } else { Mask::JointLimits };
        let actions = if actions == 0 { Actions::Coarse } else { Actions::Fine };
        let decision = FixedDecision::new(actions, mask, flags & 2 != 0);
        let mut model = Self { decision, hidden: [empty; LAYERS - 1], count: 0, last: empty, inputs: 0, width: 0 };
        let mut before = None;
        for (index, &[sizes, kind]) in heads.as_chunks::<2>().0.iter().enumerate() {
            let (inputs, outputs) = ((sizes & 0xffff) as usize, (sizes >> 16) as usize);
            let kind = Kind::from_code(kind).ok_or(ModelError::Layers)?;
            let fits = (1..=WIDTH).contains(&inputs) && (1..=WIDTH).contains(&outputs);
            if !fits || before.is_some_and(|outputs| outputs != inputs) {
                return Err(ModelError::Layers);
            }
            before = Some(outputs);
            let is_last = index + 1 == layers;
            let (columns, rows) = (columns(inputs), if is_last { ROWS } else { columns(outputs) });
            let (these, rest) =
                blocks.split_at_checked(rows / ROWS * kind.block(columns / 2)).ok_or(ModelError::Layers)?;
            blocks = rest;
            let view = View { blocks: these, kind, inputs: columns / 2, outputs: rows / 2 };
            model.width = model.width.max(view.inputs);
            if index == 0 {
                model.inputs = inputs;
            }
            if is_last {
                if outputs != JOINTS {
                    return Err(ModelError::Layers);
                }
                model.last = view;
            } else {
                *model.hidden.get_mut(index).ok_or(ModelError::Layers)? = view;
                model.count = index + 1;
            }
        }
        if before.is_none() || !blocks.is_empty() { Err(ModelError::Layers) } else { Ok(model) }
    }

    /// Values that the first layer reads.
    pub fn inputs(&self) -> usize {
        self.inputs
    }

    /// Words of scratch memory that a decision needs.
    pub fn scratch(&self) -> usize {
        2 * self.width
    }

    /// The preferences, in multiples of 1/2048; zeros where `scratch` has fewer words than [`scratch`](Self::scratch).
    ///
    /// Inputs are multiples of 1/4096; missing ones count as 0, surplus ones are not read.
    #[inline(never)] // its loop is not its caller's: a static bound multiplies nested ones
    pub fn preferences(&self, inputs: &[i16], scratch: &mut [u32]) -> [i32; JOINTS] {
        let Some((mut from, rest)) = scratch.split_at_mut_checked(self.width) else { return [0; JOINTS] };
        let Some(mut to) = rest.get_mut(..self.width) else { return [0; JOINTS] };
        let inputs = inputs.get(..self.inputs).unwrap_or(inputs);
        let hidden = self.hidden.get(..self.count).unwrap_or(&[]);
        let first = hidden.first().unwrap_or(&self.last);
        if let Some(words) = from.get_mut(..first.inputs) {
            match first.kind.form() {
                Form::Pairs => tpg_kernels::pair_inputs(inputs, words),
                Form::Split => tpg_kernels::split_inputs(inputs, words),
            }
        }
        for (index, layer) in hidden.iter().enumerate() {
            let form = hidden.get(index + 1).unwrap_or(&self.last).kind.form();
            if let (Some(inputs), Some(outputs)) = (from.get(..layer.inputs), to.get_mut(..layer.outputs)) {
                tpg_kernels::hidden(layer.kind, form, layer.blocks, inputs, outputs);
            }
            (from, to) = (to, from);
        }
        let Some(inputs) = from.get(..self.last.inputs) else { return [0; JOINTS] };
        tpg_kernels::last(self.last.kind, self.last.blocks, inputs)
            .map(|preference| preference.clamp(i32::from(LAST), i32::from(i16::MAX)))
    }

    /// What stands behind the network.
    pub fn decision(&self) -> &FixedDecision {
        &self.decision
    }

    /// The move for what is seen; [`Move::STOP`] where `scratch` is too short.
    pub fn decide(&self, arm: &Arm<f32>, seen: &Observation<f32>, scratch: &mut [u32]) -> Move {
        if scratch.len() < self.scratch() {
            return Move::STOP;
        }
        let features = super::fixed::quantise(&features(&Frame::of(arm, seen)));
        self.decision.decide(self.preferences(&features, scratch), seen.pose, &arm.ranges)
    }
}

/// Columns with their padding.
const fn columns(values: usize) -> usize {
    values.next_multiple_of(COLUMNS)
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
        columns(if widest > FEATURES { widest } else { FEATURES })
    };

    /// Words of its packed form.
    pub const WORDS: usize = Self::words(Kind::W8A16);

    /// Words of its wide packed form.
    pub const WIDE_WORDS: usize = Self::words(Kind::W16A16);

    const fn words(kind: Kind) -> usize {
        words(&[(FEATURES, A, kind), (A, B, kind), (B, JOINTS, kind)])
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
        assert!(pack(&layers, decision, &mut words), "a rescale without a multiplier, or another number of words");
        words
    }
}

impl Rescale {
    /// The number m for which [`apply`](Self::apply) is (accumulator · m + 2³¹) >> 32, clipped; `None` where 32 bits do not
    /// hold one: for a factor that is not a multiple of 2^(shift − 32), or a ratio of ½ or more.
    pub const fn multiplier(self) -> Option<i32> {
        let Self { factor, shift } = self;
        if factor < 0 || shift < 1 || shift > 47 {
            return None;
        }
        let factor = factor as i64;
        let multiplier = if shift <= 32 {
            factor << (32 - shift)
        } else if factor % (1 << (shift - 32)) == 0 {
            factor >> (shift - 32)
        } else {
            return None;
        };
        if multiplier <= i32::MAX as i64 { Some(multiplier as i32) } else { None }
    }
}

#[cfg(test)]
mod tests;
