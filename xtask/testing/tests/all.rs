//! The tests of this crate from outside, as one program: each file is a subject.

mod links;
mod listed;
mod nevers;
mod published;
