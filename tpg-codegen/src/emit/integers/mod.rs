//! Programs in integers as text.
//!
//! | module | subject |
//! | --- | --- |
//! | `body` | teams, leaves and the ways between them |
//! | `lines` | values as statements: one sum a line |
//! | `spelling` | what a language spells its own way |
//! | `comment` | the formula in the units of the sources, and the bound |
//! | `dense` | outputs that are sums of the same values, as a table and a loop |
//! | `c`, `view`, `rust` | text |

mod body;
mod c;
mod comment;
mod dense;
mod lines;
mod rust;
mod spelling;
mod view;

pub(crate) use comment::{bids_in_units, output_in_units};

pub(crate) use comment::worth_from;

use super::file::File;
use crate::integers::Integers;
use crate::options::Language;
use crate::program::Program;

/// The turns of the loops in the C of a program in integers, if it has any.
pub(crate) fn turns(program: &Program<'_>, integers: &Integers) -> Option<[u64; 2]> {
    Some(dense::Dense::find(&program.module, integers)?.turns())
}

/// The files of a program in integers.
pub(super) fn files(program: &Program<'_>, integers: &Integers) -> Vec<File> {
    match program.language {
        Language::C => c::files(program, integers),
        Language::Rust => rust::files(program, integers),
    }
}
