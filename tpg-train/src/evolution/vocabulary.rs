//! The vocabulary of programs: instructions, registers and sources, numbered as in GEGELATI.

use serde::{Deserialize, Serialize};
use tpg_engine::random::Stream;
use tpg_engine::{Limits, Line, Operand};
use tpg_graph::import::{Expression, Reading};
use tpg_graph::{ScalarType, SourceDocument, Word};

/// Number of operands of a line, GEGELATI's `maxNbOperands`; no instruction has more.
pub(super) const OPERANDS: usize = 2;

/// Index of an instruction in its set, as stored in a line.
pub(super) type InstructionIndex = u8;

/// An instruction of programs.
#[derive(Clone, Debug, PartialEq)]
pub enum ProgramInstruction {
    /// A word.
    Word(Word),
    /// A call that is composed of words.
    Call(Expression),
}

impl From<Word> for ProgramInstruction {
    fn from(word: Word) -> Self {
        Self::Word(word)
    }
}

impl ProgramInstruction {
    /// Reads a word's name, or a call of words on `a` and `b`; the error says what was found.
    pub fn parse(text: &str) -> Result<Self, String> {
        if let Some(word) = Word::from_name(text) {
            return Ok(Self::Word(word));
        }
        let call = Expression::call(text)?;
        if call.arity() > OPERANDS || call.constants() > 0 {
            return Err(format!("{text:?}, which reads more than a and b"));
        }
        Ok(Self::Call(call))
    }

    /// Returns the number of operands that it reads.
    pub fn arity(&self) -> usize {
        match self {
            Self::Word(word) => word.arity(),
            Self::Call(call) => call.arity(),
        }
    }

    /// Returns true if it also reads the register that it writes.
    pub fn reads_destination(&self) -> bool {
        matches!(self, Self::Word(word) if word.reads_destination())
    }

    /// Adds the words that it is made of, in order.
    pub fn words(&self, words: &mut Vec<Word>) {
        let mut add = |word: Word| {
            if !words.contains(&word) {
                words.push(word);
            }
        };
        match self {
            Self::Word(word) => add(*word),
            Self::Call(call) => call.spell(0, 0, &mut |_, word, _| add(word)),
        }
    }

    fn scratch(&self) -> u16 {
        match self {
            Self::Word(_) => 0,
            Self::Call(call) => call.scratch() as u16,
        }
    }
}

/// An operand of a genome's line: GEGELATI's pair of data source and location (`program/line.h`), and a literal number
/// if literals are allowed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Gene {
    /// Number of the source, see [`Vocabulary::kind`].
    pub source: u8,
    /// Location in the source, modulo its length.
    pub location: u16,
    /// The number read if the source is [`SourceKind::Literal`]; otherwise kept but unused.
    pub literal: f64,
}

impl Gene {
    /// Returns the operand that is a register.
    pub fn register(location: u16) -> Self {
        Self { source: 0, location, literal: 0.0 }
    }
}

/// An input: its operand, its place in the flat state, and its unit.
pub(super) type Input = (Gene, u16, f64);

/// Meaning of a source number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SourceKind {
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
    /// The instruction set.
    pub instructions: Vec<ProgramInstruction>,
    /// Number of registers that programs name.
    pub registers: u16,
    /// The meaning of each source number.
    pub kinds: Vec<SourceKind>,
    /// Exclusive upper bound of locations (GEGELATI, `environment.cpp`, `computeLargestAddressSpace`).
    pub largest_address_space: u16,
    /// The scalar type that programs compute in.
    pub scalar: ScalarType,
    /// Units of literals: half the range of each value of the flat state; empty without literals.
    pub scales: Vec<f64>,
    /// The middles of their declared ranges; 0 of a range without an end.
    pub middles: Vec<f64>,
    /// The outputs of the problem, which leaves compute; empty if a policy chooses among actions.
    pub outputs: Vec<Limits>,
}

