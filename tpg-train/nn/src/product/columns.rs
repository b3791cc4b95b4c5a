//! A matrix times one column.

use super::Finish;
use crate::vectors::{Vector, lanes, load, many_registers, save};
use fearless_simd::{Simd, SimdBase};

/// From this number of rows on, multiplying a column is more expensive than testing whether its factor is zero.
const MANY: usize = 128;

/// As [`by_columns`], skipping columns whose factor is zero; `kept` is a buffer for the indices of the others.
#[inline(always)]
pub(super) fn by_columns_of_sparse<S: Simd>(
    simd: S,
    out: &mut [f32],
    a: &[f32],
    b: &[f32],
    finish: Finish<'_>,
    kept: &mut Vec<usize>,
) {
    let rows = out.len();
    if rows < MANY {
        return by_columns(simd, out, a.chunks_exact(rows).zip(b.iter().copied()), finish);
    }
    // Branch-free compaction: every index is written and overwritten by the next one if its number is zero.
    kept.resize(b.len(), 0);
    let mut count = 0;
    for (index, &value) in b.iter().enumerate() {
        kept[count] = index;
        count += usize::from(value != 0.0);
    }
    let columns = kept[..count].iter().map(|&index| (&a[index * rows..][..rows], b[index]));
    by_columns(simd, out, columns, finish);
}

/// Keeps the sums of many rows in registers while iterating over the matrix's columns and their factors.
#[inline(always)]
pub(super) fn by_columns<'a, S: Simd>(
    simd: S,
    out: &mut [f32],
    columns: impl Iterator<Item = (&'a [f32], f32)> + Clone,
    finish: Finish<'_>,
) {
    let mut first = 0;
    if many_registers::<S>() {
        first = rows_of_vectors::<S, 16>(simd, out, columns.clone(), finish, first);
    }
    first = rows_of_vectors::<S, 8>(simd, out, columns.clone(), finish, first);
    first = rows_of_vectors::<S, 2>(simd, out, columns.clone(), finish, first);
    let rows = out.len();
    while rows - first >= 4 {
        few_rows::<4>(out, columns.clone(), finish, first);
        first += 4;
    }
    while first < rows {
        few_rows::<1>(out, columns.clone(), finish, first);
        first += 1;
    }
}

/// Computes `N` rows from `first` on.
#[inline(always)]
fn few_rows<'a, const N: usize>(
    out: &mut [f32],
    columns: impl Iterator<Item = (&'a [f32], f32)>,
    finish: Finish<'_>,
    first: usize,
) {
    let mut sums = [0.0; N];
    for (column, factor) in columns {
        let values = &column[first..first + N];
        for i in 0..N {
            sums[i] += values[i] * factor;
        }
    }
    for (i, sum) in sums.into_iter().enumerate() {
        out[first + i] = finish.scalar(first + i, first + i, sum);
    }
}

/// Computes rows from `first` on, `M` vectors at once; returns the first remaining row.
#[inline(always)]
#[allow(clippy::needless_range_loop, reason = "an iterator would take the address of what is to stay in registers")]
fn rows_of_vectors<'a, S: Simd, const M: usize>(
    simd: S,
    out: &mut [f32],
    columns: impl Iterator<Item = (&'a [f32], f32)> + Clone,
    finish: Finish<'_>,
    mut first: usize,
) -> usize {
    let (rows, height) = (out.len(), M * lanes::<S>());
    while rows - first >= height {
        let mut sums: [Vector<S>; M] = [SimdBase::splat(simd, 0.0); M];
        for (column, factor) in columns.clone() {
            let (values, factor) = (&column[first..first + height], <Vector<S>>::splat(simd, factor));
            for i in 0..M {
                sums[i] += load::<S>(simd, values, i) * factor;
            }
        }
        let slots = &mut out[first..first + height];
        for i in 0..M {
            let row = first + i * lanes::<S>();
            save::<S>(finish.vector(simd, row, row, sums[i]), slots, i);
        }
        first += height;
    }
    first
}
