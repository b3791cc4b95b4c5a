//! Networks in integers: `policy.q.json`, made from a trained network's weights.
//!
//! The arithmetic is [`tpg_runtime::net`]'s, which this module calls: weights with a scale for each row, `i32` accumulators
//! that are proven not to overflow, one rounding rule. Inputs are multiples
//! of 1/4096, hidden activations 0 to 32767; the kind says how many bits weights have:
//!
//! | kind | weights |
//! | --- | --- |
//! | `w8a16` | −128 to 127 |
//! | `w16a16` | −32768 to 32767 |
//!
//! | module | subject |
//! | --- | --- |
//! | `network` | [`QuantisedPolicy`]: a network in integers, checked |
//! | `file` | its text |
//! | `meaning` | inputs, outputs and what they mean |
//! | `float` | a network in floating point, and its calibration |
//! | `quantise` | from floating point to integers |
//! | `model`, `emit` | words and C; Rust |
//! | `plain` | C that needs no library |
//! | `asked` | the same with the graph that asks it |

mod asked;
mod emit;
mod file;
mod float;
mod meaning;
mod model;
mod network;
mod plain;
mod quantise;

pub use asked::to_asking_c;
pub use emit::to_rust;
pub use float::{FloatNetwork, FloatOutput, FloatValue};
pub use meaning::{Input, Output, Preferences, ValueOutput};
pub use model::{to_c, to_words};
pub use network::{QuantisedLayer, QuantisedPolicy, ROUNDING};
pub use plain::{differences, to_plain_c};
pub use quantise::{FloatLayer, QuantiseError, quantise};
