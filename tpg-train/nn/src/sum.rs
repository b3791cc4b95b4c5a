//! Sums of sixteen partial sums: a fixed order of additions, independent of the vector width.

/// Number of partial sums in a [`dot`] product.
const PARTS: usize = 16;

/// Computes a dot product: part i sums the positions i, i + 16, …; then the parts are added in pairs, at distance 8, 4, 2
/// and 1.
#[inline(always)]
pub(super) fn dot(a: &[f32], b: &[f32]) -> f32 {
    let mut parts = [0.0; PARTS];
    for (a, b) in a.chunks(PARTS).zip(b.chunks(PARTS)) {
        for ((part, a), b) in parts.iter_mut().zip(a).zip(b) {
            *part += a * b;
        }
    }
    let mut half = PARTS / 2;
    while half > 0 {
        for part in 0..half {
            parts[part] += parts[part + half];
        }
        half /= 2;
    }
    parts[0]
}

#[cfg(test)]
mod tests {
    use super::dot;
    use tpg_engine::random::{Purpose, Stream};

    #[test]
    fn a_sum_has_the_documented_order() {
        let mut numbers = [0.0f32; 37];
        Stream::new(5, 0, Purpose::Test, 23).normals(&mut numbers);
        let mut parts = [0.0; 16];
        numbers.iter().enumerate().for_each(|(i, number)| parts[i % 16] += number);
        for distance in [8, 4, 2, 1] {
            (0..distance).for_each(|i| parts[i] += parts[i + distance]);
        }
        assert_eq!(dot(&numbers, &[1.0; 37]), parts[0]);
    }
}
