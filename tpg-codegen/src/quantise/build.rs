//! Values times a scale, in whole numbers, with the bound of each.

use crate::formula;
use crate::integers::{Form, Unfit, Whole, forms};
use crate::ir::{Module, Node, NodeId, Values};
use Instruction::*;
use Node::*;
use tpg_graph::{Counts, Range};
use tpg_runtime::ops::{BY_ZERO, Instruction};

/// The greatest magnitude of a sum: one below what stands for infinity.
const MOST: f64 = 2_147_483_646.0;
/// The greatest half that is added before rounding down.
const HALF: f64 = 65_536.0;
/// The greatest magnitude of a factor and of a divisor, so that products fit.
const NARROW: f64 = 32_767.0;
/// Counts of a memory's greatest magnitude: much finer than a sensor's, so that what is added in small steps does not stall.
const MEMORY: f64 = 4_194_304.0;

/// Builds whole numbers from the values of a module. An error says what cannot be put into integers.
pub(super) struct Builder<'a> {
    module: &'a Module<'a>,
    forms: Vec<Form>,
    /// The counts of each input; of memory, those of 32 bits that the graph keeps.
    counts: Vec<Counts>,
    /// The inputs from here on are memory.
    memory: usize,
    /// The greatest weight.
    weights: f64,
    pub(super) values: Values,
    wholes: Vec<Whole>,
    /// Weights that became 0.
    pub(super) vanished: usize,
}

/// The scale of a memory.
pub(super) fn memory_scale(greatest: f64) -> f64 {
    if greatest == 0.0 { 1.0 } else { (MEMORY / greatest).log2().floor().exp2() }
}

impl<'a> Builder<'a> {
    pub(super) fn new(module: &'a Module<'a>, counts: Vec<Counts>, memory: usize, weights: u32) -> Self {
        let weights = f64::from((1_u32 << (weights - 1)) - 1);
        let (values, wholes) = (Values::default(), Vec::new());
        Self { module, forms: forms(module), counts, memory, weights, values, wholes, vanished: 0 }
    }

    fn form(&self, id: NodeId) -> Form {
        self.forms[id.index()].clone()
    }

    /// The interval of a node that was made.
    pub(super) fn whole(&self, id: NodeId) -> Whole {
        self.wholes[id.index()]
    }

    fn intern(&mut self, node: Node) -> Result<NodeId, String> {
        let id = self.values.intern(node);
        if id.index() == self.wholes.len() {
            let whole = match node {
                Constant(bits) => Whole::exactly(f64::from_bits(bits)),
                Input(input) if input.index() >= self.memory => {
                    let greatest = self.counts[input.index()].scale.recip() * self.magnitude_of_input(input.index());
                    Whole::between(-greatest.ceil(), greatest.ceil())
                }
                Input(input) => {
                    let [low, high] = self.limits(input);
                    Whole::between(low, high)
                }
                Operation(instruction, [a, b]) => Whole::apply(instruction, self.whole(a), self.whole(b)),
                Upper(..) => Err(Unfit::NotWhole),
            };
            self.wholes.push(whole.map_err(|unfit| format!("{unfit:?}"))?);
        }
        Ok(id)
    }

    fn number(&mut self, value: f64) -> Result<NodeId, String> {
        // Not −0.
        self.intern(Node::constant(value + 0.0))
    }

    fn operation(&mut self, instruction: Instruction, a: NodeId, b: NodeId) -> Result<NodeId, String> {
        self.intern(Operation(instruction, [a, b]))
    }

    fn with_number(&mut self, instruction: Instruction, a: NodeId, number: f64) -> Result<NodeId, String> {
        let b = self.number(number)?;
        self.operation(instruction, a, b)
    }

    fn magnitude_of_input(&self, input: usize) -> f64 {
        let counts = self.counts[input];
        if input >= self.memory {
            let range = self.module.graph.state_ranges().nth(input);
            return range.map_or(0.0, Range::magnitude);
        }
        let limits = self.limits(tpg_graph::Input(input as u16));
        limits.into_iter().map(|count| counts.value(count).abs()).fold(0.0, f64::max)
    }

