//! Code that is executed over terms: what a reader of C and a decoder of machine code have in common.

use crate::elf::Address;
use crate::input::{Missing, Result};
use crate::term::{Bool, Float, Terms, Width, Word};
use crate::thumb::{FLAGS, Register};
use std::collections::{BTreeMap, BTreeSet};

/// So much is executed at most between two points.
const LONGEST: u64 = 1_000_000;

/// What a policy reads and answers: the names of the C interface's fields, in order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Interface {
    /// The sources with their lengths. Their values are the terms [`Terms::source`] from 0 on, one after another.
    pub sources: Vec<(String, u32)>,
    /// Names of the values of the memory; their terms follow those of the sources.
    pub memory: Vec<String>,
    /// Names of the outputs; none where the policy answers an action.
    pub outputs: Vec<String>,
    /// Of a policy in integers, the lowest and highest of each value of the state, and of the memory after it
    pub counts: Vec<[i128; 2]>,
    /// Of a policy in integers, the bytes of each source, of each value of the memory, and of each output
    pub bytes: Vec<u8>,
}

impl Interface {
    /// A value of the state, or of the memory behind it.
    pub(crate) fn value(&self, terms: &Terms, index: u32) -> Float {
        self.counts.get(index as usize).map_or_else(|| terms.source(index), |&range| terms.counted(index, range))
    }

    /// The number of values of the sources.
    #[must_use]
    pub fn state_length(&self) -> u32 {
        self.sources.iter().map(|(_, length)| length).sum()
    }
}

/// An answer of a policy.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Answer {
    /// The number of an action
    Action(Word),
    /// The outputs, and the next memory after them
    Values(Vec<Float>),
}

/// A step to the next point, or the end.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Step<Point> {
    /// Execution goes on there
    To(Point),
    /// The function returns
    Return(Answer),
}

/// The ways on from a point, each with its condition.
pub type Ways = Vec<(Bool, Step<Point>)>;

/// The contents of a cell: a number of 32 or 64 bits, as the integer or the float that it was computed as.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) enum Value {
    Word(Word),
    Float(Float),
}

impl Value {
    /// The bits of a number.
    pub(crate) fn bits(self, terms: &Terms) -> Word {
        match self {
            Self::Word(word) => word,
            Self::Float(float) if terms.is_whole(float) => {
                terms.word_of_whole(float).unwrap_or_else(|| terms.bits(terms.unknown()))
            }
            Self::Float(float) => terms.bits(float),
        }
    }

    /// The number of 32 bits as a float.
    pub(crate) fn float(self, terms: &Terms) -> Float {
        match self {
            Self::Word(word) => terms.of_bits(word),
            Self::Float(float) => float,
        }
    }

    /// The first where the condition holds, else the second.
    pub(crate) fn chosen(terms: &Terms, condition: Bool, a: Self, b: Self) -> Self {
        match (a, b) {
            _ if a == b => a,
            (Self::Float(a), Self::Float(b)) => Self::Float(terms.choose_float(condition, a, b)),
            _ => Self::Word(terms.choose_word(condition, a.bits(terms), b.bits(terms))),
        }
    }
}

/// Something with an address that is not known. What is in memory overlaps nothing else.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Region {
    /// The values of the state, which are only read
    State,
    /// The values of the memory
    Memory,
    /// The outputs
    Outputs,
    /// The stack below the place where the function began
    Stack,
    /// A section of the image
    Section(usize),
    /// The code behind a call
    Behind(Address),
    /// The lower half of an address alone
    Half(Address),
}

/// A variable of C, a register, or a place in memory with its bytes; places do not overlap.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Cell {
    /// A scalar by its number
    Variable(u32),
    /// A register of integers, floats or flags
    Register(Register),
    /// Bytes in a part of memory
    Memory(Region, u32, u8),
}

/// The contents of cells; those that are missing are unknown.
pub(crate) type Cells = BTreeMap<Cell, Value>;

/// The cells of the first where the condition holds, else those of the second.
pub(crate) fn merged(terms: &Terms, condition: Bool, a: &Cells, b: &Cells) -> Cells {
    let both = a.iter().filter_map(|(cell, &a)| Some((*cell, Value::chosen(terms, condition, a, *b.get(cell)?))));
    both.collect()
}

/// A place in the code with all that is known there.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Point {
    pub(crate) at: usize,
    pub(crate) cells: Cells,
}

/// The facts that are known on a way, and the condition under which it is taken.
#[derive(Clone, Debug)]
pub struct State {
    pub(crate) guard: Bool,
    pub(crate) cells: Cells,
}

