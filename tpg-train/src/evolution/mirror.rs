//! Pairs of opposite bids: for an action the opposite of what is bid for the action that undoes it.

use super::genome::{Destination, Edge, Genome, GenomeLine, Program, TeamId};
use super::mutate_program::P_PROGRAM_MUTATION;
use super::stage::Context;
use super::vocabulary::{Gene, SourceKind, Vocabulary};
use tpg_engine::ActionSpace;
use tpg_engine::random::Stream;
use tpg_runtime::ops::Instruction;

/// Returns the action that undoes each one: that with the same effect and the opposite values.
pub(super) fn opposites(actions: &ActionSpace) -> Vec<Option<u16>> {
    let ActionSpace::Discrete(actions) = actions else { return Vec::new() };
    let effects: Vec<_> = actions.iter().map(|action| action.effect.as_ref()).collect();
    let opposite = |place: usize| {
        let effect = effects[place]?;
        let undoes = |other: &tpg_graph::Effect| {
            let values = effect.values.iter().zip(&other.values);
            let same = effect.name == other.name && effect.values.len() == other.values.len();
            same && values.clone().any(|(a, _)| *a != 0.0) && values.clone().all(|(a, b)| *a == -*b)
        };
        let found = effects.iter().position(|other| other.is_some_and(undoes));
        found.map(|place| place as u16)
    };
    (0..effects.len()).map(opposite).collect()
}

/// Probability that a child with several pairs loses one.
const P_PAIR_DELETION: f64 = 0.7;

/// Makes pairs of opposite bids.
///
/// Two actions that undo each other alternate for ever where both bid high. With opposite bids one of them is below zero, and a
/// third action moves where both are near it.
impl Context<'_> {
    /// Adds a child with another pair of opposite bids, with the configured probability; `None`, where another kind of child is due.
    /// The pair is one of its own, whose program is mutated, or made of a bid of any team. Draws nothing where the probability is 0.
    pub(super) fn mirrored_child(
        &self,
        genome: &mut Genome,
        parent: TeamId,
        others: &[Edge],
        stream: &mut Stream,
    ) -> Option<TeamId> {
        let probability = self.config.refinement.p_mirror;
        if probability <= 0.0 || !stream.chance(probability) {
            return None;
        }
        let mut edges = genome.team(parent).to_vec();
        let own = self.paired(&edges);
        let foreign = stream.chance(0.5);
        let taken = if foreign { self.paired(others) } else { own.clone() };
        let (edge, pair) = *taken.get(stream.below(taken.len().max(1)))?;
        if own.len() > 2 && stream.chance(P_PAIR_DELETION) {
            let (_, [first, second]) = *stream.pick(&own);
            edges.retain(|edge| ![first, second].contains(&edge.to));
        }
        let mut program = genome.program(edge.program).clone();
        if !foreign || stream.chance(P_PROGRAM_MUTATION) {
            self.mutate(&mut program, stream);
        }
        let pair = if stream.chance(self.config.tpg.p_edge_destination_change) { self.any_pair(stream)? } else { pair };
        self.bid(genome, &mut edges, program, pair)?;
        Some(genome.add_team(edges))
    }

    /// Completes the pairs of every root of a first population; does nothing where the probability is 0.
    pub(super) fn complete_roots(&self, genome: &mut Genome) {
        let roots = if self.config.refinement.p_mirror > 0.0 { genome.roots() } else { Vec::new() };
        roots.into_iter().for_each(|root| self.complete(genome, root));
    }

    /// Gives every action of a team that has an opposite the opposite bid of it, as far as there is room.
    fn complete(&self, genome: &mut Genome, team: TeamId) {
        let before = genome.team(team).to_vec();
        let mut edges: Vec<Edge> = before.clone();
        for (edge, pair) in self.paired(&before) {
            let program = genome.program(edge.program).clone();
            // A pair that does not fit stays as it is.
            let _ = self.bid(genome, &mut edges, program, pair);
        }
        genome.teams.insert(team, edges);
    }

    /// Returns the edges to actions that have an opposite, each with its action and the opposite.
    fn paired(&self, edges: &[Edge]) -> Vec<(Edge, [Destination; 2])> {
        let pair = |edge: &Edge| match edge.to {
            Destination::Action(action) => Some((*edge, self.pair(action)?)),
            Destination::Team(_) | Destination::Leaf(_) => None,
        };
        edges.iter().filter_map(pair).collect()
    }

    fn pair(&self, action: u16) -> Option<[Destination; 2]> {
        let opposite = (*self.opposites.get(usize::from(action))?)?;
        Some([action, opposite].map(Destination::Action))
    }

    /// Draws one of the pairs of opposite actions.
    fn any_pair(&self, stream: &mut Stream) -> Option<[Destination; 2]> {
        let pairs: Vec<_> = (0..self.opposites.len() as u16).filter_map(|action| self.pair(action)).collect();
        pairs.get(stream.below(pairs.len().max(1))).copied()
    }

    /// Lets a program bid for the first action of a pair, and its negation for the second; `None` if there is no room.
    fn bid(&self, genome: &mut Genome, edges: &mut Vec<Edge>, program: Program, pair: [Destination; 2]) -> Option<()> {
        let negated = self.negated(&program)?;
        let others = edges.iter().filter(|edge| !pair.contains(&edge.to)).count();
        if others + pair.len() > self.config.tpg.max_outgoing_edges {
            return None;
        }
        edges.retain(|edge| !pair.contains(&edge.to));
        edges.extend([program, negated].into_iter().zip(pair).map(|(program, to)| {
            let program = genome.add_program(program);
            Edge { program, to }
        }));
        Some(())
    }

    /// Returns a program with the opposite result; `None` if it would be too long. One that ends with a negation loses it.
    fn negated(&self, program: &Program) -> Option<Program> {
        let negation = negation(self.vocabulary)?;
        let mut lines: Vec<GenomeLine> = program.effective_lines(self.vocabulary).copied().collect();
        if lines.len() > 1 && lines.last() == Some(&negation) {
            lines.pop();
        } else {
            lines.push(negation);
        }
        let fits = lines.len() <= self.max_lines;
        fits.then_some(Program { lines })
    }
}

