//! The first population and the children of policies with outputs.
//!
//! A policy starts as a single leaf: a formula. Children mostly change the programs of a leaf; edges, bids and teams come
//! and go rarely.

use super::children::add_children;
use super::config::ProgramParameters;
use super::genome::{Destination, Edge, Genome, LeafId, ProgramId, TeamId};
use super::linear::ProgramKind;
use super::stage::{Context, Moment};
use tpg_engine::random::Stream;

/// Minimum of the maximum number of lines of a leaf's program.
const LINES: usize = 32;
/// Maximum number of rounds of mutation of a leaf's program in a child.
const ROUNDS: usize = 3;
/// Probability that a child changes only the literals of a leaf, and the standard deviations of that change, of which it draws one.
const P_LITERALS: f64 = 0.3;
const REFINEMENTS: [f64; 3] = [0.3, 0.1, 0.03];
/// Probabilities that a child with several edges changes a bid, and that it loses an edge.
const P_BID: f64 = 0.5;
const P_EDGE_DELETION: f64 = 0.15;
/// Probability that a child gets another edge, and that this leads to a team, not to a leaf.
const P_EDGE_ADDITION: f64 = 0.04;
const P_TEAM: f64 = 0.1;
/// Probability that another edge is the twin of one, where two sources are of a kind.
const P_TWIN: f64 = 0.5;

impl ProgramParameters {
    /// Returns the maximum number of lines of a leaf's program.
    pub(super) fn leaf_lines(&self) -> usize {
        self.max_program_size.max(LINES)
    }
}

impl Context<'_> {
    /// Returns the context in which programs of leaves are drawn and changed.
    fn for_leaves(self) -> Self {
        Self { max_lines: self.config.program.leaf_lines(), ..self }
    }

    /// Draws a population of formulas: each root has one edge, to a leaf of its own. Where no search for weights precedes it, every
    /// second is proportional to an input for each output.
    pub(super) fn random_leaves(&self, stream: &mut Stream) -> Genome {
        let writer = self.writer(ProgramKind::Sum).ok().filter(|_| self.config.start.share == 0.0);
        let mut genome = Genome::default();
        for root in 0..self.config.tpg.init_nb_roots {
            if let Some(writer) = writer.as_ref().filter(|_| root % 2 == 0) {
                writer.add_root(&mut genome, &writer.proportional(stream));
                continue;
            }
            let edge = self.edge_to_new_leaf(&mut genome, stream);
            genome.add_team(vec![edge]);
        }
        genome
    }

    fn edge_to_new_leaf(&self, genome: &mut Genome, stream: &mut Stream) -> Edge {
        let outputs = self.vocabulary.outputs.len();
        let programs = (0..outputs).map(|_| genome.add_program(self.for_leaves().random(stream))).collect();
        let leaf = genome.add_leaf(programs);
        Edge { program: genome.add_program(self.random(stream)), to: Destination::Leaf(leaf) }
    }

    /// Adds children, changed copies of roots.
    pub(super) fn populate_leaves(&self, genome: &mut Genome, moment: Moment) {
        let teams: Vec<TeamId> = genome.teams.keys().copied().collect();
        let leaves: Vec<LeafId> = genome.leaves().keys().copied().collect();
        let before = EarlierLeaves { teams: &teams, leaves: &leaves };
        let child = |genome: &mut Genome, parent, stream: &mut Stream| self.leaf_child(genome, parent, &before, stream);
        add_children(genome, self.config.tpg.nb_roots, moment, child);
    }

    fn leaf_child(
        &self,
        genome: &mut Genome,
        parent: TeamId,
        before: &EarlierLeaves<'_>,
        stream: &mut Stream,
    ) -> TeamId {
        if let Some(child) = self.refined_child(genome, parent, stream) {
            return child;
        }
        let mut edges = genome.team(parent).to_vec();
        let changed = stream.below(edges.len());
        match edges[changed].to {
            Destination::Leaf(leaf) => edges[changed].to = Destination::Leaf(self.changed_leaf(genome, leaf, stream)),
            Destination::Team(_) | Destination::Action(_) => self.change_bid(genome, &mut edges[changed], stream),
        }
        if edges.len() > 1 && stream.chance(P_BID) {
            let place = stream.below(edges.len());
            self.change_bid(genome, &mut edges[place], stream);
        }
        if edges.len() > 1 && stream.chance(P_EDGE_DELETION) {
            edges.remove(stream.below(edges.len()));
        }
        if edges.len() < self.config.tpg.max_outgoing_edges && stream.chance(P_EDGE_ADDITION) {
            if let Some(pair) = self.vocabulary.pair(stream).filter(|_| stream.chance(P_TWIN)) {
                let place = stream.below(edges.len());
                if edges.len() == 1 {
                    edges[place].program = genome.add_program(self.random(stream)); // a bid that has never counted
                }
                edges.push(twin(genome, edges[place], pair));
                return genome.add_team(edges);
            }
            let to = if stream.chance(P_TEAM) {
                Destination::Team(*stream.pick(before.teams))
            } else {
                Destination::Leaf(*stream.pick(before.leaves))
            };
            edges.push(Edge { program: genome.add_program(self.random(stream)), to });
        }
        genome.add_team(edges)
    }

    /// Copies a leaf and changes the program of one output, or only its literals.
    fn changed_leaf(&self, genome: &mut Genome, leaf: LeafId, stream: &mut Stream) -> LeafId {
        let mut programs = genome.leaves()[&leaf].clone();
        let output = stream.below(programs.len());
        let mut program = genome.program(programs[output]).clone();
        let refined = stream.chance(P_LITERALS) && {
            let deviation = *stream.pick(&REFINEMENTS);
            self.for_leaves().refine(&mut program, deviation, stream)
        };
        if !refined {
            for _ in 0..1 + stream.below(ROUNDS) {
                self.for_leaves().mutate(&mut program, stream);
            }
        }
        programs[output] = genome.add_program(program);
        genome.add_leaf(programs)
    }

    fn change_bid(&self, genome: &mut Genome, edge: &mut Edge, stream: &mut Stream) {
        let mut program = genome.program(edge.program).clone();
        self.mutate(&mut program, stream);
        edge.program = genome.add_program(program);
    }
}

