//! Networks in integers, of any shape: `i8` or `i16` weights, `i16` activations, `i32` accumulators.
//!
//! A network is one array of words ([`pack`]) that lies in a target's flash. [`Model::parse`] checks and borrows it, and
//! answers from states: no heap, no panic, and the same bits in Rust, in C and on every core.
//!
//! One layer's output o is, for inputs x:
//!
//! acc = bias\[o\] + Σ weights\[o\]\[i\]·x\[i\], exactly, in `i32`;
//! y = (acc·factor\[o\] + 2^(shift\[o\] − 1)) >> shift\[o\] in `i64`: rounded to nearest, halves upwards;
//! then clipped to 0..=32767 behind a hidden layer (its ReLU) and to −32767..=32767 behind the last one.
//!
//! That is the whole arithmetic, and every kernel that computes it gives the same bits. [`pack`] proves
//! at build time that no accumulator can overflow, for any input at all.
//!
//! | number | unit |
//! | --- | --- |
//! | an input | 1/4096 of (value − offset)·scale ([`Scaling`]) |
//! | an output that is a preference | 1/2048 |
//! | an output that becomes a value | 2^−exponent, then a fraction of half its range in 1/16384 ([`Value`]) |
//!
//! ```
//! use tpg_runtime::net::{Kind, LayerRows, Meaning, Model, OutputKind, Rescale, Scaling, Squash, Value, Weights, pack, words};
//!
//! // A torque from an angle in degrees: −2·tanh(angle/90°), in one layer without hidden ones.
//! const TORQUE: Meaning<'static> = Meaning {
//!     contract: 0,
//!     inputs: &[Scaling { offset: 0.0, scale: 1.0 / 90.0 }],
//!     answer: OutputKind::Values,
//!     values: &[Value { min: -2.0, max: 2.0, squash: Squash::Tanh, exponent: 11 }],
//! };
//! const SIZES: [(usize, usize, Kind); 1] = [(1, 1, Kind::W8A16)];
//! static MODEL: [u32; words(&SIZES, &TORQUE)] = {
//!     // An accumulator of 4096·64 is a preference of 1, which is 2048: times 2^−7.
//!     let rescale = [Rescale { factor: 1 << 14, shift: 21 }];
//!     let layer = LayerRows { inputs: 1, kind: Kind::W8A16, weights: Weights::I8(&[-64]), bias: &[0], rescale: &rescale };
//!     let mut words = [0; words(&SIZES, &TORQUE)];
//!     assert!(pack(&[layer], &TORQUE, &mut words), "no input may overflow an accumulator");
//!     words
//! };
//!
//! let model = Model::parse(&MODEL)?;
//! let (mut scratch, mut torque) = ([0; 8], [0.0]);
//! assert!(model.values(&[45.0], &mut scratch, &mut torque));
//! assert!((torque[0] + 2.0 * libm::tanhf(0.5)).abs() < 0.001);
//! # Ok::<(), tpg_runtime::net::ModelError>(())
//! ```

mod crc;
mod input;
mod layer;
mod meaning;
mod model;
mod pack;
mod tanh;

pub use crc::of_names as contract;
pub use input::{INPUT_ONE, integer};
pub use layer::{HIDDEN, LAST, PREFERENCE_ONE, Rescale, accumulate};
pub use meaning::{FRACTION_ONE, Meaning, OutputKind, Scaling, Squash, Value};
pub use model::{Model, ModelError};
pub use pack::{LAYERS, LayerRows, MAGIC, VERSION, WIDTH, Weights, pack, words};
pub use tpg_kernels::{Kind, ROWS};

#[cfg(test)]
mod tests;
