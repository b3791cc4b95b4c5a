//! The forms of instructions, as the architecture's manual draws them: fixed bits, and letters for fields.
//!
//! Of several forms that fit, the first counts. Points are bits that are not looked at.

use super::decode::{Fields, SHIFTS};
use super::{Computed, Index, LR, Offset, Operand, Operation, PC, Place, Register, S0, SP, list, signed};
use crate::term::Arithmetic;
use crate::term::Operator::{Add, And, Multiply, Or, Subtract, Xor};
use Computed::*;
use Operation::*;

/// The meaning of a form; `None` where it is unpredictable or left out.
type Meaning = fn(&Fields) -> Option<Operation>;

/// Operations of integers by their numbers in the architecture. Without a left operand, `ORR` copies and `ORN` inverts.
const AND: u32 = 0;
const BIC: u32 = 1;
const ORR: u32 = 2;
const ORN: u32 = 3;
const EOR: u32 = 4;
const ADD: u32 = 8;
const ADC: u32 = 10;
const SBC: u32 = 11;
const SUB: u32 = 13;
const RSB: u32 = 14;

pub(super) const FORMS: &[(&str, Meaning)] = &[
    // 16 bits. In a conditional block, most of them do not set the flags.
    ("000110 k mmm nnn ddd", |f| sets(f, [ADD, SUB][f.k], Some(f.n))),
    ("000111 k iii nnn ddd", |f| sets(f, [ADD, SUB][f.k], Some(f.n))),
    ("00000 00000 mmm ddd", |f| if f.in_block { None } else { sets(f, ORR, None) }),
    ("000hh iiiii mmm ddd", |f| sets(f, ORR, None)),
    ("00100 ddd iiiiiiii", |f| sets(f, ORR, None)),
    ("00101 nnn iiiiiiii", |f| compare(f, SUB)),
    ("0011k ddd iiiiiiii", |f| sets(f, [ADD, SUB][f.k], Some(f.d))),
    ("010000 1000 mmm nnn", |f| compare(f, AND)),
    ("010000 1001 nnn ddd", |f| sets(f, RSB, Some(f.n))),
    ("010000 1010 mmm nnn", |f| compare(f, SUB)),
    ("010000 1011 mmm nnn", |f| compare(f, ADD)),
    ("010000 1101 mmm ddd", |f| compute(Integers(Multiply), !f.in_block, f.d, &[Operand::plain(f.d), f.right()])),
    ("010000 1111 mmm ddd", |f| sets(f, ORN, None)),
    ("010000 11k0 mmm ddd", |f| sets(f, [ORR, BIC][f.k], Some(f.d))),
    ("010000 000k mmm ddd", |f| sets(f, [AND, EOR][f.k], Some(f.d))),
    ("010000 0101 mmm ddd", |f| sets(f, ADC, Some(f.d))),
    ("010000 0110 mmm ddd", |f| sets(f, SBC, Some(f.d))),
    ("010000 0kkk mmm ddd", |f| shift(f, f.k.checked_sub(2)?, !f.in_block, f.d)),
    // Operations on all sixteen registers; computing with the program counter is left out.
    ("010001 10 1 bbbb 111", |f| (f.b != PC).then_some(Exchange { register: f.b })),
    ("010001 kk t bbbb ttt", |f| {
        let (to, right) = (f.t, Operand::plain(f.b));
        match f.k {
            _ if f.b == PC => None,
            2 => processed(ORR, false, Some(to), None, right),
            // `bx`; `blx` is a call to an unknown function.
            3 => (to == 0).then_some(Exchange { register: f.b }),
            _ if to == PC => None,
            0 => processed(ADD, false, Some(to), Some(to), right),
            _ => processed(SUB, true, None, Some(to), right),
        }
    }),
    ("01001 ttt iiiiiiii", |f| near(f, 4, PC)),
    ("0101 kkk mmm bbb ttt", |f| {
        // What extends a sign is left out.
        let &bytes = [4, 2, 1].get(f.k % 4)?;
        transfer(f.k > 2, bytes, f.t, f.b, Offset::Register(f.m, 0))
    }),
    ("0110 l iiiii bbb ttt", |f| near(f, 4, f.b)),
    ("0111 l iiiii bbb ttt", |f| near(f, 1, f.b)),
    ("1000 l iiiii bbb ttt", |f| near(f, 2, f.b)),
    ("1001 l ttt iiiiiiii", |f| near(f, 4, SP)),
    ("10100 ddd iiiiiiii", |f| relative(f, 4)),
    ("10101 ddd iiiiiiii", |f| processed(ADD, false, Some(f.d), Some(SP), Operand::Number(f.i * 4))),
    ("1011 k0i1 iiiii nnn", |f| Some(BranchIf { register: f.n, zero: f.k == 0, target: f.target(f.distance(2)) })),
    ("1011 0000 k iiiiiii", |f| processed([ADD, SUB][f.k], false, Some(SP), Some(SP), Operand::Number(f.i * 4))),
    ("1011 0010 1k nnn ddd", |f| extract(f, 0, [16, 8][f.k])),
    ("1011 010 i iiiiiiii", |f| several(false, SP, list((f.i & 256) << 6 | f.i & 255), true, true)),
    ("1011 110 i iiiiiiii", |f| several(true, SP, list((f.i & 256) << 7 | f.i & 255), false, true)),
    ("1011 1111 0000 0000", |_| Some(Nop)),
    ("1011 1111 cccc iiii", |f| (f.i != 0).then_some(If)),
    ("1100 l bbb iiiiiiii", |f| {
        // The base is written back unless it is loaded. Storing a base that is written back is left out.
        let inside = list(f.i).contains(&f.b);
        if f.l || !inside { several(f.l, f.b, list(f.i), false, !inside) } else { None }
    }),
    ("1101 cccc iiiiiiii", |f| branch(f, f.i, 8)),
    ("11100 iiiiiiiiiii", |f| branch(f, f.i, 11)),
    // 32 bits: several registers, or two; exclusive accesses are left out.
    ("1110100 pu 0wl bbbb iiiiiiiiiiiiiiii", |f| {
        let registers = list(f.i);
        let has = |register| registers.contains(&register);
        let odd = f.p == f.u || has(SP) || has(PC) && (!f.l || has(LR)) || f.w && has(f.b);
        let valid = !odd && f.b != PC && registers.len() > 1;
        if valid { several(f.l, f.b, registers, f.p, f.w) } else { None }
    }),
    ("1110100 01101 bbbb 11110000000 i mmmm", |f| Some(Table { base: f.b, index: f.m, bytes: f.i as u8 + 1 })),
    ("1110100 pu1wl bbbb nnnn mmmm iiiiiiii", |f| {
        let place = Place { base: f.b, offset: Offset::Number(f.distance(4)), index: index(f)? };
        let clash = place.index != Index::Offset && [PC, f.n, f.m].contains(&f.b);
        let valid = !clash && if f.l { f.n != f.m } else { f.b != PC };
        valid.then(|| Transfer { load: f.l, bytes: 4, registers: vec![f.n, f.m], place })
    }),
    // Rotations are left out.
    ("1110101 .... . .... .... .... ..11 ....", |_| None),
    ("1110101 kkkk s bbbb 0iii tttt iihh mmmm", |f| processing(f, f.right())),
    ("11110 i0 kkkk s bbbb 0iii tttt iiiiiiii", |f| processing(f, Operand::Number(expanded(f.i)?))),
    // Plain constants, and operations on bits.
    ("11110 i1 00000 1111 0iii dddd iiiiiiii", |f| relative(f, 1)),
    ("11110 i1 01010 1111 0iii dddd iiiiiiii", |f| relative(f, -1)),
    ("11110 i1 0k0k0 bbbb 0iii tttt iiiiiiii", |f| {
        let valid = f.t != PC && (f.t != SP || f.b == SP) && matches!(f.k, 0 | 3);
        if valid { processed([ADD, SUB][f.k & 1], false, Some(f.t), Some(f.b), f.right()) } else { None }
    }),
    ("11110 i1 00100 hhhh 0iii dddd iiiiiiii", |f| {
        compute(Lower, false, f.d, &[Operand::Number(f.get('h') << 12 | f.i)])
    }),
    ("11110 i1 01100 hhhh 0iii dddd iiiiiiii", |f| {
        compute(Upper, false, f.d, &[Operand::plain(f.d), Operand::Number(f.get('h') << 12 | f.i)])
    }),
    ("11110 .1 11100 nnnn 0iii dddd ii.kkkkk", |f| {
        if f.i as usize + f.k < 32 { extract(f, f.i as u8, f.k as u8 + 1) } else { None }
    }),
    ("11110 .1 10110 bbbb 0iii dddd ii.kkkkk", |f| {
        let low = f.i as u8;
        let width = (f.k as u8 + 1).checked_sub(low).filter(|&width| width > 0)?;
        let from = if f.b == PC { Operand::Number(0) } else { Operand::plain(f.b) };
        if f.b == SP { None } else { compute(Inserted { low, width }, false, f.d, &[Operand::plain(f.d), from]) }
    }),
    ("1111001110101111 1000000000000000", |_| Some(Nop)),
    ("11110 s cccc iiiiii 10n0m iiiiiiiiiii", |f| {
        branch(f, u32::from(f.s) << 19 | u32::from(f.m) << 18 | u32::from(f.n) << 17 | f.i, 20)
    }),
    ("11110 s iiiiiiiiii 1ln1m iiiiiiiiiii", |f| {
        let [one, two] = [f.n, f.m].map(|bit| u32::from((bit == 1) == f.s));
        let to = branch(f, u32::from(f.s) << 23 | one << 22 | two << 21 | f.i, 24);
        if let Some(Branch { target }) = to
            && f.l
        {
            Some(Call { target })
        } else {
            to
        }
    }),
    // One register: relative to the program counter, with an offset, with writing back, with a register.
    ("1111100 0ukkl 1111 tttt iiiiiiiiiiii", |f| single(f, PC, Offset::Number(f.distance(1)), Index::Offset)),
    ("1111100 01kkl bbbb tttt iiiiiiiiiiii", |f| single(f, f.b, Offset::Number(f.distance(1)), Index::Offset)),
    ("1111100 00kkl bbbb tttt 1puw iiiiiiii", |f| {
        // Unprivileged accesses are left out.
        let valid = !(f.w && f.t == f.b) && (f.w || !f.u);
        if valid { single(f, f.b, Offset::Number(f.distance(1)), index(f)?) } else { None }
    }),
    ("1111100 00kkl bbbb tttt 000000 ii mmmm", |f| single(f, f.b, Offset::Register(f.m, f.i as u8), Index::Offset)),
    ("11111010 0kks nnnn 1111 dddd 0000 mmmm", |f| shift(f, f.k, f.s, f.n)),
    // Extension alone; with a sum or a rotation it is left out.
    ("11111010 0k01 1111 1111 dddd 1000 nnnn", |f| extract(f, 0, [16, 8][f.k])),
    ("11111011 0000 nnnn 1111 dddd 0000 mmmm", |f| {
        compute(Integers(Multiply), false, f.d, &[Operand::plain(f.n), f.right()])
    }),
    ("11111011 0000 nnnn aaaa dddd 000s mmmm", |f| {
        let name = OfProduct(if f.s { Subtract } else { Add });
        compute(name, false, f.d, &[f.get('a') as Register, f.n, f.m].map(Operand::plain))
    }),
    // Floats. Double precision is left out, but for loading and storing pairs of registers.
    ("1110110 puDwl bbbb xxxx 101k iiiiiiii", |f| {
        let single = f.p && !f.w;
        let (start, count) = (u32::from(to(f)), if single { 1 + f.k as u32 } else { f.i });
        // An odd count of words for doubles is the deprecated form with a gap; d16 and above are not there.
        let odd = f.k == 1 && (f.get('D') == 1 || count % 2 != 0) || f.p == f.u && !single;
        if count == 0 || start + count > 48 || odd || f.b == PC && !(f.l && single) {
            return None;
        }
        let registers = (start as Register..(start + count) as Register).collect();
        let several = several(f.l, f.b, registers, f.p && !single, f.w)?;
        let Transfer { load, bytes, registers, place } = several else { return None };
        let offset = if single { Offset::Number(f.distance(4)) } else { place.offset };
        Some(Transfer { load, bytes, registers, place: Place { offset, ..place } })
    }),
    ("1110111011110001 1111 101000010000", |_| Some(ReadFlags)),
    ("11101110000l eeee nnnn 1010 e0010000", |f| {
        let (core, float) = (f.n, S0 + f.get('e') as Register);
        let (to, from) = if f.l { (core, float) } else { (float, core) };
        compute(Same, false, to, &[Operand::plain(from)])
    }),
    ("11101110 1D11 iiii xxxx 1010 0000 iiii", |f| {
        let exponent = if f.i & 0x40 == 0 { 0x4000_0000 } else { 0x3e00_0000 };
        compute(Same, false, to(f), &[Operand::Number((f.i & 0x80) << 24 | exponent | (f.i & 0x3f) << 19)])
    }),
    ("11101110 1D11 0000 xxxx 1010 01M0 yyyy", |f| unary(f, Same)),
    ("11101110 1D11 0000 xxxx 1010 11M0 yyyy", |f| unary(f, Magnitude)),
    ("11101110 1D11 0001 xxxx 1010 01M0 yyyy", |f| unary(f, Negated)),
    // Which form of a comparison signals does not matter: exceptions are not observed.
    ("11101110 1D11 0100 xxxx 1010 .1M0 yyyy", |f| Some(Compare { left: to(f), right: Some(from(f)) })),
    ("11101110 1D11 0101 xxxx 1010 .100 0000", |f| Some(Compare { left: to(f), right: None })),
    ("11101110 1D11 1000 xxxx 1010 s1M0 yyyy", |f| unary(f, FromInteger { signed: f.s })),
    ("11101110 kDkk eeee xxxx 1010 ekM0 yyyy", |f| {
        let operands = [to(f), S0 + f.get('e') as Register, from(f)].map(Operand::plain);
        let negated = f.k % 2 == 1;
        match f.k {
            0..4 => compute(Product { negated, sum_negated: f.k > 1 }, false, to(f), &operands),
            4 | 5 => compute(Product { negated, sum_negated: false }, false, to(f), &operands[1..]),
            6 | 7 => compute(Floats { operation: Arithmetic::Add, negated }, false, to(f), &operands[1..]),
            8 => compute(Floats { operation: Arithmetic::Divide, negated }, false, to(f), &operands[1..]),
            _ => None,
        }
    }),
];

