//! Executes operations over terms. Paths that meet become one; integers that decide where control goes are constants.

use super::code::{Operation, Program};
use super::value::Here;
use crate::code::{Found, Kind, holds};
use crate::input::{Missing, Result};
use crate::machine::{Answer, Cell, Cells, Followers, Interface, Machine, Point, State, Step, Value};
use crate::term::{Bool, Float, Terms};
use std::collections::BTreeSet;

/// A function of C, ready to be executed.
#[derive(Debug)]
pub struct Code {
    file: String,
    program: Program,
    interface: Interface,
    /// Where jumps go, and where execution may be cut
    joins: BTreeSet<usize>,
    /// The cells at first
    first: Cells,
}

impl Code {
    pub(super) fn new(file: &str, program: Program, interface: &Interface) -> Self {
        let targets = program.operations.iter().filter_map(|(_, operation)| match operation {
            Operation::Branch(_, to) | Operation::Jump(to, _) => Some(*to),
            _ => None,
        });
        let joins = targets.chain(program.heads.keys().copied()).collect();
        let (file, interface) = (file.to_owned(), interface.clone());
        Self { file, program, interface, joins, first: Cells::new() }
    }

    /// The result for a float as the only input.
    pub(super) fn of_float(&mut self, terms: &Terms, argument: Float) -> Result<Float> {
        let start =
            Point { at: 0, cells: Cells::from([(Cell::Variable(self.program.inputs[0]), Value::Float(argument))]) };
        let mut result = None;
        for (guard, step) in self.run(terms, &start)? {
            let Step::Return(Answer::Values(values)) = step else { break };
            result = Some(result.map_or(values[0], |other| terms.choose_float(guard, values[0], other)));
        }
        result.ok_or_else(|| Missing::new(&*self.file, "a definition in one piece"))
    }

    fn leave(&self, scope: usize, cells: &mut Cells) {
        let (start, end) = self.program.scopes[scope];
        cells.retain(|&cell, _| !(Cell::Variable(start)..Cell::Variable(end)).contains(&cell));
    }

    /// Executes an operation; where it goes if that is not behind it.
    fn executed(&self, terms: &Terms, at: usize, mut state: State) -> Found<Followers> {
        let facts = terms.parts(state.guard);
        let here = Here { program: &self.program, terms, cells: &state.cells, facts: &facts };
        match &self.program.operations[at].1 {
            Operation::Set(address, value, is_float) => {
                let (address, value) = (here.word(address)?, here.value(value)?);
                let value = match value {
                    Value::Float(number) if terms.is_whole(number) => value,
                    value if *is_float => Value::Float(value.float(terms)),
                    value => Value::Word(value.bits(terms)),
                };
                let address = terms.number_of(address).and_then(|address| u32::try_from(address).ok());
                let variable = address.filter(|&address| address < self.program.cells);
                let variable = variable.ok_or("a place to write to that is a constant")?;
                let length = self.program.inputs.len() - self.interface.memory.len();
                if self.program.inputs[..length].contains(&variable) {
                    return Err("a state that code does not change");
                }
                state.cells.insert(Cell::Variable(variable), value);
            }
            Operation::Leave(scope) => self.leave(*scope, &mut state.cells),
            Operation::Branch(condition, otherwise) => {
                let condition = holds(terms, here.value(condition)?);
                let ways = [(condition, at + 1), (!condition, *otherwise)];
                let ways = ways.into_iter().filter_map(|(held, to)| Some((state.under(terms, held)?, Step::To(to))));
                return Ok(ways.collect());
            }
            Operation::Jump(to, left) => {
                for &scope in left {
                    self.leave(scope, &mut state.cells);
                }
                return Ok(vec![(state, Step::To(*to))]);
            }
            Operation::Return => {
                let answers = &self.program.answers;
                let answer = if self.interface.outputs.is_empty() {
                    Answer::Action(here.cell(answers[0].into())?.bits(terms))
                } else {
                    let answer = |value: Value| match self.interface.counts[..] {
                        [] => Ok(value.float(terms)),
                        _ => Kind { bytes: 4, signed: true, exact: true }.whole(terms, value),
                    };
                    let values = answers.iter().map(|&address| answer(here.cell(address.into())?));
                    Answer::Values(values.collect::<Found<_>>()?)
                };
                return Ok(vec![(state, Step::Return(answer))]);
            }
        }
        Ok(vec![(state, Step::To(at + 1))])
    }
}

impl Machine for Code {
    fn entry(&mut self, terms: &Terms) -> Result<Point> {
        let inputs = (0..).zip(&self.program.inputs);
        let value = |index| Value::Float(self.interface.value(terms, index));
        self.first = inputs.map(|(index, &address)| (Cell::Variable(address), value(index))).collect();
        Ok(Point { at: 0, cells: self.first.clone() })
    }

    fn step(&mut self, terms: &Terms, at: usize, state: State) -> Result<Followers> {
        self.executed(terms, at, state).map_err(|what| Missing::new(self.place(at), what))
    }

    fn meets(&self, at: usize) -> bool {
        self.joins.contains(&at)
    }

    /// Cuts at labels, and where nothing is being computed.
    fn cut(&mut self, terms: &Terms, at: usize, state: &mut State) -> Option<Vec<(Bool, Point)>> {
        let also_alive = *self.program.heads.get(&at)?;
        let is_aggregate = |cell: &Cell| matches!(*cell, Cell::Variable(address) if self.program.is_aggregate(address));
        let mut new = state.cells.iter().filter(|(cell, value)| self.first.get(cell) != Some(value));
        let idle = new.all(|(cell, value)| !matches!(value, Value::Float(_)) || is_aggregate(cell));
        (idle || also_alive).then(|| state.points(terms, at))
    }

    fn place(&self, at: usize) -> String {
        format!("{}:{}", self.file, self.program.operations.get(at).map_or(0, |&(line, _)| line))
    }
}
