//! Children close to their parent: all constants change together, one line is lost, or one program is mutated.

use super::config::RefinementConfig;
use super::genome::{Destination, Edge, Genome, GenomeLine, Program, ProgramId, TeamId};
use super::stage::Context;
use std::collections::BTreeMap;
use tpg_engine::random::Stream;

/// Lowest and highest standard deviation of the change of constants, relative to them; each child draws one.
const DEVIATIONS: [f64; 2] = [0.02, 0.6];

impl Context<'_> {
    /// Adds a child of `parent` that differs only by constants or by a missing line, with the configured probabilities;
    /// `None`, where another kind of child is due. Draws nothing where both are 0.
    pub(super) fn refined_child(&self, genome: &mut Genome, parent: TeamId, stream: &mut Stream) -> Option<TeamId> {
        let RefinementConfig { p_jitter, p_deletion, .. } = self.config.refinement;
        if p_jitter + p_deletion <= 0.0 {
            return None;
        }
        let drawn = stream.unit();
        if drawn < p_jitter {
            self.jittered(genome, parent, stream)
        } else if drawn < p_jitter + p_deletion {
            self.shortened(genome, parent, stream)
        } else {
            None
        }
    }

    /// Adds a child of which one program has been mutated, with the configured probability; `None`, where another kind of child
    /// is due. Draws nothing where it is 0.
    pub(super) fn mutated_child(&self, genome: &mut Genome, parent: TeamId, stream: &mut Stream) -> Option<TeamId> {
        let probability = self.config.refinement.p_mutation;
        if probability <= 0.0 || !stream.chance(probability) {
            return None;
        }
        let programs: Vec<(ProgramId, Program)> = self.programs_of(genome, parent).into_iter().collect();
        let (id, mut program) = stream.pick(&programs).clone();
        self.mutate(&mut program, stream);
        Some(copy(genome, parent, BTreeMap::from([(id, program)])))
    }

    /// Adds a child whose constants have all moved a little, or one of them; `None` if it has no constants.
    fn jittered(&self, genome: &mut Genome, parent: TeamId, stream: &mut Stream) -> Option<TeamId> {
        let mut programs = self.programs_of(genome, parent);
        let count = programs.values_mut().map(|program| self.constants(program).count()).sum::<usize>();
        if count == 0 {
            return None;
        }
        let [low, high] = DEVIATIONS;
        let deviation = low * libm::pow(high / low, stream.unit());
        let single = stream.chance(0.5).then(|| stream.below(count));
        let mut place = 0;
        for program in programs.values_mut() {
            for constant in self.constants(program) {
                if single.is_none_or(|single| single == place) {
                    *constant = self.vocabulary.moved(*constant, *constant * (1.0 + deviation * stream.normal()));
                }
                place += 1;
            }
        }
        Some(copy(genome, parent, programs))
    }

    /// Adds a child that lacks one line; `None` if no program has two.
    fn shortened(&self, genome: &mut Genome, parent: TeamId, stream: &mut Stream) -> Option<TeamId> {
        let programs = self.programs_of(genome, parent);
        let long: Vec<_> = programs.into_iter().filter(|(_, program)| program.lines.len() > 1).collect();
        let total: usize = long.iter().map(|(_, program)| program.lines.len()).sum();
        if total == 0 {
            return None;
        }
        let mut line = stream.below(total);
        for (id, mut program) in long {
            if line < program.lines.len() {
                program.lines.remove(line);
                return Some(copy(genome, parent, BTreeMap::from([(id, program)])));
            }
            line -= program.lines.len();
        }
        None
    }

    /// Returns copies of the programs of a team that matter, without lines that have no effect: the bids, if there is more
    /// than one edge, and those of its leaves.
    fn programs_of(&self, genome: &Genome, team: TeamId) -> BTreeMap<ProgramId, Program> {
        let edges = genome.team(team);
        let bids = edges.iter().map(|edge| edge.program).filter(|_| edges.len() > 1);
        let leaves = edges.iter().filter_map(|edge| match edge.to {
            Destination::Leaf(leaf) => Some(genome.leaves()[&leaf].iter().copied()),
            Destination::Team(_) | Destination::Action(_) => None,
        });
        let short = |id: ProgramId| {
            let program = genome.program(id);
            let mut lines: Vec<GenomeLine> = program.effective_lines(self.vocabulary).copied().collect();
            if lines.is_empty() {
                lines.extend(program.lines.first());
            }
            (id, Program { lines })
        };
        bids.chain(leaves.flatten()).map(short).collect()
    }

    /// Returns the literals that a program reads.
    fn constants<'p>(&'p self, program: &'p mut Program) -> impl Iterator<Item = &'p mut f64> {
        program.lines.iter_mut().flat_map(|line| line.literals(self.vocabulary))
    }
}

