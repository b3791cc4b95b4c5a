//! Decoder of Thumb-2 and single-precision VFP instructions, as compilers emit them for a Cortex-M4F.
//!
//! Everything not listed here is `None`: a refusal, never a guess. Integer and floating-point registers and flags share one numbering,
//! so that moves, loads and stores have one form: 0 to 15 are r0 to pc, 16 to 47 are s0 to s31, then come the flags.

pub(crate) mod decode;
mod forms;

use crate::code::{Computed, Expression, number, of};
use crate::term::{Operator, Width};

/// Number of a register.
pub(crate) type Register = u8;

/// The stack pointer.
pub(crate) const SP: Register = 13;
/// The return address.
pub(crate) const LR: Register = 14;
/// The program counter.
pub(crate) const PC: Register = 15;
/// The first floating-point register, s0.
pub(crate) const S0: Register = 16;
/// The first of what the flags say: 1 or 0 for each condition that negates no other, in the order in which they are encoded: equal,
/// carry, negative, overflow, higher, at least, greater.
pub(crate) const FLAGS: Register = 48;
/// Number of conditions that negate no other.
pub(crate) const FLAG_COUNT: Register = 7;
/// The first of what the floating-point unit's flags say.
pub(crate) const FLOAT_FLAGS: Register = FLAGS + FLAG_COUNT;
/// Number of registers.
pub(crate) const REGISTERS: Register = FLOAT_FLAGS + FLAG_COUNT;

/// The condition of what is always executed; each odd one below negates the one before it.
const ALWAYS: u8 = 14;

/// A destination of an instruction.
#[derive(Clone, Debug)]
pub(crate) enum Place {
    Register(Register),
    /// So many bytes at an address
    Memory(Expression, u8),
}

/// A way on to another instruction than the one behind.
#[derive(Clone, Debug)]
pub(crate) enum Exit {
    To(u32),
    /// Goes on behind when the function returns
    Call(u32),
    /// To the caller's address; or to one from a table of addresses of 4 bytes, or of distances of 1 or 2
    Computed(Expression, Option<u8>),
}

/// A decoded instruction.
#[derive(Clone, Debug, Default)]
pub(crate) struct Instruction {
    pub(crate) size: u32,
    /// It is executed where this is not 0
    pub(crate) condition: Option<Expression>,
    /// Destinations and their new values, all set at once
    pub(crate) sets: Vec<(Place, Expression)>,
    pub(crate) jump: Option<Exit>,
}

/// State of conditional execution before an instruction: the architecture's ITSTATE.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Block(u8);

impl Block {
    /// True within a conditional block.
    const fn is_open(self) -> bool {
        self.0 & 15 != 0
    }

    const fn advance(self) -> Self {
        if self.0 & 7 == 0 { Self(0) } else { Self((self.0 & 0xe0) | ((self.0 << 1) & 0x1f)) }
    }
}

/// The contents of a register.
fn register(register: Register) -> Expression {
    of(Computed::Register(register), [])
}

/// An operation of two integers of 32 bits.
fn apply(operator: Operator, a: Expression, b: Expression) -> Expression {
    of(Computed::Apply(operator, Width::W32), [a, b])
}

/// Extends the sign of a number of `bits` bits.
const fn signed(number: u32, bits: u32) -> i32 {
    ((number << (32 - bits)) as i32) >> (32 - bits)
}

/// Registers of a list in one word.
fn list(bits: u32) -> Vec<Register> {
    (0..16).filter(|register| bits >> register & 1 == 1).collect()
}
