//! The tests of this crate from outside, as one program: each file is a subject.

mod conformance;
mod hybrid_conformance;
mod kinematics;
mod results;
mod sac_conformance;
mod support;