/// Adds a copy of a team with some programs replaced.
fn copy(genome: &mut Genome, parent: TeamId, replaced: BTreeMap<ProgramId, Program>) -> TeamId {
    let new: BTreeMap<ProgramId, ProgramId> =
        replaced.into_iter().map(|(id, program)| (id, genome.add_program(program))).collect();
    let renamed = |id: ProgramId| new.get(&id).copied().unwrap_or(id);
    let edges = genome.team(parent).to_vec();
    let edges = edges.into_iter().map(|Edge { program, to }| {
        let to = match to {
            Destination::Leaf(leaf) => {
                let programs = genome.leaves()[&leaf].iter().map(|&id| renamed(id)).collect();
                Destination::Leaf(genome.add_leaf(programs))
            }
            Destination::Team(_) | Destination::Action(_) => to,
        };
        Edge { program: renamed(program), to }
    });
    let edges = edges.collect();
    genome.add_team(edges)
}

#[cfg(test)]
mod tests {
    use crate::evolution::config::{EvolutionConfig, RefinementConfig};
    use crate::evolution::genome::Genome;
    use crate::evolution::linear::{LinearWriter, ProgramKind};
    use crate::evolution::tests::context;
    use crate::evolution::vocabulary::Vocabulary;
    use tpg_engine::random::{Purpose, Stream};
    use tpg_engine::{Limits, PolicyGraph};
    use tpg_graph::{ScalarType, SourceDocument, Word};
    use tpg_runtime::ops::Instruction;

    fn vocabulary() -> Vocabulary {
        let words = vec![Instruction::Add.into(), Word::MultiplyAdd];
        let source = SourceDocument::new("s", "1", vec![[-1.0, 1.0]; 3]);
        let limits = Limits { min: -1.0, max: 1.0, nan: 0.0 };
        let bare = Vocabulary::new(words, 2, &[source], Some(vec![1.0; 3]), ScalarType::F64);
        Vocabulary { outputs: vec![limits; 2], ..bare }
    }

    fn children(p_jitter: f64, p_deletion: f64) -> (PolicyGraph, Vec<Option<PolicyGraph>>) {
        let vocabulary = vocabulary();
        let refinement = RefinementConfig { p_jitter, p_deletion, p_mutation: 0.0, p_mirror: 0.0 };
        let config = EvolutionConfig { refinement, ..EvolutionConfig::default() };
        let mutator = context(&config, &vocabulary, 0, &[]);
        let mut genome = Genome::default();
        let writer = LinearWriter::new(&vocabulary, 0, ProgramKind::Sum).expect("sums can be written");
        let parent = writer.add_root(&mut genome, &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0]);
        let child = |index| {
            let child = mutator.refined_child(&mut genome, parent, &mut Stream::new(1, 0, Purpose::Test, index));
            child.map(|child| genome.policy(child, &vocabulary))
        };
        let children = (0..200).map(child).collect();
        (genome.policy(parent, &vocabulary), children)
    }

    #[test]
    fn a_jitter_keeps_the_lines_and_a_deletion_takes_one() {
        let (parent, jittered) = children(1.0, 0.0);
        assert_eq!(parent.lines(), 8);
        let jittered: Vec<PolicyGraph> = jittered.into_iter().flatten().collect();
        assert!(jittered.len() == 200 && jittered.iter().all(|child| child.lines() == 8 && *child != parent));
        let (_, shortened) = children(0.0, 1.0);
        assert!(shortened.iter().all(|child| child.as_ref().is_some_and(|child| child.lines() == 7)));
        let (_, some) = children(0.3, 0.2);
        let made = some.iter().filter(|child| child.is_some()).count();
        assert!((70..130).contains(&made), "{made} of 200");
    }

    #[test]
    fn without_probabilities_nothing_is_drawn() {
        let vocabulary = vocabulary();
        let refinement = RefinementConfig { p_jitter: 0.0, p_deletion: 0.0, p_mutation: 0.0, p_mirror: 0.0 };
        let config = EvolutionConfig { refinement, ..EvolutionConfig::default() };
        let mutator = context(&config, &vocabulary, 0, &[]);
        let mut genome = Genome::default();
        let parent =
            LinearWriter::new(&vocabulary, 0, ProgramKind::Sum).expect("sums").add_root(&mut genome, &[0.0; 8]);
        let mut stream = Stream::new(1, 0, Purpose::Test, 0);
        let before = stream.clone().bits();
        assert_eq!(mutator.refined_child(&mut genome, parent, &mut stream), None);
        assert_eq!(stream.bits(), before);
    }
}
