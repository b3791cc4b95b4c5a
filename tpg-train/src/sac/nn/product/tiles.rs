//! A product tile by tile (Goto and van de Geijn 2008): panels of the left factor are copied side by side, a tile of the
//! product stays in registers while a panel passes by.

use super::{Factor, Finish, Product};
use crate::sac::nn::Real;
use pulp::Simd;

impl<T: Real> Product<'_, T> {
    /// Tiles of `M` vectors by `N` columns.
    #[inline(always)]
    pub(super) fn by_tiles<S: Simd, const M: usize, const N: usize>(self, simd: S) {
        let Self { out, a, b, finish, scratch } = self;
        let ((rows, inner), (_, columns)) = (a.size(), b.size());
        let height = M * T::lanes::<S>();
        scratch.panels.resize(height * inner, T::zero());
        let whole = columns - columns % N;
        scratch.rest.clear();
        if whole < columns {
            let last = |k| (0..N).map(move |j| if whole + j < columns { b.at(k, whole + j) } else { T::zero() });
            scratch.rest.extend((0..inner).flat_map(last));
        }
        for first in (0..rows).step_by(height) {
            let panel = &mut scratch.panels[..];
            pack(panel, a, first, height);
            let panel = T::vectors::<S>(panel);
            for column in (0..whole).step_by(N) {
                let sums = if b.transposed {
                    tile::<T, S, M, N>(simd, panel, b.values.chunks_exact(columns).map(|row| &row[column..][..N]))
                } else {
                    let values: [&[T]; N] = std::array::from_fn(|j| &b.values[(column + j) * inner..][..inner]);
                    tile_of_columns::<T, S, M, N>(simd, panel, values)
                };
                store(simd, &mut out[column * rows..], rows, first, sums, N, finish);
            }
            if whole < columns {
                let sums = tile::<T, S, M, N>(simd, panel, scratch.rest.chunks_exact(N));
                store(simd, &mut out[whole * rows..], rows, first, sums, columns - whole, finish);
            }
        }
    }
}

/// Copies `height` rows of a factor from row `first` on, column after column; zeros where there are no more rows.
#[inline(always)]
fn pack<T: Real>(panel: &mut [T], a: Factor<'_, T>, first: usize, height: usize) {
    let (rows, inner) = a.size();
    let there = height.min(rows - first);
    if there < height {
        panel.fill(T::zero());
    }
    if a.transposed {
        let columns = a.values[first * inner..].chunks_exact(inner.max(1));
        for (row, values) in columns.take(there).enumerate() {
            for (slots, &value) in panel.chunks_exact_mut(height).zip(values) {
                slots[row] = value;
            }
        }
    } else {
        for (slots, column) in panel.chunks_exact_mut(height).zip(a.values.chunks_exact(rows)) {
            slots[..there].copy_from_slice(&column[first..first + there]);
        }
    }
}

type Tile<T, S, const M: usize, const N: usize> = [[<T as Real>::Vector<S>; M]; N];

/// The tile of a panel and the rows of `b`, `N` numbers each.
#[inline(always)]
fn tile<'a, T: Real, S: Simd, const M: usize, const N: usize>(
    simd: S,
    panel: &[T::Vector<S>],
    b: impl Iterator<Item = &'a [T]>,
) -> Tile<T, S, M, N> {
    let mut sums = [[T::splat(simd, T::zero()); M]; N];
    for (a, b) in panel.chunks_exact(M).zip(b) {
        for j in 0..N {
            let factor = T::splat(simd, b[j]);
            for i in 0..M {
                sums[j][i] = T::plus(simd, sums[j][i], T::times(simd, a[i], factor));
            }
        }
    }
    sums
}

/// The tile of a panel and whole columns of `b`.
#[inline(always)]
fn tile_of_columns<T: Real, S: Simd, const M: usize, const N: usize>(
    simd: S,
    panel: &[T::Vector<S>],
    b: [&[T]; N],
) -> Tile<T, S, M, N> {
    let mut sums = [[T::splat(simd, T::zero()); M]; N];
    let inner = b[0].len();
    let b = b.map(|column| &column[..inner]);
    for (k, a) in panel.chunks_exact(M).enumerate().take(inner) {
        for j in 0..N {
            let factor = T::splat(simd, b[j][k]);
            for i in 0..M {
                sums[j][i] = T::plus(simd, sums[j][i], T::times(simd, a[i], factor));
            }
        }
    }
    sums
}

/// Finishes a tile and puts its first `columns` columns into `out`, which begins with the first of them.
#[inline(always)]
fn store<T: Real, S: Simd, const M: usize, const N: usize>(
    simd: S,
    out: &mut [T],
    rows: usize,
    first: usize,
    sums: Tile<T, S, M, N>,
    columns: usize,
    finish: Finish<'_, T>,
) {
    let lanes = T::lanes::<S>();
    let whole = rows - first >= M * lanes;
    for (column, sums) in out.chunks_exact_mut(rows).zip(sums).take(columns) {
        if whole {
            let slots = T::vectors_mut::<S>(&mut column[first..first + M * lanes]);
            for i in 0..M {
                slots[i] = finish.vector(simd, first + i * lanes, sums[i]);
            }
            continue;
        }
        for (i, &sum) in sums.iter().enumerate() {
            let from = first + i * lanes;
            if from < rows {
                let sum = T::unpack::<S>(&sum);
                for (row, (slot, &sum)) in column[from..].iter_mut().zip(sum).enumerate() {
                    *slot = finish.scalar(from + row, sum);
                }
            }
        }
    }
}
