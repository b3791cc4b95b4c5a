//! The forms of instructions, as the architecture's manual draws them: fixed bits, and letters for fields.
//!
//! Of several forms that fit, the first counts. Points are bits that are not looked at.

use super::decode::{Fields, SHIFTS};
use super::*;
use crate::elf::{Part, Relocation};
use crate::machine::Region;
use crate::term::Operator::{Add, And, Or, ShiftLeft, ShiftRight, Subtract, Xor};
use crate::term::{Arithmetic, Terms};
use Computed::{Base, Below, Compared, Completed, Loaded, Magnitude, Negative, OfInteger, Root, Same, Unknown};
use Expression::Number;

/// The meaning of a form; `None` where it is unpredictable or left out.
type Meaning = fn(&Fields<'_>) -> Option<Instruction>;

/// Operations of integers by their numbers in the architecture. Without a left operand, `ORR` copies and `ORN` inverts.
const AND: u32 = 0;
const BIC: u32 = 1;
const ORR: u32 = 2;
const ORN: u32 = 3;
const EOR: u32 = 4;
const ADD: u32 = 8;
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
    ("010000 1111 mmm ddd", |f| sets(f, ORN, None)),
    ("010000 11k0 mmm ddd", |f| sets(f, [ORR, BIC][f.k], Some(f.d))),
    ("010000 000k mmm ddd", |f| sets(f, [AND, EOR][f.k], Some(f.d))),
    ("010000 0kkk mmm ddd", |f| shift(f, f.k.checked_sub(2)?, !f.in_block, f.d)),
    // Operations on all sixteen registers; computing with the program counter is left out.
    ("010001 kk t bbbb ttt", |f| {
        let (to, right) = (f.t, register(f.b));
        match f.k {
            _ if f.b == PC => None,
            // `bx`; `blx` is a call to an unknown function.
            3 => (to == 0).then(|| jump(Exit::Computed(right, None))),
            _ if to == PC => None,
            2 => processed(ORR, false, Some(to), None, right),
            0 => processed(ADD, false, Some(to), Some(to), right),
            _ => processed(SUB, true, None, Some(to), right),
        }
    }),
    ("01001 ttt iiiiiiii", |f| near(f, 4, PC)),
    ("0101 kkk mmm bbb ttt", |f| {
        // What extends a sign is left out.
        let &bytes = [4, 2, 1].get(f.k % 4)?;
        Some(transfer(f, f.k > 2, bytes, &[f.t], (f.b, register(f.m), Index::Offset)))
    }),
    ("0110 l iiiii bbb ttt", |f| near(f, 4, f.b)),
    ("0111 l iiiii bbb ttt", |f| near(f, 1, f.b)),
    ("1000 l iiiii bbb ttt", |f| near(f, 2, f.b)),
    ("1001 l ttt iiiiiiii", |f| near(f, 4, SP)),
    ("10100 ddd iiiiiiii", |f| relative(f, 4)),
    ("10101 ddd iiiiiiii", |f| processed(ADD, false, Some(f.d), Some(SP), number(f.i * 4))),
    ("1011 k0i1 iiiii nnn", |f| {
        let zero = of(Same(Width::W32), [register(f.n), number(0)]);
        let condition = Some(if f.k == 0 { zero } else { !zero });
        Some(Instruction { condition, ..jump(Exit::To(f.target(f.distance(2)))) })
    }),
    ("1011 0000 k iiiiiii", |f| processed([ADD, SUB][f.k], false, Some(SP), Some(SP), number(f.i * 4))),
    ("1011 0010 1k nnn ddd", |f| extract(f, 0, [16, 8][f.k])),
    ("1011 010 i iiiiiiii", |f| several(f, false, SP, &list((f.i & 256) << 6 | f.i & 255), true, true)),
    ("1011 110 i iiiiiiii", |f| several(f, true, SP, &list((f.i & 256) << 7 | f.i & 255), false, true)),
    ("1011 1111 0000 0000", |_| Some(Instruction::default())),
    ("1100 l bbb iiiiiiii", |f| {
        // The base is written back unless it is loaded. Storing a base that is written back is left out.
        let inside = list(f.i).contains(&f.b);
        if f.l || !inside { several(f, f.l, f.b, &list(f.i), false, !inside) } else { None }
    }),
    ("1101 cccc iiiiiiii", |f| branch(f, f.i, 8)),
    ("11100 iiiiiiiiiii", |f| branch(f, f.i, 11)),
    // 32 bits: several registers, or two; exclusive accesses are left out.
    ("1110100 pu 0wl bbbb iiiiiiiiiiiiiiii", |f| {
        let registers = list(f.i);
        let has = |register| registers.contains(&register);
        let odd = f.p == f.u || has(SP) || has(PC) && (!f.l || has(LR)) || f.w && has(f.b);
        let valid = !odd && f.b != PC && registers.len() > 1;
        if valid { several(f, f.l, f.b, &registers, f.p, f.w) } else { None }
    }),
    ("1110100 01101 bbbb 11110000000 i mmmm", |f| {
        // The table follows; its entries are distances in halfwords.
        let index = apply(ShiftLeft, register(f.m), number(f.i));
        let entry = of(Loaded(f.i as u8 + 1), [apply(Add, f.place(f.target(0)), index)]);
        let target = apply(Add, f.place(f.target(0)), apply(ShiftLeft, entry, number(1)));
        (f.b == PC).then(|| jump(Exit::Computed(target, Some(f.i as u8 + 1))))
    }),
    ("1110100 pu1wl bbbb nnnn mmmm iiiiiiii", |f| {
        let index = index(f.p, f.w);
        let clash = index != Index::Offset && [PC, f.n, f.m].contains(&f.b);
        let valid = (f.p || f.w) && !clash && if f.l { f.n != f.m } else { f.b != PC };
        valid.then(|| transfer(f, f.l, 4, &[f.n, f.m], (f.b, number(f.distance(4) as u32), index)))
    }),
    // Rotations are left out.
    ("1110101 .... . .... .... .... ..11 ....", |_| None),
    ("1110101 kkkk s bbbb 0iii tttt iihh mmmm", |f| processing(f, f.right())),
    ("11110 i0 kkkk s bbbb 0iii tttt iiiiiiii", |f| processing(f, number(expanded(f.i)?))),
    // Plain constants, and operations on bits.
    ("11110 i1 00000 1111 0iii dddd iiiiiiii", |f| relative(f, 1)),
    ("11110 i1 0k0k0 bbbb 0iii tttt iiiiiiii", |f| {
        let valid = f.b != PC && f.t != PC && (f.t != SP || f.b == SP) && matches!(f.k, 0 | 3);
        if valid { processed([ADD, SUB][f.k & 1], false, Some(f.t), Some(f.b), f.right()) } else { None }
    }),
    ("11110 i1 00100 hhhh 0iii dddd iiiiiiii", |f| match f.image.relocation(f.address) {
        None => compute(f.d, number(f.get('h') << 12 | f.i)),
        Some(&Relocation { part: Part::Low, target: Ok(address) }) => compute(f.d, of(Base(Region::Half(address)), [])),
        _ => None,
    }),
    ("11110 i1 01100 hhhh 0iii dddd iiiiiiii", |f| match f.image.relocation(f.address) {
        None => {
            let lower = apply(And, register(f.d), number(0xffff));
            compute(f.d, apply(Or, lower, number((f.get('h') << 12 | f.i) << 16)))
        }
        Some(&Relocation { part: Part::High, target: Ok(address) }) => {
            compute(f.d, of(Completed(address), [register(f.d)]))
        }
        _ => None,
    }),
    ("11110 .1 11100 nnnn 0iii dddd ii.kkkkk", |f| {
        if f.i as usize + f.k < 32 { extract(f, f.i, f.k as u32 + 1) } else { None }
    }),
    ("11110 .1 10110 bbbb 0iii dddd ii.kkkkk", |f| {
        let width = (f.k as u32 + 1).checked_sub(f.i).filter(|&width| width > 0)?;
        let mask = (((1_u64 << width) - 1) as u32) << f.i;
        let kept = apply(And, register(f.d), number(!mask));
        let from = if f.b == PC { number(0) } else { register(f.b) };
        let new = apply(And, apply(ShiftLeft, from, number(f.i)), number(mask));
        if f.b == SP { None } else { compute(f.d, apply(Or, kept, new)) }
    }),
    ("11110 s cccc iiiiii 10n0m iiiiiiiiiii", |f| {
        branch(f, u32::from(f.s) << 19 | u32::from(f.m) << 18 | u32::from(f.n) << 17 | f.i, 20)
    }),
    ("11110 s iiiiiiiiii 1ln1m iiiiiiiiiii", |f| {
        let [one, two] = [f.n, f.m].map(|bit| u32::from((bit == 1) == f.s));
        let target = f.target(signed(u32::from(f.s) << 23 | one << 22 | two << 21 | f.i, 24) * 2);
        let back = (Place::Register(LR), of(Base(Region::Behind(f.address)), []));
        Some(if f.l { Instruction { sets: vec![back], ..jump(Exit::Call(target)) } } else { jump(Exit::To(target)) })
    }),
    // One register: relative to the program counter, with an offset, with writing back, with a register.
    ("1111100 0ukkl 1111 tttt iiiiiiiiiiii", |f| single(f, PC, number(f.distance(1) as u32), Index::Offset)),
    ("1111100 01kkl bbbb tttt iiiiiiiiiiii", |f| single(f, f.b, number(f.distance(1) as u32), Index::Offset)),
    ("1111100 00kkl bbbb tttt 1puw iiiiiiii", |f| {
        // Unprivileged accesses are left out.
        let valid = f.w && f.t != f.b || f.p && !f.w && !f.u;
        if valid { single(f, f.b, number(f.distance(1) as u32), index(f.p, f.w)) } else { None }
    }),
    ("1111100 00kkl bbbb tttt 000000 ii mmmm", |f| {
        single(f, f.b, apply(ShiftLeft, register(f.m), number(f.i)), Index::Offset)
    }),
    ("11111010 0kks nnnn 1111 dddd 0000 mmmm", |f| shift(f, f.k, f.s, f.n)),
    // Extension alone; with a sum or a rotation it is left out.
    ("11111010 0k01 1111 1111 dddd 1000 nnnn", |f| extract(f, 0, [16, 8][f.k])),
    // Floats. Double precision is left out, but for loading and storing pairs of registers.
    ("1110110 puDwl bbbb xxxx 101k iiiiiiii", |f| {
        let single = f.p && !f.w;
        let (start, count) = (u32::from(to(f)), if single { 1 + f.k as u32 } else { f.i });
        // An odd count of words for doubles is the deprecated form with a gap; d16 and above are not there.
        let odd = f.k == 1 && (f.get('D') == 1 || count % 2 != 0) || f.p == f.u && !single;
        if count == 0 || start + count > 48 || odd || f.b == PC && !(f.l && single) {
            return None;
        }
        let registers: Vec<_> = (start as Register..(start + count) as Register).collect();
        if single {
            return Some(transfer(f, f.l, 4, &registers, (f.b, number(f.distance(4) as u32), Index::Offset)));
        }
        several(f, f.l, f.b, &registers, f.p, f.w)
    }),
    ("1110111011110001 1111 101000010000", |_| {
        Some(setting(FLAGS, [0, 1, 2, 3, 4, 5, 6].map(|flag| register(FLOAT_FLAGS + flag))))
    }),
    ("11101110000l eeee nnnn 1010 e0010000", |f| {
        let (core, float) = (f.n, S0 + f.get('e') as Register);
        let (to, from) = if f.l { (core, float) } else { (float, core) };
        compute(to, register(from))
    }),
    ("11101110 1D11 iiii xxxx 1010 0000 iiii", |f| {
        let exponent = if f.i & 0x40 == 0 { 0x4000_0000 } else { 0x3e00_0000 };
        compute(to(f), number((f.i & 0x80) << 24 | exponent | (f.i & 0x3f) << 19))
    }),
    ("11101110 1D11 0000 xxxx 1010 01M0 yyyy", |f| compute(to(f), register(from(f)))),
    ("11101110 1D11 0000 xxxx 1010 11M0 yyyy", |f| compute(to(f), of(Magnitude, [register(from(f))]))),
    ("11101110 1D11 0001 xxxx 1010 01M0 yyyy", |f| compute(to(f), of(Negative, [register(from(f))]))),
    ("11101110 1D11 0001 xxxx 1010 11M0 yyyy", |f| compute(to(f), of(Root, [register(from(f))]))),
    // Which form of a comparison signals does not matter: exceptions are not observed.
    ("11101110 1D11 0100 xxxx 1010 .1M0 yyyy", |f| floats(to(f), register(from(f)))),
    ("11101110 1D11 0101 xxxx 1010 .100 0000", |f| floats(to(f), number(0))),
    ("11101110 1D11 1000 xxxx 1010 s1M0 yyyy", |f| compute(to(f), of(OfInteger(f.s), [register(from(f))]))),
    ("11101110 kDkk eeee xxxx 1010 ekM0 yyyy", |f| {
        let [sum, a, b] = [to(f), S0 + f.get('e') as Register, from(f)].map(register);
        let negative = |is: bool, value| if is { of(Negative, [value]) } else { value };
        let rounded = |operation, a, b| of(Computed::Arithmetic(operation), [a, b]);
        let negated = f.k % 2 == 1;
        let result = match f.k {
            // Rounded twice.
            0..4 => {
                let product = negative(negated, rounded(Arithmetic::Multiply, a, b));
                rounded(Arithmetic::Add, negative(f.k > 1, sum), product)
            }
            4 | 5 => negative(negated, rounded(Arithmetic::Multiply, a, b)),
            6 | 7 => rounded(Arithmetic::Add, a, negative(negated, b)),
            8 => rounded(Arithmetic::Divide, a, b),
            _ => return None,
        };
        compute(to(f), result)
    }),
];

