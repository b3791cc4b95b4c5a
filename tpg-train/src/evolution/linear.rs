//! Writes policies with a linear program for each output or action: a weighted sum of the inputs, or the product of two.
//!
//! A product can change its sign where another input does, as a swing-up must.

use super::genome::{Destination, Edge, Genome, GenomeLine, Program, TeamId};
use super::vocabulary::{Gene, Input, InstructionIndex, OPERANDS, Vocabulary};
use serde::{Deserialize, Serialize};
use tpg_engine::PolicyGraph;
use tpg_engine::random::Stream;
use tpg_graph::Word;
use tpg_graph::error::Finding;
use tpg_runtime::ops::Instruction;

/// Maximum number of weights of a search: beyond, it would need more steps than a run has.
const MAX_WEIGHTS: usize = 400;
/// Maximum number of lines of a program.
const MAX_LINES: usize = 1000;

/// Standard deviation of a proportional formula's weight.
const GAIN: f64 = 4.0;

/// The form of a linear program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum ProgramKind {
    /// A weighted sum of the inputs.
    Sum,
    /// The product of two weighted sums.
    Product,
}

/// Writes linear programs in the words of a vocabulary.
#[derive(Clone, Debug)]
pub(super) struct LinearWriter<'a> {
    vocabulary: &'a Vocabulary,
    inputs: Vec<Input>,
    add: InstructionIndex,
    multiply: Multiply,
    /// The word that multiplies two sums; none if a program is a single sum.
    product: Option<InstructionIndex>,
    /// Number of actions; 0 with outputs.
    actions: u16,
}

/// Words for a term of a sum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Multiply {
    /// One line: the sum grows by a product.
    Add(InstructionIndex),
    /// A line for the product, another one to add it.
    Alone(InstructionIndex),
}

impl<'a> LinearWriter<'a> {
    /// Creates a writer; `actions` is 0 where there are outputs.
    ///
    /// # Errors
    /// If the vocabulary cannot express such programs.
    pub(super) fn new(vocabulary: &'a Vocabulary, actions: u16, kind: ProgramKind) -> Result<Self, Finding> {
        let missing = |key: &str, accepted: &str| Finding::new(key, "too little for linear programs", accepted);
        let multiply = (vocabulary.index(Word::MultiplyAdd).map(Multiply::Add))
            .or_else(|| vocabulary.index(Instruction::Mul.into()).map(Multiply::Alone));
        let (Some(add), Some(multiply)) = (vocabulary.index(Instruction::Add.into()), multiply) else {
            return Err(missing("language.instructions", "add, and multiply_add or mul"));
        };
        let product = match kind {
            ProgramKind::Sum => None,
            ProgramKind::Product => match vocabulary.index(Instruction::Mul.into()) {
                None => return Err(missing("language.instructions", "add and mul, for products")),
                product => product,
            },
        };
        if vocabulary.scales.is_empty() {
            return Err(missing("language.literals", "true"));
        }
        let needed = 2 + u16::from(product.is_some());
        if vocabulary.registers < needed {
            return Err(missing("learning.nb_registers", &format!("at least {needed}")));
        }
        Ok(Self { vocabulary, inputs: vocabulary.inputs(), add, multiply, product, actions })
    }

    /// True if a search can find the weights.
    pub(super) fn is_small(&self) -> bool {
        self.weights() <= MAX_WEIGHTS && self.lines() <= MAX_LINES
    }

    /// Returns the number of programs that are searched for: the first action's bid stays 0.
    fn programs(&self) -> usize {
        match self.actions {
            0 => self.vocabulary.outputs.len(),
            actions => usize::from(actions) - 1,
        }
    }

    /// Returns the number of sums in a program.
    fn sums(&self) -> usize {
        1 + usize::from(self.product.is_some())
    }

    /// Returns the number of weights: for each sum of each program those of the inputs, and a constant.
    pub(super) fn weights(&self) -> usize {
        self.programs() * self.sums() * (self.inputs.len() + 1)
    }

    /// Returns the number of lines of a program.
    pub(super) fn lines(&self) -> usize {
        let sum = match self.multiply {
            Multiply::Add(_) => self.inputs.len() + 1,
            Multiply::Alone(_) => 2 * self.inputs.len(),
        };
        self.sums() * (sum + 1) - 1
    }

