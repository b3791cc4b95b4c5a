//! Decoder of Thumb-2 and single-precision VFP instructions, as compilers emit them for a Cortex-M4F.
//!
//! Everything not listed here is `None`: a refusal, never a guess. Integer and floating-point registers share one
//! numbering, so that moves, loads and stores have one form: 0 to 15 are r0 to pc, 16 to 47 are s0 to s31.

pub(crate) mod decode;
mod forms;

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
pub(crate) const REGISTERS: usize = 48;

/// Condition of an instruction, by its name in assembly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Condition {
    Eq,
    Ne,
    Cs,
    Cc,
    Mi,
    Pl,
    Vs,
    Vc,
    Hi,
    Ls,
    Ge,
    Lt,
    Gt,
    Le,
    Always,
}

impl Condition {
    /// Returns the condition of a field of four bits; 15 is none.
    pub(crate) fn new(bits: u32) -> Option<Self> {
        use Condition::*;
        const ALL: [Condition; 15] = [Eq, Ne, Cs, Cc, Mi, Pl, Vs, Vc, Hi, Ls, Ge, Lt, Gt, Le, Always];
        ALL.get(bits as usize).copied()
    }
}

/// Shift of an operand; `Right` fills with zeros, `Arithmetic` with the sign.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Shift {
    Left,
    Right,
    Arithmetic,
    Rotate,
}

/// Second operand of an instruction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Operand {
    Number(u32),
    /// A register, shifted by a constant of 0 to 32.
    Register(Register, Shift, u8),
}

impl Operand {
    const fn plain(register: Register) -> Self {
        Self::Register(register, Shift::Left, 0)
    }
}

/// Operation on integers, by its name in assembly: `to = left ∘ right`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Integer {
    Mov,
    Mvn,
    Add,
    Adc,
    Sub,
    Sbc,
    Rsb,
    And,
    Bic,
    Orr,
    Orn,
    Eor,
    Mul,
    /// By the lowest byte of the right operand.
    Shift(Shift),
}

/// Operation on two floats.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Binary {
    Add,
    Sub,
    Mul,
    NegMul,
    Div,
    /// `to + left · right`, rounded twice.
    MulAdd,
    /// `to + −(left · right)`, rounded twice.
    MulSub,
    /// `−to + −(left · right)`, rounded twice.
    NegMulAdd,
    /// `−to + left · right`, rounded twice.
    NegMulSub,
}

/// Operation on one float.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Unary {
    Neg,
    Abs,
    Sqrt,
    /// To a signed or unsigned integer, towards zero.
    ToInteger {
        signed: bool,
    },
    /// From a signed or unsigned integer.
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

/// Size of an access in memory.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Width {
    /// 1, 2 or 4.
    pub(crate) bytes: u8,
    pub(crate) signed: bool,
}

/// A word of memory.
pub(crate) const WORD: Width = Width { bytes: 4, signed: false };

/// Operation of an instruction.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Operation {
    /// Does nothing.
    Nop,
    /// Makes up to four instructions conditional; the decoder gives them their conditions.
    If,
    /// Computes with integers. `MOV` and `MVN` ignore the left operand; comparisons write no register.
    Integer { name: Integer, flags: bool, to: Option<Register>, left: Register, right: Operand },
    /// Adds a product to an integer, or subtracts it.
    MultiplyAdd { to: Register, factors: [Register; 2], sum: Register, subtract: bool },
    /// Takes bits, and extends them with zeros or the sign.
    Extract { to: Register, from: Register, low: u8, width: u8, signed: bool },
    /// Replaces bits by the lowest ones of another register, or zeros.
    Insert { to: Register, from: Option<Register>, low: u8, width: u8 },
    /// Counts leading zeros.
    LeadingZeros { to: Register, from: Register },
    /// Replaces the upper half of a register.
    Top { to: Register, number: u32 },
    /// Computes an address relative to the instruction.
    Address { to: Register, address: u32 },
    /// Loads or stores registers at ascending addresses.
    Transfer { load: bool, width: Width, registers: Vec<Register>, place: Place },
    /// Copies a register's bits.
    Move { to: Register, from: Register },
    /// Sets a floating-point register.
    Constant { to: Register, bits: u32 },
    /// Computes with two floats.
    Binary { name: Binary, to: Register, left: Register, right: Register },
    /// Computes with one float.
    Unary { name: Unary, to: Register, from: Register },
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

/// A decoded instruction.
#[derive(Clone, Debug)]
pub(crate) struct Instruction {
    pub(crate) address: u32,
    pub(crate) size: u32,
    pub(crate) condition: Condition,
    pub(crate) operation: Operation,
}

/// State of conditional execution before an instruction: the architecture's ITSTATE.
#[derive(Clone, Copy, Default, PartialEq)]
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