fn compute(to: Register, value: Expression) -> Option<Instruction> {
    Some(Instruction { sets: vec![(Place::Register(to), value)], ..Instruction::default() })
}

fn jump(jump: Exit) -> Instruction {
    Instruction { jump: Some(jump), ..Instruction::default() }
}

/// Sets what flags say.
fn setting(first: Register, flags: [Expression; FLAG_COUNT as usize]) -> Instruction {
    let sets = (first..).map(Place::Register).zip(flags).collect();
    Instruction { sets, ..Instruction::default() }
}

/// Returns the flags after a second number was subtracted from a first.
fn difference(a: &Expression, b: &Expression) -> [Expression; FLAG_COUNT as usize] {
    let below = |signed, a: &Expression, b: &Expression| of(Below(signed, Width::W32), [a.clone(), b.clone()]);
    let negative = below(true, &apply(Subtract, a.clone(), b.clone()), &number(0));
    let same = of(Same(Width::W32), [a.clone(), b.clone()]);
    let [carry, at_least] = [!below(false, a, b), !below(true, a, b)];
    [same, carry, negative, of(Unknown, []), below(false, b, a), at_least, below(true, b, a)]
}

/// Returns the instruction that sets the flags to a comparison of floats.
fn floats(left: Register, right: Expression) -> Option<Instruction> {
    let compared = |relation| of(Compared(relation), [register(left), right.clone()]);
    let less = || compared(Terms::less);
    let unordered = compared(|terms, a, b| terms.or(terms.is_nan(a), terms.is_nan(b)));
    let [higher, at_least] = [!compared(Terms::less_or_equal), compared(|terms, a, b| terms.less_or_equal(b, a))];
    let greater = compared(|terms, a, b| terms.less(b, a));
    Some(setting(FLOAT_FLAGS, [compared(Terms::equal), !less(), less(), unordered, higher, at_least, greater]))
}

