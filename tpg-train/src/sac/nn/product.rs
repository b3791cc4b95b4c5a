//! The matrix product, in two kernels.

use super::Real;
use nalgebra::{DMatrixView, DMatrixViewMut, Dyn};
use pulp::Arch;

/// Which matrix product a network computes with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kernel {
    /// nalgebra's, by `matrixmultiply`: fast, and the same bits on CPUs of one family.
    #[default]
    Fast,
    /// One order of additions, nothing fused: the same bits on every machine.
    Portable,
}

impl<T: Real> Factor<'_, T> {
    fn at(&self, row: usize, column: usize) -> T {
        if self.transposed { self.values[row * self.rows + column] } else { self.values[column * self.rows + row] }
    }

    fn view(&self) -> DMatrixView<'_, T, Dyn, Dyn> {
        let (rows, columns) = self.size();
        let (row_stride, column_stride) = if self.transposed { (self.rows, 1) } else { (1, self.rows) };
        DMatrixView::from_slice_with_strides(self.values, rows, columns, row_stride, column_stride)
    }
}

/// A factor of a product: a column-major matrix, read as it is or transposed.
#[derive(Clone, Copy, Debug)]
pub struct Factor<'a, T> {
    values: &'a [T],
    rows: usize,
    columns: usize,
    transposed: bool,
}

impl<'a, T> Factor<'a, T> {
    /// A column-major matrix of that size.
    ///
    /// # Panics
    /// If `values` does not hold exactly `rows`·`columns` numbers.
    pub fn new(values: &'a [T], rows: usize, columns: usize) -> Self {
        assert_eq!(values.len(), rows * columns, "a matrix of another size");
        Self { values, rows, columns, transposed: false }
    }

    /// The same numbers with rows and columns exchanged.
    pub fn transposed(self) -> Self {
        Self { transposed: !self.transposed, ..self }
    }

    /// The same matrix without the exchange where it has one row or one column: memory does not tell them apart.
    fn straightened(self) -> Self {
        if self.transposed && (self.rows == 1 || self.columns == 1) {
            Self { rows: self.columns, columns: self.rows, transposed: false, ..self }
        } else {
            self
        }
    }

    fn size(&self) -> (usize, usize) {
        if self.transposed { (self.columns, self.rows) } else { (self.rows, self.columns) }
    }
}

impl Kernel {
    /// `out` := `a`·`b`, `out` column-major.
    ///
    /// # Panics
    /// If the sizes do not fit.
    pub fn multiply<T: Real>(self, out: &mut [T], a: Factor<'_, T>, b: Factor<'_, T>) {
        let ((rows, inner), (inner_b, columns)) = (a.size(), b.size());
        assert_eq!(inner, inner_b, "factors that do not fit");
        assert_eq!(out.len(), rows * columns, "a product of another size");
        // Below six rows nalgebra falls back to one product of matrix and vector for each column.
        if self == Self::Portable || rows.min(columns).min(inner) < 6 {
            return portable(out, a, b);
        }
        DMatrixViewMut::from_slice(out, rows, columns).gemm(T::one(), &a.view(), &b.view(), T::zero());
    }
}

/// How many partial sums a dot product keeps: a fixed order that compilers turn into vector instructions.
const LANES: usize = 8;

/// Additions in the order of the inner index, on the widest vectors that the machine has: their width changes no bit.
fn portable<T: Real>(out: &mut [T], a: Factor<'_, T>, b: Factor<'_, T>) {
    let (rows, _) = a.size();
    // A row is a column in memory: (a·b)ᵀ = bᵀ·aᵀ has longer inner loops.
    let (a, b) = if rows == 1 { (b.transposed(), a.transposed()) } else { (a, b) };
    let (a, b) = (a.straightened(), b.straightened());
    Arch::new().dispatch(
        #[inline(always)]
        || by_columns(out, a, b),
    );
}

