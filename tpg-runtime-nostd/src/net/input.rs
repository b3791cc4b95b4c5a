//! From numbers to a network's inputs.

/// An input of 1 as an integer.
pub const INPUT_ONE: f32 = 4096.0;

/// An input as an integer: rounded to nearest, halves away from zero, clipped to `i16`; NaN becomes 0.
#[inline(always)]
pub fn integer(value: f32) -> i16 {
    let scaled = value * INPUT_ONE;
    let half = f32::from_bits(0.5f32.to_bits() | (scaled.to_bits() & (-0.0f32).to_bits()));
    // By way of i32, which an FPU converts to and saturates at: `as i16` costs three comparisons.
    ((scaled + half) as i32).clamp(i32::from(i16::MIN), i32::from(i16::MAX)) as i16
}

#[cfg(test)]
mod tests {
    use super::{INPUT_ONE, integer};

    #[test]
    fn inputs_are_rounded_and_clipped() {
        let nearest = |value: f32| {
            let scaled = value * INPUT_ONE;
            (scaled + if scaled < 0.0 { -0.5 } else { 0.5 }) as i16
        };
        let special =
            [0.0, -0.0, f32::NAN, -f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, f32::MIN, 7.99, -8.0];
        let halves = (-40_000..40_000).map(|n| n as f32 / 8192.0);
        let any = (0..1_000_000u32).map(|n| f32::from_bits(n.wrapping_mul(2_654_435_761)));
        for value in special.into_iter().chain(halves).chain(any) {
            assert_eq!(integer(value), nearest(value), "{value}");
        }
    }
}
