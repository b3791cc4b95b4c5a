//! Functions of own maths as terms: those that the file `own_maths.c` computes.

use crate::c;
use crate::input::Result;
use crate::term::{Float, Terms};
use std::collections::HashMap;
use std::f32::consts::FRAC_PI_2;

/// The definition.
const TEXT: &str = include_str!("own_maths.c");

/// The words of graphs for functions of one number.
pub(crate) const WORDS: [&str; 7] = ["sin", "cos", "tan", "ln", "exp", "atan", "tanh"];

/// Words for functions with the number that no magnitude of theirs is above.
pub(crate) const LIMITS: [(&str, f32); 4] = [("sin", 1.0), ("cos", 1.0), ("tanh", 1.0), ("atan", FRAC_PI_2)];

/// Words for functions with two numbers: up to the first, all of their values are below the second.
pub(crate) const STEPS: [(&str, f32, f32); 2] = [("exp", 2.0, 7.5), ("ln", 8000.0, 9.0)];

/// Functions of terms of one table.
#[derive(Debug, Default)]
pub(crate) struct Maths {
    known: HashMap<(&'static str, Float), Float>,
}

impl Maths {
    /// The function that a word of graphs names, of a term.
    pub(crate) fn apply(&mut self, terms: &Terms, word: &'static str, argument: Float) -> Result<Float> {
        if let Some(&known) = self.known.get(&(word, argument)) {
            return Ok(known);
        }
        if word == "tan" {
            // which is made of them
            self.apply(terms, "sin", argument)?;
            self.apply(terms, "cos", argument)?;
        }
        let definition = c::definition("own_maths.c", TEXT, &format!("own_{word}_of"), terms, argument)?;
        let result = terms.named(word, argument, definition);
        self.known.insert((word, argument), result);
        Ok(result)
    }
}

#[cfg(test)]
mod tests {
    use super::Maths;
    use crate::term::Terms;

    #[test]
    fn constants_have_constant_results() {
        let terms = Terms::new();
        let mut maths = Maths::default();
        for (function, argument, expected, error) in [
            ("sin", 1.0f32, 1.0f64.sin(), 1e-6),
            ("cos", 100.0, 100.0f64.cos(), 1e-6),
            ("tan", -0.5, (-0.5f64).tan(), 1e-6),
            ("ln", 10.0, 10.0f64.ln(), 1e-6),
            ("exp", -3.5, (-3.5f64).exp(), 1e-6),
            ("atan", -0.5, (-0.5f64).atan(), 1e-6),
            ("tanh", 2.0, 2.0f64.tanh(), 1e-6),
        ] {
            let argument = terms.constant(argument);
            let result = maths.apply(&terms, function, argument).expect("the definition is read");
            let bits = terms.bits_of(result).expect("a constant");
            assert!((f64::from(f32::from_bits(bits)) - expected).abs() <= error * expected.abs(), "{function}");
        }
    }
}
