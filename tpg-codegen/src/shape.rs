//! The shape of code: what the text is made of.

use crate::integers::Integers;
use crate::passes::bytecode::Bytecode;
use crate::passes::cases::Cases;
use crate::passes::schedule::Schedule;

/// The shape of code, with the results of its passes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Shape {
    /// See [`Profile::Fast`].
    Fast(Schedule),
    /// See [`Profile::Balanced`].
    Balanced(Cases),
    /// Tables and an evaluator: [`Profile::Small`], unless another shape of a small graph is less.
    Small(Bytecode),
    /// See [`Profile::ConstantTime`].
    ConstantTime,
    /// Nothing to decide: the outputs of the only leaf. In any profile; without a branch for [`Profile::ConstantTime`].
    Formula,
    /// See [`Style::Gegelati`].
    Gegelati,
    /// See [`integers`](crate::integers).
    Integers(Integers),
}
