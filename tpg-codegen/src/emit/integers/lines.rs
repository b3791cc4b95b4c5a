//! Values as statements: a sum with its products is one, everything else a call.

use super::comment::Comments;
use super::work::Work;
use crate::emit::block::unused;
use crate::integers::Whole;
use crate::ir::{Node::*, NodeId};
use Instruction::*;
use std::collections::{BTreeMap, BTreeSet};
use tpg_runtime::ops::Instruction;

/// More uses than there are.
const ROOT: usize = 1 << 20;
/// The greatest magnitude of a sum in 16 bits.
const NARROW: u64 = i16::MAX as u64;

/// The statements of some values.
pub(super) struct Lines<'a> {
    work: &'a Work<'a>,
    /// The names of nodes that have one.
    named: BTreeMap<NodeId, String>,
    /// Named nodes whose statements have not been written yet.
    open: BTreeSet<NodeId>,
}

impl<'a> Lines<'a> {
    /// Chooses what has a name in the computation of some values; names are given to the first nodes that have one.
    ///
    /// A product or sum that is used once is part of the sum that uses it.
    pub(super) fn new(work: &'a Work<'a>, roots: &[NodeId], names: Vec<(NodeId, String)>) -> Self {
        let module = work.module;
        let mut needed: BTreeSet<NodeId> = BTreeSet::new();
        let mut uses: BTreeMap<NodeId, usize> = BTreeMap::new();
        for &root in roots {
            needed.extend(module.operations_of(root));
            *uses.entry(root).or_default() += ROOT; // a root has a name
        }
        let mut in_sums = BTreeSet::new();
        for &id in &needed {
            let Operation(instruction, _) = module.node(id) else { continue };
            for &operand in module.node(id).operands() {
                *uses.entry(operand).or_default() += 1;
                if is_sum(instruction) || instruction == Mul {
                    in_sums.insert(operand);
                }
            }
        }
        let is_part = |id: &NodeId| {
            let Operation(instruction, [a, b]) = module.node(*id) else { return false };
            // A product of an input and a constant takes no more than a copy of it.
            let cheap = instruction == Mul && [a, b].iter().all(|id| !matches!(module.node(*id), Operation(..)));
            let once = uses[id] == 1 || (cheap && uses[id] < ROOT);
            (is_sum(instruction) || instruction == Mul) && once && in_sums.contains(id)
        };
        let open: BTreeSet<NodeId> = needed.into_iter().filter(|id| !is_part(id)).collect();
        let (mut named, mut taken) = (BTreeMap::new(), BTreeSet::new());
        for (id, name) in names {
            if open.contains(&id) && !named.contains_key(&id) {
                named.insert(id, unused(name, &mut taken));
            }
        }
        for &id in &open {
            named.entry(id).or_insert_with(|| unused(format!("v{}", id.0), &mut taken));
        }
        Self { work, named, open }
    }

    /// The statements for what a value needs and has no statement yet, each below its comment.
    pub(super) fn statements(&mut self, value: NodeId, comments: &Comments<'_>) -> Vec<String> {
        let (work, mut statements) = (self.work, Vec::new());
        for id in work.module.operations_of(value) {
            if self.open.remove(&id) {
                let said = comments.text(id, work.integers.interval(id));
                statements.extend(said.iter().flat_map(|said| work.spelling.comment(said)));
                statements.push(self.statement(id));
            }
        }
        statements
    }

    /// The statement of a node.
    fn statement(&self, id: NodeId) -> String {
        self.work.spelling.statement(&self.named[&id], self.is_wide(id), bare(&self.expression(id)))
    }

    /// Tests for a value of 64 bits.
    pub(super) fn is_wide(&self, id: NodeId) -> bool {
        !self.work.integers.interval(id).fits(32)
    }

    /// A node as an operand.
    pub(super) fn operand(&self, id: NodeId, wide: bool) -> String {
        let text = match self.work.module.node(id) {
            Constant(bits) => return self.work.spelling.literal(f64::from_bits(bits) as i64, wide),
            Input(input) => return self.work.spelling.input(input, wide),
            Operation(..) | Upper(..) => match self.named.get(&id) {
                Some(name) => name.clone(),
                None => format!("({})", self.expression(id)),
            },
        };
        if wide && !self.is_wide(id) { self.work.spelling.widened(&text) } else { text }
    }

