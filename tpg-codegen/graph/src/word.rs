//! The words that lines of programs are written in.

use tpg_runtime::ops::Instruction;

/// A word of a program line: an instruction, or a few of them written as one line.
///
/// Back ends and the trainer's engine know instructions only; [`compose`](Self::compose) is how they read a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Word {
    /// One instruction.
    Instruction(Instruction),
    /// `a` itself.
    Copy,
    /// `to + a · b`, where `to` is the line's destination: a product and a sum, each rounded, never fused.
    MultiplyAdd,
    /// `std::min(a, b)` of C++, which GEGELATI's programs use: `b` where `b < a`, else `a`. A NaN on either side gives `a`.
    StdMin,
    /// `std::max(a, b)` of C++, which GEGELATI's programs use: `b` where `a < b`, else `a`. A NaN on either side gives `a`.
    StdMax,
}

impl Word {
    /// Every word: the instructions in their order, then the others.
    pub const ALL: [Self; Instruction::ALL.len() + 4] = {
        let mut all = [Self::MultiplyAdd; Instruction::ALL.len() + 4];
        let mut place = 0;
        while place < Instruction::ALL.len() {
            all[place] = Self::Instruction(Instruction::ALL[place]);
            place += 1;
        }
        all[place + 1] = Self::StdMin;
        all[place + 2] = Self::StdMax;
        all[place + 3] = Self::Copy;
        all
    };

    /// Returns the name in `graph.json`, in sidecars, in configurations and in messages.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Instruction(instruction) => instruction.name(),
            Self::Copy => "copy",
            Self::MultiplyAdd => "multiply_add",
            Self::StdMin => "std_min",
            Self::StdMax => "std_max",
        }
    }

    /// Returns the word of that [`name`](Self::name).
    ///
    /// ```
    /// use tpg_graph::Word;
    /// use tpg_runtime::ops::Instruction;
    ///
    /// assert_eq!(Word::from_name("multiply_add"), Some(Word::MultiplyAdd));
    /// assert_eq!(Word::from_name("add"), Some(Word::Instruction(Instruction::Add)));
    /// assert_eq!(Word::from_name("plus"), None);
    /// ```
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|word| word.name() == name)
    }

    /// Returns the number of operands that a line gives it: 1 or 2. With 1, the second operand is ignored.
    pub const fn arity(self) -> usize {
        match self {
            Self::Instruction(instruction) => instruction.arity(),
            Self::Copy => 1,
            Self::MultiplyAdd | Self::StdMin | Self::StdMax => 2,
        }
    }

    /// Tests for a word that also reads the register it writes.
    pub const fn reads_destination(self) -> bool {
        matches!(self, Self::MultiplyAdd)
    }

    /// Returns the number of instructions that the word stands for.
    pub fn instructions(self) -> usize {
        let mut count = 0;
        self.compose((), [(), ()], |_, _| count += 1);
        count
    }

    /// Composes the word of its instructions: `apply` computes one of them, or adds it to a program under construction.
    ///
    /// `to` is the value of the destination before the line; only a word that
    /// [reads its destination](Self::reads_destination) uses it.
    ///
    /// ```
    /// use tpg_graph::Word;
    /// use tpg_runtime::ops::Own;
    ///
    /// let apply = |instruction: tpg_runtime::ops::Instruction, [a, b]: [f32; 2]| instruction.apply::<f32, Own>(a, b);
    /// assert_eq!(Word::MultiplyAdd.compose(1.0, [2.0, 3.0], apply), 7.0);
    /// assert_eq!(Word::StdMax.compose(0.0, [1.0, f32::NAN], apply), 1.0);
    /// ```
    #[inline]
    pub fn compose<T>(self, to: T, [a, b]: [T; 2], mut apply: impl FnMut(Instruction, [T; 2]) -> T) -> T {
        match self {
            Self::Instruction(instruction) => apply(instruction, [a, b]),
            Self::Copy => a,
            Self::MultiplyAdd => {
                let product = apply(Instruction::Mul, [a, b]);
                apply(Instruction::Add, [to, product])
            }
            Self::StdMin => apply(Instruction::Min, [b, a]),
            Self::StdMax => apply(Instruction::Max, [b, a]),
        }
    }
}

impl From<Instruction> for Word {
    fn from(instruction: Instruction) -> Self {
        Self::Instruction(instruction)
    }
}

#[cfg(test)]
mod tests {
    use super::Word;
    use tpg_runtime::ops::{Instruction, Own};

    /// The two functions as the C++ standard defines them, literally.
    #[test]
    fn std_min_and_max_are_those_of_cpp_for_nan_and_signed_zeros_too() {
        let values = [f64::NAN, f64::NEG_INFINITY, -1.5, -0.0, 0.0, 2.0, f64::INFINITY];
        let apply = |instruction: Instruction, [a, b]: [f64; 2]| instruction.apply::<f64, Own>(a, b);
        for a in values {
            for b in values {
                let minimum = if b < a { b } else { a };
                let maximum = if a < b { b } else { a };
                assert_eq!(Word::StdMin.compose(9.0, [a, b], apply).to_bits(), minimum.to_bits(), "{a} {b}");
                assert_eq!(Word::StdMax.compose(9.0, [a, b], apply).to_bits(), maximum.to_bits(), "{a} {b}");
            }
        }
    }

    #[test]
    fn a_product_is_rounded_before_it_is_added() {
        let apply = |instruction: Instruction, [a, b]: [f32; 2]| instruction.apply::<f32, Own>(a, b);
        let (a, to) = (1.0 + f32::EPSILON, -1.0 - 2.0 * f32::EPSILON);
        assert_eq!(Word::MultiplyAdd.compose(to, [a, a], apply), 0.0, "fused, it would be ε²");
    }

    #[test]
    fn every_word_has_a_name_of_its_own() {
        for word in Word::ALL {
            assert_eq!(Word::from_name(word.name()), Some(word));
        }
    }
}
