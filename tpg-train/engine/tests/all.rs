//! The tests of this crate from outside, as one program: each file is a subject.

mod failing;
mod side_by_side;
mod threads;
mod visiting;
