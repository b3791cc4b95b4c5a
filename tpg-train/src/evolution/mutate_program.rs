//! Random programs and their mutations, with GEGELATI's choices (`mutator/programMutator.cpp`, `mutator/lineMutator.cpp`).

use super::genome::{GenomeLine, Program};
use super::stage::Context;
use super::vocabulary::{Gene, OPERANDS, SourceKind};
use tpg_engine::random::Stream;

/// GEGELATI's probabilities of deleting and of inserting a line; it always alters one.
const P_DELETE: f64 = 0.5;
const P_ADD: f64 = 0.5;
/// GEGELATI's probability of mutating the program of an edge; rounds repeat until at least one program is mutated.
pub(super) const P_PROGRAM_MUTATION: f64 = 0.2;
/// Probability that altering a literal operand changes its number.
const LITERAL_CHANGE: f64 = 0.667;
/// Standard deviation of the factor's distance from 1 when a number is scaled.
const LITERAL_SCALING: f64 = 0.3;

impl Context<'_> {
    /// Creates a random program (`ProgramMutator::initRandomProgram`) of 1 to `maxProgramSize` lines.
    pub(super) fn random(&self, stream: &mut Stream) -> Program {
        if let Some(lines) = self.random_sum(stream) {
            return Program { lines };
        }
        let mut program = Program { lines: Vec::new() };
        let lines = 1 + stream.below(self.max_lines);
        while program.lines.len() < lines {
            self.insert_line(&mut program, stream);
        }
        program
    }

    /// Changes every literal that a program reads, each by a factor near 1; returns true if there is one.
    pub(super) fn refine(&self, program: &mut Program, deviation: f64, stream: &mut Stream) -> bool {
        let effective = program.effective(self.vocabulary);
        let lines = program.lines.iter_mut().zip(effective).filter(|(_, effective)| *effective);
        let mut any = false;
        for literal in lines.flat_map(|(line, _)| line.literals(self.vocabulary)) {
            *literal = self.vocabulary.moved(*literal, *literal * (1.0 + deviation * stream.normal()));
            any = true;
        }
        any
    }

    /// Performs one round of mutation (`ProgramMutator::mutateProgram`).
    pub(super) fn mutate(&self, program: &mut Program, stream: &mut Stream) {
        if program.lines.len() > 1 && stream.chance(P_DELETE) {
            let place = stream.below(program.lines.len());
            program.lines.remove(place);
        }
        let grows = program.lines.len() < self.max_lines && stream.chance(P_ADD);
        if grows && !self.insert_term(program, stream) {
            self.insert_line(program, stream);
        }
        let place = stream.below(program.lines.len());
        self.alter_line(&mut program.lines[place], stream);
        if stream.chance(self.config.program.p_swap) {
            swap_lines(program, stream);
        }
    }

    fn insert_line(&self, program: &mut Program, stream: &mut Stream) {
        let place = stream.below(program.lines.len() + 1);
        let line = self.random_line(stream);
        program.lines.insert(place, line);
    }

    /// Draws a line with every choice uniform (`LineMutator::initRandomCorrectLine`).
    fn random_line(&self, stream: &mut Stream) -> GenomeLine {
        GenomeLine {
            to: stream.below(self.vocabulary.registers.into()) as u16,
            instruction: stream.below(self.vocabulary.instructions.len()) as u8,
            operands: [(); OPERANDS].map(|()| Gene {
                source: stream.below(self.vocabulary.sources()) as u8,
                location: stream.below(self.vocabulary.largest_address_space.into()) as u16,
                literal: self.random_literal(stream),
            }),
        }
    }

    /// Alters one field of a line (`LineMutator::alterCorrectLine`), chosen in proportion to its bits in GEGELATI's
    /// encoding.
    fn alter_line(&self, line: &mut GenomeLine, stream: &mut Stream) {
        let vocabulary = self.vocabulary;
        let bits = |values: usize| values.next_power_of_two().trailing_zeros() as usize;
        let instruction = bits(vocabulary.instructions.len());
        let destination = bits(vocabulary.registers.into());
        let source = bits(vocabulary.sources());
        let operand = source + bits(vocabulary.largest_address_space.into());
        let selected = stream.below((instruction + destination + OPERANDS * operand).max(1));
        if selected < instruction {
            line.instruction = other(line.instruction.into(), vocabulary.instructions.len(), stream) as u8;
        } else if selected < instruction + destination {
            line.to = other(line.to.into(), vocabulary.registers.into(), stream) as u16;
        } else {
            let selected = selected - instruction - destination;
            // Without operand bits (one source with one location) there is nothing to alter.
            let Some(place) = selected.checked_div(operand) else { return };
            let gene = &mut line.operands[place];
            if vocabulary.kind(gene.source) == SourceKind::Literal && stream.chance(LITERAL_CHANGE) {
                gene.literal = self.changed_literal(gene.literal, stream);
            } else if selected % operand < source {
                gene.source = other(gene.source.into(), vocabulary.sources(), stream) as u8;
            } else {
                gene.location = other(gene.location.into(), vocabulary.largest_address_space.into(), stream) as u16;
            }
        }
    }

    /// Draws a literal in the unit of an input. It is normally distributed with one of a few widths, because bids are
    /// sums of large and small numbers.
    fn random_literal(&self, stream: &mut Stream) -> f64 {
        let width = *stream.pick(&self.config.literals.deviations);
        let scales = &self.vocabulary.scales;
        let unit = if scales.is_empty() { 1.0 } else { *stream.pick(scales) };
        self.vocabulary.scalar.round(unit * width * stream.normal())
    }

    /// Changes a literal: scaled slightly (half of the time), negated, or redrawn.
    fn changed_literal(&self, literal: f64, stream: &mut Stream) -> f64 {
        let changed = match stream.below(4) {
            0 | 1 => literal * (1.0 + LITERAL_SCALING * stream.normal()),
            2 => -literal,
            _ => return self.random_literal(stream),
        };
        self.vocabulary.moved(literal, changed)
    }
}

/// Swaps two different lines (`ProgramMutator::swapRandomLines`).
fn swap_lines(program: &mut Program, stream: &mut Stream) {
    if program.lines.len() >= 2 {
        let first = stream.below(program.lines.len());
        let second = other(first, program.lines.len(), stream);
        program.lines.swap(first, second);
    }
}

/// Draws a number below `bound` other than `current`; `current` if there is none.
fn other(current: usize, bound: usize, stream: &mut Stream) -> usize {
    if bound < 2 {
        return current;
    }
    let drawn = stream.below(bound - 1);
    drawn + usize::from(drawn >= current)
}
