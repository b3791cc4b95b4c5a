//! Functions of own maths as terms.

use crate::machine::Missing;
use crate::term::{Float, Terms};

/// A function of one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Function {
    /// `sin`
    Sin,
}

impl Function {
    /// The function that a word of graphs names.
    pub(crate) fn named(word: &str) -> Option<Self> {
        (word == "sin").then_some(Self::Sin)
    }
}

/// Functions as terms.
#[derive(Debug, Default)]
pub(crate) struct Maths;

impl Maths {
    /// A function of a term.
    pub(crate) fn apply(&mut self, _: &mut Terms, _: Function, _: Float) -> Result<Float, Missing> {
        Err(Missing::new("graph", "own maths"))
    }
}
