//! The tests of this crate from outside, as one program: each file is a subject.

mod bad_input;
mod dot_import;
mod dot_values;
mod json;
mod outputs;
mod schema;
