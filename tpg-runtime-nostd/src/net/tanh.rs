//! The hyperbolic tangent in integers.
//!
//! Linear between 193 values, 1/32 apart, from 0 to 6; 1 from there on. Within 1.6·10⁻⁴ of tanh at every argument, odd,
//! and never falling.

use super::meaning::FRACTION_ONE;

/// Arguments between two values of the table.
const STEP: u32 = 64;

/// tanh(k/32) in multiples of 1/16384.
static TABLE: [u16; 194] = {
    let mut table = [FRACTION_ONE as u16; 194];
    let mut k = 0;
    while k < table.len() {
        // Between 0 and 1: truncation after adding a half rounds to nearest.
        table[k] = (tanh(k as f64 / 32.0) * FRACTION_ONE as f64 + 0.5) as u16;
        k += 1;
    }
    table
};

/// tanh(x) = (e − 1)/(e + 1), e = exp(2x) by its series at x/512 and squaring; for x from 0 to 7.
const fn tanh(x: f64) -> f64 {
    let y = x / 512.0;
    let (mut term, mut exp, mut n) = (1.0, 1.0, 1.0);
    while n < 12.0 {
        term = term * y / n;
        exp += term;
        n += 1.0;
    }
    let mut squarings = 0;
    while squarings < 10 {
        exp = exp * exp;
        squarings += 1;
    }
    (exp - 1.0) / (exp + 1.0)
}

/// tanh of `argument` in multiples of 1/2048, in multiples of 1/16384.
pub(super) fn fraction(argument: i32) -> i32 {
    let magnitude = argument.unsigned_abs();
    let place = (magnitude / STEP) as usize;
    let value = match (TABLE.get(place), TABLE.get(place + 1)) {
        (Some(&low), Some(&high)) => {
            let rise = (u32::from(high) - u32::from(low)) * (magnitude % STEP);
            (u32::from(low) + (rise + STEP / 2) / STEP) as i32
        }
        _ => FRACTION_ONE,
    };
    if argument < 0 { -value } else { value }
}

#[cfg(test)]
mod tests {
    use super::fraction;

    #[test]
    fn it_is_near_tanh_odd_and_never_falls() {
        let mut before = 0;
        let mut worst = 0.0f64;
        for argument in 0..40_000 {
            let value = fraction(argument);
            assert!(value >= before && fraction(-argument) == -value, "{argument}");
            worst = worst.max((f64::from(value) / 16_384.0 - libm::tanh(f64::from(argument) / 2048.0)).abs());
            before = value;
        }
        assert!(worst < 1.6e-4, "{worst}");
        assert_eq!([fraction(i32::MAX), fraction(i32::MIN), fraction(0)], [16_384, -16_384, 0]);
    }
}