    /// The lowest and highest count of an input that is no memory.
    fn limits(&self, input: tpg_graph::Input) -> [f64; 2] {
        let (source, place) = self.module.graph.source_of(input);
        let first = input.index() - place;
        let bits = Counts::container_of(&self.counts[first..first + source.ranges.len()]);
        self.module.graph.count_range(input, bits)
    }

    /// The greatest magnitude of a value, that of quotients aside: these may be infinite.
    fn magnitude(&self, id: NodeId) -> f64 {
        let form = &self.forms[id.index()];
        let of_terms = form.terms.iter().map(|(&term, weight)| weight.abs() * self.magnitude_of_term(term));
        of_terms.sum::<f64>() + form.constant.abs()
    }

    fn magnitude_of_term(&self, id: NodeId) -> f64 {
        match self.module.node(id) {
            Input(input) => self.magnitude_of_input(input.index()),
            Constant(_) | Upper(..) => 0.0,
            Operation(instruction, [a, b]) => match instruction {
                Mul => self.magnitude(a) * self.magnitude(b),
                Min | Max => self.magnitude(a).max(self.magnitude(b)),
                Abs | NegateIfLess | Gate | Fmod => self.magnitude(a),
                _ => 0.0,
            },
        }
    }

    /// The greatest error that rounding the weight of a term makes.
    fn half_of(&self, id: NodeId) -> f64 {
        match self.module.node(id) {
            Input(input) => {
                let [low, high] = self.limits(input);
                0.5 * high.max(-low)
            }
            _ => 0.5,
        }
    }

    /// The greatest scale at which a value fits, and its weights; infinite if any does.
    pub(super) fn room(&self, id: NodeId) -> f64 {
        let form = &self.forms[id.index()];
        let magnitude = self.magnitude(id);
        // Rounded weights may be half a count greater, and a half is added before rounding down.
        let halves: f64 = form.terms.keys().map(|&term| self.half_of(term)).sum();
        let mut room = if magnitude > 0.0 { (MOST - halves - HALF) / magnitude } else { f64::INFINITY };
        for (&term, weight) in &form.terms {
            let of_term = match self.module.node(term) {
                Input(input) if input.index() < self.memory => (self.weights + 0.49) / self.counts[input.index()].scale,
                Operation(instruction, [a, b]) => match instruction {
                    Mul => MOST / 2.0 / (self.magnitude(a) * self.magnitude(b)),
                    Min | Max | NegateIfLess | Fmod => self.room(a).min(self.room(b)),
                    Abs | Gate => self.room(a),
                    _ => f64::INFINITY,
                },
                _ => f64::INFINITY,
            };
            room = room.min(of_term / weight.abs());
        }
        room
    }

    /// A value times a scale, with a whole number added; its magnitude stays below what stands for infinity.
    pub(super) fn at(&mut self, id: NodeId, scale: f64, added: f64) -> Result<NodeId, String> {
        let form = self.form(id);
        let mut bias = (form.constant * scale).round() + added;
        let mut terms = Vec::new();
        // Inputs in their order.
        let mut ordered: Vec<(NodeId, f64)> = form.terms.into_iter().collect();
        ordered.sort_by_key(|&(term, _)| match self.module.node(term) {
            Input(input) => (input.index(), term),
            _ => (usize::MAX, term),
        });
        for (term, weight) in ordered {
            let wanted = weight * scale;
            match self.module.node(term) {
                Input(input) if input.index() < self.memory => {
                    let counts = self.counts[input.index()];
                    let whole = (wanted * counts.scale).round();
                    self.vanished += usize::from(whole == 0.0);
                    bias -= (whole * counts.offset).round();
                    if whole != 0.0 {
                        let input = self.intern(Input(input))?;
                        terms.push(if whole == 1.0 { input } else { self.with_number(Mul, input, whole)? });
                    }
                }
                Input(input) => {
                    let place = self.intern(Input(input))?;
                    terms.push(self.remembered(place, wanted * self.counts[input.index()].scale)?);
                }
                _ => terms.push(self.scaled(term, wanted)?),
            }
        }
        let mut sum = None;
        for term in terms {
            let term = match sum {
                None => term,
                Some(sum) => {
                    // Only what may be infinite does not fit.
                    let left = MOST - self.whole(sum).magnitude() as f64 - bias.abs();
                    let term = self.limited(term, left)?;
                    self.operation(Add, sum, term)?
                }
            };
            sum = Some(term);
        }
        match sum {
            None => self.number(bias.clamp(-MOST, MOST)),
            Some(sum) if bias == 0.0 => Ok(sum),
            Some(sum) => {
                let sum = self.limited(sum, MOST - bias.abs())?;
                self.with_number(Add, sum, bias)
            }
        }
    }

