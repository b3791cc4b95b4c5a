//! A network as it lies in flash: checked once, then asked.

use super::meaning::{OutputKind, Scaling, Squash, Value};
use super::pack::{ANSWER_ARGMAX, ANSWER_PREFERENCES, ANSWER_VALUES, HEADER, LAYERS, MAGIC, SCALED, VERSION, WIDTH};
use super::{LAST, crc, integer};
use tpg_kernels::{COLUMNS, Kind, ROWS};

/// A reason that words are not a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ModelError {
    /// They do not begin with [`MAGIC`].
    NotAModel,
    /// The model is of another [`VERSION`] of the format.
    Version,
    /// There are fewer words than the model says it has.
    Short,
    /// A damaged word.
    Checksum,
    /// Layers that do not fit each other or exceed [`LAYERS`] or [`WIDTH`], or an unknown kind.
    Layers,
    /// An unknown kind of answer, a range or scale that is not finite; or made for another problem.
    Meaning,
}

#[derive(Clone, Copy, Debug)]
struct View<'a> {
    blocks: &'a [u32],
    kind: Kind,
    /// Padded inputs, in words of two columns; at most half of [`WIDTH`], padding included.
    inputs: u16,
    /// Padded outputs, in words of two.
    outputs: u16,
}

impl View<'_> {
    #[inline(always)]
    fn inputs(&self) -> usize {
        usize::from(self.inputs)
    }

    #[inline(always)]
    fn outputs(&self) -> usize {
        usize::from(self.outputs)
    }
}

/// A checked model, borrowed from where it lies.
#[derive(Clone, Copy, Debug)]
pub struct Model<'a> {
    hidden: [View<'a>; LAYERS - 1],
    count: usize,
    last: View<'a>,
    inputs: usize,
    outputs: usize,
    width: usize,
    contract: u32,
    answer: OutputKind,
    scales: &'a [[u32; 2]],
    values: &'a [[u32; 3]],
}

