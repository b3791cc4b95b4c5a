//! Tiled product (Goto and van de Geijn 2008): panels of the left factor are packed, and a tile of the product stays in
//! registers while a panel is traversed.

use super::{Factor, Finish, Product, Scratch};
use crate::vectors::{Vector, lanes, load, save};
use fearless_simd::{Simd, SimdBase};
use std::array::from_fn;
use std::marker::PhantomData;

impl Product<'_> {
    /// Computes tiles of `M` vectors by `N` columns, and narrower ones for the remaining columns.
    #[inline(always)]
    pub(super) fn by_tiles<S: Simd, const M: usize, const N: usize>(self, simd: S) {
        let Self { out, a, b, finish, scratch: Scratch { panels, sums, .. } } = self;
        let (rows, inner) = a.size();
        let height = M * lanes::<S>();
        panels.resize(rows.next_multiple_of(height) * inner, 0.0);
        for first in (0..rows).step_by(height) {
            pack::<S, M>(simd, &mut panels[first * inner..][..height * inner], a, first);
        }
        let panels = Panels::<S, M> { values: panels, rows, inner, simd: PhantomData };
        sums.resize(height * N, 0.0);
        let mut first = panels.times_whole::<N>(simd, out, b, 0, finish, sums);
        if N > 4 {
            first = panels.times_whole::<4>(simd, out, b, first, finish, sums);
        }
        panels.times_whole::<1>(simd, out, b, first, finish, sums);
    }
}

/// The left factor, packed into panels of `M` vectors of rows.
struct Panels<'a, S: Simd, const M: usize> {
    values: &'a [f32],
    rows: usize,
    inner: usize,
    simd: PhantomData<S>,
}

impl<S: Simd, const M: usize> Panels<'_, S, M> {
    /// Iterates over the panels with their first rows.
    #[inline(always)]
    fn each(&self) -> impl Iterator<Item = (&[f32], usize)> {
        let height = M * lanes::<S>();
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
        out: &mut [f32],
        b: Factor<'_>,
        first: usize,
        finish: Finish<'_>,
        sums: &mut [f32],
    ) -> usize {
        let (inner, columns) = b.size();
        let end = columns - (columns - first) % N;
        for first in (first..end).step_by(N) {
            for (panel, row) in self.each() {
                if b.transposed {
                    let rows = b.values.chunks_exact(columns).map(|row| &row[first..][..N]);
                    tile::<S, M, N>(simd, panel, rows.map(|row| from_fn(|j| row[j])), sums);
                } else {
                    let columns: [&[f32]; N] = from_fn(|j| &b.values[(first + j) * inner..][..inner]);
                    tile::<S, M, N>(simd, panel, (0..inner).map(|k| columns.map(|column| column[k])), sums);
                }
                store::<S, M>(simd, &mut out[..(first + N) * self.rows], (self.rows, row), first, sums, finish);
            }
        }
        end
    }
}

/// Copies `M` vectors of a factor's rows from row `first` on, column after column, padded with zeros.
#[inline(always)]
fn pack<S: Simd, const M: usize>(simd: S, panel: &mut [f32], a: Factor<'_>, first: usize) {
    let (rows, inner) = a.size();
    let height = M * lanes::<S>();
    let there = height.min(rows - first);
    if there < height {
        panel.fill(0.0);
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
                save::<S>(load(simd, values, i), slots, i);
            }
        }
    }
}

/// Multiplies a panel by the rows of `b`, `N` numbers each, into `sums`, column by column.
#[inline(always)]
#[allow(clippy::needless_range_loop, reason = "an iterator would take the address of what is to stay in registers")]
fn tile<S: Simd, const M: usize, const N: usize>(
    simd: S,
    panel: &[f32],
    b: impl Iterator<Item = [f32; N]>,
    sums: &mut [f32],
) {
    let mut tile: [[Vector<S>; M]; N] = [[SimdBase::splat(simd, 0.0); M]; N];
    for (a, b) in panel.chunks_exact(M * lanes::<S>()).zip(b) {
        for j in 0..N {
            let factor = <Vector<S>>::splat(simd, b[j]);
            for i in 0..M {
                tile[j][i] += load::<S>(simd, a, i) * factor;
            }
        }
    }
    let slots = &mut sums[..M * N * lanes::<S>()];
    for j in 0..N {
        for i in 0..M {
            save::<S>(tile[j][i], slots, j * M + i);
        }
    }
}

/// Finishes a tile of `M` vectors of rows and stores it in a product with the given number of rows, from that row and
/// column on, as far as `out` extends.
#[inline(always)]
fn store<S: Simd, const M: usize>(
    simd: S,
    out: &mut [f32],
    (rows, row): (usize, usize),
    column: usize,
    sums: &[f32],
    finish: Finish<'_>,
) {
    let height = M * lanes::<S>();
    let here = row..rows.min(row + height);
    let columns = out[column * rows..].chunks_exact_mut(rows).zip(sums.chunks_exact(height)).enumerate();
    for (j, (out, sums)) in columns {
        let (first, out) = ((column + j) * rows + row, &mut out[here.clone()]);
        if out.len() < height {
            for (i, (out, &sum)) in out.iter_mut().zip(sums).enumerate() {
                *out = finish.scalar(row + i, first + i, sum);
            }
        } else {
            for i in 0..M {
                let at = i * lanes::<S>();
                save::<S>(finish.vector(simd, row + at, first + at, load(simd, sums, i)), out, i);
            }
        }
    }
}