/// Returns an operation of integers.
fn processed(
    operation: u32,
    flags: bool,
    to: Option<Register>,
    left: Option<Register>,
    right: Expression,
) -> Option<Instruction> {
    let right = if matches!(operation, BIC | ORN) { apply(Xor, right, number(u32::MAX)) } else { right };
    let operator = match operation {
        AND | BIC => And,
        ORR | ORN => Or,
        EOR => Xor,
        ADD => Add,
        SUB | RSB => Subtract,
        _ => return None,
    };
    let (a, b) = match left.map(register) {
        Some(left) if operation == RSB => (right, left),
        Some(left) => (left, right),
        None => return set(flags, to, right.clone(), of_result(&right)),
    };
    let result = apply(operator, a.clone(), b.clone());
    let says = match (operator, &b) {
        (Subtract, _) => difference(&a, &b),
        // The flags of a sum with such a constant are those of the difference from its opposite.
        (Add, &Number(b)) if b & 0x7fff_ffff != 0 => difference(&a, &number((b as u32).wrapping_neg())),
        (Add, _) => {
            let mut says = of_result(&result);
            says[1] = of(Below(false, Width::W32), [result.clone(), a]);
            says
        }
        _ => of_result(&result),
    };
    set(flags, to, result, says)
}

/// Returns the flags that follow from a result alone: zero and sign.
fn of_result(result: &Expression) -> [Expression; FLAG_COUNT as usize] {
    let mut says = [(); FLAG_COUNT as usize].map(|()| of(Unknown, []));
    says[0] = of(Same(Width::W32), [result.clone(), number(0)]);
    says[2] = of(Below(true, Width::W32), [result.clone(), number(0)]);
    says
}

