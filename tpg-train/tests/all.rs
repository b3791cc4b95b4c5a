//! The tests of this crate from outside, as one program: each file is a subject.

mod arms;
mod asking;
mod counts;
mod damaged_checkpoints;
mod evaluator;
mod hybrid_any;
mod hybrid_study;
mod own_environment;
mod readme;
mod report;
mod runs;
mod sac_runs;
