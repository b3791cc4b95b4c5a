//! Networks in integers: `policy.q.json`, made from a trained network's weights.
//!
//! The arithmetic is [`tpg_runtime::net`]'s, which this module calls: weights with a scale for each row, `i32` accumulators
//! that are proven not to overflow, one rounding rule. The kind says how many bits weights and activations have:
//!
//! | kind | weights | hidden activations | inputs |
//! | --- | --- | --- | --- |
//! | `w8a16` | −128 to 127 | 0 to 32767 | multiples of 1/4096 |
//! | `w16a16` | −32768 to 32767 | 0 to 32767 | multiples of 1/4096 |
//! | `w8a8` | −127 to 127 | 0 to 127 | multiples of 1/32, −127 to 127 |
//!
//! The last layer of a `w8a8` network is `w8a16`: it is small, and its outputs would be coarse.
//!
//! | module | subject |
//! | --- | --- |
//! | `network` | [`QuantisedPolicy`]: a network in integers, checked |
//! | `file` | its text, version 1 for the arm's networks and version 2 for any other |
//! | `meaning` | inputs, outputs and what they mean |
//! | `float` | a network in floating point, and its calibration |
//! | `quantise` | from floating point to integers |
//! | `model`, `emit` | words and C; Rust |
//! | `plain` | C that needs no library |

mod emit;
mod file;
mod float;
mod meaning;
mod model;
mod network;
mod plain;
mod quantise;

pub use emit::to_rust;
pub use float::{FloatNetwork, FloatOutput, FloatValue};
pub use meaning::{Input, Output, Preferences, ValueOutput};
pub use model::{to_c, to_words};
pub use network::{QuantisedLayer, QuantisedPolicy, ROUNDING};
pub use plain::{differences, to_plain_c};
pub use quantise::{FloatLayer, QuantiseError, quantise};