impl State {
    /// The state where a condition holds, too; none if it cannot.
    pub(crate) fn under(&self, terms: &Terms, condition: Bool) -> Option<Self> {
        let guard = terms.and(self.guard, condition);
        (guard != Terms::FALSE).then(|| Self { guard, cells: self.cells.clone() })
    }

    /// One state of two whose conditions exclude each other.
    fn met(&self, terms: &Terms, other: &Self) -> Self {
        let cells = merged(terms, self.guard, &self.cells, &other.cells);
        Self { guard: terms.or(self.guard, other.guard), cells }
    }

    /// The points of a state at a place: where integers are chosen from constants, one for each choice.
    pub(crate) fn points(&self, terms: &Terms, at: usize) -> Vec<(Bool, Point)> {
        let mut points = vec![(self.guard, Point { at, cells: self.cells.clone() })];
        let plain = |(cell, value)| (!matches!(cell, &Cell::Register(FLAGS..))).then_some(value);
        let integers: BTreeSet<_> = self.cells.iter().filter_map(plain).collect();
        for &integer in integers {
            let Value::Word(word) = integer else { continue };
            let Some(numbers) = terms.numbers(word).filter(|numbers| numbers.len() > 1) else { continue };
            let mut split = Vec::new();
            for number in numbers {
                let constant = terms.number(number);
                let same = terms.same(Width::W32, word, constant);
                for (guard, point) in &points {
                    let (guard, mut point) = (terms.and(*guard, same), point.clone());
                    for found in point.cells.values_mut().filter(|found| **found == integer) {
                        *found = Value::Word(constant);
                    }
                    split.push((guard, point));
                }
            }
            points = split;
        }
        points.retain(|&(guard, _)| guard != Terms::FALSE);
        points
    }
}

/// The ways on from a place, each with what holds on it.
pub type Followers = Vec<(State, Step<usize>)>;

/// Code that can be executed piece by piece.
///
/// A point is a place in the code together with all values that are alive there, as terms. Where to cut is the machine's choice and
/// changes no result: the more paths meet at a point, with integers that are constants, the fewer pieces there are to look at. A
/// loop is cut or unrolled; its integers are constants.
pub trait Machine {
    /// The point at which the function begins.
    ///
    /// # Errors
    /// The part that cannot be executed.
    fn entry(&mut self, terms: &Terms) -> Result<Point>;

    /// Executes what is at a place. The conditions of the ways on exclude each other; the code lies in the order in which it is
    /// executed, but for loops.
    ///
    /// # Errors
    /// The part that cannot be executed.
    fn step(&mut self, terms: &Terms, at: usize, state: State) -> Result<Followers>;

    /// Tests whether paths may meet at a place.
    fn meets(&self, at: usize) -> bool;

    /// The points at which execution is cut where paths met; none if it goes on.
    fn cut(&mut self, terms: &Terms, at: usize, state: &mut State) -> Option<Vec<(Bool, Point)>>;

    /// A place, for people.
    fn place(&self, at: usize) -> String;

    /// Executes from a point. The conditions exclude each other, and one of them holds in every state that leads to the point.
    ///
    /// # Errors
    /// The part that cannot be executed.
    fn run(&mut self, terms: &Terms, from: &Point) -> Result<Ways> {
        let first = State { guard: Terms::TRUE, cells: from.cells.clone() };
        // in the order of the code, each time around a loop after the one before
        let mut pending = BTreeMap::from([((0, from.at), first)]);
        let (mut ways, mut count) = (Vec::new(), 0);
        while let Some(((round, mut at), mut state)) = pending.pop_first() {
            if count > 0
                && let Some(points) = self.cut(terms, at, &mut state)
            {
                ways.extend(points.into_iter().map(|(guard, point)| (guard, Step::To(point))));
                continue;
            }
            loop {
                count += 1;
                if count > LONGEST {
                    return Err(Missing::new(self.place(at), "a loop that ends soon"));
                }
                let mut next = self.step(terms, at, state)?;
                terms.complete(|| self.place(at))?;
                if let [(_, Step::To(to))] = next[..]
                    && to > at
                    && !self.meets(to)
                    && let Some((alone, _)) = next.pop()
                {
                    (at, state) = (to, alone);
                    continue;
                }
                for (state, step) in next {
                    let to = match step {
                        Step::To(to) => to,
                        Step::Return(answer) => {
                            ways.push((state.guard, Step::Return(answer)));
                            continue;
                        }
                    };
                    let place = (round + u64::from(to <= at), to);
                    let state = match pending.remove(&place) {
                        Some(other) => state.met(terms, &other),
                        None => state,
                    };
                    pending.insert(place, state);
                }
                break;
            }
        }
        Ok(ways)
    }
}
