//! The first population, and children of roots, with GEGELATI's choices (`mutator/tpgMutator.cpp`).

use super::children::add_children;
use super::config::TpgParameters;
use super::genome::{Destination, Edge, Genome, ProgramId, Team, TeamId};
use super::mirror::Mirror;
use super::mutate_program::{P_PROGRAM_MUTATION, ProgramMutator};
use super::refine::Refiner;
use super::stage::Moment;
use tpg_engine::random::{Purpose, Stream};

/// GEGELATI's probabilities of deleting and adding one more edge, each less likely by that factor than the one before; the first of
/// each is certain.
const P_EDGE_DELETION: f64 = 0.7;
const P_EDGE_ADDITION: f64 = 0.7;

/// Creates a random population (`TPGMutator::initRandomTPG`).
///
/// Each root gets two programs for two different actions, and up to `maxInitOutgoingEdges` − 2 programs of other roots:
/// of two candidates, the one used by fewer teams.
pub(super) fn random_population(
    mutator: &ProgramMutator<'_>,
    parameters: &TpgParameters,
    actions: u16,
    stream: &mut Stream,
) -> Genome {
    let mut genome = Genome::default();
    let roots = parameters.init_nb_roots;
    let actions = usize::from(actions);
    let programs: Vec<ProgramId> = (0..2 * roots).map(|_| genome.add_program(mutator.random(stream))).collect();
    // GEGELATI assigns the actions to the first roots in order, then draws them at random.
    let action_of: Vec<u16> = (0..2 * roots)
        .map(|index| if index < 2 * actions { (index / 2 + index % 2) % actions } else { stream.below(actions) } as u16)
        .collect();
    let mut uses = vec![1usize; programs.len()];
    for root in 0..roots {
        let edge = |index: usize, action: u16| Edge { program: programs[index], to: Destination::Action(action) };
        let own = [2 * root, 2 * root + 1];
        let mut taken = own.to_vec();
        let mut edges = own.map(|index| edge(index, action_of[index])).to_vec();
        for _ in 0..stream.below(parameters.max_init_outgoing_edges - 1) {
            let mut draw = || loop {
                let index = stream.below(programs.len());
                if !taken.contains(&index) {
                    return index;
                }
            };
            if edges.len() + 1 >= programs.len() {
                break;
            }
            let (first, second) = (draw(), draw());
            let index = if uses[second] < uses[first] { second } else { first };
            uses[index] += 1;
            taken.push(index);
            edges.push(edge(index, ((index / 2 + index % 2) % actions) as u16));
        }
        genome.add_team(Team { edges });
    }
    genome
}

/// Makes children of policies with named actions.
#[derive(Clone, Copy, Debug)]
pub(super) struct TeamMutator<'a> {
    /// Draws and changes programs.
    pub programs: ProgramMutator<'a>,
    /// Makes children by small changes.
    pub refiner: Refiner<'a>,
    /// Makes children with opposite bids.
    pub mirror: Mirror<'a>,
    /// Parameters of teams.
    pub parameters: &'a TpgParameters,
    /// Number of actions.
    pub actions: u16,
}

impl TeamMutator<'_> {
    /// Adds children: mutated copies of roots; the refiner or the mirror may make them instead.
    pub(super) fn populate(&self, genome: &mut Genome, moment: Moment) {
        let Self { programs, refiner, mirror, parameters, actions } = *self;
        let teams: Vec<TeamId> = genome.teams.keys().copied().collect();
        let edges: Vec<Edge> = genome.teams.values().flat_map(|team| team.edges.iter().copied()).collect();
        let before = Before { teams: &teams, edges: &edges, actions };
        let mut to_mutate = Vec::new();
        add_children(genome, parameters.nb_roots, moment, |genome, parent, stream| {
            let close = refiner.child(genome, parent, stream);
            let close = close.or_else(|| mirror.child(genome, parent, &edges, parameters, stream));
            let close = close.or_else(|| refiner.mutated(genome, parent, &programs, stream));
            close.unwrap_or_else(|| {
                let edges = genome.team(parent).edges.clone();
                let edges = mutated(genome, edges, &before, parameters, &mut to_mutate, stream);
                genome.add_team(Team { edges })
            })
        });
        for (index, new) in (0..).zip(&to_mutate) {
            let mut program = genome.program(*new).clone();
            programs.mutate(&mut program, &mut moment.stream(Purpose::Program, index));
            genome.programs.insert(*new, program);
        }
    }
}

/// The teams and programs that existed before any child: children lead only to these, so no cycle can arise.
struct Before<'a> {
    teams: &'a [TeamId],
    edges: &'a [Edge],
    actions: u16,
}

/// Mutates the edges of a team (`TPGMutator::mutateTPGTeam`).
fn mutated(
    genome: &mut Genome,
    mut edges: Vec<Edge>,
    before: &Before<'_>,
    parameters: &TpgParameters,
    to_mutate: &mut Vec<ProgramId>,
    stream: &mut Stream,
) -> Vec<Edge> {
    let mut probability = 1.0;
    while edges.len() > 2 && probability > stream.unit() {
        edges.remove(stream.below(edges.len()));
        probability *= P_EDGE_DELETION;
    }
    let mut probability = 1.0;
    while edges.len() < parameters.max_outgoing_edges && probability > stream.unit() {
        edges.push(*stream.pick(before.edges));
        probability *= P_EDGE_ADDITION;
    }
    let mut any = false;
    while !any {
        for edge in &mut edges {
            if stream.chance(P_PROGRAM_MUTATION) {
                mutate_edge(genome, edge, before, parameters, to_mutate, stream);
                any = true;
            }
        }
    }
    edges
}

