//! Functions of eight numbers at once, with the bits of [`own`](super::own), in a form that compilers turn into vectors: without
//! tables. Numbers of a size that would need one are computed one by one.

/// Defines sines and cosines of eight numbers of a type, by the function `circle` beside them.
macro_rules! of_eight {
    ($scalar:ident, $bits:ident) => {
        /// Replaces each number by its sine.
        #[inline(always)]
        pub(in crate::ops) fn sines(numbers: &mut [$scalar; 8]) {
            if any_is_large(numbers) {
                return numbers.iter_mut().for_each(|x| *x = own::sin(*x));
            }
            for x in numbers {
                let bits = x.to_bits();
                *x = $scalar::from_bits(circle(bits & MAGNITUDE, 1 << ($bits::BITS - 3)) ^ (bits & SIGN));
            }
        }

        /// Replaces each number by its cosine.
        #[inline(always)]
        pub(in crate::ops) fn cosines(numbers: &mut [$scalar; 8]) {
            if any_is_large(numbers) {
                return numbers.iter_mut().for_each(|x| *x = own::cos(*x));
            }
            for x in numbers {
                *x = $scalar::from_bits(circle(x.to_bits() & MAGNITUDE, 3 << ($bits::BITS - 3)));
            }
        }

        /// Infinities and NaN are not large: they become NaN in any case.
        #[inline(always)]
        fn any_is_large(numbers: &[$scalar; 8]) -> bool {
            numbers.iter().fold(false, |any, x| any | ((x.abs() >= MOST) & (x.abs() < $scalar::INFINITY)))
        }

        /// The row of [`CIRCLE`] for a quadrant.
        #[inline(always)]
        fn row(turn: $bits) -> [$scalar; CIRCLE[0].len()] {
            let odd = own::mask(TOP, turn << 1);
            core::array::from_fn(|at| {
                $scalar::from_bits(own::choose(odd, CIRCLE[1][at].to_bits(), CIRCLE[0][at].to_bits()))
            })
        }
    };
}

pub(super) mod f32;
pub(super) mod f64;
