//! Instructions of 32 bits, but those of the floating-point unit.

use super::narrow::{compare, plain, shift, transfer};
use super::{
    Index, Integer, Offset, Operand, Operation, PC, Place, Register, SP, Shift, WORD, Width, float, list, signed,
};
use Integer::*;
use Operation::*;

/// Decodes an instruction of 32 bits.
pub(super) fn decode(first: u32, second: u32, address: u32) -> Option<Operation> {
    let kind = first >> 4 & 0x7f;
    match first >> 11 & 3 {
        1 if kind & 0b110_0100 == 0 => many(first, second),
        1 if kind & 0b110_0100 == 0b000_0100 => dual(first, second),
        1 if kind & 0b110_0000 == 0b010_0000 => {
            let amount = second >> 10 & 0x1c | second >> 6 & 3;
            let (kind, amount) = shift(second >> 4 & 3, amount);
            // Rotation through the carry is left out.
            let valid = second >> 15 == 0 && (kind != Shift::Rotate || amount != 0);
            let right = register(second)?;
            valid.then(|| processing(first, second, Operand::Register(right, kind, amount)))?
        }
        1 | 3 if kind & 0b100_0000 != 0 => float::decode(first, second),
        2 if second >> 15 == 1 => branch(first, second, address),
        2 if first & 0x200 == 0 => processing(first, second, Operand::Number(expand(immediate(first, second))?)),
        2 => binary(first, second, address),
        3 if kind & 0b111_0001 == 0 => single(first, second, false),
        3 if kind & 0b110_0001 == 1 => single(first, second, true),
        3 if kind & 0b111_0000 == 0b010_0000 => by_register(first, second),
        3 if kind & 0b111_1000 == 0b011_0000 => multiply(first, second),
        _ => None,
    }
}

/// Returns a register from four bits; the stack pointer and the program counter are none here.
fn register(bits: u32) -> Option<Register> {
    let register = (bits & 15) as Register;
    (register != SP && register != PC).then_some(register)
}

/// Returns the twelve bits of an immediate operand.
const fn immediate(first: u32, second: u32) -> u32 {
    first << 1 & 0x800 | second >> 4 & 0x700 | second & 0xff
}

/// Expands an immediate operand: a byte repeated or rotated.
const fn expand(immediate: u32) -> Option<u32> {
    let byte = immediate & 0xff;
    if immediate >> 8 != 0 && immediate >> 8 < 4 && byte == 0 {
        return None;
    }
    Some(match immediate >> 8 {
        0 => byte,
        1 => byte << 16 | byte,
        2 => byte << 24 | byte << 8,
        3 => byte << 24 | byte << 16 | byte << 8 | byte,
        _ => (0x80 | immediate & 0x7f).rotate_right(immediate >> 7),
    })
}

fn processing(first: u32, second: u32, right: Operand) -> Option<Operation> {
    let flags = first >> 4 & 1 == 1;
    let (left, to) = ((first & 15) as Register, (second >> 8 & 15) as Register);
    let compares = flags && to == PC;
    let name = match first >> 5 & 15 {
        0 => And,
        1 => Bic,
        2 if left == PC => Mov,
        2 => Orr,
        3 if left == PC => Mvn,
        3 => Orn,
        4 => Eor,
        8 => Add,
        10 => Adc,
        11 => Sbc,
        13 => Sub,
        14 => Rsb,
        _ => return None,
    };
    let comparable = matches!(name, And | Eor | Add | Sub);
    let copies = matches!(name, Mov | Mvn);
    // The stack pointer is the base of sums and differences, and their result only then.
    let sums = matches!(name, Add | Sub);
    let valid_left = if copies { true } else { left != PC && (left != SP || sums) };
    let valid_to = if compares { comparable } else { to != PC && (to != SP || (sums && left == SP)) };
    if !valid_left || !valid_to {
        return None;
    }
    Some(match compares {
        true => compare(name, left, right),
        false => Operation::Integer { name, flags, to: Some(to), left: if copies { 0 } else { left }, right },
    })
}

