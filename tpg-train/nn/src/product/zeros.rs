//! Columns of zeros in the right factor: samples that a loss does not depend on, such as the half of a batch for which
//! the other critic has the smaller value.

use super::{Factor, Finish, Product};
use fearless_simd::Simd;

impl Product<'_> {
    /// As [`by_tiles`](Self::by_tiles), but skips columns of zeros in a [`sparse`](Factor::sparse) right factor if
    /// there are enough of them to save a tile.
    #[inline(always)]
    pub(super) fn by_tiles_of_samples<S: Simd, const M: usize, const N: usize>(self, simd: S) {
        let Self { out, a, b, finish, scratch } = self;
        let ((rows, _), (inner, columns)) = (a.size(), b.size());
        let (mut kept, mut gathered) = (std::mem::take(&mut scratch.kept), std::mem::take(&mut scratch.gathered));
        let may = b.sparse && !b.transposed && matches!(finish, Finish::Plain | Finish::Where(_));
        let some = may && keep(&mut kept, b, N);
        if some {
            gathered.clear();
            kept.iter().for_each(|&column| gathered.extend_from_slice(&b.values[column * inner..][..inner]));
        }
        Product {
            out: if some { &mut out[..rows * kept.len()] } else { &mut *out },
            b: if some { Factor::new(&gathered, inner, kept.len()) } else { b },
            finish: if some { Finish::Plain } else { finish },
            a,
            scratch,
        }
        .by_tiles::<S, M, N>(simd);
        if some {
            spread(out, rows, columns, &kept);
            if let Finish::Where(passed) = finish {
                out.iter_mut().zip(passed).for_each(|(out, &passed)| *out = super::passing(*out, passed));
            }
        }
        (scratch.kept, scratch.gathered) = (kept, gathered);
    }
}

/// Lists the columns that are not all zeros; returns true if at least `least` columns are all zeros.
fn keep(kept: &mut Vec<usize>, b: Factor<'_>, least: usize) -> bool {
    let (inner, columns) = b.size();
    kept.clear();
    let column = |index: &usize| &b.values[index * inner..][..inner];
    kept.extend((0..columns).filter(|index| column(index).iter().any(|&value| value != 0.0)));
    columns - kept.len() >= least
}

/// Moves the packed columns back to their positions, with zeros between them.
fn spread(out: &mut [f32], rows: usize, columns: usize, kept: &[usize]) {
    // Last to first: columns only move to the right, so none is overwritten before it has moved.
    let mut end = columns;
    for (from, &column) in kept.iter().enumerate().rev() {
        out[(column + 1) * rows..end * rows].fill(0.0);
        out.copy_within(from * rows..(from + 1) * rows, column * rows);
        end = column;
    }
    out[..end * rows].fill(0.0);
}
