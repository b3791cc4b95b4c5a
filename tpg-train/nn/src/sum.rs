//! Sums of sixteen partial sums: a fixed order of additions, independent of the vector width.

use super::Real;

/// Number of partial sums in a [`dot`] product and other [`sum`]s.
const PARTS: usize = 16;

/// Computes a dot product in the order of [`sum`].
#[inline(always)]
pub(super) fn dot<T: Real>(a: &[T], b: &[T]) -> T {
    sum([a, b], |[a, b]| a * b)
}

/// Sums a term over the positions of equally long lists: part i sums the positions i, i + 16, …; then the parts are
/// added in pairs, at distance 8, 4, 2 and 1.
#[inline(always)]
pub(super) fn sum<T: Real, const N: usize>(lists: [&[T]; N], term: impl Fn([T; N]) -> T) -> T {
    let count = lists[0].len();
    let mut parts = [T::zero(); PARTS];
    let chunks = lists.map(|list| list[..count].as_chunks::<PARTS>());
    for chunk in 0..count / PARTS {
        let chunk = chunks.map(|(chunks, _)| &chunks[chunk]);
        for (part, slot) in parts.iter_mut().enumerate() {
            *slot += term(chunk.map(|values| values[part]));
        }
    }
    for (place, slot) in parts.iter_mut().enumerate().take(count % PARTS) {
        *slot += term(chunks.map(|(_, rest)| rest[place]));
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
    use super::sum;
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
        assert_eq!(sum([&numbers[..]], |[number]| number), parts[0]);
    }
}