    /// A memory's count times a factor: exactly where it is whole, else by a weight of 15 bits of fewer counts.
    fn remembered(&mut self, place: NodeId, factor: f64) -> Result<NodeId, String> {
        if factor.fract() == 0.0 {
            return if factor == 1.0 { Ok(place) } else { self.with_number(Mul, place, factor) };
        }
        let (narrow, by) = self.narrowed(place)?;
        let bits = (NARROW / (factor.abs() * by)).log2().floor().clamp(0.0, 20.0);
        let product = self.with_number(Mul, narrow, (factor * by * bits.exp2()).round())?;
        self.shifted(product, bits)
    }

    /// The nearest number to a quotient by a power of two.
    fn shifted(&mut self, id: NodeId, bits: f64) -> Result<NodeId, String> {
        if bits <= 0.0 {
            return if bits == 0.0 { Ok(id) } else { self.with_number(Mul, id, (-bits).exp2()) };
        }
        let half = self.with_number(Add, id, (bits - 1.0).exp2())?;
        self.with_number(Quotient, half, bits.exp2())
    }

    /// A number of 15 bits and a sign, and what it was divided by.
    fn narrowed(&mut self, id: NodeId) -> Result<(NodeId, f64), String> {
        let most = self.whole(id).magnitude() as f64;
        let mut bits = 0.0_f64;
        while (most / bits.exp2()).round() > NARROW {
            bits += 1.0;
        }
        Ok((self.shifted(id, bits)?, bits.exp2()))
    }

    /// A number within limits.
    fn limited(&mut self, id: NodeId, most: f64) -> Result<NodeId, String> {
        let Whole { low, high } = self.whole(id);
        let mut id = id;
        if (high as f64) > most {
            id = self.with_number(Min, id, most)?;
        }
        if (low as f64) < -most {
            id = self.with_number(Max, id, -most)?;
        }
        Ok(id)
    }

    /// A factor or divisor: at most 15 bits and a sign, and its scale.
    fn factor(&mut self, id: NodeId) -> Result<(NodeId, f64), String> {
        if let Some((term, weight)) = self.form(id).multiple()
            && let Input(input) = self.module.node(term)
            && input.index() < self.memory
            && self.counts[input.index()].offset == 0.0
        {
            return Ok((self.intern(Input(input))?, 1.0 / (weight * self.counts[input.index()].scale)));
        }
        let scale = power_below(self.room(id));
        let value = self.at(id, scale, 0.0)?;
        let (narrow, by) = self.narrowed(value)?;
        Ok((narrow, scale / by))
    }

    /// A value that is no sum, times a scale.
    fn scaled(&mut self, id: NodeId, scale: f64) -> Result<NodeId, String> {
        let Operation(instruction, [a, b]) = self.module.node(id) else {
            // An infinite constant, or NaN.
            let value = self.module.node(id).as_constant().unwrap_or(f64::NAN) * scale;
            return self.number(if value.is_nan() {
                -f64::from(BY_ZERO) - 1.0
            } else {
                f64::from(BY_ZERO).copysign(value)
            });
        };
        match instruction {
            Mul => self.product(a, b, scale),
            Div => self.quotient(a, b, scale),
            Min | Max => {
                let (a, b) = (self.at(a, scale, 0.0)?, self.at(b, scale, 0.0)?);
                let turned = if instruction == Min { Max } else { Min };
                self.operation(if scale < 0.0 { turned } else { instruction }, a, b)
            }
            Abs | NegateIfLess | Gate | Fmod => {
                let magnitude = scale.abs();
                let a = self.at(a, magnitude, 0.0)?;
                // What is no number must not become the greatest by a change of its sign.
                let a = self.limited(a, f64::from(BY_ZERO))?;
                let b = match instruction {
                    Abs => a,
                    Gate => self.sign(b)?,
                    _ => self.at(b, magnitude, 0.0)?,
                };
                let result = self.operation(instruction, a, b)?;
                self.signed(result, scale)
            }
            _ => Err(format!("{}, for which there are no integers yet", formula::text(self.module, id))),
        }
    }