/// Columns with their padding.
pub(super) const fn columns(values: usize) -> usize {
    values.next_multiple_of(COLUMNS)
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
        let [version, layers, answer, flags] = kinds.to_le_bytes();
        if magic != MAGIC {
            return Err(ModelError::NotAModel);
        }
        if version != VERSION {
            return Err(ModelError::Version);
        }
        let words = words.get(..length as usize).ok_or(ModelError::Short)?;
        if words.len() < HEADER {
            return Err(ModelError::Short);
        }
        if crc::of_model(words) != checksum {
            return Err(ModelError::Checksum);
        }
        let answer = match answer {
            ANSWER_PREFERENCES => OutputKind::Preferences { flags },
            ANSWER_VALUES => OutputKind::Values,
            ANSWER_ARGMAX => OutputKind::Argmax,
            _ => return Err(ModelError::Meaning),
        };
        let heads = words.get(HEADER..).unwrap_or(&[]);
        let heads = heads.get(..2 * usize::from(layers & !SCALED)).ok_or(ModelError::Layers)?;
        let empty = View { blocks: &[], kind: Kind::W8A16, inputs: 0, outputs: 0 };
        let mut model = Self {
            hidden: [empty; LAYERS - 1],
            count: 0,
            last: empty,
            inputs: 0,
            outputs: 0,
            width: 0,
            contract,
            answer,
            scales: &[],
            values: &[],
        };
        let heads = heads.as_chunks::<2>().0;
        let (Some([first, _]), Some([last, _])) = (heads.first(), heads.last()) else { return Err(ModelError::Layers) };
        (model.inputs, model.outputs) = ((first & 0xffff) as usize, (last >> 16) as usize);
        let rest = words.get(HEADER + 2 * heads.len()..).ok_or(ModelError::Layers)?;
        let blocks = model.read_meaning(rest, layers & SCALED != 0)?;
        model.read_layers(heads, blocks)?;
        Ok(model)
    }

    /// Reads scales and values; the words behind them.
    fn read_meaning(&mut self, words: &'a [u32], scaled: bool) -> Result<&'a [u32], ModelError> {
        let scales = if scaled { self.inputs } else { 0 };
        let values = if self.answer == OutputKind::Values { self.outputs } else { 0 };
        let (scales, words) = words.split_at_checked(2 * scales).ok_or(ModelError::Meaning)?;
        let (values, words) = words.split_at_checked(3 * values).ok_or(ModelError::Meaning)?;
        (self.scales, self.values) = (scales.as_chunks().0, values.as_chunks().0);
        let finite = |word: &u32| f32::from_bits(*word).is_finite();
        let sound = |place| self.value(place).is_some_and(|value| value.is_sound());
        if !scales.iter().all(finite) || !(0..self.values.len()).all(sound) {
            return Err(ModelError::Meaning);
        }
        Ok(words)
    }

    fn read_layers(&mut self, heads: &[[u32; 2]], mut blocks: &'a [u32]) -> Result<(), ModelError> {
        let mut before = None;
        for (index, &[sizes, kind]) in heads.iter().enumerate() {
            let (inputs, outputs) = ((sizes & 0xffff) as usize, (sizes >> 16) as usize);
            let kind = Kind::from_code(kind).ok_or(ModelError::Layers)?;
            let fits = (1..=WIDTH).contains(&inputs) && (1..=WIDTH).contains(&outputs);
            if !fits || before.is_some_and(|outputs| outputs != inputs) {
                return Err(ModelError::Layers);
            }
            before = Some(outputs);
            let is_last = index + 1 == heads.len();
            let columns_in = columns(inputs);
            let rows = if is_last { outputs.next_multiple_of(ROWS) } else { columns(outputs) };
            let (these, rest) =
                blocks.split_at_checked(rows / ROWS * kind.block(columns_in / 2)).ok_or(ModelError::Layers)?;
            blocks = rest;
            let view = View { blocks: these, kind, inputs: (columns_in / 2) as u16, outputs: (rows / 2) as u16 };
            self.width = self.width.max(view.inputs());
            if is_last {
                self.last = view;
            } else {
                *self.hidden.get_mut(index).ok_or(ModelError::Layers)? = view;
                self.count = index + 1;
            }
        }
        if blocks.is_empty() { Ok(()) } else { Err(ModelError::Layers) }
    }

    /// Values that the first layer reads.
    pub fn inputs(&self) -> usize {
        self.inputs
    }

    /// Values that the last layer gives.
    pub fn outputs(&self) -> usize {
        self.outputs
    }

    /// The kind of answer.
    pub fn answer(&self) -> OutputKind {
        self.answer
    }

    /// The checksum of the inputs' names.
    pub fn contract(&self) -> u32 {
        self.contract
    }

    /// The scale of an input; `None` where the model has none, or no such input.
    pub fn scale(&self, input: usize) -> Option<Scaling> {
        let [offset, scale] = self.scales.get(input)?.map(f32::from_bits);
        Some(Scaling { offset, scale })
    }

    /// The value that an output becomes; `None` where it becomes none, or there is no such output.
    pub fn value(&self, output: usize) -> Option<Value> {
        let &[min, max, how] = self.values.get(output)?;
        let [squash, exponent, ..] = how.to_le_bytes();
        let squash = match squash {
            0 => Squash::Tanh,
            1 => Squash::Clamp,
            _ => return None,
        };
        Some(Value { min: f32::from_bits(min), max: f32::from_bits(max), squash, exponent })
    }

    /// Words of scratch memory that a decision needs.
    pub fn scratch(&self) -> usize {
        2 * self.width
    }

    /// The first four outputs, from inputs in multiples of 1/4096; zeros where `scratch` has fewer words than
    /// [`scratch`](Self::scratch). Missing inputs count as 0, surplus ones are not read.
    #[inline(never)] // its loop is not its caller's: a static bound multiplies nested ones
    pub fn first(&self, inputs: &[i16], scratch: &mut [u32]) -> [i32; ROWS] {
        let hidden = self.through_hidden(scratch, |words| self.load(inputs, words));
        let Some(inputs) = hidden else { return [0; ROWS] };
        tpg_kernels::last(self.last.kind, self.last.blocks, inputs).map(clip)
    }

    /// All outputs, from inputs in multiples of 1/4096; whether they were computed.
    ///
    /// They are not where `scratch` has fewer words than [`scratch`](Self::scratch). Missing inputs count as 0, surplus
    /// ones are not read; outputs that do not fit are left out.
    pub fn outputs_of(&self, inputs: &[i16], scratch: &mut [u32], outputs: &mut [i32]) -> bool {
        let hidden = self.through_hidden(scratch, |words| self.load(inputs, words));
        let Some(inputs) = hidden else { return false };
        self.each_output(inputs, |output, value| {
            if let Some(slot) = outputs.get_mut(output) {
                *slot = value;
            }
        });
        true
    }

    /// The values that a state answers with; whether they were computed.
    ///
    /// They are not where the model does not answer with values, or `state`, `values` or `scratch` are too short.
    pub fn values(&self, state: &[f32], scratch: &mut [u32], values: &mut [f32]) -> bool {
        if self.answer != OutputKind::Values || values.len() < self.outputs {
            return false;
        }
        self.ask(state, scratch, |output, number| {
            if let (Some(slot), Some(value)) = (values.get_mut(output), self.value(output)) {
                *slot = value.of(number);
            }
        })
    }

    /// The number of the greatest output for a state, of equals the first.
    ///
    /// `None` where that is not the model's kind of answer, or `state` or `scratch` are too short.
    pub fn choose(&self, state: &[f32], scratch: &mut [u32]) -> Option<u16> {
        if self.answer != OutputKind::Argmax {
            return None;
        }
        let mut best = (0, i32::MIN);
        let asked = self.ask(state, scratch, |output, number| {
            if number > best.1 {
                best = (output, number);
            }
        });
        asked.then_some(best.0 as u16)
    }

    fn ask(&self, state: &[f32], scratch: &mut [u32], each: impl FnMut(usize, i32)) -> bool {
        let Some(state) = state.get(..self.inputs) else { return false };
        let hidden = self.through_hidden(scratch, |words| self.load_state(state, words));
        let Some(inputs) = hidden else { return false };
        self.each_output(inputs, each);
        true
    }

    fn each_output(&self, inputs: &[u32], mut each: impl FnMut(usize, i32)) {
        let last = &self.last;
        let blocks = last.blocks.chunks_exact(last.kind.block(inputs.len()));
        let numbers = blocks.flat_map(|block| tpg_kernels::last(last.kind, block, inputs));
        for (output, number) in numbers.enumerate().take(self.outputs) {
            each(output, clip(number));
        }
    }

    #[inline(always)]
    fn first_layer(&self) -> &View<'a> {
        self.hidden.get(..self.count).unwrap_or(&[]).first().unwrap_or(&self.last)
    }

    /// Writes integers as the first layer's inputs.
    #[inline(always)]
    fn load(&self, inputs: &[i16], words: &mut [u32]) {
        let inputs = inputs.get(..self.inputs).unwrap_or(inputs);
        let first = self.first_layer();
        if let Some(words) = words.get_mut(..first.inputs()) {
            tpg_kernels::pair_inputs(inputs, words);
        }
    }

    /// Writes a state as the first layer's inputs, four values at a time.
    fn load_state(&self, state: &[f32], words: &mut [u32]) {
        let first = self.first_layer();
        let mut number = 0;
        for words in words.as_chunks_mut::<2>().0.iter_mut().take(first.inputs() / 2) {
            let mut four = [0; 4];
            for slot in &mut four {
                if let Some(&value) = state.get(number) {
                    *slot = match self.scale(number) {
                        Some(Scaling { offset, scale }) => integer((value - offset) * scale),
                        None => integer(value),
                    };
                }
                number += 1;
            }
            tpg_kernels::pair_inputs(&four, words);
        }
    }

    /// Runs the hidden layers on what `load` writes; the last layer's inputs. `None` where `scratch` is too short.
    #[inline(always)]
    fn through_hidden<'s>(&self, scratch: &'s mut [u32], load: impl FnOnce(&mut [u32])) -> Option<&'s [u32]> {
        let (mut from, rest) = scratch.split_at_mut_checked(self.width)?;
        let mut to = rest.get_mut(..self.width)?;
        load(from);
        let hidden = self.hidden.get(..self.count).unwrap_or(&[]);
        for layer in hidden {
            if let (Some(inputs), Some(outputs)) = (from.get(..layer.inputs()), to.get_mut(..layer.outputs())) {
                tpg_kernels::hidden(layer.kind, layer.blocks, inputs, outputs);
            }
            (from, to) = (to, from);
        }
        from.get(..self.last.inputs())
    }
}

#[inline(always)]
fn clip(number: i32) -> i32 {
    number.clamp(i32::from(LAST), i32::from(i16::MAX))
}

#[cfg(test)]
mod tests {
    use super::{Model, clip};

    impl Model<'_> {
        /// [`outputs_of`](Self::outputs_of) by the kernels in plain Rust.
        pub(in crate::net) fn portable_outputs(&self, inputs: &[i16]) -> std::vec::Vec<i32> {
            use std::{vec, vec::Vec};
            use tpg_kernels::portable;
            let hidden = &self.hidden[..self.count];
            let mut from = vec![0; self.first_layer().inputs()];
            tpg_kernels::pair_inputs(inputs, &mut from);
            for layer in hidden {
                let blocks = layer.blocks.chunks_exact(layer.kind.block(from.len()));
                from = blocks.flat_map(|block| portable::hidden(layer.kind, block, &from)).collect::<Vec<_>>();
            }
            let last = &self.last;
            let blocks = last.blocks.chunks_exact(last.kind.block(from.len()));
            let numbers = blocks.flat_map(|block| {
                portable::rescale(last.kind, block, &from, portable::accumulate(last.kind, block, &from)).map(clip)
            });
            numbers.take(self.outputs).collect()
        }
    }
}