impl Vocabulary {
    /// Creates a vocabulary; `literals` are the units of literals, if operands can be literal numbers.
    ///
    /// # Panics
    /// If there are no registers, no instructions or more than 256: configurations are checked earlier.
    pub fn new(
        instructions: Vec<impl Into<ProgramInstruction>>,
        registers: u16,
        sources: &[SourceDocument],
        literals: Option<Vec<f64>>,
        scalar: ScalarType,
    ) -> Self {
        let instructions: Vec<ProgramInstruction> = instructions.into_iter().map(Into::into).collect();
        assert!(registers > 0 && (1..=256).contains(&instructions.len()));
        let mut kinds = vec![SourceKind::Registers];
        let mut place = 0;
        for source in sources {
            kinds.push(SourceKind::Data(place, source.length as u16));
            place += source.length as u16;
        }
        if literals.is_some() {
            kinds.push(SourceKind::Literal);
        }
        let longest = sources.iter().map(|source| source.length as u16).max().unwrap_or(1);
        let largest_address_space = registers.max(longest);
        let middle = |[min, max]: [f64; 2]| Some(0.5 * (min + max)).filter(|middle| middle.is_finite()).unwrap_or(0.0);
        let middles = sources.iter().flat_map(|source| source.ranges.iter().copied().map(middle)).collect();
        Self {
            instructions,
            registers,
            kinds,
            largest_address_space,
            scalar,
            scales: literals.unwrap_or_default(),
            middles,
            outputs: Vec::new(),
        }
    }

    /// Returns the instruction at an index of the set.
    pub fn instruction(&self, index: InstructionIndex) -> &ProgramInstruction {
        &self.instructions[usize::from(index)]
    }

    /// Returns the index of an instruction in the set, if it is in it.
    pub fn index(&self, word: Word) -> Option<InstructionIndex> {
        self.instructions
            .iter()
            .position(|known| *known == ProgramInstruction::Word(word))
            .map(|place| place as InstructionIndex)
    }

    /// Returns the numbers of two sources of as many values each, more than one: two things of a kind. Draws none if there are none.
    pub fn pair(&self, stream: &mut Stream) -> Option<[u8; 2]> {
        let sources = || (0..).zip(&self.kinds);
        let pairs = sources().flat_map(|one| sources().map(move |other| [one, other])).filter_map(|pair| match pair {
            [(one, SourceKind::Data(_, length)), (other, SourceKind::Data(_, same))] => {
                (one < other && length == same && *length > 1).then_some([one, other])
            }
            _ => None,
        });
        let pairs: Vec<[u8; 2]> = pairs.collect();
        (!pairs.is_empty()).then(|| *stream.pick(&pairs))
    }

    /// Returns the operand that is a literal number; only where literals are allowed.
    pub fn literal(&self, literal: f64) -> Gene {
        Gene { source: (self.sources() - 1) as u8, location: 0, literal }
    }

    /// Returns a literal's new value, rounded to the scalar type; the old one where the new one is not finite.
    pub fn moved(&self, literal: f64, to: f64) -> f64 {
        let rounded = self.scalar.round(to);
        if rounded.is_finite() { rounded } else { literal }
    }

    /// Returns the number of registers of a policy: calls need some for what they compute on the way.
    pub fn policy_registers(&self) -> u16 {
        self.registers + self.instructions.iter().map(ProgramInstruction::scratch).max().unwrap_or(0)
    }

    /// Appends the lines of a policy that an instruction with its operands is.
    pub fn spell(&self, index: InstructionIndex, to: u16, genes: &[Gene; OPERANDS], lines: &mut Vec<Line>) {
        let call = match self.instruction(index) {
            &ProgramInstruction::Word(instruction) => {
                lines.push(Line { to, instruction, operands: genes.map(|gene| self.read(&gene)) });
                return;
            }
            ProgramInstruction::Call(call) => call,
        };
        let operand = |read: &Reading| match *read {
            Reading::Operand(place, _) => self.read(&genes[place]),
            Reading::Number(value) => Operand::Constant(self.scalar.round(value)),
            Reading::Register(register) => Operand::Register(register as u16),
            Reading::Constant(_) => unreachable!("a call without constants of the line"),
        };
        call.spell(to.into(), self.registers.into(), &mut |to, instruction, reads| {
            let mut operands = [Operand::Register(0); OPERANDS];
            operands.iter_mut().zip(reads).for_each(|(slot, read)| *slot = operand(read));
            lines.push(Line { to: to as u16, instruction, operands });
        });
    }