/// Mutates an edge (`TPGMutator::mutateOutgoingEdge`): replaces its program by a copy to be mutated, and may change the
/// destination.
fn mutate_edge(
    genome: &mut Genome,
    edge: &mut Edge,
    before: &Before<'_>,
    parameters: &TpgParameters,
    to_mutate: &mut Vec<ProgramId>,
    stream: &mut Stream,
) {
    let copy = genome.add_program(genome.program(edge.program).clone());
    to_mutate.push(copy);
    edge.program = copy;
    if stream.chance(parameters.p_edge_destination_change) {
        edge.to = if stream.chance(parameters.p_edge_destination_is_action) {
            Destination::Action(stream.below(before.actions.into()) as u16)
        } else {
            Destination::Team(*stream.pick(before.teams))
        };
    }
}

#[cfg(test)]
mod tests {
    use super::{Moment, TeamMutator, random_population};
    use crate::configuration::Configuration as _;
    use crate::evolution::config::EvolutionConfig;
    use crate::evolution::genome::{Destination, Genome, ProgramId};
    use crate::evolution::mirror::Mirror;
    use crate::evolution::mutate_program::ProgramMutator;
    use crate::evolution::refine::Refiner;
    use crate::evolution::vocabulary::Vocabulary;
    use tpg_engine::random::{Purpose, Stream};
    use tpg_graph::{ScalarType, SourceDocument};

    fn config() -> EvolutionConfig {
        let mut config = EvolutionConfig::preset("paper-fs").expect("a preset");
        (config.tpg.nb_roots, config.tpg.init_nb_roots) = (40, 30);
        config
    }

    fn vocabulary(config: &EvolutionConfig) -> Vocabulary {
        let source = SourceDocument::new("s", "1", vec![[-1.0, 1.0]; 3]);
        Vocabulary::new(config.instructions(), 8, &[source], None, ScalarType::F32)
    }

    fn evolved(config: &EvolutionConfig, generations: u64) -> Genome {
        let vocabulary = vocabulary(config);
        let mutator =
            ProgramMutator { vocabulary: &vocabulary, parameters: &config.program, literals: &config.literals };
        let mut genome = random_population(&mutator, &config.tpg, 9, &mut Stream::new(1, 0, Purpose::Test, 0));
        for generation in 0..generations {
            let moment = Moment { seed: 1, generation };
            let refiner = Refiner { vocabulary: &vocabulary, parameters: &config.refinement };
            let mirror = Mirror { programs: mutator, opposites: &[], probability: 0.0 };
            let mutator = TeamMutator { programs: mutator, refiner, mirror, parameters: &config.tpg, actions: 9 };
            mutator.populate(&mut genome, moment);
            let doomed: Vec<_> = genome.roots().into_iter().step_by(3).collect();
            genome.remove_roots(&doomed);
        }
        genome
    }

    #[test]
    fn the_first_population_is_gegelatis() {
        let config = config();
        let genome = evolved(&config, 0);
        assert_eq!((genome.roots().len(), genome.teams.len()), (30, 30));
        for (place, team) in genome.teams.values().enumerate() {
            assert!((2..=config.tpg.max_init_outgoing_edges).contains(&team.edges.len()));
            if place < 9 {
                let actions = [0, 1].map(|edge| Destination::Action(((place + edge) % 9) as u16));
                assert_eq!([team.edges[0].to, team.edges[1].to], actions, "actions are spread over the first roots");
            }
            let mut programs: Vec<ProgramId> = team.edges.iter().map(|edge| edge.program).collect();
            programs.sort_unstable();
            programs.dedup();
            assert_eq!(programs.len(), team.edges.len(), "a team's first programs are different ones");
        }
    }

    #[test]
    fn children_fill_the_population_lead_only_to_older_teams_and_keep_the_limits() {
        let config = config();
        let vocabulary = vocabulary(&config);
        let mut genome = evolved(&config, 8);
        let mutator =
            ProgramMutator { vocabulary: &vocabulary, parameters: &config.program, literals: &config.literals };
        let moment = Moment { seed: 1, generation: 9 };
        let refiner = Refiner { vocabulary: &vocabulary, parameters: &config.refinement };
        let mirror = Mirror { programs: mutator, opposites: &[], probability: 0.0 };
        let mutator = TeamMutator { programs: mutator, refiner, mirror, parameters: &config.tpg, actions: 9 };
        mutator.populate(&mut genome, moment);
        assert_eq!(genome.roots().len(), config.tpg.nb_roots);
        let mut deep = 0;
        for (&id, team) in &genome.teams {
            assert!((2..=config.tpg.max_outgoing_edges).contains(&team.edges.len()));
            for edge in &team.edges {
                assert!((1..=config.program.max_program_size).contains(&genome.program(edge.program).lines.len()));
                if let Destination::Team(to) = edge.to {
                    assert!(to < id, "an edge to a younger team could close a cycle");
                    deep += 1;
                }
            }
        }
        assert!(deep > 0, "some edge leads to a team by now");
        assert_eq!(evolved(&config, 8), evolved(&config, 8), "the same seed, the same genome");
    }
}
