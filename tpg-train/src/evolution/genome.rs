//! The genome: teams and programs in one arena. A root is a team without incoming edges.

use super::vocabulary::{Gene, InstructionIndex, OPERANDS, SourceKind, Vocabulary};
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use tpg_engine::{self, Line, PolicyGraph};
use tpg_graph::dataflow::{Assignment, effective};

/// Number of a team. Numbers only increase and are never reused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub(crate) struct TeamId(pub u64);

/// Number of a program. Numbers only increase and are never reused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub(crate) struct ProgramId(pub u64);

/// Number of a leaf. Numbers only increase and are never reused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub(crate) struct LeafId(pub u64);

/// Destination of an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub(crate) enum Destination {
    /// A team.
    Team(TeamId),
    /// An action.
    Action(u16),
    /// A leaf, where there are outputs in place of actions.
    Leaf(LeafId),
}

/// A program that bids for a destination. Edges of several teams may share a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Edge {
    /// The bidding program.
    pub program: ProgramId,
    /// The destination it bids for.
    pub to: Destination,
}

/// A line of an evolving program.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct GenomeLine {
    /// Index of the instruction in its set.
    pub instruction: InstructionIndex,
    /// Destination register.
    pub to: u16,
    /// Its operands; those beyond the instruction's arity are kept but not read.
    pub operands: [Gene; OPERANDS],
}

impl GenomeLine {
    /// Iterates over the literals that it reads.
    pub(crate) fn literals<'l>(&'l mut self, vocabulary: &'l Vocabulary) -> impl Iterator<Item = &'l mut f64> {
        let genes = self.operands.iter_mut().take(vocabulary.instruction(self.instruction).arity());
        genes.filter(|gene| vocabulary.kind(gene.source) == SourceKind::Literal).map(|gene| &mut gene.literal)
    }
}

/// An evolving program.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Program {
    /// Its lines.
    pub lines: Vec<GenomeLine>,
}

impl Program {
    /// Tells of each line whether register 0, the bid, depends on it.
    pub(crate) fn effective(&self, vocabulary: &Vocabulary) -> Vec<bool> {
        let lines: Vec<Spelled<'_>> = self.lines.iter().map(|line| Spelled { line, vocabulary }).collect();
        effective(vocabulary.registers.into(), &lines)
    }

    /// Returns the effective lines with every operand resolved; they are few of a long program's lines.
    pub(crate) fn lines(&self, vocabulary: &Vocabulary) -> Vec<Line> {
        let mut lines = Vec::new();
        for line in self.effective_lines(vocabulary) {
            vocabulary.spell(line.instruction, line.to, &line.operands, &mut lines);
        }
        lines
    }

    /// Iterates over the lines that reach the bid.
    pub(crate) fn effective_lines(&self, vocabulary: &Vocabulary) -> impl Iterator<Item = &GenomeLine> {
        self.lines.iter().zip(self.effective(vocabulary)).filter(|(_, effective)| *effective).map(|(line, _)| line)
    }
}

/// A line with the vocabulary that says what it reads.
struct Spelled<'a> {
    line: &'a GenomeLine,
    vocabulary: &'a Vocabulary,
}

impl Assignment for Spelled<'_> {
    fn writes(&self) -> usize {
        self.line.to.into()
    }

    fn reads(&self) -> impl Iterator<Item = usize> {
        let Self { line, vocabulary } = *self;
        let instruction = vocabulary.instruction(line.instruction);
        let genes = line.operands.iter().take(instruction.arity());
        let registers = genes.filter_map(|gene| vocabulary.register(gene).map(usize::from));
        registers.chain(instruction.reads_destination().then(|| self.writes()))
    }
}

/// All teams and programs of a population.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Genome {
    next: u64,
    /// The edges of each team; among equal bids the last one wins. The caller must not create a cycle: edges of new teams lead to
    /// older ones.
    pub teams: BTreeMap<TeamId, Vec<Edge>>,
    /// The programs.
    pub programs: BTreeMap<ProgramId, Program>,
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    leaves: BTreeMap<LeafId, Vec<ProgramId>>,
}

impl Genome {
    /// Returns the programs of each leaf, in the order of the outputs.
    pub(crate) fn leaves(&self) -> &BTreeMap<LeafId, Vec<ProgramId>> {
        &self.leaves
    }

    /// Adds a leaf: the program of each output.
    pub(crate) fn add_leaf(&mut self, programs: Vec<ProgramId>) -> LeafId {
        let id = LeafId(self.number());
        self.leaves.insert(id, programs);
        id
    }

    /// Returns the edges of a team.
    pub(crate) fn team(&self, id: TeamId) -> &[Edge] {
        &self.teams[&id]
    }

    /// Returns a program.
    pub(crate) fn program(&self, id: ProgramId) -> &Program {
        &self.programs[&id]
    }

    /// Adds a team.
    pub(crate) fn add_team(&mut self, edges: Vec<Edge>) -> TeamId {
        let id = TeamId(self.number());
        self.teams.insert(id, edges);
        id
    }