/// Decodes operations with a plain constant, and those on bits.
fn binary(first: u32, second: u32, address: u32) -> Option<Operation> {
    let (from, to) = ((first & 15) as Register, (second >> 8 & 15) as Register);
    let number = immediate(first, second);
    let low = (second >> 10 & 0x1c | second >> 6 & 3) as u8;
    let last = (second & 31) as u8;
    let half = (first & 15) << 12 | number;
    if to == PC {
        return None;
    }
    let kind = first >> 4 & 31;
    match kind {
        0b00000 | 0b01010 => {
            let name = if kind == 0 { Add } else { Sub };
            if from == PC {
                let base = address.wrapping_add(4) & !3;
                let address = if kind == 0 { base.wrapping_add(number) } else { base.wrapping_sub(number) };
                return (to != SP).then_some(Address { to, address });
            }
            (to != SP || from == SP).then(|| plain(name, to, from, Operand::Number(number)))
        }
        0b00100 => Some(plain(Mov, register(to.into())?, 0, Operand::Number(half))),
        0b01100 => Some(Top { to: register(to.into())?, number: half }),
        0b10100 | 0b11100 if low + last < 32 => {
            let (to, from) = (register(to.into())?, register(from.into())?);
            Some(Extract { to, from, low, width: last + 1, signed: kind == 0b10100 })
        }
        0b10110 if last >= low => {
            let from = if from == PC { None } else { Some(register(from.into())?) };
            Some(Insert { to: register(to.into())?, from, low, width: last + 1 - low })
        }
        _ => None,
    }
}

fn branch(first: u32, second: u32, address: u32) -> Option<Operation> {
    let (sign, one, two) = (first >> 10 & 1, second >> 13 & 1, second >> 11 & 1);
    let long = || {
        let (one, two) = (!(one ^ sign) & 1, !(two ^ sign) & 1);
        signed(sign << 23 | one << 22 | two << 21 | (first & 0x3ff) << 11 | second & 0x7ff, 24) * 2
    };
    let target = |offset| address.wrapping_add(4).wrapping_add_signed(offset);
    match second >> 12 & 0b101 {
        0 if first >> 6 & 15 < 14 => {
            let offset = signed(sign << 19 | two << 18 | one << 17 | (first & 0x3f) << 11 | second & 0x7ff, 20) * 2;
            Some(Branch { target: target(offset) })
        }
        0 => (first == 0xf3af && second == 0x8000).then_some(Nop),
        1 => Some(Branch { target: target(long()) }),
        5 => Some(Call { target: target(long()) }),
        _ => None,
    }
}

/// Decodes loads and stores of several registers.
fn many(first: u32, second: u32) -> Option<Operation> {
    let (base, load, written) = ((first & 15) as Register, first >> 4 & 1 == 1, first >> 5 & 1 == 1);
    let registers = list(second);
    let bytes = 4 * registers.len() as i32;
    let (offset, index) = match (first >> 7 & 3, written) {
        (1, true) => (bytes, Index::After),
        (1, false) => (0, Index::Offset),
        (2, true) => (-bytes, Index::Before),
        (2, false) => (-bytes, Index::Offset),
        _ => return None,
    };
    let inside = registers.contains(&base);
    let odd = registers.contains(&SP) || (registers.contains(&PC) && (!load || registers.contains(&super::LR)));
    let valid = base != PC && registers.len() > 1 && !odd && !(written && inside);
    let place = Place { base, offset: Offset::Number(offset), index };
    valid.then_some(Transfer { load, width: WORD, registers, place })
}

/// Decodes loads and stores of two registers, and branches by tables; exclusive accesses are left out.
fn dual(first: u32, second: u32) -> Option<Operation> {
    let base = (first & 15) as Register;
    let (before, up, written) = (first >> 8 & 1 == 1, first >> 7 & 1 == 1, first >> 5 & 1 == 1);
    if first & 0xfff0 == 0xe8d0 && second & 0xffe0 == 0xf000 {
        let bytes = 1 + (second >> 4 & 1) as u8;
        return Some(Table { base, index: register(second)?, bytes });
    }
    if !before && !written {
        return None;
    }
    let load = first >> 4 & 1 == 1;
    let registers = [register(second >> 12)?, register(second >> 8)?];
    let distance = ((second & 0xff) * 4) as i32;
    let index = index(before, written);
    let clash = index != Index::Offset && (base == PC || registers.contains(&base));
    let valid = !clash && if load { registers[0] != registers[1] } else { base != PC };
    let place = Place { base, offset: Offset::Number(if up { distance } else { -distance }), index };
    valid.then(|| Transfer { load, width: WORD, registers: registers.to_vec(), place })
}

