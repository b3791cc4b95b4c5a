//! The decoder: an instruction with its condition.

use super::forms::FORMS;
use super::{ALWAYS, Block, Instruction, Operand, Operation::*, PC, Register, SP};
use crate::term::Operator;

/// An instruction's bits, of which each field has a letter in its form.
pub(super) struct Fields {
    form: &'static str,
    /// Those of 16 bits are in the upper half.
    bits: u32,
    address: u32,
    pub(super) in_block: bool,
    /// Registers: a result, a left and a right operand, the one that is loaded or stored, a base.
    pub(super) d: Register,
    pub(super) n: Register,
    pub(super) m: Register,
    pub(super) t: Register,
    pub(super) b: Register,
    /// A number, and the kind of an operation.
    pub(super) i: u32,
    pub(super) k: usize,
    /// Signed or setting flags, loading, indexed before, upwards, written back.
    pub(super) s: bool,
    pub(super) l: bool,
    pub(super) p: bool,
    pub(super) u: bool,
    pub(super) w: bool,
}

/// Shifts by their numbers; rotations are left out.
pub(super) const SHIFTS: [Operator; 3] = [Operator::ShiftLeft, Operator::ShiftRight, Operator::ShiftArithmetic];

/// The letters of a form, each with its bit.
fn letters(form: &str, bits: u32) -> impl Iterator<Item = (char, u32)> {
    let letters = form.chars().filter(|letter| *letter != ' ');
    letters.zip((0..32).rev()).map(move |(letter, place)| (letter, bits >> place & 1))
}

/// Returns a field: all bits of a letter.
fn field(form: &str, bits: u32, letter: char) -> u32 {
    letters(form, bits).filter(|found| found.0 == letter).fold(0, |field, (_, bit)| field << 1 | bit)
}

impl Fields {
    /// Reads the fields; none if a register is the stack pointer or the program counter: `d`, `n`, `m` and `a` cannot be.
    fn new(form: &'static str, bits: u32, address: u32, in_block: bool) -> Option<Self> {
        let get = |letter| field(form, bits, letter);
        let [d, n, m, t, b] = ['d', 'n', 'm', 't', 'b'].map(|letter| get(letter) as Register);
        let [s, l, p, u, w] = ['s', 'l', 'p', 'u', 'w'].map(|letter| get(letter) != 0);
        let (i, k, sum) = (get('i'), get('k') as usize, get('a') as Register);
        let valid = ![d, n, m, sum].into_iter().any(|register| [SP, PC].contains(&register));
        valid.then_some(Self { form, bits, address, in_block, d, n, m, t, b, i, k, s, l, p, u, w })
    }

    pub(super) fn get(&self, letter: char) -> u32 {
        field(self.form, self.bits, letter)
    }

    /// Returns the right operand: a register, which may be shifted by a number, where the form has one, else the number.
    pub(super) fn right(&self) -> Operand {
        match (self.form.contains('m'), self.get('h') as usize, self.i) {
            (false, ..) => Operand::Number(self.i),
            // 0 to the right means 32.
            (_, shift @ 1.., 0) => Operand::Register(self.m, SHIFTS[shift], 32),
            (_, shift, by) => Operand::Register(self.m, SHIFTS[shift], by as u8),
        }
    }

    /// Returns an address relative to the instruction.
    pub(super) fn target(&self, distance: i32) -> u32 {
        self.address.wrapping_add(4).wrapping_add_signed(distance)
    }

    /// Returns the number as a distance: ahead, unless the form says otherwise in the field `u`.
    pub(super) fn distance(&self, scale: u32) -> i32 {
        let distance = (self.i * scale) as i32;
        if self.form.contains('u') && !self.u { -distance } else { distance }
    }
}

/// Decodes the instruction at the start of `code`; returns it with the state of conditional execution behind it.
/// `None` if it is cut short, unpredictable, or no part of what is covered here.
pub(crate) fn decode(code: &[u8], address: u32, block: Block) -> Option<(Instruction, Block)> {
    let half = |at: usize| Some(u32::from(u16::from_le_bytes(code.get(at..at + 2)?.try_into().ok()?)));
    let first = half(0)?;
    let (size, second) = if first >> 11 > 0b11100 { (4, half(2)?) } else { (2, 0) };
    let bits = first << 16 | second;
    let fits =
        |form: &str| letters(form, bits).all(|(letter, bit)| letter.to_digit(2).is_none_or(|fixed| fixed == bit));
    let &(form, meaning) = FORMS.iter().find(|(form, _)| fits(form))?;
    let fields = Fields::new(form, bits, address, block.is_open())?;
    let operation = meaning(&fields)?;
    // The condition of a branch, or of a block that begins. 14 is another instruction, 15 a call of the supervisor.
    let own = form.contains('c').then(|| fields.get('c') as u8);
    let instruction = |condition| Instruction { address, size, condition, operation: operation.clone() };
    if operation == If {
        let valid = !block.is_open() && own.is_some_and(|own| own < ALWAYS || own == ALWAYS && fields.i == 8);
        return valid.then(|| (instruction(ALWAYS), Block((first & 255) as u8)));
    }
    if !block.is_open() {
        let condition = own.unwrap_or(ALWAYS);
        return (own != Some(ALWAYS) && condition <= ALWAYS).then(|| (instruction(condition), block.advance()));
    }
    // What leaves a block is its last instruction; a conditional branch of its own has no place in it.
    let misplaced = own.is_some() || matches!(operation, BranchIf { .. }) || operation.leaves() && block.0 & 7 != 0;
    let condition = block.0 >> 4;
    (!misplaced && condition <= ALWAYS).then(|| (instruction(condition), block.advance()))
}
