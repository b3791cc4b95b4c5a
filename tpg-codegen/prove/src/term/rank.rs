//! The order of binary32 values as integers.

/// The bits of plus infinity.
pub const INFINITY: u32 = 0x7f80_0000;
/// The bits of minus zero: the sign.
pub const NEGATIVE_ZERO: u32 = 0x8000_0000;
/// The bits that stand for every NaN.
pub const NAN: u32 = 0x7fc0_0000;

/// Tests whether bits are a NaN's.
#[must_use]
pub const fn is_nan_bits(bits: u32) -> bool {
    bits & !NEGATIVE_ZERO > INFINITY
}

/// An integer that orders as the float does: `rank(a) <= rank(b)` exactly where `a <= b`. Both zeros rank 0, and NaN ranks one below
/// minus infinity.
#[must_use]
pub const fn rank(bits: u32) -> i64 {
    let magnitude = (bits & !NEGATIVE_ZERO) as i64;
    if is_nan_bits(bits) {
        -(INFINITY as i64) - 1
    } else if bits & NEGATIVE_ZERO != 0 {
        -magnitude
    } else {
        magnitude
    }
}

/// The bits with a rank; zero is +0.
const fn of_rank(rank: i64) -> u32 {
    if rank < -(INFINITY as i64) {
        NAN
    } else if rank < 0 {
        NEGATIVE_ZERO | (-rank) as u32
    } else {
        rank as u32
    }
}

/// The bits that rank one below; NaN below minus infinity. Not for NaN.
#[must_use]
pub const fn next_below(bits: u32) -> u32 {
    of_rank(rank(bits) - 1)
}

/// The bits that rank one above; minus infinity above NaN. Not for plus infinity.
#[must_use]
pub const fn next_above(bits: u32) -> u32 {
    of_rank(rank(bits) + 1)
}

#[cfg(test)]
mod tests {
    use super::{INFINITY, NAN, NEGATIVE_ZERO, next_above, next_below, rank};

    #[test]
    fn ranks_order_as_floats_do() {
        let values = [
            f32::NEG_INFINITY,
            f32::MIN,
            -1.0,
            -f32::from_bits(1),
            -0.0,
            0.0,
            f32::from_bits(1),
            2.5,
            f32::MAX,
            f32::INFINITY,
        ];
        for a in values {
            for b in values {
                assert_eq!(a <= b, rank(a.to_bits()) <= rank(b.to_bits()), "{a} {b}");
            }
            assert!(rank(NAN) < rank(a.to_bits()) && rank(NAN | NEGATIVE_ZERO) < rank(a.to_bits()));
        }
    }

    #[test]
    fn neighbours_are_one_rank_apart() {
        assert_eq!(next_below(f32::MIN.to_bits()), f32::NEG_INFINITY.to_bits());
        assert_eq!(next_below(f32::NEG_INFINITY.to_bits()), NAN);
        assert_eq!(next_above(NAN), f32::NEG_INFINITY.to_bits());
        assert_eq!(next_above(f32::MAX.to_bits()), INFINITY);
        assert_eq!(next_below(0), NEGATIVE_ZERO | 1);
        assert_eq!(next_above(NEGATIVE_ZERO | 1), 0);
    }
}
