//! The forms of instructions, as the architecture's manual draws them: fixed bits, and letters for fields.
//!
//! Of several forms that fit, the first counts. Points are bits that are not looked at.

use super::decode::Fields;
use super::{
    Binary, Index, Integer, LR, Offset, Operand, Operation, PC, Place, Register, S0, SP, Shift, Unary, WORD, Width,
    list, signed,
};
use Integer::*;
use Operation::*;

/// The meaning of a form; `None` where it is unpredictable or left out.
type Meaning = fn(&Fields) -> Option<Operation>;

pub(super) const FORMS: &[(&str, Meaning)] = &[
    // 16 bits. In a conditional block, most of them do not set the flags.
    ("000110 k mmm nnn ddd", |f| sets(f, [Add, Sub][f.k], f.n)),
    ("000111 k iii nnn ddd", |f| sets(f, [Add, Sub][f.k], f.n)),
    ("00000 00000 mmm ddd", |f| if f.in_block { None } else { sets(f, Mov, 0) }),
    ("000hh iiiii mmm ddd", |f| sets(f, Mov, 0)),
    ("00100 ddd iiiiiiii", |f| sets(f, Mov, 0)),
    ("00101 nnn iiiiiiii", |f| compare(f, Sub)),
    ("0011k ddd iiiiiiii", |f| sets(f, [Add, Sub][f.k], f.d)),
    ("010000 1000 mmm nnn", |f| compare(f, And)),
    ("010000 1001 nnn ddd", |f| sets(f, Rsb, f.n)),
    ("010000 1010 mmm nnn", |f| compare(f, Sub)),
    ("010000 1011 mmm nnn", |f| compare(f, Add)),
    ("010000 11kk mmm ddd", |f| sets(f, [Orr, Mul, Bic, Mvn][f.k], f.d)),
    ("010000 0kkk mmm ddd", |f| sets(f, [And, Eor, LEFT, RIGHT, ARITHMETIC, Adc, Sbc, ROTATE][f.k], f.d)),
    // Operations on all sixteen registers; computing with the program counter is left out.
    ("010001 10 1 bbbb 111", |f| (f.b != PC).then_some(Exchange { register: f.b })),
    ("010001 kk t bbbb ttt", |f| {
        let (to, right) = (f.t, Operand::plain(f.b));
        match f.k {
            _ if f.b == PC => None,
            2 => plain(Mov, to, 0, right),
            // `bx`; `blx` is a call to an unknown function.
            3 => (to == 0).then_some(Exchange { register: f.b }),
            _ if to == PC => None,
            0 => plain(Add, to, to, right),
            _ => Some(Operation::Integer { name: Sub, flags: true, to: None, left: to, right }),
        }
    }),
    ("01001 ttt iiiiiiii", |f| near(f, 4, PC)),
    ("0101 kkk mmm bbb ttt", |f| {
        let width = Width { bytes: [4, 2, 1, 1, 4, 2, 1, 2][f.k], signed: matches!(f.k, 3 | 7) };
        transfer(f.k > 2, width, f.t, f.b, Offset::Register(f.m, 0))
    }),
    ("0110 l iiiii bbb ttt", |f| near(f, 4, f.b)),
    ("0111 l iiiii bbb ttt", |f| near(f, 1, f.b)),
    ("1000 l iiiii bbb ttt", |f| near(f, 2, f.b)),
    ("1001 l ttt iiiiiiii", |f| near(f, 4, SP)),
    ("10100 ddd iiiiiiii", |f| Some(relative(f, 4))),
    ("10101 ddd iiiiiiii", |f| plain(Add, f.d, SP, Operand::Number(f.i * 4))),
    ("1011 k0i1 iiiii nnn", |f| Some(BranchIf { register: f.n, zero: f.k == 0, target: f.target(f.distance(2)) })),
    ("1011 0000 k iiiiiii", |f| plain([Add, Sub][f.k], SP, SP, Operand::Number(f.i * 4))),
    ("1011 0010 uk nnn ddd", |f| extract(f, 0, [16, 8][f.k])),
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
        valid.then(|| Transfer { load: f.l, width: WORD, registers: vec![f.n, f.m], place })
    }),
    // Rotation through the carry is left out.
    ("1110101 .... . .... 0000 .... 0011 ....", |_| None),
    ("1110101 kkkk s bbbb 0iii tttt iihh mmmm", |f| processing(f, f.right())),
    ("11110 i0 kkkk s bbbb 0iii tttt iiiiiiii", |f| processing(f, Operand::Number(expanded(f.i)?))),
    // Plain constants, and operations on bits.
    ("11110 i1 00000 1111 0iii dddd iiiiiiii", |f| Some(relative(f, 1))),
    ("11110 i1 01010 1111 0iii dddd iiiiiiii", |f| Some(relative(f, -1))),
    ("11110 i1 0k0k0 bbbb 0iii tttt iiiiiiii", |f| {
        let valid = f.t != PC && (f.t != SP || f.b == SP) && matches!(f.k, 0 | 3);
        if valid { plain([Add, Sub][f.k & 1], f.t, f.b, f.right()) } else { None }
    }),
    ("11110 i1 00100 hhhh 0iii dddd iiiiiiii", |f| plain(Mov, f.d, 0, Operand::Number(f.get('h') << 12 | f.i))),
    ("11110 i1 01100 hhhh 0iii dddd iiiiiiii", |f| Some(Top { to: f.d, number: f.get('h') << 12 | f.i })),
    ("11110 .1 1u100 nnnn 0iii dddd ii.kkkkk", |f| {
        if f.i as usize + f.k < 32 { extract(f, f.i as u8, f.k as u8 + 1) } else { None }
    }),
    ("11110 .1 10110 bbbb 0iii dddd ii.kkkkk", |f| {
        let low = f.i as u8;
        let width = (f.k as u8 + 1).checked_sub(low).filter(|&width| width > 0)?;
        (f.b != SP).then_some(Insert { to: f.d, from: (f.b != PC).then_some(f.b), low, width })
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
    ("1111100 sukkl 1111 tttt iiiiiiiiiiii", |f| single(f, PC, Offset::Number(f.distance(1)), Index::Offset)),
    ("1111100 s1kkl bbbb tttt iiiiiiiiiiii", |f| single(f, f.b, Offset::Number(f.distance(1)), Index::Offset)),
    ("1111100 s0kkl bbbb tttt 1puw iiiiiiii", |f| {
        // Unprivileged accesses are left out.
        let valid = !(f.w && f.t == f.b) && (f.w || !f.u);
        if valid { single(f, f.b, Offset::Number(f.distance(1)), index(f)?) } else { None }
    }),
    ("1111100 s0kkl bbbb tttt 000000 ii mmmm", |f| single(f, f.b, Offset::Register(f.m, f.i as u8), Index::Offset)),
    ("11111010 0kks nnnn 1111 dddd 0000 mmmm", |f| {
        let name = [LEFT, RIGHT, ARITHMETIC, ROTATE][f.k];
        Some(Operation::Integer { name, flags: f.s, to: Some(f.d), left: f.n, right: f.right() })
    }),
    // Extension alone; with a sum or a rotation it is left out.
    ("11111010 0k0u 1111 1111 dddd 1000 nnnn", |f| extract(f, 0, [16, 8][f.k])),
    ("11111010 1011 nnnn 1111 dddd 1000 mmmm", |f| (f.n == f.m).then_some(LeadingZeros { to: f.d, from: f.m })),
    ("11111011 0000 nnnn 1111 dddd 0000 mmmm", |f| plain(Mul, f.d, f.n, f.right())),
    ("11111011 0000 nnnn aaaa dddd 000s mmmm", |f| {
        Some(MultiplyAdd { to: f.d, factors: [f.n, f.m], sum: f.get('a') as Register, subtract: f.s })
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
        let Transfer { load, width, registers, place } = several else { return None };
        let offset = if single { Offset::Number(f.distance(4)) } else { place.offset };
        Some(Transfer { load, width, registers, place: Place { offset, ..place } })
    }),
    ("1110111011110001 1111 101000010000", |_| Some(ReadFlags)),
    ("11101110000l eeee nnnn 1010 e0010000", |f| {
        let (core, float) = (f.n, S0 + f.get('e') as Register);
        let (to, from) = if f.l { (core, float) } else { (float, core) };
        Some(Move { to, from })
    }),
    ("11101110 1D11 iiii xxxx 1010 0000 iiii", |f| {
        let exponent = if f.i & 0x40 == 0 { 0x4000_0000 } else { 0x3e00_0000 };
        Some(Constant { to: to(f), bits: (f.i & 0x80) << 24 | exponent | (f.i & 0x3f) << 19 })
    }),
    ("11101110 1D11 0000 xxxx 1010 01M0 yyyy", |f| Some(Move { to: to(f), from: from(f) })),
    ("11101110 1D11 0000 xxxx 1010 11M0 yyyy", |f| unary(f, Unary::Abs)),
    ("11101110 1D11 0001 xxxx 1010 01M0 yyyy", |f| unary(f, Unary::Neg)),
    ("11101110 1D11 0001 xxxx 1010 11M0 yyyy", |f| unary(f, Unary::Sqrt)),
    // Which form of a comparison signals does not matter: exceptions are not observed.
    ("11101110 1D11 0100 xxxx 1010 .1M0 yyyy", |f| Some(Compare { left: to(f), right: Some(from(f)) })),
    ("11101110 1D11 0101 xxxx 1010 .100 0000", |f| Some(Compare { left: to(f), right: None })),
    ("11101110 1D11 1000 xxxx 1010 s1M0 yyyy", |f| unary(f, Unary::FromInteger { signed: f.s })),
    ("11101110 1D11 110s xxxx 1010 11M0 yyyy", |f| unary(f, Unary::ToInteger { signed: f.s })),
    ("11101110 kDkk eeee xxxx 1010 ekM0 yyyy", |f| {
        use Binary::*;
        let name = *[MulAdd, MulSub, NegMulSub, NegMulAdd, Mul, NegMul, Add, Sub, Div].get(f.k)?;
        Some(Operation::Binary { name, to: to(f), left: S0 + f.get('e') as Register, right: from(f) })
    }),
];

const LEFT: Integer = Integer::Shift(Shift::Left);
const RIGHT: Integer = Integer::Shift(Shift::Right);
const ARITHMETIC: Integer = Integer::Shift(Shift::Arithmetic);
const ROTATE: Integer = Integer::Shift(Shift::Rotate);

/// Returns an operation that sets the flags outside of conditional blocks.
fn sets(f: &Fields, name: Integer, left: Register) -> Option<Operation> {
    Some(Operation::Integer { name, flags: !f.in_block, to: Some(f.d), left, right: f.right() })
}

fn compare(f: &Fields, name: Integer) -> Option<Operation> {
    Some(Operation::Integer { name, flags: true, to: None, left: f.n, right: f.right() })
}

/// Returns an operation that leaves the flags alone.
fn plain(name: Integer, to: Register, left: Register, right: Operand) -> Option<Operation> {
    Some(Operation::Integer { name, flags: false, to: Some(to), left, right })
}

fn extract(f: &Fields, low: u8, width: u8) -> Option<Operation> {
    Some(Extract { to: f.d, from: f.n, low, width, signed: !f.u })
}

fn branch(f: &Fields, halves: u32, bits: u32) -> Option<Operation> {
    Some(Branch { target: f.target(signed(halves, bits) * 2) })
}

fn transfer(load: bool, width: Width, register: Register, base: Register, offset: Offset) -> Option<Operation> {
    Some(Transfer { load, width, registers: vec![register], place: Place { base, offset, index: Index::Offset } })
}

fn near(f: &Fields, bytes: u8, base: Register) -> Option<Operation> {
    let offset = Offset::Number(f.distance(bytes.into()));
    transfer(f.l || base == PC, Width { bytes, signed: false }, f.t, base, offset)
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
    (!registers.is_empty()).then_some(Transfer { load, width: WORD, registers, place })
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
    let width = Width { bytes: *[1, 2, 4].get(f.k)?, signed: f.s };
    let is_word = f.k == 2;
    // Only whole words are loaded into the stack pointer or the program counter; bytes there are hints.
    let odd = f.t == PC && !(f.l && is_word) || f.t == SP && !is_word || f.s && (is_word || !f.l) || base == PC && !f.l;
    let place = Place { base, offset, index };
    (!odd).then(|| Transfer { load: f.l, width, registers: vec![f.t], place })
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
    let (flags, left, to) = (f.s, f.b, f.t);
    let compares = flags && to == PC;
    let name = match f.k {
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
    let copies = matches!(name, Mov | Mvn);
    // The stack pointer is the base of sums and differences, and their result only then.
    let sums = matches!(name, Add | Sub);
    let valid_left = copies || left != PC && (left != SP || sums);
    let comparable = sums || matches!(name, And | Eor);
    let valid_to = if compares { comparable } else { to != PC && (to != SP || sums && left == SP) };
    let (to, left) = ((!compares).then_some(to), if copies { 0 } else { left });
    (valid_left && valid_to).then_some(Operation::Integer { name, flags, to, left, right })
}

/// Returns an address relative to the instruction.
fn relative(f: &Fields, scale: i32) -> Operation {
    Address { to: f.d, address: (f.target(0) & !3).wrapping_add_signed(f.i as i32 * scale) }
}

/// Returns the register of floats of a result: four bits and the lowest.
fn to(f: &Fields) -> Register {
    S0 + (f.get('x') << 1 | f.get('D')) as Register
}

/// Returns the right register of floats.
fn from(f: &Fields) -> Register {
    S0 + (f.get('y') << 1 | f.get('M')) as Register
}

fn unary(f: &Fields, name: Unary) -> Option<Operation> {
    Some(Operation::Unary { name, to: to(f), from: from(f) })
}
