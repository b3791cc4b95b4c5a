//! The vocabulary of programs: instructions, registers and sources, numbered as in GEGELATI.

use serde::{Deserialize, Serialize};
use tpg_engine::{Limits, Operand};
use tpg_graph::Word;
use tpg_graph::{ScalarType, SourceDocument};

/// Number of operands of a line, GEGELATI's `maxNbOperands`; no instruction has more.
pub(super) const OPERANDS: usize = 2;

/// Index of an instruction in its set, as stored in a line.
pub(super) type InstructionIndex = u8;

/// An operand of a genome's line: GEGELATI's pair of data source and location (`program/line.h`), and a literal number
/// if literals are allowed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Gene {
    /// Number of the source, see [`Vocabulary::kind`].
    pub source: u8,
    /// Location in the source, modulo its length.
    pub location: u16,
    /// The number read if the source is [`Kind::Literal`]; otherwise kept but unused.
    pub literal: f64,
}

impl Gene {
    /// Returns the operand that is a register.
    pub fn register(location: u16) -> Self {
        Self { source: 0, location, literal: 0.0 }
    }
}

/// Meaning of a source number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The registers: always source 0.
    Registers,
    /// A data source of the environment: its first index in the flat state, and its length.
    Data(u16, u16),
    /// The operand's own number, if literals are allowed: the last source.
    Literal,
}

/// The vocabulary of programs.
#[derive(Clone, Debug, PartialEq)]
pub struct Vocabulary {
    instructions: Vec<Word>,
    registers: u16,
    kinds: Vec<Kind>,
    /// Exclusive upper bound of locations (GEGELATI, `environment.cpp`, `computeLargestAddressSpace`).
    largest_address_space: u16,
    scalar: ScalarType,
    /// Units of literals: half the range of each value of the flat state; empty without literals.
    scales: Vec<f64>,
    /// Upper bounds of the bids for the first actions: first index and count, after all values that programs can read.
    bounds: Option<(u16, u16)>,
    /// The outputs, where there are some in place of actions.
    outputs: Vec<Limits>,
}

impl Vocabulary {
    /// Creates a vocabulary; `literals` are the units of literals, if operands can be literal numbers.
    ///
    /// # Panics
    /// If there are no registers, no instructions or more than 256: configurations are checked earlier.
    pub fn new(
        instructions: Vec<Word>,
        registers: u16,
        sources: &[SourceDocument],
        literals: Option<Vec<f64>>,
        scalar: ScalarType,
    ) -> Self {
        assert!(registers > 0 && (1..=256).contains(&instructions.len()));
        let mut kinds = vec![Kind::Registers];
        let mut place = 0;
        for source in sources {
            kinds.push(Kind::Data(place, source.length as u16));
            place += source.length as u16;
        }
        if literals.is_some() {
            kinds.push(Kind::Literal);
        }
        let longest = sources.iter().map(|source| source.length as u16).max().unwrap_or(1);
        let largest_address_space = registers.max(longest);
        Self {
            instructions,
            registers,
            kinds,
            largest_address_space,
            scalar,
            scales: literals.unwrap_or_default(),
            bounds: None,
            outputs: Vec::new(),
        }
    }

    /// Adds the outputs of the problem, which leaves compute.
    #[must_use]
    pub fn with_outputs(self, outputs: Vec<Limits>) -> Self {
        Self { outputs, ..self }
    }

    /// Returns the outputs; empty if a policy chooses among actions.
    pub fn outputs(&self) -> &[Limits] {
        &self.outputs
    }

    /// Appends a source that bounds bids from above, one value for each of the first actions; operands cannot refer to
    /// it.
    #[must_use]
    pub fn with_bounds(self, source: &SourceDocument) -> Self {
        let readable = self.kinds.iter().filter_map(|kind| match *kind {
            Kind::Data(place, length) => Some(place + length),
            Kind::Registers | Kind::Literal => None,
        });
        let place = readable.max().unwrap_or(0);
        Self { bounds: Some((place, source.length as u16)), ..self }
    }

    /// Returns the index of an action's bound in the flat state, if it has one.
    pub fn bound(&self, action: u16) -> Option<u16> {
        self.bounds.filter(|&(_, length)| action < length).map(|(place, _)| place + action)
    }

    /// Returns the units of literals; empty if there are none.
    pub fn scales(&self) -> &[f64] {
        &self.scales
    }

    /// Returns the instruction set.
    pub fn instructions(&self) -> &[Word] {
        &self.instructions
    }

    /// Returns the instruction at an index of the set.
    pub fn instruction(&self, index: InstructionIndex) -> Word {
        self.instructions[usize::from(index)]
    }

    /// Returns the index of an instruction in the set, if it is in it.
    pub fn index(&self, word: Word) -> Option<InstructionIndex> {
        self.instructions.iter().position(|known| *known == word).map(|place| place as InstructionIndex)
    }

    /// Returns the operand that is a literal number; only where literals are allowed.
    pub fn literal(&self, literal: f64) -> Gene {
        Gene { source: (self.sources() - 1) as u8, location: 0, literal }
    }

    /// Returns the number of registers of a program.
    pub fn registers(&self) -> u16 {
        self.registers
    }

    /// Returns the number of sources that an operand can refer to.
    pub fn sources(&self) -> usize {
        self.kinds.len()
    }

    /// Returns the meaning of a source number.
    pub fn kind(&self, source: u8) -> Kind {
        self.kinds[usize::from(source)]
    }

    /// Returns the inputs that programs can read: an operand for each, its place in the flat state, and its unit.
    pub fn inputs(&self) -> Vec<(Gene, u16, f64)> {
        let of_source = |(source, kind): (u8, &Kind)| match *kind {
            Kind::Data(place, length) => (0..length).map(|at| (source, at, place + at)).collect(),
            Kind::Registers | Kind::Literal => Vec::new(),
        };
        let places = (0..).zip(&self.kinds).flat_map(of_source);
        let unit = |place: u16| self.scales.get(usize::from(place)).copied().unwrap_or(1.0);
        let input = |(source, location, place)| (Gene { source, location, literal: 0.0 }, place, unit(place));
        places.map(input).collect()
    }

    /// Returns the exclusive upper bound of locations.
    pub fn largest_address_space(&self) -> u16 {
        self.largest_address_space
    }

    /// Returns the scalar type that programs compute in.
    pub fn scalar(&self) -> ScalarType {
        self.scalar
    }

    /// Returns the register that an operand refers to, if it is one.
    pub fn register(&self, gene: &Gene) -> Option<u16> {
        (self.kind(gene.source) == Kind::Registers).then(|| gene.location % self.registers)
    }

    /// Resolves an operand.
    pub fn read(&self, gene: &Gene) -> Operand {
        match self.kind(gene.source) {
            Kind::Registers => Operand::Register(gene.location % self.registers),
            Kind::Data(place, length) => Operand::Input(place + gene.location % length),
            Kind::Literal => Operand::Constant(gene.literal),
        }
    }
}
