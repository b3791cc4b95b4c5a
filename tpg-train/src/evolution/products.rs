//! Programs that are sums of products of two inputs: an area, a power, the error across a direction.
//!
//! Two random lines hardly ever make such a product, and half of a difference of products is often worth nothing.

use super::genome::{GenomeLine, Program};
use super::stage::Context;
use super::vocabulary::{Gene, Input};
use tpg_engine::random::Stream;
use tpg_graph::Word;
use tpg_runtime::ops::Instruction;

/// Most terms of a random sum.
const MOST_TERMS: usize = 2;

/// Most lines of a product.
const LINES: usize = 2;

impl Context<'_> {
    /// Returns a random program whose bid is a sum of products, if the parameters want one now. Draws nothing where they never do.
    pub(super) fn random_sum(&self, stream: &mut Stream) -> Option<Vec<GenomeLine>> {
        if !self.wants_product(stream) {
            return None;
        }
        let terms = 1 + stream.below(MOST_TERMS);
        let mut lines = self.term(stream);
        for _ in 1..terms {
            let term = self.term(stream);
            if lines.len() + term.len() <= self.max_lines {
                lines.extend(term);
            }
        }
        Some(lines)
    }

    /// Inserts a term into a program, if the parameters want one now and there is room; returns true if it did. Draws nothing
    /// where they never do.
    pub(super) fn insert_term(&self, program: &mut Program, stream: &mut Stream) -> bool {
        if !self.wants_product(stream) {
            return false;
        }
        let term = self.term(stream);
        let fits = program.lines.len() + term.len() <= self.max_lines;
        if fits {
            let place = stream.below(program.lines.len() + 1);
            program.lines.splice(place..place, term);
        }
        fits
    }

    fn wants_product(&self, stream: &mut Stream) -> bool {
        let probability = self.config.program.p_product;
        probability > 0.0 && stream.chance(probability)
    }

    /// Draws the lines that add to the bid one of three things, in the inputs' units and with either sign: a product of two inputs, or
    /// one of them; of two sources `a` and `b`, `a_i b_j - a_j b_i`, which is 0 where they have one direction; or `a_i b_i + a_j b_j`.
    fn term(&self, stream: &mut Stream) -> Vec<GenomeLine> {
        let inputs = self.vocabulary.inputs();
        let sign = if stream.chance(0.5) { 1.0 } else { -1.0 };
        let kind = stream.below(3);
        if kind > 0
            && self.max_lines >= 2 * LINES
            && let Some([a, b]) = self.two_sources(&inputs, stream)
        {
            let most = a.len().min(b.len());
            let (first, second) = (stream.below(most), stream.below(most - 1));
            let second = second + usize::from(second >= first);
            let (with_first, with_second, other) =
                if kind == 1 { (second, first, -sign) } else { (first, second, sign) };
            let mut lines = self.product(a[first], Some(b[with_first]), sign, stream);
            lines.extend(self.product(a[second], Some(b[with_second]), other, stream));
            return lines;
        }
        let first = *stream.pick(&inputs);
        let second = inputs.get(stream.below(inputs.len() + 1)).copied();
        self.product(first, second, sign, stream)
    }

    /// Draws two different sources with two values or more.
    fn two_sources<'i>(&self, inputs: &'i [Input], stream: &mut Stream) -> Option<[&'i [Input]; 2]> {
        let sources: Vec<&[Input]> =
            inputs.chunk_by(|a, b| a.0.source == b.0.source).filter(|source| source.len() > 1).collect();
        if sources.len() < 2 {
            return None;
        }
        let (first, second) = (stream.below(sources.len()), stream.below(sources.len() - 1));
        Some([sources[first], sources[second + usize::from(second >= first)]])
    }

    /// Returns the lines that add to the bid the product of two inputs in their units, or one of them.
    fn product(
        &self,
        (first, _, unit): Input,
        second: Option<Input>,
        sign: f64,
        stream: &mut Stream,
    ) -> Vec<GenomeLine> {
        let vocabulary = self.vocabulary;
        let number = |word: Word| vocabulary.index(word).expect("a checked configuration has it");
        let add = number(Word::MultiplyAdd);
        let unit = unit * second.map_or(1.0, |(.., unit)| unit);
        let weight = vocabulary.literal(vocabulary.scalar.round(sign / unit));
        let Some((second, ..)) = second else {
            return vec![GenomeLine { instruction: add, to: 0, operands: [first, weight] }];
        };
        let to = 1 + stream.below(usize::from(vocabulary.registers) - 1) as u16;
        let weighted = Gene::register(to);
        vec![
            GenomeLine { instruction: number(Instruction::Mul.into()), to, operands: [first, weight] },
            GenomeLine { instruction: add, to: 0, operands: [weighted, second] },
        ]
    }
}

