//! The tests of this crate from outside, as one program: each file is a subject.

mod arm;
mod behind;
mod control_among_balls;
mod dodge;
mod episode;
mod frame;
mod hybrid;
mod kinematics;
mod network;
mod radial;
mod sensors;
mod sources;
