//! The genome: teams and programs in one arena; a root is a team that no edge leads to.

use super::vocabulary::{Gene, InstructionIndex, OPERANDS, Vocabulary};
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use tpg_engine::{self, Line, Policy};
use tpg_graph::dataflow::effective;

/// A team's number. Numbers only grow: none is ever given twice.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct TeamId(pub u64);

/// A program's number. Numbers only grow: none is ever given twice.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct ProgramId(pub u64);

/// Where an edge leads.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Destination {
    /// To a team.
    Team(TeamId),
    /// To an action.
    Action(u16),
}

/// A program that bids for a destination. Edges of several teams may share a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Edge {
    /// Who bids.
    pub program: ProgramId,
    /// For what.
    pub to: Destination,
}

/// A team; of equal bids the last edge wins.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Team {
    /// Its edges.
    pub edges: Vec<Edge>,
}

/// A line as it evolves.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct GenomeLine {
    /// The instruction's place in its set.
    pub instruction: InstructionIndex,
    /// The register that takes the result.
    pub to: u16,
    /// Its operands; those beyond the instruction's arity are kept but not read.
    pub operands: [Gene; OPERANDS],
}

/// A program as it evolves.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Program {
    /// GEGELATI's program constants (`data/constantHandler.h`).
    pub constants: Vec<f64>,
    /// Its lines.
    pub lines: Vec<GenomeLine>,
}

impl Program {
    /// The lines with every operand looked up.
    pub fn lines(&self, vocabulary: &Vocabulary) -> Vec<Line> {
        let line = |line: &GenomeLine| Line {
            to: line.to,
            instruction: vocabulary.instruction(line.instruction),
            operands: line.operands.map(|gene| vocabulary.read(&gene, &self.constants)),
        };
        self.lines.iter().map(line).collect()
    }

    /// What GEGELATI's `Program::hasIdenticalBehavior` compares: the effective lines, without what they do not read.
    pub fn behaviour(&self, vocabulary: &Vocabulary) -> Vec<Line> {
        let lines = self.lines(vocabulary);
        let effective = effective(vocabulary.registers().into(), &lines);
        let kept = lines.into_iter().zip(effective).filter(|(_, effective)| *effective);
        kept.map(|(line, _)| {
            let [a, b] = line.operands;
            Line { operands: [a, if line.instruction.arity() == 1 { a } else { b }], ..line }
        })
        .collect()
    }
}

/// Teams and programs.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Genome {
    next: u64,
    teams: BTreeMap<TeamId, Team>,
    programs: BTreeMap<ProgramId, Program>,
}

impl Genome {
    /// The teams, by number.
    pub fn teams(&self) -> &BTreeMap<TeamId, Team> {
        &self.teams
    }

    /// A team.
    pub fn team(&self, id: TeamId) -> &Team {
        &self.teams[&id]
    }

    /// A team's edges, to be changed. The caller sees to it that no cycle comes of it: new teams lead to older ones.
    pub fn edges_mut(&mut self, id: TeamId) -> &mut Vec<Edge> {
        &mut self.teams.get_mut(&id).expect("the team exists").edges
    }

    /// A program.
    pub fn program(&self, id: ProgramId) -> &Program {
        &self.programs[&id]
    }

    /// How many programs there are.
    pub fn program_count(&self) -> usize {
        self.programs.len()
    }

    /// Adds a team.
    pub fn add_team(&mut self, team: Team) -> TeamId {
        let id = TeamId(self.number());
        self.teams.insert(id, team);
        id
    }

    /// Adds a program.
    pub fn add_program(&mut self, program: Program) -> ProgramId {
        let id = ProgramId(self.number());
        self.programs.insert(id, program);
        id
    }

    /// Puts another program in a program's place.
    pub fn replace_program(&mut self, id: ProgramId, program: Program) {
        self.programs.insert(id, program);
    }

    fn number(&mut self) -> u64 {
        self.next += 1;
        self.next
    }

    /// The teams that no edge leads to, by number.
    pub fn roots(&self) -> Vec<TeamId> {
        let edges = self.teams.values().flat_map(|team| &team.edges);
        let entered: BTreeSet<TeamId> = edges
            .filter_map(|edge| match edge.to {
                Destination::Team(team) => Some(team),
                Destination::Action(_) => None,
            })
            .collect();
        self.teams.keys().copied().filter(|team| !entered.contains(team)).collect()
    }

    /// Removes roots. Teams that only they led to become roots, as in GEGELATI (`tpgGraph.cpp`, `removeVertex`);
    /// programs that nobody uses any more go.
    pub fn remove_roots(&mut self, roots: &[TeamId]) {
        for root in roots {
            self.teams.remove(root);
        }
        let used: BTreeSet<ProgramId> =
            self.teams.values().flat_map(|team| &team.edges).map(|edge| edge.program).collect();
        self.programs.retain(|id, _| used.contains(id));
    }

    /// The teams that a root reaches, itself included, by number.
    pub fn reachable(&self, root: TeamId) -> BTreeSet<TeamId> {
        let mut reached = BTreeSet::from([root]);
        let mut open = vec![root];
        while let Some(team) = open.pop() {
            for edge in &self.team(team).edges {
                if let Destination::Team(to) = edge.to
                    && reached.insert(to)
                {
                    open.push(to);
                }
            }
        }
        reached
    }

    /// Copies a root with all it reaches from another genome, under new numbers.
    pub fn adopt(&mut self, from: &Self, root: TeamId) -> TeamId {
        let reached = from.reachable(root);
        let mut programs = BTreeMap::new();
        let teams: BTreeMap<TeamId, TeamId> =
            reached.iter().map(|&old| (old, self.add_team(Team::default()))).collect();
        for (&old, &new) in &teams {
            let mut edges = Vec::new();
            for edge in &from.team(old).edges {
                let program = match programs.get(&edge.program) {
                    Some(&program) => program,
                    None => {
                        let program = self.add_program(from.program(edge.program).clone());
                        programs.insert(edge.program, program);
                        program
                    }
                };
                let to = match edge.to {
                    Destination::Team(team) => Destination::Team(teams[&team]),
                    action @ Destination::Action(_) => action,
                };
                edges.push(Edge { program, to });
            }
            *self.edges_mut(new) = edges;
        }
        teams[&root]
    }

    /// A root as the engine takes it.
    pub fn policy(&self, root: TeamId, vocabulary: &Vocabulary) -> Policy {
        let reached: Vec<TeamId> = self.reachable(root).into_iter().collect();
        let place = |id: TeamId| reached.binary_search(&id).expect("the team is reached") as u32;
        let mut programs = Vec::new();
        let mut numbers = BTreeMap::new();
        let mut teams = Vec::new();
        for &team in &reached {
            let edges = self.team(team).edges.iter().map(|edge| {
                let program = *numbers.entry(edge.program).or_insert_with(|| {
                    programs.push(self.program(edge.program).lines(vocabulary));
                    programs.len() as u32 - 1
                });
                let to = match edge.to {
                    Destination::Team(team) => tpg_engine::Destination::Team(place(team)),
                    Destination::Action(action) => tpg_engine::Destination::Action(action),
                };
                tpg_engine::Edge { program, to }
            });
            teams.push(edges.collect());
        }
        let policy = Policy::new(vocabulary.registers(), place(root), teams, programs);
        if vocabulary.bound(0).is_some() { policy.shielded(|action| vocabulary.bound(action)) } else { policy }
    }
}
