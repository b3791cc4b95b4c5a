//! Cheap estimates of exponentials and logarithms, from the bits of a number: those of `x`, read as an integer, are a
//! straight line between powers of two through `log2(x)`. That is never more than 0.0861 below the logarithm, and, the other
//! way round, never below the exponential and at most 6.2 % above it. So a test of two operations says which of two
//! exponentials is greater, wherever they are not that near, and neither is computed.
//!
//! An estimate that is NaN says nothing. It is NaN wherever the function is.

use ScalarType::*;
use tpg_graph::ScalarType;

/// The numbers that estimates are made with, in a scalar type. All are exact in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Estimate {
    /// Between these, an exponential is estimated from bits. Above, it nears infinity, below 0.
    pub exp_between: (f64, f64),
    /// Bits of a number are about this, times its logarithm …
    pub exp_scale: f64,
    /// … and this, the bits of 1 and a little more than any rounding and any provider is off.
    pub exp_offset: u64,
    /// No exponential of what is below the range is above this.
    pub exp_below: f64,
    /// Above this, every provider's exponential is infinite.
    pub exp_infinite_above: f64,
    /// The logarithm of a number is about this, times its bits …
    pub ln_scale: f64,
    /// … less this.
    pub ln_offset: f64,
}

/// A logarithm is at least its estimate, less this.
pub(crate) const LN_LESS: f64 = 0.0625;

/// The numbers of a scalar type.
pub(crate) const fn numbers(scalar: ScalarType) -> Estimate {
    match scalar {
        F32 => Estimate {
            exp_between: (-87.0, 88.0),
            exp_scale: 12102203.0,
            exp_offset: 0x3f80_0800,
            exp_below: 1e-37_f32 as f64,
            exp_infinite_above: 90.0,
            ln_scale: 8.262958e-8_f32 as f64,
            ln_offset: 87.96973_f32 as f64,
        },
        F64 => Estimate {
            exp_between: (-708.0, 709.0),
            exp_scale: 6497320848556798.0,
            exp_offset: 0x3ff0_0000_2000_0000,
            exp_below: 1e-307,
            exp_infinite_above: 710.0,
            ln_scale: 1.539095918623324e-16,
            ln_offset: 709.0296084817056,
        },
    }
}

#[cfg(test)]
mod tests {
    use super::LN_LESS;
    use crate::passes::tests::upper;
    use tpg_graph::ScalarType;
    use tpg_runtime::ops::{Instruction, Maths, Own, System};
    use tpg_runtime::scalar::Scalar;

    /// The estimate is not below the result, and what is made of it not above, rounded as generated code rounds.
    fn assert_around<S: Scalar, M: Maths<S>>(scalar: ScalarType, instruction: Instruction, argument: S) {
        let result = instruction.apply::<S, M>(argument, argument).to_f64();
        let above = upper(scalar, instruction, argument.to_f64());
        let below = if instruction == Instruction::Ln { scalar.round(above - LN_LESS) } else { f64::NAN };
        if result.is_nan() {
            assert!(below.is_nan() || below == f64::NEG_INFINITY, "{instruction:?} {argument:?}: {below}");
            return;
        }
        assert!(result <= above || above.is_nan(), "{instruction:?} {argument:?} is {result}, above {above}");
        assert!(result >= below || below.is_nan(), "{instruction:?} {argument:?} is {result}, below {below}");
    }

    fn everywhere(argument: f32) {
        for instruction in [Instruction::Ln, Instruction::Exp] {
            assert_around::<f32, Own>(ScalarType::F32, instruction, argument);
            assert_around::<f32, System>(ScalarType::F32, instruction, argument);
            let argument = f64::from(argument);
            assert_around::<f64, Own>(ScalarType::F64, instruction, argument);
            assert_around::<f64, System>(ScalarType::F64, instruction, argument);
        }
    }

    #[test]
    fn estimates_are_on_their_side_of_every_provider() {
        // Every 1024th number there is in f32, infinities and NaN among them.
        for bits in (0..=u32::MAX >> 10).map(|upper| upper << 10).chain([f32::MAX.to_bits(), 1]) {
            everywhere(f32::from_bits(bits));
        }
        // Around powers of two, where the line meets the curve.
        for power in -1020..=1020 {
            for ulps in -3_i64..=3 {
                let near = |x: f64| f64::from_bits((x.to_bits() as i64 + ulps) as u64);
                let argument = f64::from(power) * std::f64::consts::LN_2;
                assert_around::<f64, System>(ScalarType::F64, Instruction::Exp, near(argument));
                assert_around::<f64, System>(ScalarType::F64, Instruction::Ln, near(2.0_f64.powi(power)));
                everywhere(near(argument) as f32);
                everywhere(near(2.0_f64.powi(power)) as f32);
            }
        }
        // Where an exponential comes near infinity, and near 0.
        for place in 0..40_000 {
            let step = f64::from(place) * 0.0001;
            for argument in [707.5 + step, -707.5 - step] {
                assert_around::<f64, System>(ScalarType::F64, Instruction::Exp, argument);
                assert_around::<f64, Own>(ScalarType::F64, Instruction::Exp, argument);
            }
            everywhere((86.5 + step) as f32);
            everywhere((-86.5 - step) as f32);
        }
    }

    #[test]
    fn estimates_are_near() {
        for argument in [-50.0, -1.0, 0.0, 0.3, 1.0, 20.0, 80.0] {
            for scalar in [ScalarType::F32, ScalarType::F64] {
                assert!(upper(scalar, Instruction::Exp, argument) <= argument.exp() * 1.062, "{scalar:?} {argument}");
            }
        }
        for argument in [1e-30, 0.5, 1.0, 3.0, 4095.0, 1e30] {
            for scalar in [ScalarType::F32, ScalarType::F64] {
                let argument = scalar.round(argument);
                assert!(upper(scalar, Instruction::Ln, argument) <= argument.ln() + 0.061, "{scalar:?} {argument}");
            }
        }
    }
}
