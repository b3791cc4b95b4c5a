//! The matrix product with a fixed order of additions.
//!
//! Every element of a product is Σₖ aᵢₖ·bₖⱼ with k ascending from a sum of zero, each multiplication and each addition
//! rounded separately. Vectors and registers hold different elements, never parts of one element's sum, so neither the
//! width of the machine's vectors nor the size of a batch changes a bit. The one exception is a single-row left factor
//! times whole columns, which is a [`dot`] product of sixteen partial sums.

mod columns;
mod tiles;
mod zeros;

use super::sum::dot;
use super::vectors::{Vector, load, many_registers, where_positive};
use fearless_simd::{Level, Simd, dispatch};

/// A factor of a product: a column-major matrix, used as it is or transposed.
#[derive(Clone, Copy, Debug)]
pub struct Factor<'a> {
    values: &'a [f32],
    rows: usize,
    columns: usize,
    transposed: bool,
    sparse: bool,
}

impl<'a> Factor<'a> {
    /// Wraps a column-major matrix of the given size.
    ///
    /// # Panics
    /// If `values` does not hold exactly `rows`·`columns` numbers.
    pub fn new(values: &'a [f32], rows: usize, columns: usize) -> Self {
        assert_eq!(values.len(), rows * columns, "a matrix of another size");
        Self { values, rows, columns, transposed: false, sparse: false }
    }

    /// Returns the transposed matrix.
    pub fn transposed(self) -> Self {
        Self { transposed: !self.transposed, ..self }
    }

    /// Marks the matrix, as a right factor, as having many zeros: columns of zeros, and zeros of a single column, are
    /// detected and skipped. That changes no bit as long as the left factor is finite.
    pub fn sparse(self) -> Self {
        Self { sparse: true, ..self }
    }

    /// Returns the numbers in memory order.
    pub fn values(&self) -> &'a [f32] {
        self.values
    }

    fn size(&self) -> (usize, usize) {
        if self.transposed { (self.columns, self.rows) } else { (self.rows, self.columns) }
    }
}

/// Operation applied to the elements of a product before they are stored.
#[derive(Clone, Copy, Debug)]
pub enum Finish<'a> {
    /// No operation.
    Plain,
    /// Adds the row's bias.
    Bias(&'a [f32]),
    /// Adds the row's bias and sets values that are not above zero to zero (ReLU).
    Rectified(&'a [f32]),
    /// Zeroes the elements at which this matrix, of the product's size, is not above zero: the backward pass of a ReLU.
    Where(&'a [f32]),
}

impl Finish<'_> {
    /// Finishes the element in that row, at index `place` of the product.
    #[inline(always)]
    fn scalar(self, row: usize, place: usize, sum: f32) -> f32 {
        match self {
            Self::Plain => sum,
            Self::Bias(bias) => sum + bias[row],
            Self::Rectified(bias) => rectified(sum + bias[row]),
            Self::Where(passed) => passing(sum, passed[place]),
        }
    }

    /// Finishes one vector of rows, from that row and place on.
    #[inline(always)]
    fn vector<S: Simd>(self, simd: S, row: usize, place: usize, sum: Vector<S>) -> Vector<S> {
        match self {
            Self::Plain => sum,
            Self::Bias(bias) => sum + load(simd, &bias[row..], 0),
            Self::Rectified(bias) => {
                let sum = sum + load(simd, &bias[row..], 0);
                where_positive::<S>(simd, sum, sum)
            }
            Self::Where(passed) => where_positive::<S>(simd, sum, load(simd, &passed[place..], 0)),
        }
    }
}

/// ReLU; NaN becomes zero.
#[inline(always)]
pub(super) fn rectified(value: f32) -> f32 {
    if value > 0.0 { value } else { 0.0 }
}

/// Returns the gradient where a ReLU's output was positive, zero elsewhere.
#[inline(always)]
pub(super) fn passing(gradient: f32, passed: f32) -> f32 {
    if passed > 0.0 { gradient } else { 0.0 }
}

/// Buffers for products; they grow to the size of the largest one.
#[derive(Clone, Debug, Default)]
pub struct Scratch {
    /// Panels of the left factor: for each tile's rows, column after column.
    panels: Vec<f32>,
    /// A tile, column by column.
    sums: Vec<f32>,
    /// Columns of the right factor that are not all zeros: their indices, and the columns side by side.
    kept: Vec<usize>,
    gathered: Vec<f32>,
}

/// Computes `out` := finish(`a`·`b`); `out` is column-major.
///
/// # Panics
/// If the sizes do not match.
pub fn multiply(out: &mut [f32], a: Factor<'_>, b: Factor<'_>, finish: Finish<'_>, scratch: &mut Scratch) {
    dispatch!(Level::new(), simd => Product { out, a, b, finish, scratch }.compute(simd));
}

struct Product<'a> {
    out: &'a mut [f32],
    a: Factor<'a>,
    b: Factor<'a>,
    finish: Finish<'a>,
    scratch: &'a mut Scratch,
}