    /// Returns the number of rows of weights with a row for the first action, too.
    pub(super) fn rows(&self) -> usize {
        if self.actions == 0 { self.programs() } else { self.actions.into() }
    }

    /// Returns the units of the inputs.
    pub(super) fn units(&self) -> Vec<f64> {
        self.inputs.iter().map(|(.., unit)| *unit).collect()
    }

    /// Returns the places of the inputs in the flat state.
    pub(super) fn places(&self) -> impl Iterator<Item = usize> + Clone {
        self.inputs.iter().map(|(_, place, _)| usize::from(*place))
    }

    /// Returns the weights that rows of sums stand for. The greatest bid wins, so what counts is the distance from the first
    /// action's, which stays 0.
    pub(super) fn weights_of_rows(&self, rows: &[Vec<f64>]) -> Vec<f64> {
        match self.actions {
            0 => rows.concat(),
            _ => rows[1..]
                .iter()
                .flat_map(|row| row.iter().zip(&rows[0]).map(|(weight, first)| weight - first))
                .collect(),
        }
    }

    /// Returns the policy with the given weights.
    pub(super) fn policy(&self, weights: &[f64]) -> PolicyGraph {
        let mut genome = Genome::default();
        let team = self.add_root(&mut genome, weights);
        genome.policy(team, self.vocabulary)
    }

    /// Adds the policy with the given weights to a genome. A weight of 1 is a whole output's half range for an input's.
    pub(super) fn add_root(&self, genome: &mut Genome, weights: &[f64]) -> TeamId {
        let outputs = &self.vocabulary.outputs;
        let of_program = self.sums() * (self.inputs.len() + 1);
        let programs = weights.chunks_exact(of_program).enumerate().map(|(place, weights)| {
            let unit = outputs.get(place).map_or(1.0, |output| 0.5 * (output.max - output.min));
            self.program(weights, unit)
        });
        let edges = if self.actions == 0 {
            let programs = programs.map(|program| genome.add_program(program)).collect();
            let leaf = Destination::Leaf(genome.add_leaf(programs));
            vec![Edge { program: genome.add_program(self.zero()), to: leaf }]
        } else {
            let bids = std::iter::once(self.zero()).chain(programs);
            let edge =
                |(action, program)| Edge { program: genome.add_program(program), to: Destination::Action(action) };
            (0..self.actions).zip(bids).map(edge).collect()
        };
        genome.add_team(edges)
    }

    /// Draws weights with which each output is proportional to the distance of one input from the middle of its range.
    pub(super) fn proportional(&self, stream: &mut Stream) -> Vec<f64> {
        let sources: Vec<&[Input]> = self.inputs.chunk_by(|a, b| a.0.source == b.0.source).collect();
        let row = |_| {
            let source = *stream.pick(&sources);
            let (gene, place, unit) = *stream.pick(source);
            let weight = GAIN * stream.normal();
            let weights = self.inputs.iter().map(|input| if input.0 == gene { weight } else { 0.0 });
            let constant = -weight * self.vocabulary.middles[usize::from(place)] / unit;
            weights.chain([constant]).collect::<Vec<f64>>()
        };
        (0..self.programs()).flat_map(row).collect()
    }

    /// Adds a policy that bids a sum of the inputs for each action, with the given weights of the flat state's values and a constant.
    pub(super) fn add_linear(&self, genome: &mut Genome, rows: &[Vec<f64>]) -> TeamId {
        let program = |row: &Vec<f64>| {
            let weights = self.inputs.iter().map(|(_, place, unit)| row[usize::from(*place)] * unit);
            self.program(&weights.chain(row.last().copied()).collect::<Vec<_>>(), 1.0)
        };
        let edge = |(action, row)| Edge { program: genome.add_program(program(row)), to: Destination::Action(action) };
        let edges = (0..).zip(rows).map(edge).collect();
        genome.add_team(edges)
    }

    /// Returns the program with the given weights, `unit` times its sum or product.
    fn program(&self, weights: &[f64], unit: f64) -> Program {
        let mut lines = Vec::new();
        for ((to, weights), unit) in (0..).zip(weights.chunks_exact(self.inputs.len() + 1)).zip([unit, 1.0]) {
            self.write_sum(&mut lines, to, weights, unit);
        }
        if let Some(instruction) = self.product {
            lines.push(GenomeLine { instruction, to: 0, operands: [Gene::register(0), Gene::register(1)] });
        }
        Program { lines }
    }

