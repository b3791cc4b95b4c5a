//! The first population, and children of roots, with GEGELATI's choices (`mutator/tpgMutator.cpp`).

use super::children::add_children;
use super::genome::{Destination, Edge, Genome, ProgramId, TeamId};
use super::mutate_program::P_PROGRAM_MUTATION;
use super::stage::{Context, Moment};
use tpg_engine::random::{Purpose, Stream};

/// GEGELATI's probabilities of deleting and adding one more edge, each less likely by that factor than the one before; the first of
/// each is certain.
const P_EDGE_DELETION: f64 = 0.7;
const P_EDGE_ADDITION: f64 = 0.7;

/// The teams and programs that existed before any child: children lead only to these, so no cycle can arise.
struct EarlierEdges<'a> {
    teams: &'a [TeamId],
    edges: &'a [Edge],
}

impl Context<'_> {
    /// Creates a random population (`TPGMutator::initRandomTPG`).
    ///
    /// Each root gets two programs for two different actions, and up to `maxInitOutgoingEdges` − 2 programs of other roots:
    /// of two candidates, the one used by fewer teams.
    pub(super) fn random_teams(&self, stream: &mut Stream) -> Genome {
        let mut genome = Genome::default();
        let parameters = &self.config.tpg;
        let (roots, actions) = (parameters.init_nb_roots, usize::from(self.actions));
        let programs: Vec<ProgramId> = (0..2 * roots).map(|_| genome.add_program(self.random(stream))).collect();
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
            genome.add_team(edges);
        }
        genome
    }

    /// Adds children, mutated copies of roots; some are changed only a little, or get opposite bids.
    pub(super) fn populate_teams(&self, genome: &mut Genome, moment: Moment) {
        let teams: Vec<TeamId> = genome.teams.keys().copied().collect();
        let edges: Vec<Edge> = genome.teams.values().flatten().copied().collect();
        let before = EarlierEdges { teams: &teams, edges: &edges };
        let mut to_mutate = Vec::new();
        add_children(genome, self.config.tpg.nb_roots, moment, |genome, parent, stream| {
            let close = self.refined_child(genome, parent, stream);
            let close = close.or_else(|| self.mirrored_child(genome, parent, &edges, stream));
            let close = close.or_else(|| self.mutated_child(genome, parent, stream));
            close.unwrap_or_else(|| {
                let edges = genome.team(parent).to_vec();
                let edges = self.mutated_edges(genome, edges, &before, &mut to_mutate, stream);
                genome.add_team(edges)
            })
        });
        for (index, new) in (0..).zip(&to_mutate) {
            let mut program = genome.program(*new).clone();
            self.mutate(&mut program, &mut moment.stream(Purpose::Program, index));
            genome.programs.insert(*new, program);
        }
    }

    /// Mutates the edges of a team (`TPGMutator::mutateTPGTeam`).
    fn mutated_edges(
        &self,
        genome: &mut Genome,
        mut edges: Vec<Edge>,
        before: &EarlierEdges<'_>,
        to_mutate: &mut Vec<ProgramId>,
        stream: &mut Stream,
    ) -> Vec<Edge> {
        let mut probability = 1.0;
        while edges.len() > 2 && probability > stream.unit() {
            edges.remove(stream.below(edges.len()));
            probability *= P_EDGE_DELETION;
        }
        let mut probability = 1.0;
        while edges.len() < self.config.tpg.max_outgoing_edges && probability > stream.unit() {
            edges.push(*stream.pick(before.edges));
            probability *= P_EDGE_ADDITION;
        }
        let mut any = false;
        while !any {
            for edge in &mut edges {
                if stream.chance(P_PROGRAM_MUTATION) {
                    self.mutate_edge(genome, edge, before, to_mutate, stream);
                    any = true;
                }
            }
        }
        edges
    }

    /// Mutates an edge (`TPGMutator::mutateOutgoingEdge`): replaces its program by a copy to be mutated, and may change the
    /// destination.
    fn mutate_edge(
        &self,
        genome: &mut Genome,
        edge: &mut Edge,
        before: &EarlierEdges<'_>,
        to_mutate: &mut Vec<ProgramId>,
        stream: &mut Stream,
    ) {
        let copy = genome.add_program(genome.program(edge.program).clone());
        to_mutate.push(copy);
        edge.program = copy;
        if stream.chance(self.config.tpg.p_edge_destination_change) {
            edge.to = if stream.chance(self.config.tpg.p_edge_destination_is_action) {
                Destination::Action(stream.below(self.actions.into()) as u16)
            } else {
                Destination::Team(*stream.pick(before.teams))
            };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Moment;
    use crate::configuration::Configuration as _;
    use crate::evolution::config::EvolutionConfig;
    use crate::evolution::genome::{Destination, Genome, ProgramId};
    use crate::evolution::tests::context;
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
        let mutator = context(config, &vocabulary, 9, &[]);
        let mut genome = mutator.random_teams(&mut Stream::new(1, 0, Purpose::Test, 0));
        for generation in 0..generations {
            mutator.populate_teams(&mut genome, Moment { seed: 1, generation });
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
            assert!((2..=config.tpg.max_init_outgoing_edges).contains(&team.len()));
            if place < 9 {
                let actions = [0, 1].map(|edge| Destination::Action(((place + edge) % 9) as u16));
                assert_eq!([team[0].to, team[1].to], actions, "actions are spread over the first roots");
            }
            let mut programs: Vec<ProgramId> = team.iter().map(|edge| edge.program).collect();
            programs.sort_unstable();
            programs.dedup();
            assert_eq!(programs.len(), team.len(), "a team's first programs are different ones");
        }
    }

    #[test]
    fn children_fill_the_population_lead_only_to_older_teams_and_keep_the_limits() {
        let config = config();
        let vocabulary = vocabulary(&config);
        let mut genome = evolved(&config, 8);
        let mutator = context(&config, &vocabulary, 9, &[]);
        mutator.populate_teams(&mut genome, Moment { seed: 1, generation: 9 });
        assert_eq!(genome.roots().len(), config.tpg.nb_roots);
        let mut deep = 0;
        for (&id, team) in &genome.teams {
            assert!((2..=config.tpg.max_outgoing_edges).contains(&team.len()));
            for edge in team {
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
