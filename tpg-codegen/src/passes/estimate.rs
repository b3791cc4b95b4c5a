//! Cheap estimates of exponentials and logarithms, from the bits of a number: those of `x`, read as an integer, are a
//! straight line between powers of two through `log2(x)`. That is never more than 0.0861 below the logarithm, and, the other
//! way round, never below the exponential and at most 6.2 % above it. So a test of two operations says which of two
//! exponentials is greater, wherever they are not that near, and neither is computed.
//!
//! An estimate that is NaN says nothing. It is NaN wherever the function is. In `f32` there are none: code without them is proven.

/// Between these, an exponential is estimated from bits. Above, it nears infinity, below 0.
pub(crate) const EXP_BETWEEN: (f64, f64) = (-708.0, 709.0);
/// Bits of a number are about this, times its logarithm …
pub(crate) const EXP_SCALE: f64 = 6497320848556798.0;
/// … and this, the bits of 1 and a little more than any rounding and any provider is off.
pub(crate) const EXP_OFFSET: u64 = 0x3ff0_0000_2000_0000;
/// No exponential of what is below the range is above this.
pub(crate) const EXP_BELOW: f64 = 1e-307;
/// Above this, every provider's exponential is infinite.
pub(crate) const EXP_INFINITE_ABOVE: f64 = 710.0;
/// The logarithm of a number is about this, times its bits …
pub(crate) const LN_SCALE: f64 = 1.539095918623324e-16;
/// … less this.
pub(crate) const LN_OFFSET: f64 = 709.0296084817056;
/// A logarithm is at least its estimate, less this.
pub(crate) const LN_LESS: f64 = 0.0625;

#[cfg(test)]
mod tests {
    use super::LN_LESS;
    use crate::passes::tests::upper;
    use tpg_runtime::ops::{Instruction, Maths, Own, System};

    /// The estimate is not below the result, and what is made of it not above.
    fn assert_around<M: Maths<f64>>(instruction: Instruction, argument: f64) {
        let result = instruction.apply::<f64, M>(argument, argument);
        let above = upper(instruction, argument);
        let below = if instruction == Instruction::Ln { above - LN_LESS } else { f64::NAN };
        if result.is_nan() {
            assert!(below.is_nan() || below == f64::NEG_INFINITY, "{instruction:?} {argument:?}: {below}");
            return;
        }
        assert!(result <= above || above.is_nan(), "{instruction:?} {argument:?} is {result}, above {above}");
        assert!(result >= below || below.is_nan(), "{instruction:?} {argument:?} is {result}, below {below}");
    }

    fn everywhere(argument: f64) {
        for instruction in [Instruction::Ln, Instruction::Exp] {
            assert_around::<Own>(instruction, argument);
            assert_around::<System>(instruction, argument);
        }
    }

    #[test]
    fn estimates_are_on_their_side_of_every_provider() {
        // Every 1024th number there is in f32, infinities and NaN among them.
        for bits in (0..=u32::MAX >> 10).map(|upper| upper << 10).chain([f32::MAX.to_bits(), 1]) {
            everywhere(f32::from_bits(bits).into());
        }
        // Around powers of two, where the line meets the curve.
        for power in -1020..=1020 {
            for ulps in -3_i64..=3 {
                let near = |x: f64| f64::from_bits((x.to_bits() as i64 + ulps) as u64);
                everywhere(near(f64::from(power) * std::f64::consts::LN_2));
                everywhere(near(2.0_f64.powi(power)));
            }
        }
        // Where an exponential comes near infinity, and near 0.
        for place in 0..40_000 {
            let step = f64::from(place) * 0.0001;
            everywhere(707.5 + step);
            everywhere(-707.5 - step);
        }
    }

    #[test]
    fn estimates_are_near() {
        for argument in [-50.0, -1.0, 0.0, 0.3, 1.0, 20.0, 80.0] {
            assert!(upper(Instruction::Exp, argument) <= argument.exp() * 1.062, "{argument}");
        }
        for argument in [1e-30, 0.5, 1.0, 3.0, 4095.0, 1e30_f64] {
            assert!(upper(Instruction::Ln, argument) <= argument.ln() + 0.061, "{argument}");
        }
    }
}