/// Adds an edge that does with one of two sources what an edge does with the other.
fn twin(genome: &mut Genome, edge: Edge, pair: [u8; 2]) -> Edge {
    let program = exchanged(genome, edge.program, pair);
    let Destination::Leaf(leaf) = edge.to else { return Edge { program, ..edge } };
    let programs = genome.leaves()[&leaf].clone();
    let programs = programs.into_iter().map(|program| exchanged(genome, program, pair)).collect();
    Edge { program, to: Destination::Leaf(genome.add_leaf(programs)) }
}

/// Adds a copy of a program that reads each of two sources for the other.
fn exchanged(genome: &mut Genome, program: ProgramId, [one, other]: [u8; 2]) -> ProgramId {
    let mut program = genome.program(program).clone();
    for gene in program.lines.iter_mut().flat_map(|line| &mut line.operands) {
        gene.source = match gene.source {
            source if source == one => other,
            source if source == other => one,
            source => source,
        };
    }
    genome.add_program(program)
}

/// The teams and leaves that existed before any child: children lead only to these, so no cycle can arise.
struct EarlierLeaves<'a> {
    teams: &'a [TeamId],
    leaves: &'a [LeafId],
}

#[cfg(test)]
mod tests {
    use super::{Edge, twin};
    use crate::evolution::config::EvolutionConfig;
    use crate::evolution::genome::{Destination, Genome};
    use crate::evolution::linear::{LinearWriter, ProgramKind};
    use crate::evolution::stage::Moment;
    use crate::evolution::tests::context;
    use crate::evolution::vocabulary::Vocabulary;
    use tpg_engine::Limits;
    use tpg_engine::random::{Purpose, Stream};
    use tpg_graph::{ScalarType, SourceDocument};

