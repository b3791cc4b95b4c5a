//! Decoder of Thumb-2 and single-precision VFP instructions, as compilers emit them for a Cortex-M4F.
//!
//! Everything not listed here is `None`: a refusal, never a guess. Integer and floating-point registers share one
//! numbering, so that moves, loads and stores have one form: 0 to 15 are r0 to pc, 16 to 47 are s0 to s31.

pub(crate) mod decode;
mod forms;

use crate::term::{Arithmetic, Operator};

/// Number of a register: 0 to 15 for integers, 16 to 47 for floats.
pub(crate) type Register = u8;

/// The stack pointer.
pub(crate) const SP: Register = 13;
/// The return address.
pub(crate) const LR: Register = 14;
/// The program counter.
pub(crate) const PC: Register = 15;
/// The first floating-point register, s0.
pub(crate) const S0: Register = 16;
/// Number of registers.
pub(crate) const REGISTERS: Register = 48;

/// Condition of an instruction, as it is encoded: each odd one negates the one before it.
pub(crate) type Condition = u8;

/// The condition of what is always executed.
pub(crate) const ALWAYS: Condition = 14;

/// Operand of an instruction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Operand {
    Number(u32),
    /// A register, shifted by a constant of 0 to 32.
    Register(Register, Operator, u8),
}

impl Operand {
    const fn plain(register: Register) -> Self {
        Self::Register(register, Operator::ShiftLeft, 0)
    }
}

/// A computation on operands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Computed {
    /// The operand.
    Same,
    /// An operation of two integers; shifts are by the lowest byte.
    Integers(Operator),
    /// The sum of two integers and the carry.
    WithCarry,
    /// An operation of an integer and the product of two more.
    OfProduct(Operator),
    /// Bits of an integer.
    Extracted {
        low: u8,
        width: u8,
    },
    /// An integer with bits replaced by the lowest ones of another.
    Inserted {
        low: u8,
        width: u8,
    },
    /// A number, or the lower half of an address.
    Lower,
    /// An integer with another upper half, which may be that of an address.
    Upper,
    /// The address that a number is.
    Address,
    /// An operation of two floats, of which the second may be negated.
    Floats {
        operation: Arithmetic,
        negated: bool,
    },
    /// The product of the last two floats, which may be negated, added to the first, if there is one, which may be negated.
    /// Rounded twice.
    Product {
        negated: bool,
        sum_negated: bool,
    },
    Negated,
    Magnitude,
    /// A float from a signed or unsigned integer.
    FromInteger {
        signed: bool,
    },
}

/// Place in memory: base and offset.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Place {
    /// For `PC` the address is aligned to four.
    pub(crate) base: Register,
    pub(crate) offset: Offset,
    pub(crate) index: Index,
}

/// Offset from a base register.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Offset {
    Number(i32),
    /// A register, shifted to the left.
    Register(Register, u8),
}

/// Address of an access, and writing back.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Index {
    /// Base and offset; the base keeps its value.
    Offset,
    /// Base and offset; written back.
    Before,
    /// The base; base and offset are written back.
    After,
}

/// Operation of an instruction.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Operation {
    /// Does nothing.
    Nop,
    /// Makes up to four instructions conditional; the decoder gives them their conditions.
    If,
    /// Computes; comparisons write no register. The last operand may be inverted.
    Compute { name: Computed, flags: bool, to: Option<Register>, from: Vec<Operand>, inverted: bool },
    /// Loads or stores registers at ascending addresses, of 1, 2 or 4 bytes.
    Transfer { load: bool, bytes: u8, registers: Vec<Register>, place: Place },
    /// Compares floats; their flags wait for `ReadFlags`.
    Compare { left: Register, right: Option<Register> },
    /// Makes the flags of floats those of conditions.
    ReadFlags,
    /// Goes to an address.
    Branch { target: u32 },
    /// Goes to an address if a register is zero, or is not.
    BranchIf { register: Register, zero: bool, target: u32 },
    /// Goes ahead by twice an entry of a table of bytes or halves.
    Table { base: Register, index: Register, bytes: u8 },
    /// Goes to the address in a register.
    Exchange { register: Register },
    /// Calls a function.
    Call { target: u32 },
}

impl Operation {
    /// True if the next instruction may be another than the one behind.
    pub(crate) fn leaves(&self) -> bool {
        use Operation::*;
        match self {
            Branch { .. } | BranchIf { .. } | Table { .. } | Exchange { .. } | Call { .. } => true,
            Transfer { load, registers, .. } => *load && registers.contains(&PC),
            _ => false,
        }
    }
}

/// A decoded instruction.
#[derive(Clone, Debug)]
pub(crate) struct Instruction {
    pub(crate) address: u32,
    pub(crate) size: u32,
    pub(crate) condition: Condition,
    pub(crate) operation: Operation,
}

impl Instruction {
    /// The address behind it.
    pub(crate) fn behind(&self) -> u32 {
        self.address.wrapping_add(self.size)
    }
}

/// State of conditional execution before an instruction: the architecture's ITSTATE.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Block(u8);

impl Block {
    /// True within a conditional block.
    pub(crate) const fn is_open(self) -> bool {
        self.0 & 15 != 0
    }

    const fn advance(self) -> Self {
        if self.0 & 7 == 0 { Self(0) } else { Self((self.0 & 0xe0) | ((self.0 << 1) & 0x1f)) }
    }
}

/// Extends the sign of a number of `bits` bits.
const fn signed(number: u32, bits: u32) -> i32 {
    ((number << (32 - bits)) as i32) >> (32 - bits)
}

/// Registers of a list in one word.
fn list(bits: u32) -> Vec<Register> {
    (0..16).filter(|register| bits >> register & 1 == 1).collect()
}