fn compute(name: Computed, flags: bool, to: Register, from: &[Operand]) -> Option<Operation> {
    Some(Compute { name, flags, to: Some(to), from: from.to_vec(), inverted: false })
}

/// Returns an operation of integers.
fn processed(
    number: u32,
    flags: bool,
    to: Option<Register>,
    left: Option<Register>,
    right: Operand,
) -> Option<Operation> {
    let name = match number {
        ORR | ORN if left.is_none() => Same,
        AND | BIC => Integers(And),
        ORR | ORN => Integers(Or),
        EOR => Integers(Xor),
        ADD => Integers(Add),
        ADC | SBC => WithCarry,
        SUB | RSB => Integers(Subtract),
        _ => return None,
    };
    let mut from: Vec<_> = left.map(Operand::plain).into_iter().chain([right]).collect();
    if number == RSB {
        from.reverse();
    }
    Some(Compute { name, flags, to, from, inverted: matches!(number, BIC | ORN | SBC) })
}

/// Returns an operation that sets the flags outside of conditional blocks.
fn sets(f: &Fields, number: u32, left: Option<Register>) -> Option<Operation> {
    processed(number, !f.in_block, Some(f.d), left, f.right())
}

fn compare(f: &Fields, number: u32) -> Option<Operation> {
    processed(number, true, None, Some(f.n), f.right())
}