    fn evolved(generations: u64) -> Genome {
        let mut config = EvolutionConfig::default();
        config.tpg.init_nb_roots = 40;
        let source = SourceDocument::new("s", "1", vec![[-1.0, 1.0]; 3]);
        let limits = Limits { min: -1.0, max: 1.0, nan: 0.0 };
        let bare = Vocabulary::new(config.instructions(), 4, &[source], Some(vec![1.0; 3]), ScalarType::F32);
        let vocabulary = Vocabulary { outputs: vec![limits; 2], ..bare };
        let mutator = context(&config, &vocabulary, 0, &[]);
        let mut genome = mutator.random_leaves(&mut Stream::new(1, 0, Purpose::Test, 0));
        for generation in 0..generations {
            mutator.populate_leaves(&mut genome, Moment { seed: 1, generation });
            let doomed: Vec<_> = genome.roots().into_iter().step_by(2).collect();
            genome.remove_roots(&doomed);
        }
        for root in genome.roots() {
            let policy = genome.policy(root, &vocabulary);
            assert!(policy.leaves.iter().all(|leaf| leaf.len() == 2) && !policy.leaves.is_empty());
        }
        genome
    }

    #[test]
    fn a_twin_reads_the_other_source_in_its_bid_and_its_outputs() {
        let config = EvolutionConfig::default();
        let sources = ["bright", "dark"].map(|name| SourceDocument::new(name, "1", vec![[0.0, 2.0]; 2]));
        let bare = Vocabulary::new(config.instructions(), 4, &sources, Some(vec![1.0; 4]), ScalarType::F32);
        let vocabulary = Vocabulary { outputs: vec![Limits { min: -1.0, max: 1.0, nan: 0.0 }; 2], ..bare };
        let mut genome = Genome::default();
        let writer = LinearWriter::new(&vocabulary, 0, ProgramKind::Sum).expect("sums can be written");
        let root = writer.add_root(&mut genome, &[3.0, 0.0, 0.0, 0.0, -3.0, 0.0, 5.0, 0.0, 0.0, -5.0]);
        let pair = vocabulary.pair(&mut Stream::new(1, 0, Purpose::Test, 0)).expect("two sources of two values");
        let Destination::Leaf(leaf) = genome.team(root)[0].to else { panic!("a leaf") };
        let edge = Edge { program: genome.leaves()[&leaf][0], to: Destination::Leaf(leaf) };
        let edges = [edge, twin(&mut genome, edge, pair)];
        // The bid, and the outputs.
        let values = |edge: Edge, state: [f64; 4]| {
            let Destination::Leaf(leaf) = edge.to else { panic!("a leaf") };
            let programs = std::iter::once(&edge.program).chain(&genome.leaves()[&leaf]);
            programs.map(|id| genome.program(*id).bid(&vocabulary, &state)).collect::<Vec<_>>()
        };
        let (first, second) = (values(edges[0], [2.0, 1.0, 0.5, 0.0]), values(edges[1], [0.5, 0.0, 2.0, 1.0]));
        assert_eq!((first, second), (vec![3.0, 3.0, 0.0], vec![3.0, 3.0, 0.0]));
        assert_ne!(values(edges[1], [2.0, 1.0, 0.5, 0.0]), [3.0, 3.0, 0.0]);
    }

    #[test]
    fn a_policy_starts_as_a_formula_and_structure_is_added() {
        assert!(evolved(0).teams.values().all(|team| team.len() == 1));
        let genome = evolved(400);
        let edges: Vec<usize> = genome.teams.values().map(Vec::len).collect();
        assert!(edges.iter().any(|&edges| edges > 1), "{edges:?}");
        let to_teams = genome.teams.values().flatten();
        assert!(to_teams.clone().any(|edge| matches!(edge.to, Destination::Team(_))), "some edge leads to a team");
        assert!(to_teams.clone().all(|edge| !matches!(edge.to, Destination::Action(_))));
        let used: std::collections::BTreeSet<_> = to_teams.map(|edge| edge.to).collect();
        assert!(genome.leaves().keys().all(|&leaf| used.contains(&Destination::Leaf(leaf))), "no leaf is left over");
        assert_eq!(evolved(400), genome, "the same seed, the same genome");
    }
}
