//! Instructions of 16 bits.

use super::{Index, Integer, Offset, Operand, Operation, PC, Place, Register, SP, Shift, WORD, Width, list, signed};
use Integer::*;
use Operand::*;
use Operation::*;

/// Decodes an instruction of 16 bits. In a conditional block, most do not set the flags.
pub(super) fn decode(half: u32, address: u32, in_block: bool) -> Option<Operation> {
    let flags = !in_block;
    let register = |low: u32| (half >> low & 7) as Register;
    let integer = |name, to, left, right| Some(Operation::Integer { name, flags, to: Some(to), left, right });
    let imm8 = half & 255;
    let imm5 = half >> 6 & 31;
    match half >> 11 {
        0b00000 if imm5 == 0 && in_block => None,
        kind @ 0b00000..=0b00010 => {
            let shift = shift(kind, imm5);
            integer(Mov, register(0), 0, Operand::Register(register(3), shift.0, shift.1))
        }
        0b00011 => {
            let name = if half >> 9 & 1 == 0 { Add } else { Sub };
            let right = if half >> 10 & 1 == 0 { Operand::plain(register(6)) } else { Number(half >> 6 & 7) };
            integer(name, register(0), register(3), right)
        }
        0b00100 => integer(Mov, register(8), 0, Number(imm8)),
        0b00101 => Some(compare(Sub, register(8), Number(imm8))),
        0b00110 => integer(Add, register(8), register(8), Number(imm8)),
        0b00111 => integer(Sub, register(8), register(8), Number(imm8)),
        0b01000 if half >> 10 & 1 == 0 => processing(half, flags),
        0b01000 => special(half),
        0b01001 => Some(transfer(true, WORD, register(8), PC, Offset::Number((imm8 * 4) as i32))),
        0b01010 | 0b01011 => {
            let (load, width) = match half >> 9 & 7 {
                0 => (false, WORD),
                1 => (false, Width { bytes: 2, signed: false }),
                2 => (false, Width { bytes: 1, signed: false }),
                3 => (true, Width { bytes: 1, signed: true }),
                4 => (true, WORD),
                5 => (true, Width { bytes: 2, signed: false }),
                6 => (true, Width { bytes: 1, signed: false }),
                _ => (true, Width { bytes: 2, signed: true }),
            };
            Some(transfer(load, width, register(0), register(3), Offset::Register(register(6), 0)))
        }
        kind @ 0b01100..=0b10001 => {
            let bytes = [4, 1, 2][(kind as usize - 0b01100) / 2];
            let offset = Offset::Number((imm5 * u32::from(bytes)) as i32);
            Some(transfer(kind & 1 == 1, Width { bytes, signed: false }, register(0), register(3), offset))
        }
        kind @ (0b10010 | 0b10011) => {
            Some(transfer(kind & 1 == 1, WORD, register(8), SP, Offset::Number((imm8 * 4) as i32)))
        }
        0b10100 => Some(Address { to: register(8), address: (address.wrapping_add(4) & !3).wrapping_add(imm8 * 4) }),
        0b10101 => Some(plain(Add, register(8), SP, Number(imm8 * 4))),
        0b10110 | 0b10111 => miscellaneous(half, address),
        0b11000 => many(false, register(8), imm8),
        0b11001 => many(true, register(8), imm8),
        // 14 is an undefined instruction, 15 a call of the supervisor.
        0b11010 | 0b11011 => (half >> 8 & 15 < 14)
            .then(|| Branch { target: address.wrapping_add(4).wrapping_add_signed(signed(imm8, 8) * 2) }),
        0b11100 => {
            let offset = signed(half & 0x7ff, 11) * 2;
            Some(Branch { target: address.wrapping_add(4).wrapping_add_signed(offset) })
        }
        _ => None,
    }
}

/// Returns the shift of an immediate field: 0 to the right means 32.
pub(super) const fn shift(kind: u32, amount: u32) -> (Shift, u8) {
    let right = if amount == 0 { 32 } else { amount as u8 };
    match kind {
        0 => (Shift::Left, amount as u8),
        1 => (Shift::Right, right),
        2 => (Shift::Arithmetic, right),
        _ => (Shift::Rotate, amount as u8),
    }
}

pub(super) const fn compare(name: Integer, left: Register, right: Operand) -> Operation {
    Operation::Integer { name, flags: true, to: None, left, right }
}

/// Returns an operation that leaves the flags alone.
pub(super) const fn plain(name: Integer, to: Register, left: Register, right: Operand) -> Operation {
    Operation::Integer { name, flags: false, to: Some(to), left, right }
}