    /// A value limited to a range.
    pub(super) fn limited(&self, id: NodeId, range: Whole) -> String {
        let Whole { low, high } = self.work.integers.interval(id);
        let wide = self.is_wide(id);
        let value = self.operand(id, wide);
        if range.low <= low && high <= range.high {
            return value;
        }
        let limits = [range.low, range.high].map(|end| self.work.spelling.literal(end, wide));
        let text = self.work.spelling.call("clamp", wide, &[value, limits[0].clone(), limits[1].clone()]);
        if wide { self.work.spelling.narrowed(&text) } else { text }
    }

    /// The expression that computes an operation.
    fn expression(&self, id: NodeId) -> String {
        let Operation(instruction, [a, b]) = self.work.module.node(id) else { return self.operand(id, false) };
        let operands = &self.work.module.node(id).operands().to_vec();
        // Computed in the width of the greatest that takes part.
        let wide = operands.iter().chain([&id]).any(|&id| self.is_wide(id));
        let text = match instruction {
            Add | Sub => self.sum(id, wide),
            Mul if !wide && let Some(product) = self.narrow(id) => format!("(int32_t)({product})"),
            Mul => format!("{} * {}", self.operand(a, wide), self.operand(b, wide)),
            Quotient => self.quotient(a, b, wide),
            Fmod => format!("{} % {}", self.operand(a, wide), self.operand(b, wide)),
            _ => {
                let arguments: Vec<String> = operands.iter().map(|&operand| self.operand(operand, wide)).collect();
                self.work.spelling.call(instruction.name(), wide, &arguments)
            }
        };
        if wide && !self.is_wide(id) { self.work.spelling.narrowed(&format!("({text})")) } else { text }
    }

    /// A sum of terms.
    fn sum(&self, id: NodeId, wide: bool) -> String {
        let collected = |any_order| {
            let mut terms = Vec::new();
            self.terms(id, wide, false, any_order, &mut terms);
            terms
        };
        // Every partial sum is a node, so its bound holds. If all magnitudes fit, so does every other partial sum.
        let mut terms = collected(true);
        let most: u64 = terms.iter().map(|term| term.magnitude).sum();
        if most > if wide { Whole::MOST } else { i64::from(i32::MAX) }.unsigned_abs() {
            terms = collected(false);
        }
        in_16_bits(&mut terms);
        let mut text = String::new();
        for Term { minus, text: term, .. } in terms {
            text.push_str(match (text.is_empty(), minus) {
                (true, false) => "",
                (true, true) => "-",
                (false, false) => " + ",
                (false, true) => " - ",
            });
            text.push_str(&term);
        }
        text
    }

    /// Collects the terms of a sum in the order in which they are added, those of its second operand only if any order will do.
    fn terms(&self, id: NodeId, wide: bool, minus: bool, any_order: bool, terms: &mut Vec<Term>) {
        let Operation(instruction, [a, b]) = self.work.module.node(id) else { return };
        let sides = [(a, minus, true), (b, minus != (instruction == Sub), any_order)];
        for (side, minus, opens) in sides {
            let is_inner = matches!(self.work.module.node(side), Operation(inner, _) if is_sum(inner));
            // In another width, it is computed in brackets.
            if opens && is_inner && !self.named.contains_key(&side) && self.width(side) == wide {
                self.terms(side, wide, minus, any_order, terms);
            } else if self.constant(side) != Some(0) {
                terms.push(self.term(side, wide, minus));
            }
        }
    }