/// Returns a shift by a register.
fn shift(f: &Fields, number: usize, flags: bool, left: Register) -> Option<Operation> {
    compute(Integers(*SHIFTS.get(number)?), flags, f.d, &[Operand::plain(left), Operand::plain(f.m)])
}

fn extract(f: &Fields, low: u8, width: u8) -> Option<Operation> {
    compute(Extracted { low, width }, false, f.d, &[Operand::plain(f.n)])
}

fn branch(f: &Fields, halves: u32, bits: u32) -> Option<Operation> {
    Some(Branch { target: f.target(signed(halves, bits) * 2) })
}

fn transfer(load: bool, bytes: u8, register: Register, base: Register, offset: Offset) -> Option<Operation> {
    Some(Transfer { load, bytes, registers: vec![register], place: Place { base, offset, index: Index::Offset } })
}

fn near(f: &Fields, bytes: u8, base: Register) -> Option<Operation> {
    let offset = Offset::Number(f.distance(bytes.into()));
    transfer(f.l || base == PC, bytes, f.t, base, offset)
}

/// Loads or stores registers from the base on, or up to it.
fn several(load: bool, base: Register, registers: Vec<Register>, down: bool, written: bool) -> Option<Operation> {
    let bytes = 4 * registers.len() as i32;
    let (offset, index) = match (down, written) {
        (false, true) => (bytes, Index::After),
        (false, false) => (0, Index::Offset),
        (true, true) => (-bytes, Index::Before),
        (true, false) => (-bytes, Index::Offset),
    };
    let place = Place { base, offset: Offset::Number(offset), index };
    (!registers.is_empty()).then_some(Transfer { load, bytes: 4, registers, place })
}

