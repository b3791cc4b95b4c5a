//! Functions of own maths as terms: those that the file `own_maths.c` computes.

use crate::c;
use crate::input::Result;
use crate::term::{Float, Terms};
use std::collections::HashMap;

/// The definition.
const TEXT: &str = include_str!("own_maths.c");

/// The words of graphs for functions of one number.
pub(crate) const WORDS: [&str; 5] = ["sin", "cos", "tan", "ln", "exp"];

/// Functions of terms of one table.
#[derive(Debug, Default)]
pub(crate) struct Maths {
    known: HashMap<(String, Float), Float>,
}

impl Maths {
    /// The function that a word of graphs names, of a term.
    pub(crate) fn apply(&mut self, terms: &Terms, word: &str, argument: Float) -> Result<Float> {
        let key = (word.to_owned(), argument);
        if let Some(&known) = self.known.get(&key) {
            return Ok(known);
        }
        let result = c::definition("own_maths.c", TEXT, &format!("own_{word}_of"), terms, argument)?;
        self.known.insert(key, result);
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
        ] {
            let argument = terms.constant(argument);
            let result = maths.apply(&terms, function, argument).expect("the definition is read");
            let bits = terms.bits_of(result).expect("a constant");
            assert!((f64::from(f32::from_bits(bits)) - expected).abs() <= error * expected.abs(), "{function}");
        }
    }
}
