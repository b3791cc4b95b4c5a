//! From rows of weights to words.
//!
//! | word | holds |
//! | --- | --- |
//! | 0 | [`MAGIC`] |
//! | 1 | [`VERSION`]; layers << 8; 1 << 15 if inputs have scales; kind of answer << 16 (0 preferences, 1 values, 2 argmax); the problem's flags << 24 |
//! | 2 | number of words |
//! | 3 | CRC-32 (IEEE 802.3) of words 1 and 2 and all behind this one, low byte first |
//! | 4 | the contract: CRC-32 of the inputs' names, each with a line feed behind it |
//! | 5, 6 | of the first layer: inputs + (outputs << 16), code of its [`Kind`]; two words for each further layer |
//! | then | offset and scale of each input, as `f32`, if inputs have scales |
//! | then | of each output that becomes a value: min and max as `f32`, squash (0 tanh, 1 clamp) + (exponent << 8) |
//! | then | the layers' blocks, one after another, rows padded to the next layer's columns |
//!
//! Multipliers are the factors shifted so that every shift is 32 ([`Rescale::multiplier`]), so that a packed network answers
//! bit for bit as its layers do.

use super::meaning::{Meaning, OutputKind, Squash};
use super::model::columns;
use super::{Rescale, crc};
use tpg_kernels::{Kind, ROWS};

/// "TPGS" in memory.
pub const MAGIC: u32 = u32::from_le_bytes(*b"TPGS");
/// Changes with every change of the layout.
pub const VERSION: u8 = 2;
/// The most layers a model may have: four hidden ones and the last.
pub const LAYERS: usize = 5;
/// The most inputs or outputs a layer may have.
pub const WIDTH: usize = 512;

pub(super) const HEADER: usize = 5;
/// The bit beside the number of layers that says that inputs have scales.
pub(super) const SCALED: u8 = 0x80;
pub(super) const ANSWER_PREFERENCES: u8 = 0;
pub(super) const ANSWER_VALUES: u8 = 1;
pub(super) const ANSWER_ARGMAX: u8 = 2;

/// A layer's weights, row by row.
#[derive(Clone, Copy, Debug)]
pub enum Weights<'a> {
    /// In 8 bits: right for every kind.
    I8(&'a [i8]),
    /// In 16 bits: right for every kind that [has room](Kind::weights) for them.
    I16(&'a [i16]),
}

/// A layer as it is before it is packed. It has as many rows as `bias` has numbers.
#[derive(Clone, Copy, Debug)]
pub struct LayerRows<'a> {
    /// Columns of a row.
    pub inputs: usize,
    /// The kind that it is packed as.
    pub kind: Kind,
    /// Its weights.
    pub weights: Weights<'a>,
    /// Its biases.
    pub bias: &'a [i32],
    /// The factors that turn accumulators into outputs.
    pub rescale: &'a [Rescale],
}

impl LayerRows<'_> {
    const fn weight(&self, row: usize, column: usize) -> i32 {
        if row >= self.bias.len() || column >= self.inputs {
            return 0;
        }
        match self.weights {
            Weights::I8(weights) => weights[row * self.inputs + column] as i32,
            Weights::I16(weights) => weights[row * self.inputs + column] as i32,
        }
    }

    const fn fits(&self) -> bool {
        let count = match self.weights {
            Weights::I8(weights) => weights.len(),
            Weights::I16(weights) => weights.len(),
        };
        let outputs = self.bias.len();
        let sizes = self.inputs >= 1 && self.inputs <= WIDTH && outputs >= 1 && outputs <= WIDTH;
        sizes && count == self.inputs * outputs && self.rescale.len() == outputs
    }

    /// The greatest magnitude that a row's accumulator can take, for any inputs.
    ///
    /// # Panics
    /// If there is no such row or not a weight for each of its columns.
    pub const fn worst_accumulator(&self, row: usize) -> i64 {
        let mut worst = self.bias[row].unsigned_abs() as i64;
        let mut column = 0;
        while column < self.inputs {
            worst += self.weight(row, column).unsigned_abs() as i64 * 32_768;
            column += 1;
        }
        worst
    }

    /// Returns true if every weight is one of its kind and no input can overflow an accumulator.
    const fn is_sound(&self) -> bool {
        let (least, greatest) = self.kind.weights();
        let mut row = 0;
        while row < self.bias.len() {
            if self.worst_accumulator(row) > i32::MAX as i64 {
                return false;
            }
            let mut column = 0;
            while column < self.inputs {
                let weight = self.weight(row, column);
                if weight < least as i32 || weight > greatest as i32 {
                    return false;
                }
                column += 1;
            }
            row += 1;
        }
        true
    }

    /// Word `word` of four columns of a row, which has one (`i8`) or two (`i16`).
    const fn word(&self, row: usize, column: usize, word: usize) -> u32 {
        let w = [
            self.weight(row, column),
            self.weight(row, column + 1),
            self.weight(row, column + 2),
            self.weight(row, column + 3),
        ];
        match self.kind {
            Kind::W8A16 => u32::from_le_bytes([w[0] as u8, w[2] as u8, w[1] as u8, w[3] as u8]),
            Kind::W16A16 => halves(w[2 * word], w[2 * word + 1]),
        }
    }
}

const fn halves(low: i32, high: i32) -> u32 {
    (low as u16 as u32) | ((high as u16 as u32) << 16)
}