    /// Adds a program.
    pub(crate) fn add_program(&mut self, program: Program) -> ProgramId {
        let id = ProgramId(self.number());
        self.programs.insert(id, program);
        id
    }

    fn number(&mut self) -> u64 {
        self.next += 1;
        self.next
    }

    /// Returns the teams without incoming edges, by number.
    pub(crate) fn roots(&self) -> Vec<TeamId> {
        let edges = self.teams.values().flatten();
        let entered: BTreeSet<TeamId> = edges
            .filter_map(|edge| match edge.to {
                Destination::Team(team) => Some(team),
                Destination::Action(_) | Destination::Leaf(_) => None,
            })
            .collect();
        self.teams.keys().copied().filter(|team| !entered.contains(team)).collect()
    }

    /// Removes roots. Teams that only they led to become roots, as in GEGELATI (`tpgGraph.cpp`, `removeVertex`); unused
    /// leaves and programs are removed.
    pub(crate) fn remove_roots(&mut self, roots: &[TeamId]) {
        for root in roots {
            self.teams.remove(root);
        }
        let edges = || self.teams.values().flatten();
        let reached: BTreeSet<Destination> = edges().map(|edge| edge.to).collect();
        let mut used: BTreeSet<ProgramId> = edges().map(|edge| edge.program).collect();
        self.leaves.retain(|&id, _| reached.contains(&Destination::Leaf(id)));
        used.extend(self.leaves.values().flatten());
        self.programs.retain(|id, _| used.contains(id));
    }

    /// Returns the teams reachable from a root, including itself, by number.
    pub(crate) fn reachable(&self, root: TeamId) -> BTreeSet<TeamId> {
        let mut reached = BTreeSet::from([root]);
        let mut open = vec![root];
        while let Some(team) = open.pop() {
            for edge in self.team(team) {
                if let Destination::Team(to) = edge.to
                    && reached.insert(to)
                {
                    open.push(to);
                }
            }
        }
        reached
    }

    /// Converts a root to an engine policy.
    pub(crate) fn policy(&self, root: TeamId, vocabulary: &Vocabulary) -> PolicyGraph {
        self.policy_of(root, vocabulary, &mut BTreeMap::new())
    }

    /// Converts roots to engine policies, each program once.
    pub(crate) fn policies(&self, roots: &[TeamId], vocabulary: &Vocabulary) -> Vec<PolicyGraph> {
        let mut known = BTreeMap::new();
        roots.iter().map(|&root| self.policy_of(root, vocabulary, &mut known)).collect()
    }

    fn policy_of(
        &self,
        root: TeamId,
        vocabulary: &Vocabulary,
        known: &mut BTreeMap<ProgramId, Arc<[Line]>>,
    ) -> PolicyGraph {
        let reached: Vec<TeamId> = self.reachable(root).into_iter().collect();
        let place = |id: TeamId| reached.binary_search(&id).expect("the team is reached") as u32;
        let mut programs = Vec::new();
        let mut numbers = BTreeMap::new();
        let mut teams = Vec::new();
        let (mut leaves, mut leaf_numbers) = (Vec::new(), BTreeMap::new());
        let mut number = |id: ProgramId| {
            *numbers.entry(id).or_insert_with(|| {
                let lines = || self.program(id).lines(vocabulary).into();
                programs.push(Arc::clone(known.entry(id).or_insert_with(lines)));
                programs.len() as u32 - 1
            })
        };
        for &team in &reached {
            let edges = self.team(team).iter().map(|edge| {
                let program = number(edge.program);
                let to = match edge.to {
                    Destination::Team(team) => tpg_engine::Destination::Team(place(team)),
                    Destination::Action(action) => tpg_engine::Destination::Action(action),
                    Destination::Leaf(leaf) => {
                        tpg_engine::Destination::Action(*leaf_numbers.entry(leaf).or_insert_with(|| {
                            leaves.push(self.leaves[&leaf].iter().map(|&id| number(id)).collect());
                            leaves.len() as u16 - 1
                        }))
                    }
                };
                tpg_engine::Edge { program, to }
            });
            teams.push(edges.collect());
        }
        PolicyGraph::with_programs(vocabulary.policy_registers(), place(root), teams, programs)
            .with_outputs(vocabulary.outputs.to_vec(), leaves)
    }
}

#[cfg(test)]
mod tests {
    use super::{Program, Vocabulary};

    impl Program {
        /// Returns its bid in a state, in `f64`.
        pub(in crate::evolution) fn bid(&self, vocabulary: &Vocabulary, state: &[f64]) -> f64 {
            use tpg_runtime::ops::Own;
            let mut arena = tpg_engine::Arena::<f64, Own>::default();
            let bid = arena.program(vocabulary.policy_registers(), &self.lines(vocabulary));
            let mut values: Vec<f64> = Vec::new();
            for node in arena.nodes() {
                values.push(match *node {
                    tpg_engine::Node::Input(input) => state[usize::from(input)],
                    tpg_engine::Node::Constant(value) => value,
                    tpg_engine::Node::Operation(word, a, b) => {
                        word.apply::<f64, Own>(values[a.index()], values[b.index()])
                    }
                });
            }
            values[bid.index()]
        }
    }
}
