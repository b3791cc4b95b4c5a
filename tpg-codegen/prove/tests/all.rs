//! The tests of this crate from outside, as one program: each file is a subject.

mod answers;
mod emulator;
mod instructions;
mod objects;