    fn signed(&mut self, id: NodeId, sign: f64) -> Result<NodeId, String> {
        if sign > 0.0 {
            return Ok(id);
        }
        let id = self.limited(id, f64::from(BY_ZERO))?;
        let zero = self.number(0.0)?;
        self.operation(Sub, zero, id)
    }

    /// A number with the sign of a value, as exactly as there is room.
    fn sign(&mut self, id: NodeId) -> Result<NodeId, String> {
        if let Some((term, weight)) = self.form(id).multiple()
            && let Input(_) = self.module.node(term)
            && weight > 0.0
        {
            return self.factor(term).map(|(input, _)| input);
        }
        self.at(id, power_below(self.room(id)), 0.0)
    }

    /// A product of two values that are no constants.
    fn product(&mut self, a: NodeId, b: NodeId, scale: f64) -> Result<NodeId, String> {
        // The factor with a sum can have any scale.
        let (a, b) = if self.form(a).multiple().is_some() { (b, a) } else { (a, b) };
        let (b, b_scale) = self.factor(b)?;
        let greatest = self.magnitude(a);
        if greatest == 0.0 {
            return self.number(0.0);
        }
        // A scale such that both have as many bits as fit, and the product is a power of two above the one asked for.
        let bits = (NARROW * b_scale.abs() / (scale.abs() * greatest)).log2().floor();
        let a_scale = scale * bits.exp2() / b_scale;
        let finer = (self.room(a) / a_scale.abs()).log2().floor().clamp(0.0, 30.0);
        let a = self.at(a, a_scale * finer.exp2(), if finer > 0.0 { (finer - 1.0).exp2() } else { 0.0 })?;
        let a = if finer > 0.0 { self.with_number(Quotient, a, finer.exp2())? } else { a };
        let product = self.operation(Mul, a, b)?;
        self.shifted(product, bits)
    }

    /// A quotient, rounded down.
    fn quotient(&mut self, a: NodeId, b: NodeId, scale: f64) -> Result<NodeId, String> {
        if self.forms[b.index()].terms.is_empty() {
            // By 0: only signs matter.
            let a = self.sign(a)?;
            let quotient = self.with_number(Quotient, a, 0.0)?;
            return self.signed(quotient, scale);
        }
        let (b, b_scale) = self.factor(b)?;
        let mut coarser = 0.0_f64;
        let mut a_scale = scale * b_scale;
        while a_scale.abs() > self.room(a) {
            a_scale /= 2.0;
            coarser += 1.0;
        }
        let a = self.at(a, a_scale, 0.0)?;
        let quotient = self.operation(Quotient, a, b)?;
        if coarser == 0.0 {
            return Ok(quotient);
        }
        let limited = self.limited(quotient, (MOST / coarser.exp2()).floor())?;
        self.with_number(Mul, limited, coarser.exp2())
    }

    /// The nearest count of a value to a scale that is a power of two.
    pub(super) fn rounded(&mut self, id: NodeId, scale: f64) -> Result<NodeId, String> {
        let is_sum = self.form(id).multiple().is_none_or(|(term, _)| matches!(self.module.node(term), Input(_)));
        // The half needs room, too.
        let bits = (power_below(self.room(id)) / scale).log2().clamp(-30.0, 17.0);
        if !is_sum && bits >= 0.0 || bits == 0.0 {
            return self.at(id, scale, 0.0);
        }
        if bits < 0.0 {
            let coarse = self.at(id, scale * bits.exp2(), 0.0)?;
            return self.with_number(Mul, coarse, (-bits).exp2());
        }
        let sum = self.at(id, scale * bits.exp2(), (bits - 1.0).exp2())?;
        self.with_number(Quotient, sum, bits.exp2())
    }
}

/// The greatest power of two that is not above a scale; 2¹⁵ where any will do.
pub(super) fn power_below(scale: f64) -> f64 {
    if scale.is_finite() { scale.log2().floor().exp2() } else { 32_768.0 }
}