    /// Writes the lines of a sum, whose result is in register `to`. An input of weight 0 has none.
    fn write_sum(&self, lines: &mut Vec<GenomeLine>, to: u16, weights: &[f64], unit: f64) {
        let literal = |value: f64| self.vocabulary.literal(self.vocabulary.moved(0.0, value));
        let (spare, sum, first) = (self.sums() as u16, Gene::register(to), lines.len());
        for ((gene, _, of_input), weight) in self.inputs.iter().zip(weights).filter(|(_, weight)| **weight != 0.0) {
            let operands = [*gene, literal(unit * weight / of_input)];
            match self.multiply {
                Multiply::Alone(instruction) if lines.len() > first => {
                    lines.push(GenomeLine { instruction, to: spare, operands });
                    lines.push(GenomeLine { instruction: self.add, to, operands: [sum, Gene::register(spare)] });
                }
                Multiply::Add(instruction) | Multiply::Alone(instruction) => {
                    lines.push(GenomeLine { instruction, to, operands });
                }
            }
        }
        let constant = literal(unit * weights[self.inputs.len()]);
        lines.push(GenomeLine { instruction: self.add, to, operands: [sum, constant] });
    }

    /// Returns a program whose result is 0.
    fn zero(&self) -> Program {
        let operands = [self.vocabulary.literal(0.0); OPERANDS];
        Program { lines: vec![GenomeLine { instruction: self.add, to: 0, operands }] }
    }
}

#[cfg(test)]
mod tests {
    use super::{LinearWriter, ProgramKind};
    use crate::evolution::genome::{Destination, Genome};
    use crate::evolution::vocabulary::Vocabulary;
    use tpg_engine::Limits;
    use tpg_engine::random::{Purpose, Stream};
    use tpg_graph::{ScalarType, SourceDocument, Word};
    use tpg_runtime::ops::Instruction;

    fn vocabulary(words: &[Word], outputs: usize) -> Vocabulary {
        let source = SourceDocument::new("s", "1", vec![[-1.0, 1.0]; 2]);
        let limits = Limits { min: -2.0, max: 2.0, nan: 0.0 };
        let scales = Some(vec![1.0, 4.0]);
        let bare = Vocabulary::new(words.to_vec(), 4, &[source], scales, ScalarType::F64);
        Vocabulary { outputs: vec![limits; outputs], ..bare }
    }

    /// Returns the values of a root's programs in a state: its bids, or its outputs.
    fn values(kind: ProgramKind, words: &[Word], outputs: usize, actions: u16, weights: &[f64]) -> Vec<f64> {
        let vocabulary = vocabulary(words, outputs);
        let writer = LinearWriter::new(&vocabulary, actions, kind).expect("sums can be written");
        assert_eq!(writer.weights(), weights.len());
        let mut genome = Genome::default();
        let root = writer.add_root(&mut genome, weights);
        let edges = genome.team(root);
        let programs: Vec<_> = match edges[0].to {
            Destination::Leaf(leaf) => genome.leaves()[&leaf].clone(),
            _ => {
                assert!((0..).zip(edges).all(|(action, edge)| edge.to == Destination::Action(action)));
                edges.iter().map(|edge| edge.program).collect()
            }
        };
        let state = [0.5, 8.0];
        let programs = programs.into_iter().map(|id| genome.program(id));
        programs
            .map(|program| {
                assert!(program.lines.len() <= writer.lines());
                program.bid(&vocabulary, &state)
            })
            .collect()
    }

    #[test]
    fn a_weight_is_an_outputs_half_range_for_an_inputs() {
        let [add, mul] = [Instruction::Add, Instruction::Mul].map(Word::from);
        for words in [&[add, mul][..], &[add, Word::MultiplyAdd]] {
            // Inputs 0.5 of 1 and 8 of 4, outputs of ±2: 2 (3 · 0.5 + 1 · 2 − 1) = 5, and 2 · 2 = 4.
            let weights = [3.0, 1.0, -1.0, 0.0, 1.0, 0.0];
            assert_eq!(values(ProgramKind::Sum, words, 2, 0, &weights), [5.0, 4.0]);
            assert_eq!(values(ProgramKind::Sum, words, 0, 3, &weights), [0.0, 2.5, 2.0], "the first bid stays 0");
        }
    }

