//! The runtime of learned policies: what trainer, interpreter, generated code and firmware share.
//!
//! Every meaning has its one definition here. A policy decides the same in training, in the interpreter, in generated Rust, in
//! generated C and on a Cortex-M4 because they all use this crate.
//!
//! # Map
//!
//! | module | subject |
//! | --- | --- |
//! | [`policy`] | the [`Policy`](policy::Policy) trait that generated code implements |
//! | [`ops`] | the instruction set, and sin, cos, tan, ln, exp with the same bits everywhere |
//! | [`cycle`] | has this been here before? |
//! | [`switch`] | two policies over one problem, and the rules by which they take turns |
//! | [`net`] | networks in integers, of any shape |
//! | [`scalar`] | `f32` and `f64` |
//! | [`mod@named`] | enumerations whose values have names in files |
//!
//! # Features
//!
//! | feature | effect |
//! | --- | --- |
//! | `std` | [`ops::System`] is the platform's libm instead of the crate `libm` |
//! | `standalone` | the text of the files that generated code needs, for tools that compile it |
//!
//! No heap, no panic, no `unsafe`; builds for `thumbv7em-none-eabihf` and `thumbv6m-none-eabi`. MSRV 1.89.

#![no_std]

#[cfg(any(feature = "std", test))]
extern crate std;

pub mod cycle;
pub mod named;
pub mod net;
pub mod ops;
pub mod policy;
pub mod scalar;
#[cfg(feature = "standalone")]
pub mod standalone;
pub mod switch;
