//! The decoder: an instruction with its condition.

use super::forms::FORMS;
use super::{ALWAYS, Block, FLAGS, Instruction, PC, Register, SP, apply, number, register};
use crate::code::{Computed, Expression, of};
use crate::elf::{Address, Image};
use crate::machine::Region;
use crate::term::Operator;

/// An instruction's bits, of which each field has a letter in its form.
pub(super) struct Fields<'i> {
    form: &'static str,
    /// Those of 16 bits are in the upper half.
    bits: u32,
    pub(super) image: &'i Image,
    pub(super) address: Address,
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

impl<'i> Fields<'i> {
    /// Reads the fields; none if a register is the stack pointer or the program counter: `d`, `n` and `m` cannot be.
    fn new(form: &'static str, bits: u32, image: &'i Image, address: Address, in_block: bool) -> Option<Self> {
        let get = |letter| field(form, bits, letter);
        let [d, n, m, t, b] = ['d', 'n', 'm', 't', 'b'].map(|letter| get(letter) as Register);
        let [s, l, p, u, w] = ['s', 'l', 'p', 'u', 'w'].map(|letter| get(letter) != 0);
        let (i, k) = (get('i'), get('k') as usize);
        let valid = ![d, n, m].into_iter().any(|register| [SP, PC].contains(&register));
        valid.then_some(Self { form, bits, image, address, in_block, d, n, m, t, b, i, k, s, l, p, u, w })
    }

    pub(super) fn get(&self, letter: char) -> u32 {
        field(self.form, self.bits, letter)
    }

    /// Returns the right operand: a register, which may be shifted by a number, where the form has one, else the number.
    pub(super) fn right(&self) -> Expression {
        match (self.form.contains('m'), self.get('h') as usize, self.i) {
            (false, ..) => number(self.i),
            (_, 0, 0) => register(self.m),
            // 0 to the right means 32.
            (_, shift, by) => apply(SHIFTS[shift], register(self.m), number(if by == 0 { 32 } else { by })),
        }
    }

    /// Returns an address relative to the instruction.
    pub(super) fn target(&self, distance: i32) -> u32 {
        self.address.offset.wrapping_add(4).wrapping_add_signed(distance)
    }

    /// Returns the address of a place in the instruction's section.
    pub(super) fn place(&self, offset: u32) -> Expression {
        apply(Operator::Add, of(Computed::Base(Region::Section(self.address.section)), []), number(offset))
    }

    /// Returns the number as a distance: ahead, unless the form says otherwise in the field `u`.
    pub(super) fn distance(&self, scale: u32) -> i32 {
        let distance = (self.i * scale) as i32;
        if self.form.contains('u') && !self.u { -distance } else { distance }
    }
}

/// Decodes the instruction at the start of `code`; returns it with the state of conditional execution behind it.
/// `None` if it is cut short, unpredictable, or no part of what is covered here.
pub(crate) fn decode(code: &[u8], image: &Image, address: Address, block: Block) -> Option<(Instruction, Block)> {
    let half = |at: usize| Some(u32::from(u16::from_le_bytes(code.get(at..at + 2)?.try_into().ok()?)));
    let first = half(0)?;
    if first >> 8 == 0xbf && first & 15 != 0 {
        // The next up to four instructions are conditional.
        let (own, then) = ((first >> 4 & 15) as u8, first & 15);
        let valid = !block.is_open() && (own < ALWAYS || own == ALWAYS && then == 8);
        return valid.then(|| (Instruction { size: 2, ..Instruction::default() }, Block((first & 255) as u8)));
    }
    let (size, second) = if first >> 11 > 0b11100 { (4, half(2)?) } else { (2, 0) };
    let bits = first << 16 | second;
    let fits =
        |form: &str| letters(form, bits).all(|(letter, bit)| letter.to_digit(2).is_none_or(|fixed| fixed == bit));
    let &(form, meaning) = FORMS.iter().find(|(form, _)| fits(form))?;
    let fields = Fields::new(form, bits, image, address, block.is_open())?;
    let meant = meaning(&fields)?;
    // The condition of a branch. 14 is another instruction, 15 a call of the supervisor.
    let own = form.contains('c').then(|| fields.get('c') as u8);
    // What leaves a block is its last instruction; a conditional branch of its own has no place in it.
    let leaves = own.is_some() || meant.condition.is_some() || meant.jump.is_some() && block.0 & 7 != 0;
    let number = if block.is_open() { block.0 >> 4 } else { own.unwrap_or(ALWAYS) };
    if own == Some(ALWAYS) || number > ALWAYS || block.is_open() && leaves {
        return None;
    }
    let flag = register(FLAGS + number / 2);
    let condition = match number {
        ALWAYS => meant.condition,
        _ => Some(if number % 2 == 1 { !flag } else { flag }),
    };
    Some((Instruction { size, condition, ..meant }, block.advance()))
}
