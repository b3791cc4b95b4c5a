//! Translation of statements to a document: numbers of the file become names and ids.

use super::declared::{Action, Declared, Edge, Kind, Node, Rank};
use super::fault::Fault;
use super::lines::{Lines, ProgramLines, TeamLines};
use super::program::Meaning;
use crate::error::{InputError, counted};
use crate::import::sidecar::Sidecar;
use crate::model::{Document, EdgeDocument, ProgramDocument, TeamDocument};
use std::collections::BTreeMap;

/// Destination of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum EdgeEnd {
    Team(u32),
    Action(u32),
    /// By the number of its node.
    Leaf(u32),
}

pub(super) struct Resolver<'s> {
    pub(super) file: &'s str,
    /// The document described by the sidecar.
    pub(super) document: &'s Document,
    pub(super) sidecar: &'s Sidecar,
    pub(super) declared: Declared,
}

impl Resolver<'_> {
    pub(super) fn error(&self, line: usize, found: impl Into<String>, accepted: impl Into<String>) -> InputError {
        Fault::new(found, accepted).on(self.file, line)
    }

    pub(super) fn refuse<T>(
        &self,
        line: usize,
        found: impl Into<String>,
        accepted: impl Into<String>,
    ) -> Result<T, InputError> {
        Err(self.error(line, found, accepted))
    }

    /// Tests for a policy that answers with values.
    pub(super) fn has_values(&self) -> bool {
        !self.document.outputs.is_empty()
    }

    pub(super) fn is_something(&self) -> Result<(), InputError> {
        let missing = |what: &str| self.refuse(self.declared.close, format!("a graph without {what}"), "at least one");
        match (self.declared.teams.items(), self.declared.programs.items()) {
            ([], _) if !self.has_values() => missing("teams"),
            (_, []) => missing("programs"),
            _ => Ok(()),
        }
    }

    /// Checks the links. They are redundant, but the nodes that they name must exist.
    pub(super) fn links(&self) -> Result<(), InputError> {
        self.declared.links.iter().try_for_each(|&(line, program)| self.program_exists(line, program))
    }

    fn program_exists(&self, line: usize, program: u32) -> Result<(), InputError> {
        match self.declared.programs.place(program) {
            Some(_) => Ok(()),
            None => self.refuse(line, format!("P{program}, which does not exist"), "a program that the file declares"),
        }
    }

    /// Builds the teams. Each team keeps its edges in file order, which decides ties.
    pub(super) fn teams(&self, lines: &mut Lines) -> Result<Vec<TeamDocument>, InputError> {
        let destinations = self.destinations()?;
        let mut teams = Vec::new();
        for team in self.declared.teams.items() {
            teams.push(TeamDocument { id: team.number, edges: Vec::new() });
            lines.teams.push(TeamLines { node: team.line, edges: Vec::new() });
        }
        for &Edge { line, team, program, .. } in &self.declared.edges {
            let Some(place) = self.declared.teams.place(team) else {
                return Err(self.no_team(line, team));
            };
            self.program_exists(line, program)?;
            let Some((destination, _)) = destinations.get(&program) else {
                let found = format!("T{team} -> P{program}, and no edge that says where P{program} leads");
                return self.refuse(line, found, format!("T{team} -> P{program} -> a team or an action"));
            };
            let mut edge = EdgeDocument { program, ..EdgeDocument::default() };
            match *destination {
                EdgeEnd::Team(team) => edge.team = Some(team),
                EdgeEnd::Action(action) => edge.action = Some(action),
                EdgeEnd::Leaf(leaf) => edge.leaf = Some(leaf),
            }
            teams[place].edges.push(edge);
            lines.teams[place].edges.push(line);
        }
        Ok(teams)
    }

    /// Finds the destination of each program and the line that states it. GEGELATI clones a program before it changes
    /// the destination, so an edge without a destination is unambiguous.
    fn destinations(&self) -> Result<BTreeMap<u32, (EdgeEnd, usize)>, InputError> {
        let mut destinations = BTreeMap::new();
        for &Edge { line, program, to, .. } in &self.declared.edges {
            let Some(to) = to else { continue };
            let destination = self.destination(line, to)?;
            let (first, first_line) = *destinations.entry(program).or_insert((destination, line));
            if first != destination {
                let name = |destination| match destination {
                    EdgeEnd::Team(team) => format!("T{team}"),
                    EdgeEnd::Action(action) => format!("action {action}"),
                    EdgeEnd::Leaf(node) => format!("A{node}"),
                };
                let found =
                    format!("P{program} leads to {}, and on line {first_line} to {}", name(destination), name(first));
                return self.refuse(line, found, "one destination for each program");
            }
        }
        Ok(destinations)
    }

    fn destination(&self, line: usize, to: Node) -> Result<EdgeEnd, InputError> {
        let Node { kind, number } = to;
        if kind == Kind::Team {
            let exists = self.declared.teams.place(number).is_some();
            return if exists { Ok(EdgeEnd::Team(number)) } else { Err(self.no_team(line, number)) };
        }
        match self.declared.actions.get(number) {
            Some(_) if self.has_values() => Ok(EdgeEnd::Leaf(number)),
            Some(Action { labels, programs, line, .. }) => match labels.as_slice() {
                &[action] if programs.is_empty() => Ok(EdgeEnd::Action(action)),
                _ => {
                    let accepted = "actions without programs, or outputs instead of actions in the sidecar";
                    self.refuse(*line, format!("{to}, whose programs compute values"), accepted)
                }
            },
            None => self.refuse(line, format!("{to}, which does not exist"), "an action that the file declares"),
        }
    }

    fn no_team(&self, line: usize, team: u32) -> InputError {
        self.error(line, format!("T{team}, which does not exist"), "a team that the file declares")
    }

    pub(super) fn programs(&self, lines: &mut Lines) -> Result<Vec<ProgramDocument>, InputError> {
        let mut programs = Vec::new();
        let mut constants_of_first = None;
        for node in self.declared.programs.items() {
            let number = node.number;
            let Some(content) = self.declared.lines.get(number) else {
                let accepted = format!("`I{number} [… label=\"…\"]`, with an empty label for no lines");
                return self.refuse(node.line, format!("P{number} without its lines I{number}"), accepted);
            };
            let (constants, line) = match (node.constants.as_slice(), content.constants.as_slice()) {
                (integers, []) => (integers, node.line),
                (integers, _) if self.sidecar.constants_of_lines() => (integers, node.line),
                ([], reals) => (reals, content.line),
                _ => {
                    let accepted = format!("constants in one place, on line {} or here", node.line);
                    return self.refuse(content.line, format!("constants of P{number} a second time"), accepted);
                }
            };
            // The number of constants determines the meaning of source numbers, so it must be the same for all
            // programs.
            let (first, first_line) = *constants_of_first.get_or_insert((constants.len(), line));
            if constants.len() != first {
                let accepted = format!("as many in each program: {first} on line {first_line}");
                return self.refuse(line, counted(constants.len(), "constant"), accepted);
            }
            let meaning = Meaning {
                document: self.document,
                instructions: self.sidecar.instructions(),
                shapes: self.sidecar.shapes(),
                registers: self.sidecar.registers(),
                constants,
                of_lines: if self.sidecar.constants_of_lines() { &content.constants } else { &[] },
            };
            let document = meaning.lines(&content.lines).map_err(|fault| fault.on(self.file, content.line))?;
            programs.push(ProgramDocument { id: number, lines: document });
            lines.programs.push(ProgramLines { node: node.line, lines: content.line });
        }
        Ok(programs)
    }

    /// Finds the root. It is the root that the file declares, if any (the export of a sub-graph declares none), and it
    /// must be the only team without incoming edges. The graph's validation checks that there is exactly one such team.
    pub(super) fn root(&self, teams: &[TeamDocument], lines: &mut Lines) -> Result<Option<u32>, InputError> {
        if teams.is_empty() {
            return self.only_action().map(|()| None);
        }
        let mut entered = vec![false; teams.len()];
        for edge in teams.iter().flat_map(|team| &team.edges) {
            if let Some(place) = edge.team.and_then(|team| self.declared.teams.place(team)) {
                entered[place] = true;
            }
        }
        let mut free = (0..teams.len()).filter(|&place| !entered[place]);
        let (first, second) = (free.next(), free.next());
        let Some(rank) = &self.declared.rank else {
            let root = first.unwrap_or(0);
            lines.root = lines.teams[root].node;
            return Ok(Some(teams[root].id));
        };
        lines.root = rank.line;
        let root = self.ranked(rank)?;
        match (first, second) {
            (Some(only), None) if teams[only].id != root => {
                let found = format!("T{root} as the root, and edges that lead to it");
                self.refuse(rank.line, found, format!("T{}, the one team that no edge leads to", teams[only].id))
            }
            _ => Ok(Some(root)),
        }
    }

    /// Checks that a file without teams has one action, its root.
    fn only_action(&self) -> Result<(), InputError> {
        let actions = self.declared.actions.items();
        let [action] = actions else {
            let line = actions.get(1).map_or(self.declared.close, |action| action.line);
            return self.refuse(line, format!("{} and no team", counted(actions.len(), "action")), "one action");
        };
        match &self.declared.rank {
            Some(Rank { line, roots }) => match roots.as_slice() {
                &[root] if (root.kind, root.number) == (Kind::Action, action.node) => Ok(()),
                [root] => {
                    let accepted = format!("A{}, the only action", action.node);
                    self.refuse(*line, format!("{root} as the root"), accepted)
                }
                _ => self.refuse(*line, counted(roots.len(), "root"), "one"),
            },
            None => Ok(()),
        }
    }

    fn ranked(&self, rank: &Rank) -> Result<u32, InputError> {
        match rank.roots.as_slice() {
            &[Node { kind: Kind::Team, number }] if self.declared.teams.place(number).is_some() => Ok(number),
            &[Node { kind: Kind::Team, number }] => Err(self.no_team(rank.line, number)),
            [] => self.refuse(rank.line, "no root", "one team"),
            [node] => self.refuse(rank.line, format!("{node} as the root"), "a team"),
            roots => {
                let names: Vec<String> = roots.iter().map(Node::to_string).collect();
                self.refuse(rank.line, format!("{} roots: {}", roots.len(), names.join(" ")), "one team")
            }
        }
    }
}
