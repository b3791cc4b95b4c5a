//! The tests of this crate from outside, as one program: each file is a subject.

mod dodge;
mod fresh;
mod generated_policy;
mod paper;
mod self_test;
mod test_targets;