/// Sets a register, and the flags if that is asked for.
fn set(
    flags: bool,
    to: Option<Register>,
    result: Expression,
    says: [Expression; FLAG_COUNT as usize],
) -> Option<Instruction> {
    let mut instruction = if flags { setting(FLAGS, says) } else { Instruction::default() };
    instruction.sets.extend(to.map(|to| (Place::Register(to), result)));
    Some(instruction)
}

/// Returns an operation that sets the flags outside of conditional blocks.
fn sets(f: &Fields<'_>, operation: u32, left: Option<Register>) -> Option<Instruction> {
    processed(operation, !f.in_block, Some(f.d), left, f.right())
}

fn compare(f: &Fields<'_>, operation: u32) -> Option<Instruction> {
    processed(operation, true, None, Some(f.n), f.right())
}

/// Returns a shift by the lowest byte of a register.
fn shift(f: &Fields<'_>, kind: usize, flags: bool, left: Register) -> Option<Instruction> {
    let by = apply(And, register(f.m), number(255));
    let result = apply(*SHIFTS.get(kind)?, register(left), by);
    set(flags, Some(f.d), result.clone(), of_result(&result))
}

fn extract(f: &Fields<'_>, low: u32, width: u32) -> Option<Instruction> {
    let above = apply(ShiftRight, register(f.n), number(low));
    compute(f.d, apply(And, above, number(((1_u64 << width) - 1) as u32)))
}

