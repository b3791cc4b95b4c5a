//! Functions of own maths as terms: those that the file `own_maths.c` computes.

use crate::c;
use crate::input::Result;
use crate::term::{Float, Terms};
use std::collections::HashMap;

/// The definition.
const TEXT: &str = include_str!("own_maths.c");

/// A function of one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Function {
    Sin,
    Cos,
    Tan,
    Ln,
    Exp,
}

impl Function {
    /// The function that a word of graphs names.
    pub(crate) fn named(word: &str) -> Option<Self> {
        match word {
            "sin" => Some(Self::Sin),
            "cos" => Some(Self::Cos),
            "tan" => Some(Self::Tan),
            "ln" => Some(Self::Ln),
            "exp" => Some(Self::Exp),
            _ => None,
        }
    }

    const fn name(self) -> &'static str {
        match self {
            Self::Sin => "own_sin",
            Self::Cos => "own_cos",
            Self::Tan => "own_tan",
            Self::Ln => "own_ln",
            Self::Exp => "own_exp",
        }
    }
}

/// Functions of terms of one table.
#[derive(Debug, Default)]
pub(crate) struct Maths {
    known: HashMap<(Function, Float), Float>,
}

impl Maths {
    /// A function of a term.
    pub(crate) fn apply(&mut self, terms: &Terms, function: Function, argument: Float) -> Result<Float> {
        if let Some(&known) = self.known.get(&(function, argument)) {
            return Ok(known);
        }
        let result = c::definition("own_maths.c", TEXT, function.name(), terms, argument)?;
        self.known.insert((function, argument), result);
        Ok(result)
    }
}

#[cfg(test)]
mod tests {
    use super::{Function, Maths};
    use crate::term::Terms;

    #[test]
    fn constants_have_constant_results() {
        let terms = Terms::new();
        let mut maths = Maths::default();
        for (function, argument, expected, error) in [
            (Function::Sin, 1.0f32, 1.0f64.sin(), 1e-6),
            (Function::Cos, 100.0, 100.0f64.cos(), 1e-6),
            (Function::Tan, -0.5, (-0.5f64).tan(), 1e-6),
            (Function::Ln, 10.0, 10.0f64.ln(), 1e-6),
            (Function::Exp, -3.5, (-3.5f64).exp(), 1e-6),
        ] {
            let argument = terms.constant(argument);
            let result = maths.apply(&terms, function, argument).expect("the definition is read");
            let bits = terms.bits_of(result).expect("a constant");
            assert!((f64::from(f32::from_bits(bits)) - expected).abs() <= error * expected.abs(), "{function:?}");
        }
    }
}