fn index(f: &Fields) -> Option<Index> {
    match (f.p, f.w) {
        (true, false) => Some(Index::Offset),
        (true, true) => Some(Index::Before),
        (false, true) => Some(Index::After),
        (false, false) => None,
    }
}

fn single(f: &Fields, base: Register, offset: Offset, index: Index) -> Option<Operation> {
    let &bytes = [1, 2, 4].get(f.k)?;
    let is_word = bytes == 4;
    // Only whole words are loaded into the stack pointer or the program counter; bytes there are hints.
    let odd = f.t == PC && !(f.l && is_word) || f.t == SP && !is_word || base == PC && !f.l;
    let place = Place { base, offset, index };
    (!odd).then(|| Transfer { load: f.l, bytes, registers: vec![f.t], place })
}

/// Expands an immediate operand: a byte repeated or rotated.
fn expanded(immediate: u32) -> Option<u32> {
    let byte = immediate & 0xff;
    let repeated = match immediate >> 8 {
        0 => return Some(byte),
        1 => byte << 16 | byte,
        2 => byte << 24 | byte << 8,
        3 => byte << 24 | byte << 16 | byte << 8 | byte,
        _ => return Some((0x80 | immediate & 0x7f).rotate_right(immediate >> 7)),
    };
    (byte != 0).then_some(repeated)
}