pub(super) fn transfer(load: bool, width: Width, register: Register, base: Register, offset: Offset) -> Operation {
    Transfer { load, width, registers: vec![register], place: Place { base, offset, index: Index::Offset } }
}

fn processing(half: u32, flags: bool) -> Option<Operation> {
    let (to, from) = ((half & 7) as Register, (half >> 3 & 7) as Register);
    let right = Operand::plain(from);
    let name = match half >> 6 & 15 {
        0 => And,
        1 => Eor,
        2 => Integer::Shift(Shift::Left),
        3 => Integer::Shift(Shift::Right),
        4 => Integer::Shift(Shift::Arithmetic),
        5 => Adc,
        6 => Sbc,
        7 => Integer::Shift(Shift::Rotate),
        8 => return Some(compare(And, to, right)),
        9 => {
            let right = Number(0);
            return Some(Operation::Integer { name: Rsb, flags, to: Some(to), left: from, right });
        }
        10 => return Some(compare(Sub, to, right)),
        11 => return Some(compare(Add, to, right)),
        12 => Orr,
        13 => Mul,
        14 => Bic,
        _ => Mvn,
    };
    Some(Operation::Integer { name, flags, to: Some(to), left: to, right })
}

/// Decodes operations on all sixteen registers; none of them but the comparison sets flags.
fn special(half: u32) -> Option<Operation> {
    let to = ((half & 7) | (half >> 4 & 8)) as Register;
    let from = (half >> 3 & 15) as Register;
    let right = Operand::plain(from);
    match half >> 8 & 3 {
        // Computing with the program counter is left out.
        0 | 1 if to == PC || from == PC => None,
        0 => Some(plain(Add, to, to, right)),
        1 => Some(compare(Sub, to, right)),
        2 if from == PC => None,
        2 if to == PC => Some(Exchange { register: from }),
        2 => Some(plain(Mov, to, 0, right)),
        // `bx`; `blx` is a call to an unknown function.
        _ => (half & 0x87 == 0 && from != PC).then_some(Exchange { register: from }),
    }
}

fn miscellaneous(half: u32, address: u32) -> Option<Operation> {
    let (to, from) = ((half & 7) as Register, (half >> 3 & 7) as Register);
    if half & 0xf500 == 0xb100 {
        let offset = (half >> 4 & 0x20 | half >> 3 & 0x1f) * 2;
        let target = address.wrapping_add(4).wrapping_add(offset);
        return Some(BranchIf { register: to, zero: half & 0x800 == 0, target });
    }
    match half >> 8 & 15 {
        0 => {
            let name = if half & 0x80 == 0 { Add } else { Sub };
            Some(plain(name, SP, SP, Number((half & 0x7f) * 4)))
        }
        2 => {
            let (width, signed) = [(16, true), (8, true), (16, false), (8, false)][(half >> 6 & 3) as usize];
            Some(Extract { to, from, low: 0, width, signed })
        }
        4 | 5 => push(half & 255 | half << 6 & 0x4000),
        12 | 13 => pop(half & 255 | half << 7 & 0x8000),
        15 if half & 15 != 0 => Some(If),
        15 => (half & 255 == 0).then_some(Nop),
        _ => None,
    }
}

fn push(bits: u32) -> Option<Operation> {
    let registers = list(bits);
    let place = Place { base: SP, offset: Offset::Number(-4 * registers.len() as i32), index: Index::Before };
    (!registers.is_empty()).then_some(Transfer { load: false, width: WORD, registers, place })
}

fn pop(bits: u32) -> Option<Operation> {
    let registers = list(bits);
    let place = Place { base: SP, offset: Offset::Number(4 * registers.len() as i32), index: Index::After };
    (!registers.is_empty()).then_some(Transfer { load: true, width: WORD, registers, place })
}

/// Decodes `stm` and `ldm`: the base is written back unless it is loaded.
fn many(load: bool, base: Register, bits: u32) -> Option<Operation> {
    let registers = list(bits);
    let inside = registers.contains(&base);
    let index = if load && inside { Index::Offset } else { Index::After };
    let bytes = 4 * registers.len() as i32;
    let offset = Offset::Number(if index == Index::After { bytes } else { 0 });
    // Storing a base that is written back is defined for the lowest register only; left out.
    let valid = !registers.is_empty() && (load || !inside);
    valid.then_some(Transfer { load, width: WORD, registers, place: Place { base, offset, index } })
}
