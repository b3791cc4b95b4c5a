//! The tests of this crate from outside, as one program: each file is a subject.

mod among_balls;
mod asking;
mod calls;
mod header;
mod library;
mod linked;
mod network;
mod radial;
mod text;