    /// A term: a product needs no brackets.
    fn term(&self, id: NodeId, wide: bool, minus: bool) -> Term {
        let magnitude = self.work.integers.interval(id).magnitude();
        if let Some(value) = self.constant(id).filter(|&value| value < 0 && value > -i64::from(i32::MAX)) {
            return Term { minus: !minus, text: self.work.spelling.literal(-value, wide), magnitude, narrow: None };
        }
        let is_product = matches!(self.work.module.node(id), Operation(Mul, _));
        let is_part = !self.named.contains_key(&id);
        let text =
            if is_product && is_part && self.width(id) == wide { self.expression(id) } else { self.operand(id, wide) };
        Term { minus, text, magnitude, narrow: self.narrow(id).filter(|_| !wide && is_part) }
    }

    /// A count of 8 bits or its product with a constant, without a cast, if C computes it in 16 bits.
    fn narrow(&self, id: NodeId) -> Option<String> {
        let text = match self.work.module.node(id) {
            Input(input) => self.work.spelling.byte(input)?,
            Operation(Mul, [a, b]) => {
                let (count, weight) = if self.constant(a).is_some() { (b, a) } else { (a, b) };
                let Input(input) = self.work.module.node(count) else { return None };
                format!(
                    "{} * {}",
                    self.work.spelling.byte(input)?,
                    self.work.spelling.literal(self.constant(weight)?, false)
                )
            }
            _ => return None,
        };
        (self.work.integers.interval(id).magnitude() <= NARROW).then_some(text)
    }

    /// Tests for an operation in 64 bits.
    fn width(&self, id: NodeId) -> bool {
        self.work.module.node(id).operands().iter().chain([&id]).any(|&id| self.is_wide(id))
    }

    fn constant(&self, id: NodeId) -> Option<i64> {
        self.work.module.node(id).as_constant().map(|value| value as i64)
    }

    fn quotient(&self, a: NodeId, b: NodeId, wide: bool) -> String {
        let divisor = self.work.integers.interval(b);
        let dividend = self.operand(a, wide);
        if divisor.contains(0) {
            return self.work.spelling.call("quotient", wide, &[dividend, self.operand(b, wide)]);
        }
        let is_positive = self.work.integers.interval(a).low >= 0;
        if let Some(power) = self.constant(b).filter(|&power| power > 1 && power & (power - 1) == 0) {
            let bits = power.trailing_zeros();
            if is_positive {
                return self.work.spelling.halved(&dividend, bits, wide);
            }
            return self.work.spelling.call("shift", wide, &[dividend, self.work.spelling.place(bits as usize)]);
        }
        let divisor_text = self.operand(b, wide);
        if is_positive && self.constant(b).is_some_and(|divisor| divisor > 0) {
            format!("{dividend} / {divisor_text}")
        } else {
            self.work.spelling.call("divide", wide, &[dividend, divisor_text])
        }
    }
}

/// A term of a sum.
struct Term {
    minus: bool,
    text: String,
    /// The greatest magnitude.
    magnitude: u64,
    /// [`Lines::narrow`].
    narrow: Option<String>,
}

/// Adds neighbours in 16 bits where these hold their sum: a core of 8 bits has half of the work, others the same as before.
fn in_16_bits(terms: &mut [Term]) {
    let mut rest = terms;
    while !rest.is_empty() {
        let mut most = 0;
        let fits = |term: &&Term| {
            most += term.magnitude;
            term.narrow.is_some() && !term.minus && most <= NARROW
        };
        let length = rest.iter().take_while(fits).count();
        let (group, others) = rest.split_at_mut(length.max(1));
        if length > 1 {
            for term in &mut *group {
                term.text = term.narrow.take().unwrap_or_default();
            }
            group[0].text.insert_str(0, "(int32_t)(");
            group[length - 1].text.push(')');
        }
        rest = others;
    }
}

/// Returns an expression without brackets around all of it.
fn bare(text: &str) -> &str {
    let is_whole = |inner: &&str| {
        let mut depth = 0;
        inner.chars().all(|letter| {
            depth += i32::from(letter == '(') - i32::from(letter == ')');
            depth >= 0
        })
    };
    text.strip_prefix('(').and_then(|text| text.strip_suffix(')')).filter(is_whole).unwrap_or(text)
}

fn is_sum(instruction: Instruction) -> bool {
    matches!(instruction, Add | Sub)
}
