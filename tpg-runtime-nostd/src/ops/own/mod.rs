//! Sine, cosine, tangent, logarithm, exponential, arctangent and hyperbolic tangent without loops.
//!
//! Everything is computed whatever the argument: no condition decides what is executed, so that a program has one
//! instruction count. The statements are in the order of the operations, none of which is fused or reassociated, and the
//! C templates `own_f32.c` and `own_f64.c` of `tpg-codegen` hold the same ones, with tables and coefficients that are printed
//! from the constants here: the bits are the same on every machine that rounds to nearest.
//!
//! # Method
//!
//! * **Sine and cosine** reduce every finite argument exactly, in integers (Payne and Hanek, *Radian reduction for
//!   trigonometric functions*, 1983): the mantissa times a window on the bits of 2/π is the angle in quadrants, modulo 4,
//!   as a fixed-point number. Its upper bits are the quadrant; what is left, times π/2, goes into one of two polynomials,
//!   chosen as a row of coefficients.
//! * **Tangent** is sine by cosine, which is never 0.
//! * **Logarithm**: `ln(2ᵏ·m) = k·ln 2 + 2·artanh((m − 1) / (m + 1))` for `√½ ≤ m < √2`.
//! * **Exponential**: `eˣ = 2ⁿ·eʳ` with `n` the integer nearest to `x / ln 2`.
//! * **Arctangent**: `π/4 + arctan((a − 1) / (a + 1))` or `π/2 + arctan(−1 / a)` where that leaves a smaller argument, then a
//!   polynomial.
//! * **Hyperbolic tangent**: `1 − 2 / (e²ᵃ + 1)`, and a polynomial below 0.55.
//!
//! Polynomials are minimax fits of Sollya's `fpminimax`; `tests/fixtures/own_maths/coefficients.sollya` derives them.
//!
//! # Error bounds
//!
//! In `f32` over every argument there is, in `f64` over the references in `tests/fixtures/own_maths` and 30 million
//! random arguments against 64-bit mantissas; `tests/own_maths.rs` measures them again.
//!
//! | | `f32` | `f64` |
//! | --- | --- | --- |
//! | `sin`, `cos` | 8.8e-8, 1.5 ulp | 1.7e-16, 1.5 ulp |
//! | `tan` | 3.5 ulp | 3.5 ulp |
//! | `ln` | 0.96 ulp | 0.96 ulp |
//! | `exp` | 1 ulp | 1 ulp |
//! | `atan` | 2.1 ulp | 2.5 ulp |
//! | `tanh` | 1.5 ulp | 2.5 ulp |
//!
//! `sin` is odd, keeps the sign of zero and never leaves [−1, 1]; so is `tanh`; `cos` is even. Infinities give what IEEE 754
//! recommends, NaN gives NaN.
// It is compiled alone, too, where generated code is verified: nothing here may depend on the rest of the crate.

pub mod f32;
pub mod f64;