fn processing(f: &Fields, right: Operand) -> Option<Operation> {
    let (number, left, to) = (f.k as u32, f.b, f.t);
    let compares = f.s && to == PC;
    let copies = left == PC && matches!(number, ORR | ORN);
    // The stack pointer is the base of sums and differences, and their result only then.
    let sums = matches!(number, ADD | SUB);
    let valid_left = copies || left != PC && (left != SP || sums);
    let comparable = sums || matches!(number, AND | EOR);
    let valid_to = if compares { comparable } else { to != PC && (to != SP || sums && left == SP) };
    if !(valid_left && valid_to) {
        return None;
    }
    processed(number, f.s, (!compares).then_some(to), (!copies).then_some(left), right)
}

/// Returns an address relative to the instruction.
fn relative(f: &Fields, scale: i32) -> Option<Operation> {
    let address = (f.target(0) & !3).wrapping_add_signed(f.i as i32 * scale);
    compute(Computed::Address, false, f.d, &[Operand::Number(address)])
}

/// Returns the register of floats of a result: four bits and the lowest.
fn to(f: &Fields) -> Register {
    S0 + (f.get('x') << 1 | f.get('D')) as Register
}

/// Returns the right register of floats.
fn from(f: &Fields) -> Register {
    S0 + (f.get('y') << 1 | f.get('M')) as Register
}

fn unary(f: &Fields, name: Computed) -> Option<Operation> {
    compute(name, false, to(f), &[Operand::plain(from(f))])
}