#[cfg(test)]
mod tests {
    use crate::configuration::Configuration as _;
    use crate::evolution::config::EvolutionConfig;
    use crate::evolution::genome::Program;
    use crate::evolution::tests::context;
    use crate::evolution::vocabulary::Vocabulary;
    use std::collections::BTreeSet;
    use tpg_engine::random::{Purpose, Stream};
    use tpg_graph::{ScalarType, SourceDocument};

    fn config() -> EvolutionConfig {
        let mut config = EvolutionConfig::preset("raw-fs").expect("a preset");
        config.program.p_product = 1.0;
        config
    }

    /// Returns the size of every term that is drawn in a state of sources with two values each.
    fn terms(config: &EvolutionConfig, state: &[f64], units: Vec<f64>) -> BTreeSet<i64> {
        let source = |name: &str| {
            let ranges = vec![[-1.0, 1.0]; 2];
            SourceDocument::new(name, "1", ranges)
        };
        let sources = [source("a"), source("b")];
        let vocabulary =
            Vocabulary::new(config.instructions(), 3, &sources[..state.len() / 2], Some(units), ScalarType::F64);
        let mutator = context(config, &vocabulary, 2, &[]);
        let term = |index| {
            let mut program = Program::default();
            assert!(mutator.insert_term(&mut program, &mut Stream::new(1, 0, Purpose::Test, index)));
            program.bid(&vocabulary, state) as i64
        };
        (0..3000).map(term).collect()
    }

    #[test]
    fn a_term_is_in_the_inputs_units_and_has_either_sign() {
        // 3 and 5 in units of their own.
        let of_one: BTreeSet<i64> = [3, 5, 9, 15, 25].into_iter().flat_map(|size| [size, -size]).collect();
        assert_eq!(terms(&config(), &[6.0, 20.0], vec![2.0, 4.0]), of_one);
    }

    #[test]
    fn terms_of_two_sources_are_what_is_across_and_what_is_along() {
        // 2 · 11 − 3 · 7 = 1 and 2 · 7 + 3 · 11 = 47 are no products of two of them.
        let found = terms(&config(), &[2.0, 3.0, 7.0, 11.0], vec![1.0; 4]);
        assert!([1, -1, 47, -47, 22, -21].iter().all(|it| found.contains(it)), "{found:?}");
        let of_two = |size: i64| [2, 3, 7, 11, 1].iter().any(|a| [2, 3, 7, 11].iter().any(|b| a * b == size.abs()));
        assert!(found.iter().all(|it| of_two(*it) || [1, 47].contains(&it.abs())), "{found:?}");
    }

    #[test]
    fn programs_keep_their_length_and_without_the_probability_nothing_is_drawn() {
        let mut config = config();
        let vocabulary = Vocabulary::new(
            config.instructions(),
            3,
            &[SourceDocument::new("a", "1", vec![[-1.0, 1.0]; 2])],
            Some(vec![1.0; 2]),
            ScalarType::F64,
        );
        config.program.max_program_size = 3;
        let mutator = context(&config, &vocabulary, 2, &[]);
        for index in 0..300 {
            let mut stream = Stream::new(1, 0, Purpose::Test, index);
            let mut program = mutator.random(&mut stream);
            assert!((1..=3).contains(&program.lines.len()));
            mutator.insert_term(&mut program, &mut stream);
            assert!(program.lines.len() <= 3);
        }
        let mut never = config.clone();
        never.program.p_product = 0.0;
        let mutator = context(&never, &vocabulary, 2, &[]);
        let mut stream = Stream::new(1, 0, Purpose::Test, 0);
        let before = stream.clone().bits();
        assert_eq!(mutator.random_sum(&mut stream), None);
        assert!(!mutator.insert_term(&mut Program::default(), &mut stream));
        assert_eq!(stream.bits(), before);
    }
}
