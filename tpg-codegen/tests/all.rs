//! The tests of this crate from outside, as one program: each file is a subject.

mod c_lint;
mod command_line;
mod common;
mod compilers;
mod constant_time;
mod contraction;
mod convert;
mod cortex_m4;
mod eva;
mod expect;
mod generate;
mod generated;
mod least;
mod memory;
mod networks;
mod outputs;
mod own_maths_c;
mod packages;
mod passes;
mod policy_kinds;
mod proven;
mod random_graphs;
mod report;
mod ten_thousand_teams;
mod two_policies;
mod verify;