/// Returns the line that negates a program's result; `None` without the word or the number for it.
fn negation(vocabulary: &Vocabulary) -> Option<GenomeLine> {
    let instruction = vocabulary.index(Instruction::Sub.into())?;
    let line = GenomeLine { instruction, to: 0, operands: [vocabulary.literal(0.0), Gene::register(0)] };
    let last = (vocabulary.sources() - 1) as u8;
    (vocabulary.kind(last) == SourceKind::Literal).then_some(line)
}

#[cfg(test)]
mod tests {
    use super::opposites;
    use crate::configuration::Configuration as _;
    use crate::evolution::config::EvolutionConfig;
    use crate::evolution::genome::{Destination, Genome};
    use crate::evolution::linear::{LinearWriter, ProgramKind};
    use crate::evolution::tests::context;
    use crate::evolution::vocabulary::Vocabulary;
    use tpg_engine::ActionSpace;
    use tpg_engine::random::{Purpose, Stream};
    use tpg_graph::{Effect, ScalarType, SourceDocument, Word};
    use tpg_runtime::ops::Instruction;

    #[test]
    fn an_opposite_has_the_same_effect_with_opposite_values() {
        let mut space = ActionSpace::discrete(["left", "up", "right", "stop", "ask"]);
        let ActionSpace::Discrete(actions) = &mut space else { unreachable!() };
        let effects = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, 0.0]];
        for (action, values) in actions.iter_mut().zip(effects) {
            action.effect = Some(Effect { name: "move".to_owned(), values: values.to_vec() });
        }
        assert_eq!(opposites(&space), [Some(2), None, Some(0), None, None]);
        assert!(opposites(&ActionSpace::Box(Vec::new())).is_empty());
    }

    #[test]
    fn a_child_bids_the_opposite_for_the_opposite_action() {
        let words = [Instruction::Add, Instruction::Sub, Instruction::Mul].map(Word::from);
        let words = [&words[..], &[Word::MultiplyAdd]].concat();
        let source = SourceDocument::new("s", "1", vec![[-1.0, 1.0]; 3]);
        let vocabulary = Vocabulary::new(words, 2, &[source], Some(vec![1.0; 3]), ScalarType::F64);
        let mut config = EvolutionConfig::preset("raw-fs").expect("a preset");
        (config.refinement.p_mirror, config.tpg.max_outgoing_edges) = (1.0, 3);
        let opposites = [Some(1), Some(0), None];
        let mirror = context(&config, &vocabulary, 3, &opposites);
        let mut genome = Genome::default();
        let writer = LinearWriter::new(&vocabulary, 3, ProgramKind::Sum).expect("sums can be written");
        let parent = writer.add_root(&mut genome, &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0]);
        let bids = |genome: &Genome, team, state: [f64; 3]| {
            let programs = genome.team(team).iter().map(|edge| genome.program(edge.program));
            programs.map(|program| program.bid(&vocabulary, &state)).collect::<Vec<f64>>()
        };
        mirror.complete(&mut genome, parent);
        let opposed = |genome: &Genome, team| {
            let edges = genome.team(team);
            let bids = bids(genome, team, [0.5, -1.0, 2.0]);
            let leaf =
                |action| edges.iter().position(|edge| edge.to == Destination::Action(action)).map(|place| bids[place]);
            (leaf(0), leaf(1), leaf(2))
        };
        assert_eq!(opposed(&genome, parent), (Some(-8.5), Some(8.5), Some(18.5)));
        let others = genome.team(parent).to_vec();
        let mut same = 0;
        for index in 0..200 {
            let mut stream = Stream::new(1, 0, Purpose::Test, index);
            let child = mirror.mirrored_child(&mut genome, parent, &others, &mut stream).expect("there is room");
            let (Some(first), Some(second), Some(third)) = opposed(&genome, child) else { panic!("a bid is missing") };
            assert!(first == -second || first.is_nan(), "{first} and {second}");
            assert_eq!(third, 18.5, "an action without opposite is left alone");
            same += usize::from(first.abs() == 8.5);
        }
        assert!((5..180).contains(&same), "{same}");
        let mut never = config.clone();
        never.refinement.p_mirror = 0.0;
        let never = context(&never, &vocabulary, 3, &opposites);
        let mut stream = Stream::new(1, 0, Purpose::Test, 0);
        let before = stream.clone().bits();
        assert_eq!(never.mirrored_child(&mut genome, parent, &others, &mut stream), None);
        assert_eq!(stream.bits(), before, "nothing is drawn");
    }
}
