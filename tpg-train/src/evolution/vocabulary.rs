//! What programs can be written with: instructions, registers and sources, numbered as GEGELATI numbers them.

use crate::engine::Operand;
use serde::{Deserialize, Serialize};
use tpg_arm::observation::shield::SHIELDED;
use tpg_graph::{ScalarType, SourceDocument};
use tpg_runtime::ops::Instruction;

/// Operands of a line. GEGELATI calls it `maxNbOperands`; the instruction set has no instruction with more.
pub const OPERANDS: usize = 2;

/// The place of an instruction in its set, as a line stores it.
pub type InstructionIndex = u8;

/// An operand of a genome's line: GEGELATI's pair of data source and location (`program/line.h`), and a number of its own
/// where literal constants are allowed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Gene {
    /// Which source, by [`Vocabulary::kind`].
    pub source: u8,
    /// Where in the source, modulo its length.
    pub location: u16,
    /// The number read where the source is [`Kind::Literal`]; kept, unused, otherwise.
    pub literal: f64,
}

/// What a source number stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The registers: always source 0.
    Registers,
    /// The program's constants, where a program has some: source 1.
    Constants,
    /// A data source of the environment: its first place in the flat state, and its length.
    Data(u16, u16),
    /// The operand's own number, where that is allowed: the last source.
    Literal,
}

/// What programs can be written with.
#[derive(Clone, Debug, PartialEq)]
pub struct Vocabulary {
    instructions: Vec<Instruction>,
    registers: u16,
    constants: u16,
    kinds: Vec<Kind>,
    /// GEGELATI, `environment.cpp`, `computeLargestAddressSpace`: locations are drawn below this.
    largest_address_space: u16,
    scalar: ScalarType,
    /// Where the shield begins in the flat state, behind all that programs can name.
    shield: Option<u16>,
}

impl Vocabulary {
    /// Puts a vocabulary together.
    ///
    /// # Panics
    /// If there is no register, or no or more than 256 instructions: a configuration is checked before.
    pub fn new(
        instructions: Vec<Instruction>,
        registers: u16,
        constants: u16,
        sources: &[SourceDocument],
        literals: bool,
        scalar: ScalarType,
    ) -> Self {
        assert!(registers > 0 && (1..=256).contains(&instructions.len()));
        let mut kinds = vec![Kind::Registers];
        if constants > 0 {
            kinds.push(Kind::Constants);
        }
        let mut place = 0;
        for source in sources {
            kinds.push(Kind::Data(place, source.length as u16));
            place += source.length as u16;
        }
        if literals {
            kinds.push(Kind::Literal);
        }
        let longest = sources.iter().map(|source| source.length as u16).max().unwrap_or(1);
        let largest_address_space = registers.max(constants).max(longest);
        Self { instructions, registers, constants, kinds, largest_address_space, scalar, shield: None }
    }

    /// The same under a shield whose values begin at that place of the flat state; no operand can name them.
    #[must_use]
    pub fn with_shield(self, place: u16) -> Self {
        Self { shield: Some(place), ..self }
    }

    /// The place of an action's bound in the flat state, where there is a shield and it speaks of the action.
    pub fn bound(&self, action: u16) -> Option<u16> {
        self.shield.filter(|_| usize::from(action) < SHIELDED).map(|place| place + action)
    }

    /// The instruction set.
    pub fn instructions(&self) -> &[Instruction] {
        &self.instructions
    }

    /// The instruction at a place of the set.
    pub fn instruction(&self, index: InstructionIndex) -> Instruction {
        self.instructions[usize::from(index)]
    }

    /// Registers of a program.
    pub fn registers(&self) -> u16 {
        self.registers
    }

    /// Constants of a program.
    pub fn constants(&self) -> u16 {
        self.constants
    }

    /// How many sources an operand can name.
    pub fn sources(&self) -> usize {
        self.kinds.len()
    }

    /// What a source number stands for.
    pub fn kind(&self, source: u8) -> Kind {
        self.kinds[usize::from(source)]
    }

    /// Locations are drawn below this.
    pub fn largest_address_space(&self) -> u16 {
        self.largest_address_space
    }

    /// The scalar that programs compute in.
    pub fn scalar(&self) -> ScalarType {
        self.scalar
    }

    /// What an operand reads; `constants` are its program's.
    pub fn read(&self, gene: &Gene, constants: &[f64]) -> Operand {
        match self.kind(gene.source) {
            Kind::Registers => Operand::Register(gene.location % self.registers),
            Kind::Constants => Operand::Constant(constants[usize::from(gene.location % self.constants)]),
            Kind::Data(place, length) => Operand::Input(place + gene.location % length),
            Kind::Literal => Operand::Constant(gene.literal),
        }
    }
}
