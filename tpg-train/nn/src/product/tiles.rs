//! Tiled product (Goto and van de Geijn 2008): panels of the left factor are packed, and a tile of the product stays in
//! registers while a panel is traversed.

use super::{Factor, Finish, Product, Scratch};
use crate::Real;
use crate::vectors::{Vector, lanes, load, save, where_positive};
use fearless_simd::{Simd, SimdBase};
use std::marker::PhantomData;

/// Tile widths, in columns, for when the widest tile no longer fits, and for when this one no longer fits either.
const NARROW: usize = 8;
const LAST: usize = 4;

impl<T: Real> Product<'_, T> {
    /// Computes tiles of `M` vectors by `N` columns, and narrower ones for the remaining columns.
    #[inline(always)]
    pub(super) fn by_tiles<S: Simd, const M: usize, const N: usize>(self, simd: S) {
        let Self { out, a, b, finish, scratch: Scratch { panels, rest, sums, .. } } = self;
        let ((rows, inner), (_, columns)) = (a.size(), b.size());
        let height = M * lanes::<T, S>();
        panels.resize(rows.next_multiple_of(height) * inner, T::zero());
        for first in (0..rows).step_by(height) {
            pack::<T, S, M>(simd, &mut panels[first * inner..][..height * inner], a, first);
        }
        let panels = Panels::<T, S, M> { values: panels, rows, inner, simd: PhantomData };
        sums.resize(height * N, T::zero());
        let mut first = panels.times_whole::<N>(simd, out, b, 0, finish, sums);
        if N > NARROW {
            first = panels.times_whole::<NARROW>(simd, out, b, first, finish, sums);
        }
        for first in (first..columns).step_by(LAST) {
            let here = first..columns.min(first + LAST);
            rest.clear();
            rest.resize(inner * LAST, T::zero());
            for (k, slots) in rest.chunks_exact_mut(LAST).enumerate() {
                if b.transposed {
                    slots[..here.len()].copy_from_slice(&b.values[k * columns..][here.clone()]);
                } else {
                    slots.iter_mut().zip(here.clone()).for_each(|(slot, column)| *slot = b.values[column * inner + k]);
                }
            }
            for (panel, row) in panels.each() {
                tile::<T, S, M, LAST>(simd, panel, rest.chunks_exact(LAST), sums);
                store::<T, S, M>(simd, &mut out[..here.end * rows], (rows, row), first, sums, finish);
            }
        }
    }
}

/// The left factor, packed into panels of `M` vectors of rows.
struct Panels<'a, T: Real, S: Simd, const M: usize> {
    values: &'a [T],
    rows: usize,
    inner: usize,
    simd: PhantomData<S>,
}

impl<T: Real, S: Simd, const M: usize> Panels<'_, T, S, M> {
    /// Iterates over the panels with their first rows.
    #[inline(always)]
    fn each(&self) -> impl Iterator<Item = (&[T], usize)> {
        let height = M * lanes::<T, S>();
        let size = height * self.inner;
        let firsts = (0..self.rows).step_by(height);
        firsts.enumerate().map(move |(index, first)| (&self.values[index * size..][..size], first))
    }

    /// Computes the product's columns from `first` on, as long as they fill tiles of `N`; returns the first remaining
    /// column.
    #[inline(always)]
    fn times_whole<const N: usize>(
        &self,
        simd: S,
        out: &mut [T],
        b: Factor<'_, T>,
        first: usize,
        finish: Finish<'_, T>,
        sums: &mut [T],
    ) -> usize {
        let (inner, columns) = b.size();
        let end = columns - (columns - first) % N;
        for first in (first..end).step_by(N) {
            for (panel, row) in self.each() {
                if b.transposed {
                    let rows = b.values.chunks_exact(columns).map(|row| &row[first..][..N]);
                    tile::<T, S, M, N>(simd, panel, rows, sums);
                } else {
                    tile_of_columns::<T, S, M, N>(simd, panel, &b.values[first * inner..][..N * inner], inner, sums);
                }
                store::<T, S, M>(simd, &mut out[..(first + N) * self.rows], (self.rows, row), first, sums, finish);
            }
        }
        end
    }
}

/// Copies `M` vectors of a factor's rows from row `first` on, column after column, padded with zeros.
#[inline(always)]
fn pack<T: Real, S: Simd, const M: usize>(simd: S, panel: &mut [T], a: Factor<'_, T>, first: usize) {
    let (rows, inner) = a.size();
    let height = M * lanes::<T, S>();
    let there = height.min(rows - first);
    if there < height {
        panel.fill(T::zero());
    }
    let slots = panel.chunks_exact_mut(height);
    if a.transposed {
        let columns = a.values[first * inner..].chunks_exact(inner.max(1));
        for (row, values) in columns.take(there).enumerate() {
            for (slots, &value) in panel.chunks_exact_mut(height).zip(values) {
                slots[row] = value;
            }
        }
    } else if there < height {
        for (slots, column) in slots.zip(a.values.chunks_exact(rows)) {
            slots[..there].copy_from_slice(&column[first..]);
        }
    } else {
        // A fixed number of vectors, so there is no call per column.
        for (slots, column) in slots.zip(a.values.chunks_exact(rows)) {
            let values = &column[first..first + height];
            for i in 0..M {
                save::<T, S>(load(simd, values, i), slots, i);
            }
        }
    }
}

