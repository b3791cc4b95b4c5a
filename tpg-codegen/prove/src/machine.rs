//! Code that is executed over terms: what a reader of C and a decoder of machine code have in common.

use crate::input::Result;
use crate::term::{Bool, Float, Terms, Word};
use std::fmt::Debug;
use std::hash::Hash;

/// What a policy reads and answers: the names of the C interface's fields, in order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Interface {
    /// The sources with their lengths. Their values are the terms [`Terms::source`] from 0 on, one after another.
    pub sources: Vec<(String, u32)>,
    /// Names of the values of the memory; their terms follow those of the sources.
    pub memory: Vec<String>,
    /// Names of the outputs; none where the policy answers an action.
    pub outputs: Vec<String>,
}

impl Interface {
    /// The number of values of the sources.
    #[must_use]
    pub fn state_length(&self) -> u32 {
        self.sources.iter().map(|(_, length)| length).sum()
    }
}

/// An answer of a policy.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Answer {
    /// The number of an action
    Action(Word),
    /// The outputs, and the next memory after them
    Values(Vec<Float>),
}

/// A step to the next point, or the end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Step<Point> {
    /// Execution goes on there
    To(Point),
    /// The function returns
    Return(Answer),
}

/// The ways on from a point, each with its condition.
pub type Ways<Point> = Vec<(Bool, Step<Point>)>;

/// Code that can be executed piece by piece.
///
/// A point is a place in the code together with all values that are alive there, as terms. Where to cut is the machine's choice and
/// changes no result: the more paths meet at a point, with integers that are constants, the fewer pieces there are to look at. A
/// loop is cut or unrolled; its integers are constants.
pub trait Machine {
    /// A place in the code with its state.
    type Point: Clone + Eq + Hash + Debug;

    /// The point at which the function begins.
    ///
    /// # Errors
    /// What cannot be executed.
    fn entry(&mut self, terms: &Terms) -> Result<Self::Point>;

    /// Executes from a point. The conditions exclude each other, and one of them holds in every state that leads to the point.
    ///
    /// # Errors
    /// What cannot be executed.
    fn run(&mut self, terms: &Terms, from: &Self::Point) -> Result<Ways<Self::Point>>;

    /// The place of a point, for people.
    fn place(&self, point: &Self::Point) -> String;
}