fn branch(f: &Fields<'_>, halves: u32, bits: u32) -> Option<Instruction> {
    Some(jump(Exit::To(f.target(signed(halves, bits) * 2))))
}

/// Address of an access, and writing back.
#[derive(Clone, Copy, PartialEq)]
enum Index {
    /// Base and offset; the base keeps its value.
    Offset,
    /// Base and offset; written back.
    Before,
    /// The base; base and offset are written back.
    After,
}

/// Loads or stores registers at ascending addresses.
fn transfer(
    f: &Fields<'_>,
    load: bool,
    bytes: u8,
    registers: &[Register],
    (base, offset, index): (Register, Expression, Index),
) -> Instruction {
    let table = (!matches!(offset, Number(_))).then_some(4);
    let from = if base == PC { f.place(f.target(0) & !3) } else { register(base) };
    let sum = apply(Add, from.clone(), offset);
    let first = if index == Index::After { from } else { sum.clone() };
    let mut result = Instruction::default();
    if index != Index::Offset {
        result.sets.push((Place::Register(base), sum));
    }
    for (at, &other) in (0..).zip(registers) {
        let address = apply(Add, first.clone(), Number(4 * at));
        match (load, other) {
            (true, PC) => result.jump = Some(Exit::Computed(of(Loaded(bytes), [address]), table)),
            (true, _) => result.sets.push((Place::Register(other), of(Loaded(bytes), [address]))),
            (false, _) if bytes == 4 => result.sets.push((Place::Memory(address, bytes), register(other))),
            (false, _) => {
                let part = apply(And, register(other), Number((1 << (8 * bytes)) - 1));
                result.sets.push((Place::Memory(address, bytes), part));
            }
        }
    }
    result
}

fn near(f: &Fields<'_>, bytes: u8, base: Register) -> Option<Instruction> {
    let offset = number(f.distance(bytes.into()) as u32);
    Some(transfer(f, f.l || base == PC, bytes, &[f.t], (base, offset, Index::Offset)))
}

/// Loads or stores registers from the base on, or up to it.
fn several(
    f: &Fields<'_>,
    load: bool,
    base: Register,
    registers: &[Register],
    down: bool,
    written: bool,
) -> Option<Instruction> {
    let bytes = 4 * registers.len() as u32;
    let offset = match (down, written) {
        (true, _) => bytes.wrapping_neg(),
        (false, true) => bytes,
        (false, false) => 0,
    };
    let base = (base, number(offset), index(down, written));
    (!registers.is_empty()).then(|| transfer(f, load, 4, registers, base))
}

/// The address that is accessed where a base is written back, before that or after.
fn index(before: bool, written: bool) -> Index {
    match (before, written) {
        (_, false) => Index::Offset,
        (true, true) => Index::Before,
        (false, true) => Index::After,
    }
}

fn single(f: &Fields<'_>, base: Register, offset: Expression, index: Index) -> Option<Instruction> {
    let &bytes = [1, 2, 4].get(f.k)?;
    let is_word = bytes == 4;
    // Only whole words are loaded into the stack pointer or the program counter; bytes there are hints.
    let odd = f.t == PC && !(f.l && is_word) || f.t == SP && !is_word || base == PC && !f.l;
    (!odd).then(|| transfer(f, f.l, bytes, &[f.t], (base, offset, index)))
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

fn processing(f: &Fields<'_>, right: Expression) -> Option<Instruction> {
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
fn relative(f: &Fields<'_>, scale: u32) -> Option<Instruction> {
    compute(f.d, f.place((f.target(0) & !3).wrapping_add(f.i * scale)))
}

/// Returns the register of floats of a result: four bits and the lowest.
fn to(f: &Fields<'_>) -> Register {
    S0 + (f.get('x') << 1 | f.get('D')) as Register
}

/// Returns the right register of floats.
fn from(f: &Fields<'_>) -> Register {
    S0 + (f.get('y') << 1 | f.get('M')) as Register
}
