//! Arithmetic at compile time that is the target's, bit for bit.

use ScalarType::*;
use tpg_graph::{Graph, MathsProvider, ScalarType};
use tpg_runtime::ops::{Instruction, Maths, Own};
use tpg_runtime::scalar::Scalar;

/// The arithmetic of a graph: its scalar type and who computes its transcendental functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Arithmetic {
    /// The type programs compute in.
    pub scalar: ScalarType,
    /// The provider of the transcendental functions.
    pub maths: MathsProvider,
}

impl Arithmetic {
    /// The arithmetic of a graph.
    pub(crate) fn new(graph: &Graph) -> Self {
        Self { scalar: graph.scalar(), maths: graph.maths() }
    }

    /// The result of an instruction on constants, where the target is certain to compute the same.
    ///
    /// The arithmetic ones and comparisons are IEEE 754's and the own kernels are the same statements on every machine.
    /// The platform's libm is another one on another platform, so its calls stay, but for what the C standard (F.10)
    /// fixes: NaN, infinities, zeros, and the logarithm of one and of what is negative.
    pub(crate) fn evaluate(self, instruction: Instruction, a: f64, b: f64) -> Option<f64> {
        let is_the_platforms = instruction.is_transcendental() && self.maths == MathsProvider::System;
        (!is_the_platforms || is_fixed_by_the_standard(instruction, a)).then(|| self.exact(instruction, a, b))
    }

    /// The result of an instruction, of a transcendental one by the own kernels.
    pub(crate) fn exact(self, instruction: Instruction, a: f64, b: f64) -> f64 {
        match self.scalar {
            F32 => apply::<f32>(instruction, a, b),
            F64 => apply::<f64>(instruction, a, b),
        }
    }

    /// The greatest finite number.
    pub(crate) fn greatest(self) -> f64 {
        match self.scalar {
            F32 => f64::from(f32::MAX),
            F64 => f64::MAX,
        }
    }

    /// The reciprocal of `divisor`, if multiplying by it equals dividing bit for bit: for a power of two, both are the one
    /// correctly rounded result.
    pub(crate) fn reciprocal(self, divisor: f64) -> Option<f64> {
        let (power_of_two, reciprocal) = match self.scalar {
            F32 => {
                let narrow = divisor as f32;
                let inverse = 1.0 / narrow;
                let power = narrow.to_bits() & 0x007f_ffff == 0 && narrow.is_normal() && inverse.is_normal();
                (power, f64::from(inverse))
            }
            F64 => {
                let inverse = 1.0 / divisor;
                let power = divisor.to_bits() & 0x000f_ffff_ffff_ffff == 0 && divisor.is_normal();
                (power && inverse.is_normal(), inverse)
            }
        };
        power_of_two.then_some(reciprocal)
    }
}

fn is_fixed_by_the_standard(instruction: Instruction, a: f64) -> bool {
    // That an infinity's arctangent is π/2 leaves open how it is rounded.
    let always = a.is_nan() || a == 0.0 || (a.is_infinite() && instruction != Instruction::Atan);
    always || (instruction == Instruction::Ln && (a < 0.0 || a == 1.0))
}

/// Every provider has the same result for special values, so own maths stands for the platform's.
fn apply<S: Scalar>(instruction: Instruction, a: f64, b: f64) -> f64
where
    Own: Maths<S>,
{
    instruction.apply::<S, Own>(S::from_f64(a), S::from_f64(b)).to_f64()
}

#[cfg(test)]
mod tests {
    use super::Arithmetic;
    use tpg_graph::{MathsProvider, ScalarType};
    use tpg_runtime::ops::Instruction;

    const ALL: [Arithmetic; 4] = [
        Arithmetic { scalar: ScalarType::F32, maths: MathsProvider::Own },
        Arithmetic { scalar: ScalarType::F64, maths: MathsProvider::Own },
        Arithmetic { scalar: ScalarType::F32, maths: MathsProvider::System },
        Arithmetic { scalar: ScalarType::F64, maths: MathsProvider::System },
    ];

    #[test]
    fn what_the_standard_fixes_is_what_the_platform_computes() {
        let specials = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, -0.0, 1.0, -1.0, -7.5];
        type Function = fn(f64) -> f64;
        let functions: [(Instruction, Function); 7] = [
            (Instruction::Sin, f64::sin),
            (Instruction::Cos, f64::cos),
            (Instruction::Tan, f64::tan),
            (Instruction::Ln, f64::ln),
            (Instruction::Exp, f64::exp),
            (Instruction::Atan, f64::atan),
            (Instruction::Tanh, f64::tanh),
        ];
        let system = ALL[3];
        let mut folded = 0;
        for (instruction, function) in functions {
            for argument in specials {
                if let Some(result) = system.evaluate(instruction, argument, argument) {
                    let expected = function(argument);
                    let equal = result.to_bits() == expected.to_bits() || (result.is_nan() && expected.is_nan());
                    assert!(equal, "{instruction:?} {argument}: {result} but {expected}");
                    folded += 1;
                }
            }
        }
        assert_eq!(folded, 6 * 5 + 3 + 3, "five specials for each, three for atan, and ln of 1, -1 and -7.5");
    }

    #[test]
    fn calls_of_the_platform_on_ordinary_constants_stay() {
        assert_eq!(ALL[3].evaluate(Instruction::Sin, 0.5, 0.5), None);
        assert!(ALL[1].evaluate(Instruction::Sin, 0.5, 0.5).is_some(), "own kernels are certain");
    }

    #[test]
    fn f32_rounds_to_f32() {
        assert_eq!(ALL[0].exact(Instruction::Add, 16_777_216.0, 1.0), 16_777_216.0);
        assert_eq!(ALL[1].exact(Instruction::Add, 16_777_216.0, 1.0), 16_777_217.0);
    }

    #[test]
    fn only_powers_of_two_have_a_reciprocal_that_divides() {
        for arithmetic in ALL {
            assert_eq!(arithmetic.reciprocal(4.0), Some(0.25));
            assert_eq!(arithmetic.reciprocal(-0.5), Some(-2.0));
            for other in [0.0, -0.0, 3.0, f64::INFINITY, f64::NAN, 1e-310] {
                assert_eq!(arithmetic.reciprocal(other), None, "{other}");
            }
        }
        assert_eq!(ALL[0].reciprocal(2_f64.powi(127)), None, "the reciprocal would be subnormal");
    }
}