/// Words of a model whose layers have those inputs, outputs and kinds.
pub const fn words(layers: &[(usize, usize, Kind)], meaning: &Meaning<'_>) -> usize {
    let mut words = HEADER + 2 * layers.len() + 2 * meaning.inputs.len() + 3 * meaning.values.len();
    let mut index = 0;
    while index < layers.len() {
        let (inputs, outputs, kind) = layers[index];
        words += blocks(outputs, index + 1 == layers.len()) * kind.block(columns(inputs) / 2);
        index += 1;
    }
    words
}

const fn blocks(outputs: usize, last: bool) -> usize {
    if last { outputs.div_ceil(ROWS) } else { columns(outputs) / ROWS }
}

/// Packs layers, first to last, and says whether it could.
///
/// It cannot if sizes do not fit each other, the meaning, the runtime's limits or `words` ([`words()`] says how many there
/// must be), if an accumulator could overflow, if a rescale has no [multiplier](Rescale::multiplier), or if a range or a
/// scale is not finite.
pub const fn pack(layers: &[LayerRows<'_>], meaning: &Meaning<'_>, words: &mut [u32]) -> bool {
    if layers.is_empty() || layers.len() > LAYERS || words.len() < HEADER + 2 * layers.len() {
        return false;
    }
    let Some(mut at) = pack_meaning(layers, meaning, words, HEADER + 2 * layers.len()) else { return false };
    let mut index = 0;
    while index < layers.len() {
        let layer = &layers[index];
        let outputs = layer.bias.len();
        let last = index + 1 == layers.len();
        if !layer.fits() || !layer.is_sound() || (!last && outputs != layers[index + 1].inputs) {
            return false;
        }
        words[HEADER + 2 * index] = layer.inputs as u32 | ((outputs as u32) << 16);
        words[HEADER + 2 * index + 1] = layer.kind.code();
        let mut block = 0;
        while block < blocks(outputs, last) {
            match pack_block(layer, block * ROWS, words, at) {
                Some(end) => at = end,
                None => return false,
            }
            block += 1;
        }
        index += 1;
    }
    if at != words.len() {
        return false;
    }
    let (answer, flags) = match meaning.answer {
        OutputKind::Preferences { flags } => (ANSWER_PREFERENCES, flags),
        OutputKind::Values => (ANSWER_VALUES, 0),
        OutputKind::Argmax => (ANSWER_ARGMAX, 0),
    };
    let scaled = if meaning.inputs.is_empty() { 0 } else { SCALED };
    words[0] = MAGIC;
    words[1] = u32::from_le_bytes([VERSION, layers.len() as u8 | scaled, answer, flags]);
    words[2] = words.len() as u32;
    words[4] = meaning.contract;
    words[3] = crc::of_model(words);
    true
}

/// Writes scales and values at `at`; where the layers go.
const fn pack_meaning(
    layers: &[LayerRows<'_>],
    meaning: &Meaning<'_>,
    words: &mut [u32],
    mut at: usize,
) -> Option<usize> {
    let Meaning { inputs, values, answer, .. } = *meaning;
    let outputs = layers[layers.len() - 1].bias.len();
    let wanted = if matches!(answer, OutputKind::Values) { outputs } else { 0 };
    let fits = at + 2 * inputs.len() + 3 * values.len() <= words.len();
    if !fits || values.len() != wanted || !(inputs.is_empty() || inputs.len() == layers[0].inputs) {
        return None;
    }
    let mut index = 0;
    while index < inputs.len() {
        if !inputs[index].offset.is_finite() || !inputs[index].scale.is_finite() {
            return None;
        }
        words[at] = inputs[index].offset.to_bits();
        words[at + 1] = inputs[index].scale.to_bits();
        at += 2;
        index += 1;
    }
    index = 0;
    while index < values.len() {
        if !values[index].is_sound() {
            return None;
        }
        let squash = match values[index].squash {
            Squash::Tanh => 0,
            Squash::Clamp => 1,
        };
        words[at] = values[index].min.to_bits();
        words[at + 1] = values[index].max.to_bits();
        words[at + 2] = u32::from_le_bytes([squash, values[index].exponent, 0, 0]);
        at += 3;
        index += 1;
    }
    Some(at)
}

/// Writes the block of four rows from `row` on at `at`; where the next one goes.
const fn pack_block(layer: &LayerRows<'_>, row: usize, words: &mut [u32], at: usize) -> Option<usize> {
    let columns = columns(layer.inputs);
    let length = layer.kind.block(columns / 2);
    if at + length > words.len() {
        return None;
    }
    let words_per_four = match layer.kind {
        Kind::W8A16 => 1,
        Kind::W16A16 => 2,
    };
    let mut index = 0;
    while index < ROWS {
        let row = row + index;
        if row < layer.bias.len() {
            words[at + index] = layer.bias[row] as u32;
            match layer.rescale[row].multiplier() {
                Some(multiplier) => words[at + length - ROWS + index] = multiplier as u32,
                None => return None,
            }
        } else {
            words[at + index] = 0;
            words[at + length - ROWS + index] = 0;
        }
        let mut column = 0;
        while column < columns {
            let mut word = 0;
            while word < words_per_four {
                let place = at + ROWS + (column / 4 * words_per_four + word) * ROWS + index;
                words[place] = layer.word(row, column, word);
                word += 1;
            }
            column += 4;
        }
        index += 1;
    }
    Some(at + length)
}