    /// Returns the number of sources that an operand can refer to.
    pub fn sources(&self) -> usize {
        self.kinds.len()
    }

    /// Returns the meaning of a source number.
    pub fn kind(&self, source: u8) -> SourceKind {
        self.kinds[usize::from(source)]
    }

    /// Returns the inputs that programs can read: an operand for each, its place in the flat state, and its unit.
    pub fn inputs(&self) -> Vec<Input> {
        let of_source = |(source, kind): (u8, &SourceKind)| match *kind {
            SourceKind::Data(place, length) => (0..length).map(|at| (source, at, place + at)).collect(),
            SourceKind::Registers | SourceKind::Literal => Vec::new(),
        };
        let places = (0..).zip(&self.kinds).flat_map(of_source);
        let unit = |place: u16| self.scales.get(usize::from(place)).copied().unwrap_or(1.0);
        let input = |(source, location, place)| (Gene { source, location, literal: 0.0 }, place, unit(place));
        places.map(input).collect()
    }

    /// Returns the register that an operand refers to, if it is one.
    pub fn register(&self, gene: &Gene) -> Option<u16> {
        (self.kind(gene.source) == SourceKind::Registers).then(|| gene.location % self.registers)
    }

    /// Resolves an operand.
    pub fn read(&self, gene: &Gene) -> Operand {
        match self.kind(gene.source) {
            SourceKind::Registers => Operand::Register(gene.location % self.registers),
            SourceKind::Data(place, length) => Operand::Input(place + gene.location % length),
            SourceKind::Literal => Operand::Constant(gene.literal),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Gene, ProgramInstruction, Vocabulary};
    use tpg_engine::{Line, Operand};
    use tpg_graph::{ScalarType, SourceDocument, Word};

    #[test]
    fn a_call_is_spelled_in_registers_that_programs_do_not_name() {
        let instructions =
            ["copy(0.1)", "div(a, add(1, abs(b)))", "abs"].map(|text| ProgramInstruction::parse(text).expect(text));
        let source = SourceDocument::new("x", "", vec![[-1.0, 1.0]]);
        let vocabulary = Vocabulary::new(instructions.to_vec(), 3, &[source], None, ScalarType::F32);
        assert_eq!((vocabulary.registers, vocabulary.policy_registers()), (3, 5));
        let (x, r) = (Gene { source: 1, location: 0, literal: 0.0 }, Gene::register);
        let spelled = |index: u8| {
            let mut lines = Vec::new();
            vocabulary.spell(index, 1, &[x, r(2)], &mut lines);
            lines
        };
        let line =
            |to, word: &str, a, b| Line { to, instruction: Word::from_name(word).expect(word), operands: [a, b] };
        let (zero, tenth) = (Operand::Register(0), Operand::Constant(f64::from(0.1_f32)));
        assert_eq!(spelled(0), [line(1, "copy", tenth, zero)]);
        assert_eq!(
            spelled(1),
            [
                line(4, "abs", Operand::Register(2), zero),
                line(3, "add", Operand::Constant(1.0), Operand::Register(4)),
                line(1, "div", Operand::Input(0), Operand::Register(3)),
            ]
        );
        assert_eq!(spelled(2), [line(1, "abs", Operand::Input(0), Operand::Register(2))]);
        for (text, found) in [
            ("pi", "neither an operand nor"),
            ("a", "which computes nothing"),
            ("mul(a, c)", "more than a and b"),
            ("mul(a, k0)", "more than"),
        ] {
            assert!(ProgramInstruction::parse(text).expect_err(text).contains(found), "{text}");
        }
    }
}
