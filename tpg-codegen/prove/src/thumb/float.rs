//! Instructions of the single-precision floating-point unit.

use super::{Binary, Index, Offset, Operation, PC, Place, Register, S0, SP, Unary, WORD};
use Binary::*;
use Operation::*;

/// Decodes an instruction of the floating-point unit. Double precision is left out, but for loading, storing and
/// copying pairs of registers.
pub(super) fn decode(first: u32, second: u32) -> Option<Operation> {
    let is_double = match second >> 8 & 15 {
        10 => false,
        11 => true,
        _ => return None,
    };
    match first >> 8 & 0x1f {
        0x0c | 0x0d => memory(first, second, is_double),
        0x0e if second >> 4 & 1 == 1 => move_core(first, second, is_double),
        0x0e if !is_double => processing(first, second),
        _ => None,
    }
}

/// Returns a register from four bits and the lowest.
const fn single(high: u32, low: u32) -> Register {
    S0 + ((high & 15) << 1 | low & 1) as Register
}

/// Decodes `vldr`, `vstr`, `vldm`, `vstm`, `vpush` and `vpop`.
fn memory(first: u32, second: u32, is_double: bool) -> Option<Operation> {
    let (before, up, written) = (first >> 8 & 1 == 1, first >> 7 & 1 == 1, first >> 5 & 1 == 1);
    let (load, base) = (first >> 4 & 1 == 1, (first & 15) as Register);
    let start = match (is_double, first >> 6 & 1) {
        (false, low) => single(second >> 12, low),
        (true, 0) => single(second >> 12, 0),
        // d16 and above are not there.
        (true, _) => return None,
    };
    let distance = ((second & 0xff) * 4) as i32;
    let signed = if up { distance } else { -distance };
    let (count, offset, index) = match (before, up, written) {
        (true, _, false) => (if is_double { 2 } else { 1 }, signed, Index::Offset),
        (false, true, false) => (second & 0xff, 0, Index::Offset),
        (false, true, true) => (second & 0xff, distance, Index::After),
        (true, false, true) => (second & 0xff, -distance, Index::Before),
        _ => return None,
    };
    let end = u32::from(start) + count;
    // An odd count of words for doubles is the deprecated form with a gap.
    let valid = count > 0 && end <= 48 && (!is_double || count % 2 == 0);
    let relative = base == PC && !(load && before && !written);
    let registers = (start..end as Register).collect();
    let place = Place { base, offset: Offset::Number(offset), index };
    (valid && !relative).then_some(Transfer { load, width: WORD, registers, place })
}

/// Decodes moves between the register files, and of the flags.
fn move_core(first: u32, second: u32, is_double: bool) -> Option<Operation> {
    let core = (second >> 12 & 15) as Register;
    if first == 0xeef1 && second & 0x0fff == 0x0a10 {
        return (core == PC).then_some(ReadFlags);
    }
    let float = single(first, second >> 7);
    let valid = !is_double && first & 0xffe0 == 0xee00 && second & 0x7f == 0x10 && core != PC && core != SP;
    let (to, from) = if first >> 4 & 1 == 1 { (core, float) } else { (float, core) };
    valid.then_some(Move { to, from })
}

fn processing(first: u32, second: u32) -> Option<Operation> {
    let to = single(second >> 12, first >> 6);
    let left = single(first, second >> 7);
    let right = single(second, second >> 5);
    let other = second >> 6 & 1 == 1;
    let name = match (first >> 5 & 4 | first >> 4 & 3, other) {
        (0, false) => MulAdd,
        (0, true) => MulSub,
        (1, false) => NegMulSub,
        (1, true) => NegMulAdd,
        (2, false) => Mul,
        (2, true) => NegMul,
        (3, false) => Add,
        (3, true) => Sub,
        (4, false) => Div,
        (7, false) => {
            let byte = (first & 15) << 4 | second & 15;
            let exponent = if byte & 0x40 == 0 { 0x4000_0000 } else { 0x3e00_0000 };
            let bits = (byte & 0x80) << 24 | exponent | (byte & 0x3f) << 19;
            return (second & 0xa0 == 0).then_some(Constant { to, bits });
        }
        (7, true) => return unary(first & 15, second >> 7 & 1 == 1, to, right, second),
        _ => return None,
    };
    Some(Operation::Binary { name, to, left, right })
}

fn unary(kind: u32, second_form: bool, to: Register, from: Register, second: u32) -> Option<Operation> {
    let name = match (kind, second_form) {
        (0, false) => return Some(Move { to, from }),
        (0, true) => Unary::Abs,
        (1, false) => Unary::Neg,
        (1, true) => Unary::Sqrt,
        // Which form signals does not matter: exceptions are not observed.
        (4, _) => return Some(Compare { left: to, right: Some(from) }),
        (5, _) => return (second & 0x2f == 0).then_some(Compare { left: to, right: None }),
        (8, signed) => Unary::FromInteger { signed },
        (12 | 13, true) => Unary::ToInteger { signed: kind == 13 },
        _ => return None,
    };
    Some(Operation::Unary { name, to, from })
}
