//! Sine and cosine of several angles at once, with the bits of [`libm::sincos`], in a form that compilers turn into vectors.

/// 2/π, and π/2 in two parts: the first has 33 bits, so that its product with a small whole number is exact (`rem_pio2.c`).
const TURNS: f64 = core::f64::consts::FRAC_2_PI;
const HALF_PI: [f64; 2] = [1.5707963267341256, 6.077100506506192e-11];
/// Adding it rounds to a whole number, which is then in the lowest bits.
const ROUND: f64 = 6755399441055744.0;
/// Where libm begins to reduce angles in another way: about 2²⁰ quarters of a turn.
const HUGE: f64 = 1647099.0;
/// The polynomials of `k_sin.c` and `k_cos.c`.
const SINE: [f64; 6] = [
    -0.16666666666666632,
    0.00833333333332249,
    -0.0001984126982985795,
    2.7557313707070068e-06,
    -2.5050760253406863e-08,
    1.58969099521155e-10,
];
const COSINE: [f64; 6] = [
    0.0416666666666666,
    -0.001388888888887411,
    2.480158728947673e-05,
    -2.7557314351390663e-07,
    2.087572321298175e-09,
    -1.1359647557788195e-11,
];

/// Returns the sines and the cosines of angles.
#[inline(always)]
pub(crate) fn sincos<const L: usize>(angles: &[f64; L]) -> [[f64; L]; 2] {
    let (mut sines, mut cosines) = ([0.0; L], [0.0; L]);
    let mut any_is_other = false;
    for ((&angle, sine), cosine) in angles.iter().zip(&mut sines).zip(&mut cosines) {
        let other;
        (*sine, *cosine, other) = reduced(angle);
        any_is_other |= other;
    }
    if any_is_other {
        for ((&angle, sine), cosine) in angles.iter().zip(&mut sines).zip(&mut cosines) {
            (*sine, *cosine) = libm::sincos(angle);
        }
    }
    [sines, cosines]
}

/// Sine, cosine, and whether libm may take another way for this angle: one that is −0, huge or no number, or close to where the
/// quadrant or the way changes. (Of a tiny angle libm returns itself and 1, which is what comes out here, too.)
#[inline(always)]
fn reduced(angle: f64) -> (f64, f64, bool) {
    let quarters = angle * TURNS;
    let turns = quarters + ROUND;
    let quadrant = turns.to_bits();
    let whole = turns - ROUND;
    let rough = angle - whole * HALF_PI[0];
    let rest = whole * HALF_PI[1];
    let x = rough - rest;
    let y = (rough - x) - rest;

    // libm reduces further where 16 bits are cancelled, and counts up to four quarters by the upper half of the angle's bits: to
    // within 5e-6 of a quarter.
    let is_cancelled = angle.abs() > 65536.0 * x.abs();
    let is_close = (quarters - whole).abs() > 0.49999;
    let is_moderate = angle.abs() < HUGE;
    let other = is_cancelled | is_close | !is_moderate | (angle.to_bits() == 1 << 63);

    let z = x * x;
    let w = z * z;
    let [s1, s2, s3, s4, s5, s6] = SINE;
    let r = s2 + z * (s3 + z * s4) + z * w * (s5 + z * s6);
    let v = z * x;
    let reduced = x - ((z * (0.5 * y - v * r) - y) - v * s1);
    let sine = if whole == 0.0 { x + v * (s1 + z * r) } else { reduced };

    let [c1, c2, c3, c4, c5, c6] = COSINE;
    let r = z * (c1 + z * (c2 + z * c3)) + w * w * (c4 + z * (c5 + z * c6));
    let half = 0.5 * z;
    let w = 1.0 - half;
    let cosine = w + (((1.0 - w) - half) + (z * r - x * y));

    let (a, b) = if quadrant & 1 == 1 { (cosine, sine) } else { (sine, cosine) };
    let signed = |value: f64, negative: u64| f64::from_bits(value.to_bits() ^ ((negative & 2) << 62));
    (signed(a, quadrant), signed(b, quadrant.wrapping_add(1)), other)
}

#[cfg(test)]
mod tests {
    use super::sincos;
    use core::f64::consts::FRAC_PI_4;

    #[test]
    fn eight_at_once_have_libms_bits() {
        let mut angles = vec![0.0, 5e-324, 1e-300, f64::INFINITY, f64::NAN, f64::MAX];
        let exponents = (-60..=60).map(|exponent| f64::from(exponent).exp2());
        angles.extend(exponents.flat_map(|scale| (0..3000).map(move |step| scale * (1.0 + f64::from(step) / 3000.0))));
        for eighth in 0..5000 {
            // A multiple of an eighth of a turn, and numbers near it at every distance.
            let near = f64::from(eighth) * FRAC_PI_4;
            let bits = (0..45).map(|bit| f64::from_bits(near.to_bits() ^ 1 << bit));
            angles.extend([near, near.next_up(), near.next_down()].into_iter().chain(bits));
        }
        angles.extend(angles.clone().iter().map(|angle| -angle));
        for eight in angles.as_chunks::<8>().0 {
            let [sines, cosines] = sincos(eight);
            for (lane, &angle) in eight.iter().enumerate() {
                let (sine, cosine) = libm::sincos(angle);
                let bits = |[a, b]: [f64; 2]| [a, b].map(|x| if x.is_nan() { 0 } else { x.to_bits() });
                assert_eq!(bits([sines[lane], cosines[lane]]), bits([sine, cosine]), "{angle:e}");
            }
        }
    }
}
