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

/// The constants of a scalar type as literals; what the types have in other shapes is given.
macro_rules! constants {
    ($printer:expr, $own:ident, $row:expr, $two_over_pi:expr, $half_pi:expr, $log2_e:expr) => {{
        let number = |value| $printer.literal(f64::from(value));
        OwnMaths {
            two_over_pi: words($two_over_pi),
            circle: $own::CIRCLE.map(|row| $row(row.map(number))),
            half_pi: $half_pi,
            ln_2_high: number($own::LN_2_HIGH),
            ln_2_low: number($own::LN_2_LOW),
            log2_e: number($log2_e),
            ln: $own::LN.map(number).to_vec(),
            exp: $own::EXP.map(number).to_vec(),
            atan: $own::ATAN.map(number).to_vec(),
            quarters: $own::QUARTERS.as_flattened().iter().copied().map(number).collect(),
            tanh: $own::TANH.map(number).to_vec(),
        }
    }};
}

impl OwnMaths {
    pub(super) fn new(printer: &Printer<'_>) -> Self {
        match printer.graph.scalar() {
            ScalarType::F32 => {
                let half_pi = format!("{:#x}U", single::HALF_PI);
                let row = |row: [String; 4]| row.join(", ");
                constants!(printer, single, row, &single::TWO_OVER_PI[..READ], half_pi, std::f32::consts::LOG2_E)
            }
            ScalarType::F64 => {
                let half_pi =
                    format!("((uint64_t){:#x}U << 32) | {:#x}U", double::HALF_PI >> 32, double::HALF_PI as u32);
                let row = |row: [String; 7]| format!("{},\n         {}", row[..5].join(", "), row[5..].join(", "));
                constants!(printer, double, row, &double::TWO_OVER_PI, half_pi, std::f64::consts::LOG2_E)
            }
        }
    }
}

fn words(table: &[u32]) -> Vec<String> {
    table.iter().map(|word| format!("{word:#010x}U")).collect()
}