    #[test]
    fn a_proportional_formula_is_0_in_the_middle_of_its_input() {
        let source = SourceDocument::new("s", "1", vec![[0.0, 2.0], [-3.0, 5.0]]);
        let limits = Limits { min: -2.0, max: 2.0, nan: 0.0 };
        let words = vec![Word::MultiplyAdd, Instruction::Add.into()];
        let bare = Vocabulary::new(words, 4, &[source], Some(vec![1.0, 4.0]), ScalarType::F64);
        let vocabulary = Vocabulary { outputs: vec![limits; 3], ..bare };
        let writer = LinearWriter::new(&vocabulary, 0, ProgramKind::Sum).expect("sums can be written");
        for index in 0..10 {
            let weights = writer.proportional(&mut Stream::new(1, 0, Purpose::Test, index));
            for row in weights.chunks_exact(3) {
                let read = row[..2].iter().filter(|weight| **weight != 0.0).count();
                let middle = row[0] * 1.0 + row[1] * 1.0 / 4.0 + row[2];
                assert!(read == 1 && middle.abs() < 1e-9, "{row:?}");
            }
        }
    }

    #[test]
    fn a_product_multiplies_two_sums() {
        let [add, mul] = [Instruction::Add, Instruction::Mul].map(Word::from);
        for words in [&[add, mul][..], &[add, mul, Word::MultiplyAdd]] {
            // Outputs of ±2, and a bid without a unit: (3 · 0.5 + 1 · 2 − 1) (0 · 0.5 + 1 · 2 + 1).
            let weights = [3.0, 1.0, -1.0, 0.0, 1.0, 1.0];
            assert_eq!(values(ProgramKind::Product, words, 1, 0, &weights), [15.0]);
            assert_eq!(values(ProgramKind::Product, words, 0, 2, &weights), [0.0, 7.5]);
        }
    }

    #[test]
    fn a_given_policy_bids_its_sums_without_lines_for_weights_of_0() {
        let [add, mul] = [Instruction::Add, Instruction::Mul].map(Word::from);
        for words in [&[add, mul][..], &[add, Word::MultiplyAdd]] {
            let vocabulary = vocabulary(words, 0);
            let writer = LinearWriter::new(&vocabulary, 2, ProgramKind::Sum).expect("sums can be written");
            let mut genome = Genome::default();
            let root = writer.add_linear(&mut genome, &[vec![0.0, 0.25, 1.0], vec![2.0, 0.5, -1.0]]);
            let programs: Vec<_> = genome.team(root).iter().map(|edge| genome.program(edge.program)).collect();
            let bids: Vec<f64> = programs.iter().map(|program| program.bid(&vocabulary, &[0.5, 8.0])).collect();
            assert_eq!(bids, [3.0, 4.0], "in the inputs' own units");
            assert_eq!(programs[0].lines.len(), 2);
        }
    }

    #[test]
    fn what_cannot_be_written_is_refused_with_its_key() {
        let refused = |vocabulary: &Vocabulary, kind| LinearWriter::new(vocabulary, 0, kind).expect_err("no sums").key;
        let key = |vocabulary: &Vocabulary| refused(vocabulary, ProgramKind::Sum);
        assert_eq!(key(&vocabulary(&[Instruction::Mul.into()], 1)), "language.instructions");
        let source = SourceDocument::new("s", "1", vec![[-1.0, 1.0]]);
        let words = vec![Instruction::Add.into(), Word::MultiplyAdd];
        let without = Vocabulary::new(words.clone(), 4, std::slice::from_ref(&source), None, ScalarType::F64);
        assert_eq!(key(&without), "language.literals");
        let registers = |count, words: &[Word]| {
            Vocabulary::new(words.to_vec(), count, std::slice::from_ref(&source), Some(vec![1.0]), ScalarType::F64)
        };
        assert_eq!(key(&registers(1, &words)), "learning.nb_registers");
        assert_eq!(refused(&registers(4, &words), ProgramKind::Product), "language.instructions");
        let words = [Instruction::Add.into(), Instruction::Mul.into()];
        assert_eq!(refused(&registers(2, &words), ProgramKind::Product), "learning.nb_registers");
    }
}