impl Product<'_> {
    #[inline(always)]
    fn compute<S: Simd>(self, simd: S) {
        let ((rows, inner), (inner_b, columns)) = (self.a.size(), self.b.size());
        assert_eq!(inner, inner_b, "factors that do not fit");
        assert_eq!(self.out.len(), rows * columns, "a product of another size");
        if let Finish::Bias(bias) | Finish::Rectified(bias) = self.finish {
            assert_eq!(bias.len(), rows, "a bias of another size");
        }
        if let Finish::Where(passed) = self.finish {
            assert_eq!(passed.len(), self.out.len(), "a mask of another size");
        }
        if rows == 1 && !self.b.transposed {
            for (place, column) in self.b.values.chunks_exact(inner.max(1)).enumerate() {
                self.out[place] = self.finish.scalar(0, place, dot(self.a.values, column));
            }
        } else if columns == 1 && !self.a.transposed {
            let Self { out, a, b, finish, scratch } = self;
            if b.sparse {
                columns::by_columns_of_sparse(simd, out, a.values, b.values, finish, &mut scratch.kept);
            } else {
                columns::by_columns(simd, out, a.values.chunks_exact(rows).zip(b.values.iter().copied()), finish);
            }
        } else if rows == 1 && matches!(self.finish, Finish::Plain) {
            // One row in memory is one column: (a·b)ᵀ = bᵀ·aᵀ.
            let pairs = self.b.values.chunks_exact(columns).zip(self.a.values.iter().copied());
            columns::by_columns(simd, self.out, pairs, self.finish);
        } else if many_registers::<S>() {
            self.by_tiles_of_samples::<S, 1, 16>(simd);
        } else {
            self.by_tiles_of_samples::<S, 2, 4>(simd);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::DMatrix;
    use tpg_engine::random::{Purpose, Stream};

    const SHAPES: [(usize, usize, usize); 9] = [
        (1, 9, 17),
        (9, 1, 17),
        (64, 38, 33),
        (7, 20, 6),
        (3, 4, 5),
        (8, 64, 1),
        (300, 21, 1),
        (1, 40, 40),
        (40, 33, 8),
    ];
    const FLIPS: [(bool, bool); 4] = [(false, false), (true, false), (false, true), (true, true)];

    fn normals(count: usize, salt: u64) -> Vec<f32> {
        let mut numbers = vec![0.0; count];
        Stream::new(salt, 0, Purpose::Test, 23).normals(&mut numbers);
        numbers
    }

    /// Creates a factor of that size, stored either way round.
    fn factor(values: &[f32], flip: bool, (rows, columns): (usize, usize)) -> Factor<'_> {
        if flip { Factor::new(values, columns, rows).transposed() } else { Factor::new(values, rows, columns) }
    }

    /// Lists the widths of vectors that this processor has.
    fn levels() -> Vec<Level> {
        let widest = Level::new();
        #[cfg(target_arch = "x86_64")]
        let narrower = [
            widest.as_sse2().map(Level::Sse2),
            widest.as_sse4_2().map(Level::Sse4_2),
            widest.as_avx2().map(Level::Avx2),
        ];
        #[cfg(not(target_arch = "x86_64"))]
        let narrower = [None];
        narrower.into_iter().flatten().chain([widest]).collect()
    }

    fn bits(values: &[f32]) -> Vec<u32> {
        values.iter().map(|value| value.to_bits()).collect()
    }

    /// Computes a product number by number, in the documented order.
    fn plainly(a: Factor<'_>, b: Factor<'_>, finish: Finish<'_>) -> Vec<f32> {
        let at = |factor: Factor<'_>, row: usize, column: usize| {
            let (row, column) = if factor.transposed { (column, row) } else { (row, column) };
            factor.values[column * factor.rows + row]
        };
        let ((rows, inner), (_, columns)) = (a.size(), b.size());
        let whole = rows == 1 && !b.transposed;
        let product = |place: usize| {
            let (row, column) = (place % rows, place / rows);
            let sum = if whole {
                dot(a.values, &b.values[column * inner..][..inner])
            } else {
                (0..inner).fold(0.0, |sum, k| sum + at(a, row, k) * at(b, k, column))
            };
            finish.scalar(row, place, sum)
        };
        (0..rows * columns).map(product).collect()
    }

    #[test]
    fn every_width_of_vectors_gives_the_bits_of_single_numbers() {
        let mut scratch = Scratch::default();
        for (rows, inner, columns) in SHAPES {
            let (a, b, bias) = (normals(rows * inner, 1), normals(inner * columns, 2), normals(rows, 3));
            let passed = normals(rows * columns, 4);
            for (flip_a, flip_b) in FLIPS {
                let (a, b) = (factor(&a, flip_a, (rows, inner)), factor(&b, flip_b, (inner, columns)));
                for finish in [Finish::Plain, Finish::Bias(&bias), Finish::Rectified(&bias), Finish::Where(&passed)] {
                    let expected = bits(&plainly(a, b, finish));
                    for level in levels() {
                        let mut out = vec![f32::NAN; rows * columns];
                        let product = Product { out: &mut out, a, b, finish, scratch: &mut scratch };
                        dispatch!(level, simd => product.compute(simd));
                        assert!(bits(&out) == expected, "{rows} {inner} {columns} {finish:?} {level:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn columns_of_zeros_are_left_out_without_changing_a_bit() {
        let (rows, inner, columns) = (37, 20, 70);
        let (a, bias, passed) = (normals(rows * inner, 1), normals(rows, 3), normals(rows * columns, 4));
        let a = Factor::new(&a, rows, inner);
        // First and last columns, some in between, most, all, none.
        let kept: [fn(usize) -> bool; 5] = [|c| (9..60).contains(&c), |c| c % 3 == 1, |c| c == 41, |_| false, |_| true];
        let mut scratch = Scratch::default();
        for kept in kept {
            let mut b = normals(inner * columns, 2);
            let zeros = b.chunks_exact_mut(inner).enumerate().filter(|&(column, _)| !kept(column));
            zeros.for_each(|(_, column)| column.fill(0.0));
            let b = Factor::new(&b, inner, columns);
            for finish in [Finish::Plain, Finish::Bias(&bias), Finish::Where(&passed)] {
                let expected = bits(&plainly(a, b, finish));
                for (level, b) in levels().into_iter().flat_map(|level| [(level, b), (level, b.sparse())]) {
                    let mut out = vec![f32::NAN; rows * columns];
                    let product = Product { out: &mut out, a, b, finish, scratch: &mut scratch };
                    dispatch!(level, simd => product.compute(simd));
                    assert!(bits(&out) == expected, "{finish:?} {level:?}");
                }
            }
        }
    }

    #[test]
    fn zeros_of_a_single_column_are_left_out_without_changing_a_bit() {
        let (rows, inner) = (301, 40);
        let (a, bias, mut b) = (normals(rows * inner, 1), normals(rows, 3), normals(inner, 2));
        for zeros in [0, 17, inner] {
            b.iter_mut().step_by(2).take(zeros).for_each(|value| *value = 0.0);
            let (a, b, finish) = (Factor::new(&a, rows, inner), Factor::new(&b, inner, 1), Finish::Rectified(&bias));
            let expected = bits(&plainly(a, b, finish));
            for (level, b) in levels().into_iter().flat_map(|level| [(level, b), (level, b.sparse())]) {
                let mut out = vec![f32::NAN; rows];
                let product = Product { out: &mut out, a, b, finish, scratch: &mut Scratch::default() };
                dispatch!(level, simd => product.compute(simd));
                assert!(bits(&out) == expected, "{zeros} zeros, {level:?}");
            }
        }
    }

    #[test]
    fn a_gradient_passes_where_a_relu_did() {
        let (rows, inner, columns) = (19, 7, 23);
        let (a, b, passed) = (normals(rows * inner, 1), normals(inner * columns, 2), normals(rows * columns, 4));
        let (a, b) = (Factor::new(&a, rows, inner), Factor::new(&b, inner, columns));
        let mut scratch = Scratch::default();
        let [mut plain, mut masked] = [(); 2].map(|()| vec![f32::NAN; rows * columns]);
        multiply(&mut plain, a, b, Finish::Plain, &mut scratch);
        multiply(&mut masked, a, b, Finish::Where(&passed), &mut scratch);
        for ((masked, plain), passed) in masked.into_iter().zip(plain).zip(passed) {
            assert_eq!(masked, if passed > 0.0 { plain } else { 0.0 });
        }
    }

    #[test]
    fn products_are_nalgebras_but_for_rounding() {
        for (rows, inner, columns) in SHAPES {
            let (a, b) = (normals(rows * inner, 1), normals(inner * columns, 2));
            for (flip_a, flip_b) in FLIPS {
                let matrix = |values: &[f32], flip: bool, (rows, columns): (usize, usize)| {
                    if flip {
                        DMatrix::from_column_slice(columns, rows, values).transpose()
                    } else {
                        DMatrix::from_column_slice(rows, columns, values)
                    }
                };
                let expected = matrix(&a, flip_a, (rows, inner)) * matrix(&b, flip_b, (inner, columns));
                let mut scratch = Scratch::default();
                let mut out = vec![f32::NAN; rows * columns];
                let (a, b) = (factor(&a, flip_a, (rows, inner)), factor(&b, flip_b, (inner, columns)));
                multiply(&mut out, a, b, Finish::Plain, &mut scratch);
                for (ours, theirs) in out.iter().zip(expected.as_slice()) {
                    assert!((ours - theirs).abs() < 1e-6 * inner as f32, "{rows} {inner} {columns}: {ours} {theirs}");
                }
            }
        }
    }

    #[test]
    fn a_batch_gives_each_sample_what_it_gets_alone() {
        let (rows, inner, columns) = (70, 38, 19);
        let (a, b, bias) = (normals(rows * inner, 1), normals(inner * columns, 2), normals(rows, 3));
        let mut scratch = Scratch::default();
        let mut together = vec![f32::NAN; rows * columns];
        let a = Factor::new(&a, rows, inner);
        multiply(&mut together, a, Factor::new(&b, inner, columns), Finish::Rectified(&bias), &mut scratch);
        for (column, expected) in b.chunks(inner).zip(together.chunks(rows)) {
            let mut alone = vec![f32::NAN; rows];
            multiply(&mut alone, a, Factor::new(column, inner, 1), Finish::Rectified(&bias), &mut scratch);
            assert_eq!(alone, expected);
        }
    }
}