#[inline(always)]
fn by_columns<T: Real>(out: &mut [T], a: Factor<'_, T>, b: Factor<'_, T>) {
    let ((rows, inner), _) = (a.size(), b.size());
    for (j, column) in out.chunks_exact_mut(rows).enumerate() {
        if !a.transposed {
            let factors = (0..inner).map(|k| b.at(k, j));
            column_of_columns(column, a.values, factors);
        } else if !b.transposed {
            let right = &b.values[j * inner..][..inner];
            for (i, sum) in column.iter_mut().enumerate() {
                *sum = dot(&a.values[i * inner..][..inner], right);
            }
        } else {
            for (i, sum) in column.iter_mut().enumerate() {
                *sum = (0..inner).fold(T::zero(), |sum, k| sum + a.at(i, k) * b.at(k, j));
            }
        }
    }
}

/// Rows whose sums stay in registers while the columns pass by.
const BLOCK: usize = 64;

/// `out` := Σ column·factor over the columns in `values`.
#[inline(always)]
fn column_of_columns<T: Real>(out: &mut [T], values: &[T], factors: impl Iterator<Item = T> + Clone) {
    let rows = out.len();
    let mut blocks = out.chunks_exact_mut(BLOCK);
    let mut first = 0;
    for block in &mut blocks {
        let mut sums = [T::zero(); BLOCK];
        for (column, factor) in values.chunks_exact(rows).zip(factors.clone()) {
            for (sum, &value) in sums.iter_mut().zip(&column[first..first + BLOCK]) {
                *sum += value * factor;
            }
        }
        block.copy_from_slice(&sums);
        first += BLOCK;
    }
    let rest = blocks.into_remainder();
    rest.fill(T::zero());
    for (column, factor) in values.chunks_exact(rows).zip(factors) {
        for (sum, &value) in rest.iter_mut().zip(&column[first..]) {
            *sum += value * factor;
        }
    }
}

#[inline(always)]
fn dot<T: Real>(a: &[T], b: &[T]) -> T {
    let mut sums = [T::zero(); LANES];
    let (a_lanes, b_lanes) = (a.chunks_exact(LANES), b.chunks_exact(LANES));
    let rest = a_lanes.remainder().iter().zip(b_lanes.remainder()).fold(T::zero(), |sum, (&x, &y)| sum + x * y);
    for (x, y) in a_lanes.zip(b_lanes) {
        for lane in 0..LANES {
            sums[lane] += x[lane] * y[lane];
        }
    }
    sums.into_iter().fold(rest, |sum, lane| sum + lane)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A matrix of small whole numbers, so that every order of additions gives the same sum.
    fn matrix(rows: usize, columns: usize, salt: usize) -> Vec<f32> {
        (0..rows * columns).map(|i| ((i * 7 + salt) % 11) as f32 - 5.0).collect()
    }

    #[test]
    fn both_kernels_multiply_all_shapes_either_way_round() {
        for (rows, inner, columns) in [(1, 9, 17), (9, 1, 17), (64, 38, 33), (7, 20, 6), (3, 4, 5), (8, 64, 1)] {
            for (flip_a, flip_b) in [(false, false), (true, false), (false, true), (true, true)] {
                let (a, b) = (matrix(rows, inner, 1), matrix(inner, columns, 4));
                let entry = |values: &[f32], flip: bool, (rows, columns): (usize, usize), i: usize, j: usize| {
                    if flip { values[i * columns + j] } else { values[j * rows + i] }
                };
                let factor = |values, flip, (rows, columns)| {
                    if flip {
                        Factor::new(values, columns, rows).transposed()
                    } else {
                        Factor::new(values, rows, columns)
                    }
                };
                let a_factor = factor(&a[..], flip_a, (rows, inner));
                let b_factor = factor(&b[..], flip_b, (inner, columns));
                for kernel in [Kernel::Fast, Kernel::Portable] {
                    let mut out = vec![f32::NAN; rows * columns];
                    kernel.multiply(&mut out, a_factor, b_factor);
                    for i in 0..rows {
                        for j in 0..columns {
                            let sum: f32 = (0..inner)
                                .map(|k| {
                                    entry(&a, flip_a, (rows, inner), i, k) * entry(&b, flip_b, (inner, columns), k, j)
                                })
                                .sum();
                            assert_eq!(out[j * rows + i], sum, "{kernel:?} {rows} {inner} {columns} at {i} {j}");
                        }
                    }
                }
            }
        }
    }
}
