//! Programs in integers: their teams, leaves and sums, in the spelling of C and of Rust.
//!
//! | module | subject |
//! | --- | --- |
//! | `work` | teams and leaves |
//! | `lines` | values as statements: one sum a line |
//! | `spelling` | what a language spells its own way |
//! | `comment` | the formula in the units of the sources, and the bound |
//! | `dense` | outputs that are sums of the same values, as a table and a loop |

mod comment;
mod dense;
mod lines;
mod spelling;
mod work;

pub(crate) use comment::{bids_in_units, output_in_units, worth_from};
pub(super) use comment::{with_unit, worth};
pub(super) use dense::{Dense, DenseTable};
pub(super) use spelling::answer_bits;
pub(crate) use spelling::state_bits;
pub(super) use work::Work;

use crate::integers::Integers;
use crate::program::Program;

/// The turns of the loops in the C of a program in integers, if it has any.
pub(crate) fn turns(program: &Program<'_>, integers: &Integers) -> Option<[u64; 2]> {
    Some(Dense::find(&program.module, integers)?.turns())
}