const fn index(before: bool, written: bool) -> Index {
    match (before, written) {
        (true, false) => Index::Offset,
        (true, true) => Index::Before,
        (false, _) => Index::After,
    }
}

/// Decodes loads and stores of one register.
fn single(first: u32, second: u32, load: bool) -> Option<Operation> {
    let (base, target) = ((first & 15) as Register, (second >> 12) as Register);
    let width = Width { bytes: [1, 2, 4].get((first >> 5 & 3) as usize).copied()?, signed: first >> 8 & 1 == 1 };
    let is_word = width.bytes == 4;
    // Only whole words are loaded into the stack pointer or the program counter; bytes there are hints.
    let odd = target == PC && !(load && is_word) || target == SP && !is_word || width.signed && (is_word || !load);
    if odd || (base == PC && !load) {
        return None;
    }
    let up = first >> 7 & 1 == 1;
    let sign = |distance: u32, up: bool| if up { distance as i32 } else { -(distance as i32) };
    if base == PC {
        return Some(transfer(load, width, target, PC, Offset::Number(sign(second & 0xfff, up))));
    }
    if up {
        return Some(transfer(load, width, target, base, Offset::Number((second & 0xfff) as i32)));
    }
    if second >> 11 & 1 == 1 {
        let (before, up, written) = (second >> 10 & 1 == 1, second >> 9 & 1 == 1, second >> 8 & 1 == 1);
        let unprivileged = before && up && !written;
        let clash = written && target == base;
        let place = Place { base, offset: Offset::Number(sign(second & 0xff, up)), index: index(before, written) };
        let valid = (before || written) && !unprivileged && !clash;
        return valid.then(|| Transfer { load, width, registers: vec![target], place });
    }
    let offset = Offset::Register(register(second)?, (second >> 4 & 3) as u8);
    (second >> 6 & 63 == 0).then(|| transfer(load, width, target, base, offset))
}

/// Decodes shifts by registers, extensions, and operations on bits.
fn by_register(first: u32, second: u32) -> Option<Operation> {
    if second >> 12 != 15 {
        return None;
    }
    let (to, right) = (register(second >> 8)?, register(second)?);
    let (kind, minor) = (first >> 4 & 15, second >> 4 & 15);
    match (kind, minor) {
        (0..=7, 0) => {
            let shift = [Shift::Left, Shift::Right, Shift::Arithmetic, Shift::Rotate][kind as usize / 2];
            let (name, left) = (Integer::Shift(shift), register(first)?);
            Some(Operation::Integer { name, flags: kind & 1 == 1, to: Some(to), left, right: Operand::plain(right) })
        }
        // Extension alone; with a sum or a rotation it is left out.
        (0 | 1 | 4 | 5, 8) if first & 15 == 15 => {
            let width = if kind & 4 == 0 { 16 } else { 8 };
            Some(Extract { to, from: right, low: 0, width, signed: kind & 1 == 0 })
        }
        (0b1011, 8) if first & 15 == second & 15 => Some(LeadingZeros { to, from: right }),
        _ => None,
    }
}

fn multiply(first: u32, second: u32) -> Option<Operation> {
    if first >> 4 & 7 != 0 {
        return None;
    }
    let (to, factors) = (register(second >> 8)?, [register(first)?, register(second)?]);
    let sum = second >> 12 & 15;
    match second >> 4 & 15 {
        0 if sum == 15 => Some(plain(Mul, to, factors[0], Operand::plain(factors[1]))),
        kind @ (0 | 1) => Some(MultiplyAdd { to, factors, sum: register(sum)?, subtract: kind == 1 }),
        _ => None,
    }
}
