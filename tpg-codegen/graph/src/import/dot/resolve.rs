//! Translation of statements to a document: numbers of the file become names and ids.

use super::declared::{Declared, DeclaredAction, DeclaredEdge, DotNode, NodeKind};
use super::fault::Fault;
use super::leaves;
use super::program::Meaning;
use crate::error::{InputError, counted};
use crate::import::sidecar::Sidecar;
use crate::model::{Document, EdgeDocument, ProgramDocument, Provenance, TeamDocument};
use std::collections::{BTreeMap, BTreeSet};

/// The program of the file from which each program with an id of its own is made.
pub(super) type Bases = BTreeMap<u32, u32>;

pub(super) struct Resolver<'s> {
    pub(super) file: &'s str,
    pub(super) sidecar: &'s Sidecar,
    pub(super) declared: Declared,
}

impl Resolver<'_> {
    /// Builds the document; the graph's validation checks what does not concern the format.
    pub(super) fn document(&self) -> Result<(Document, Bases), InputError> {
        self.links()?;
        let (mut teams, mut programs) = (self.teams()?, self.programs()?);
        let root = self.root(&teams)?;
        let (leaves, bases) =
            if self.has_values() { leaves::resolve(self, &mut teams, &mut programs)? } else { Default::default() };
        let mut provenance = Provenance::default();
        if let Some((tool, version)) = &self.declared.exporter {
            provenance.tool = Some(tool.clone());
            provenance.version = Some(version.clone());
        }
        Ok((Document { root, teams, leaves, programs, provenance, ..self.sidecar.document().clone() }, bases))
    }

    /// Returns the line of what a JSON path names in the document; `None` if the path leads into the sidecar.
    pub(super) fn line(&self, path: &str, document: &Document, bases: &Bases) -> Option<usize> {
        let declared = &self.declared;
        let mut steps = path.split(['.', '[', ']']).filter(|step| !step.is_empty() && *step != "$");
        let list = steps.next()?;
        let index = steps.next().and_then(|index| index.parse::<usize>().ok()).unwrap_or(usize::MAX);
        let inner = steps.next();
        let line = match list {
            "root" => {
                declared.rank.as_ref().map(|rank| rank.line).or_else(|| declared.teams.get(&document.root?).copied())
            }
            "teams" => declared.teams.get_index(index).map(|(team, line)| {
                let mut edges = declared.edges.iter().filter(|edge| edge.team == *team);
                let edge = steps.next().and_then(|place| edges.nth(place.parse().ok()?));
                edge.map_or(*line, |edge| edge.line)
            }),
            "leaves" => document.leaves.get(index).and_then(|leaf| Some(declared.actions.get(&leaf.id)?.line)),
            "programs" => document.programs.get(index).and_then(|program| {
                let number = *bases.get(&program.id).unwrap_or(&program.id);
                let lines = declared.lines.get(&number).filter(|_| inner == Some("lines"));
                Some(lines.map_or(declared.programs.get(&number)?.line, |lines| lines.line))
            }),
            _ => return None,
        };
        Some(line.unwrap_or(declared.close))
    }

    pub(super) fn refuse<T>(
        &self,
        line: usize,
        found: impl Into<String>,
        accepted: impl Into<String>,
    ) -> Result<T, InputError> {
        Err(Fault::new(found, accepted).on(self.file, line))
    }

    /// Tests for a policy that answers with values.
    fn has_values(&self) -> bool {
        !self.sidecar.document().outputs.is_empty()
    }

    /// Checks the links. They are redundant, but the nodes that they name must exist.
    fn links(&self) -> Result<(), InputError> {
        let missing = self.declared.links.iter().find(|(_, program)| !self.declared.programs.contains_key(program));
        missing.map_or(Ok(()), |(line, program)| {
            self.refuse(*line, format!("P{program}, which does not exist"), "a program that the file declares")
        })
    }

    /// Builds the teams. Each team keeps its edges in file order, which decides ties.
    fn teams(&self) -> Result<Vec<TeamDocument>, InputError> {
        let empty = |&id: &u32| TeamDocument { id, edges: Vec::new() };
        let mut teams: Vec<TeamDocument> = self.declared.teams.keys().map(empty).collect();
        // GEGELATI clones a program before it changes the destination, so an edge without one is unambiguous.
        let mut destinations = BTreeMap::new();
        for edge in &self.declared.edges {
            if let Some(to) = edge.to {
                destinations.entry(edge.program).or_insert(to);
            }
        }
        for &DeclaredEdge { line, team, program, to } in &self.declared.edges {
            let Some(place) = self.declared.teams.get_index_of(&team) else {
                return self.refuse(line, format!("T{team}, which does not exist"), "a team that the file declares");
            };
            let Some(to) = to.or_else(|| destinations.get(&program).copied()) else {
                let found = format!("T{team} -> P{program}, and no edge that says where P{program} leads");
                return self.refuse(line, found, format!("T{team} -> P{program} -> a team or an action"));
            };
            teams[place].edges.push(self.edge(line, program, to)?);
        }
        Ok(teams)
    }

    fn edge(&self, line: usize, program: u32, to: DotNode) -> Result<EdgeDocument, InputError> {
        let edge = EdgeDocument { program, ..EdgeDocument::default() };
        if to.kind == NodeKind::Team {
            return Ok(EdgeDocument { team: Some(to.number), ..edge });
        }
        let Some(DeclaredAction { labels, programs, line, .. }) = self.declared.actions.get(&to.number) else {
            return self.refuse(line, format!("{to}, which does not exist"), "an action that the file declares");
        };
        match labels.as_slice() {
            _ if self.has_values() => Ok(EdgeDocument { leaf: Some(to.number), ..edge }),
            &[action] if programs.is_empty() => Ok(EdgeDocument { action: Some(action), ..edge }),
            _ => {
                let accepted = "actions without programs, or outputs instead of actions in the sidecar";
                self.refuse(*line, format!("{to}, whose programs compute values"), accepted)
            }
        }
    }

    fn programs(&self) -> Result<Vec<ProgramDocument>, InputError> {
        let mut programs = Vec::new();
        let mut constants_of_first = None;
        for (number, node) in &self.declared.programs {
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
            let of_lines = if self.sidecar.constants_of_lines() { content.constants.as_slice() } else { &[] };
            let meaning = Meaning { sidecar: self.sidecar, constants, of_lines };
            let document = meaning.lines(&content.lines).map_err(|fault| fault.on(self.file, content.line))?;
            programs.push(ProgramDocument { id: *number, lines: document });
        }
        Ok(programs)
    }

    /// Finds the root: the one that the file declares, or else, as in the export of a sub-graph, the first team without
    /// incoming edges. A file without teams has none.
    fn root(&self, teams: &[TeamDocument]) -> Result<Option<u32>, InputError> {
        let Some(rank) = &self.declared.rank else {
            let entered: BTreeSet<u32> =
                teams.iter().flat_map(|team| &team.edges).filter_map(|edge| edge.team).collect();
            let free = teams.iter().find(|team| !entered.contains(&team.id));
            return Ok(free.or(teams.first()).map(|team| team.id));
        };
        match *rank.roots.as_slice() {
            [DotNode { kind: NodeKind::Team, number }] => Ok(Some(number)),
            [DotNode { kind: NodeKind::Action, number }]
                if teams.is_empty() && self.declared.actions.contains_key(&number) =>
            {
                Ok(None)
            }
            ref roots => {
                let names: Vec<String> = roots.iter().map(DotNode::to_string).collect();
                let found = if names.is_empty() {
                    "no root".to_owned()
                } else {
                    format!("{} as the root", names.join(" and "))
                };
                self.refuse(rank.line, found, "one team, or the one action of a file without teams")
            }
        }
    }
}
