//! The tables and coefficients of own maths in C, printed from the constants of the runtime: the numbers stand once.

use super::expression::Printer;
use crate::emit::syntax::Syntax;
use tpg_graph::ScalarType;
use tpg_runtime::ops::own::{f32 as single, f64 as double};

/// The constants as C literals.
pub(super) struct OwnMaths {
    pub(super) two_over_pi: Vec<String>,
    /// The rows of the polynomials of sine and cosine.
    pub(super) circle: [String; 2],
    pub(super) half_pi: String,
    pub(super) ln_2_high: String,
    pub(super) ln_2_low: String,
    pub(super) log2_e: String,
    pub(super) ln: Vec<String>,
    pub(super) exp: Vec<String>,
    pub(super) atan: Vec<String>,
    /// π/4, what is missing from it, and the same of π/2.
    pub(super) quarters: Vec<String>,
    pub(super) tanh: Vec<String>,
}

/// Entries of the `f32` table of 2/π that are read; the zeros after them save a bounds check in Rust.
const READ: usize = 25;

impl OwnMaths {
    pub(super) fn new(printer: &Printer<'_>) -> Self {
        match printer.graph.scalar() {
            ScalarType::F32 => Self::single(printer),
            ScalarType::F64 => Self::double(printer),
        }
    }

    fn single(printer: &Printer<'_>) -> Self {
        let number = |value: f32| printer.literal(f64::from(value));
        Self {
            two_over_pi: words(&single::TWO_OVER_PI[..READ]),
            circle: single::CIRCLE.map(|row| row.map(number).join(", ")),
            half_pi: format!("{:#x}U", single::HALF_PI),
            ln_2_high: number(single::LN_2_HIGH),
            ln_2_low: number(single::LN_2_LOW),
            log2_e: number(std::f32::consts::LOG2_E),
            ln: single::LN.map(number).to_vec(),
            exp: single::EXP.map(number).to_vec(),
            atan: single::ATAN.map(number).to_vec(),
            quarters: single::QUARTERS.as_flattened().iter().copied().map(number).collect(),
            tanh: single::TANH.map(number).to_vec(),
        }
    }

    fn double(printer: &Printer<'_>) -> Self {
        let number = |value: f64| printer.literal(value);
        let row = |row: [f64; 7]| {
            let (first, second) = row.split_at(5);
            let line = |numbers: &[f64]| numbers.iter().map(|&value| number(value)).collect::<Vec<_>>().join(", ");
            format!("{},\n         {}", line(first), line(second))
        };
        Self {
            two_over_pi: words(&double::TWO_OVER_PI),
            circle: double::CIRCLE.map(row),
            half_pi: format!("((uint64_t){:#x}U << 32) | {:#x}U", double::HALF_PI >> 32, double::HALF_PI as u32),
            ln_2_high: number(double::LN_2_HIGH),
            ln_2_low: number(double::LN_2_LOW),
            log2_e: number(std::f64::consts::LOG2_E),
            ln: double::LN.map(number).to_vec(),
            exp: double::EXP.map(number).to_vec(),
            atan: double::ATAN.map(number).to_vec(),
            quarters: double::QUARTERS.as_flattened().iter().copied().map(number).collect(),
            tanh: double::TANH.map(number).to_vec(),
        }
    }
}

fn words(table: &[u32]) -> Vec<String> {
    table.iter().map(|word| format!("{word:#010x}U")).collect()
}
