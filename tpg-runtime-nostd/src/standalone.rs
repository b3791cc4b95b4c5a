//! The text of the files that generated Rust needs, for compiling it with `rustc` alone.
//!
//! They need nothing but `core` (and `std` for the platform's libm), so a verifier can build them without cargo, registry
//! or network: the very text of this crate, not a copy that could differ.

/// File names, relative to a crate's `src`, and their text. `lib.rs` comes first.
pub const FILES: [(&str, &str); 15] = [
    ("lib.rs", LIB),
    ("named.rs", include_str!("named.rs")),
    ("ops/mod.rs", include_str!("ops/mod.rs")),
    ("ops/constant_time.rs", include_str!("ops/constant_time.rs")),
    ("ops/eight/mod.rs", include_str!("ops/eight/mod.rs")),
    ("ops/eight/f32.rs", include_str!("ops/eight/f32.rs")),
    ("ops/eight/f64.rs", include_str!("ops/eight/f64.rs")),
    ("ops/instruction.rs", include_str!("ops/instruction.rs")),
    ("ops/maths.rs", include_str!("ops/maths.rs")),
    ("ops/own/mod.rs", include_str!("ops/own/mod.rs")),
    ("ops/own/f32.rs", include_str!("ops/own/f32.rs")),
    ("ops/own/f64.rs", include_str!("ops/own/f64.rs")),
    ("ops/remainder.rs", include_str!("ops/remainder.rs")),
    ("policy.rs", include_str!("policy.rs")),
    ("scalar.rs", include_str!("scalar.rs")),
];

const LIB: &str = "\
#![no_std]
extern crate std;
pub mod named;
pub mod ops;
pub mod policy;
pub mod scalar;
";
