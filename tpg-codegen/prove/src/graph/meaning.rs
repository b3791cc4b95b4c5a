//! The meaning of a graph as terms, declaratively: an edge wins if no earlier bid is higher and no later one is as high.

use super::{Destination, Graph, GraphLine, GraphOperand};
use crate::input::{Missing, Result};
use crate::maths::{Maths, WORDS};
use crate::term::{Bool, Float, Terms};
use std::collections::HashMap;

/// A graph's meaning in a table of terms.
#[derive(Debug)]
pub struct Meaning<'g> {
    graph: &'g Graph,
    maths: Maths,
    programs: HashMap<usize, Float>,
    teams: HashMap<usize, Vec<(Bool, Destination)>>,
}

impl<'g> Meaning<'g> {
    /// The meaning of a graph; terms are made when they are asked for.
    #[must_use]
    pub fn new(graph: &'g Graph) -> Self {
        Self { graph, maths: Maths::default(), programs: HashMap::new(), teams: HashMap::new() }
    }

    /// Gives the functions of all programs their names, before code computes them. What has no meaning is told where a team needs it.
    pub(crate) fn functions(&mut self, terms: &Terms) {
        for (program, lines) in self.graph.programs.iter().enumerate() {
            if lines.iter().any(|line| own(&line.word).is_some()) {
                let _ = self.program(terms, program);
            }
        }
    }

    /// The result of a program: its lines in order, on registers that are zero at first.
    fn program(&mut self, terms: &Terms, program: usize) -> Result<Float> {
        if let Some(&known) = self.programs.get(&program) {
            return Ok(known);
        }
        let mut registers = vec![self.graph.constant(terms, 0.0); self.graph.registers];
        for line in &self.graph.programs[program] {
            let operands: Vec<_> = (line.operands.iter())
                .map(|&operand| match operand {
                    GraphOperand::Register(register) => registers[register],
                    GraphOperand::Source(index) => self.graph.interface.value(terms, index),
                    GraphOperand::Constant(value) => self.graph.constant(terms, value),
                })
                .collect();
            registers[line.to] = self.line(terms, line, registers[line.to], &operands)?;
        }
        self.programs.insert(program, registers[0]);
        Ok(registers[0])
    }

    /// A line's result; `to` is what its register holds before.
    fn line(&mut self, terms: &Terms, line: &GraphLine, to: Float, operands: &[Float]) -> Result<Float> {
        let constant = |value| self.graph.constant(terms, value);
        let is_whole = self.graph.is_whole();
        let result = match (line.word.as_str(), operands) {
            ("add", &[a, b]) => terms.add(a, b),
            ("sub", &[a, b]) => terms.subtract(a, b),
            ("mul", &[a, b]) => terms.multiply(a, b),
            ("div", &[a, b]) if !is_whole => terms.divide(a, b),
            ("fmod", &[_, b]) if is_whole && terms.equal(b, constant(0.0)) != Terms::FALSE => {
                return Err(Missing::new("graph", "a remainder by what is never 0"));
            }
            ("fmod", &[a, b]) => terms.remainder(a, b),
            ("quotient", &[a, b]) if is_whole => {
                let [zero, most, least, lowest] =
                    [0, i32::MAX, -i32::MAX, i32::MIN].map(|value| constant(value.into()));
                let by_zero = terms.choose_float(terms.less(a, zero), least, lowest);
                let by_zero = terms.choose_float(terms.less(zero, a), most, by_zero);
                terms.choose_float(terms.equal(b, zero), by_zero, terms.rounded_down(a, b))
            }
            ("multiply_add", &[a, b]) => terms.add(to, terms.multiply(a, b)),
            ("negate_if_less", &[a, b]) => terms.choose_float(terms.less(a, b), terms.negate(a), a),
            ("min", &[a, b]) | ("std_min", &[b, a]) => terms.minimum(a, b),
            ("max", &[a, b]) | ("std_max", &[b, a]) => terms.maximum(a, b),
            ("gate", &[a, b]) => terms.choose_float(terms.equal(b, constant(0.0)), constant(-0.0), a),
            ("copy", &[a]) => a,
            ("abs", &[a]) => terms.magnitude(a),
            ("sqrt", &[a]) if !is_whole => terms.root(a),
            (word, &[a])
                if self.graph.own_maths
                    && !is_whole
                    && let Some(function) = own(word) =>
            {
                self.maths.apply(terms, function, a)?
            }
            (word, _) => {
                let whose = if own(word).is_some() && !self.graph.own_maths { "platform's" } else { "word" };
                let of = if is_whole { " of whole numbers" } else { "" };
                return Err(Missing::new("graph", format!("the meaning of the {whose} `{word}`{of}")));
            }
        };
        Ok(result)
    }

    /// The conditions under which each edge of a team wins. They exclude each other, and one of them always holds.
    ///
    /// # Errors
    /// A word without a meaning.
    pub fn winners(&mut self, terms: &Terms, team: usize) -> Result<Vec<(Bool, Destination)>> {
        if let Some(known) = self.teams.get(&team) {
            return Ok(known.clone());
        }
        let edges = &self.graph.teams[team].edges;
        let mut bids = Vec::new();
        for edge in edges {
            bids.push(self.program(terms, edge.program)?);
        }
        let mut winners: Vec<(Bool, Destination)> = Vec::new();
        for (at, edge) in edges.iter().enumerate() {
            let mut conditions = Vec::new();
            for (other, &bid) in bids.iter().enumerate() {
                if other < at {
                    conditions.push(as_high(terms, bids[at], bid));
                } else if other > at {
                    conditions.push(!as_high(terms, bid, bids[at]));
                }
            }
            winners.push((terms.all(conditions), edge.to));
        }
        self.teams.insert(team, winners.clone());
        Ok(winners)
    }

    /// The values that a leaf answers, limited to their ranges: the outputs, then the next memory.
    ///
    /// # Errors
    /// A word without a meaning.
    pub fn values(&mut self, terms: &Terms, leaf: usize) -> Result<Vec<Float>> {
        let mut values = Vec::new();
        for (&program, &limits) in self.graph.leaves[leaf].iter().zip(&self.graph.limits) {
            let value = self.program(terms, program)?;
            let limits = limits.map(|limit| self.graph.constant(terms, limit));
            values.push(terms.clamp(value, limits));
        }
        Ok(values)
    }

    /// The conditions under which a leaf's values are numbers in their ranges.
    ///
    /// # Errors
    /// A word without a meaning.
    pub fn in_range(&mut self, terms: &Terms, leaf: usize) -> Result<Bool> {
        let mut conditions = Vec::new();
        for (value, [low, high, _]) in self.values(terms, leaf)?.into_iter().zip(self.graph.limits.clone()) {
            let [low, high] = [low, high].map(|end| self.graph.constant(terms, end));
            conditions.extend([terms.less_or_equal(low, value), terms.less_or_equal(value, high)]);
        }
        Ok(terms.all(conditions))
    }
}

/// The name of a function of own maths.
fn own(word: &str) -> Option<&'static str> {
    WORDS.into_iter().find(|&own| own == word)
}

/// Tests whether bid `a` is as high as bid `b`; a NaN counts as minus infinity.
fn as_high(terms: &Terms, a: Float, b: Float) -> Bool {
    let (higher, nan) = (terms.at_most(b, a), terms.is_nan(a));
    if nan == Terms::FALSE {
        return higher;
    }
    terms.or(higher, terms.and(nan, terms.at_most(b, terms.constant(f32::NEG_INFINITY))))
}