/// Multiplies a panel by the rows of `b`, `N` numbers each, into `sums`, column by column.
#[inline(always)]
#[allow(clippy::needless_range_loop, reason = "an iterator would take the address of what is to stay in registers")]
fn tile<'a, T: Real, S: Simd, const M: usize, const N: usize>(
    simd: S,
    panel: &[T],
    b: impl Iterator<Item = &'a [T]>,
    sums: &mut [T],
) {
    let mut tile: [[Vector<T, S>; M]; N] = [[SimdBase::splat(simd, T::zero()); M]; N];
    for (a, b) in panel.chunks_exact(M * lanes::<T, S>()).zip(b) {
        for j in 0..N {
            let factor = <Vector<T, S>>::splat(simd, b[j]);
            for i in 0..M {
                tile[j][i] += load::<T, S>(simd, a, i) * factor;
            }
        }
    }
    leave::<T, S, M, N>(tile, sums);
}

/// Multiplies a panel by `N` whole columns of `b`, `inner` numbers each, into `sums`, column by column.
#[inline(always)]
#[allow(clippy::needless_range_loop, reason = "an iterator would take the address of what is to stay in registers")]
fn tile_of_columns<T: Real, S: Simd, const M: usize, const N: usize>(
    simd: S,
    panel: &[T],
    b: &[T],
    inner: usize,
    sums: &mut [T],
) {
    let mut tile: [[Vector<T, S>; M]; N] = [[SimdBase::splat(simd, T::zero()); M]; N];
    let b: [&[T]; N] = std::array::from_fn(|j| &b[j * inner..][..inner]);
    for (k, a) in panel.chunks_exact(M * lanes::<T, S>()).enumerate().take(inner) {
        for j in 0..N {
            let factor = <Vector<T, S>>::splat(simd, b[j][k]);
            for i in 0..M {
                tile[j][i] += load::<T, S>(simd, a, i) * factor;
            }
        }
    }
    leave::<T, S, M, N>(tile, sums);
}

/// Stores a tile in memory. Until then it stays in registers because nothing takes its address.
#[inline(always)]
#[allow(clippy::needless_range_loop, reason = "an iterator would take the address of what is to stay in registers")]
fn leave<T: Real, S: Simd, const M: usize, const N: usize>(tile: [[Vector<T, S>; M]; N], sums: &mut [T]) {
    let slots = &mut sums[..M * N * lanes::<T, S>()];
    for j in 0..N {
        for i in 0..M {
            save::<T, S>(tile[j][i], slots, j * M + i);
        }
    }
}

/// Finishes a tile of `M` vectors of rows and stores it in a product with the given number of rows, from that row and
/// column on, as far as `out` extends.
#[inline(always)]
fn store<T: Real, S: Simd, const M: usize>(
    simd: S,
    out: &mut [T],
    (rows, row): (usize, usize),
    column: usize,
    sums: &[T],
    finish: Finish<'_, T>,
) {
    let height = M * lanes::<T, S>();
    let here = row..rows.min(row + height);
    let columns = out[column * rows..].chunks_exact_mut(rows).zip(sums.chunks_exact(height)).enumerate();
    let columns = columns.map(|(j, (out, sums))| ((column + j) * rows + row, &mut out[here.clone()], sums));
    if here.len() < height {
        for (first, out, sums) in columns {
            for (i, (out, &sum)) in out.iter_mut().zip(sums).enumerate() {
                *out = finish.scalar(row + i, first + i, sum);
            }
        }
        return;
    }
    // One loop per kind of finish, so that the loops do not test it.
    match finish {
        Finish::Plain => {
            for (_, out, sums) in columns {
                out.copy_from_slice(sums);
            }
        }
        Finish::Bias(bias) => {
            let bias = &bias[here.clone()];
            for (_, out, sums) in columns {
                for i in 0..M {
                    save::<T, S>(load::<T, S>(simd, sums, i) + load(simd, bias, i), out, i);
                }
            }
        }
        Finish::Rectified(bias) => {
            let bias = &bias[here.clone()];
            for (_, out, sums) in columns {
                for i in 0..M {
                    let sum = load::<T, S>(simd, sums, i) + load(simd, bias, i);
                    save::<T, S>(where_positive::<T, S>(simd, sum, sum), out, i);
                }
            }
        }
        Finish::Where(passed) => {
            for (first, out, sums) in columns {
                let passed = &passed[first..][..height];
                for i in 0..M {
                    let passed = load::<T, S>(simd, passed, i);
                    save::<T, S>(where_positive::<T, S>(simd, load(simd, sums, i), passed), out, i);
                }
            }
        }
    }
}
