//! Leaves: the programs of GEGELATI's continuous actions, one for each output.
//!
//! GEGELATI takes a value from register 0 or from another one, and squashes it. Here a value is register 0 of a program, so
//! a program that leaves it elsewhere, or whose value is squashed, gets a copy with lines that follow.

use super::declared::DeclaredAction;
use super::resolve::{Bases, Resolver};
use crate::Word;
use crate::error::{InputError, counted};
use crate::import::composed::Given;
use crate::import::sidecar::Values;
use crate::model::{LeafDocument, LineDocument, OperandDocument, ProgramDocument, TeamDocument};
use std::collections::{BTreeMap, BTreeSet};

/// Builds the leaves, and adds the programs that only they need; these are made of others.
pub(super) fn resolve(
    resolver: &Resolver<'_>,
    teams: &mut [TeamDocument],
    programs: &mut Vec<ProgramDocument>,
) -> Result<(Vec<LeafDocument>, Bases), InputError> {
    let next = programs.iter().map(|program| program.id).max().unwrap_or(0).saturating_add(1);
    let mut builder = LeafBuilder { resolver, programs, next, made: BTreeMap::new() };
    let leaves = match resolver.sidecar.values() {
        Values::Bid => builder.of_bids(teams)?,
        Values::Programs | Values::Registers => builder.of_actions(teams)?,
    };
    let bases = builder.made.into_iter().filter_map(|((base, ..), made)| Some((made, base?))).collect();
    // Some programs only stood for their copies.
    let bidding = teams.iter().flat_map(|team| &team.edges).map(|edge| edge.program);
    let used: BTreeSet<u32> = bidding.chain(leaves.iter().flat_map(|leaf| leaf.programs.iter().copied())).collect();
    programs.retain(|program| used.contains(&program.id));
    Ok((leaves, bases))
}

struct LeafBuilder<'b, 's> {
    resolver: &'b Resolver<'s>,
    programs: &'b mut Vec<ProgramDocument>,
    /// The next free id of a program.
    next: u32,
    /// The id of the program that computes an output from a register of another program.
    made: BTreeMap<(Option<u32>, u32, usize), u32>,
}

impl LeafBuilder<'_, '_> {
    fn outputs(&self) -> usize {
        self.resolver.sidecar.activations().len()
    }

    /// Builds a leaf of each action node that the graph reaches.
    fn of_actions(&mut self, teams: &[TeamDocument]) -> Result<Vec<LeafDocument>, InputError> {
        let reached: BTreeSet<u32> = teams.iter().flat_map(|team| &team.edges).filter_map(|edge| edge.leaf).collect();
        let resolver = self.resolver;
        let mut leaves = Vec::new();
        for (node, action) in &resolver.declared.actions {
            if teams.is_empty() || reached.contains(node) {
                leaves.push(LeafDocument { id: *node, programs: self.of_action(*node, action)?, memory: Vec::new() });
            }
        }
        Ok(leaves)
    }

    fn of_action(&mut self, node: u32, action: &DeclaredAction) -> Result<Vec<u32>, InputError> {
        let DeclaredAction { line, labels, programs } = action;
        let count = programs.len();
        let refused = |found: String, accepted: String| self.resolver.refuse(*line, found, accepted);
        if self.resolver.sidecar.values() == Values::Registers {
            return match programs.as_slice() {
                &[program] => {
                    Ok((0..self.outputs()).map(|output| self.program(Some(program), output as u32, output)).collect())
                }
                _ => refused(
                    format!("A{node} with {}", counted(count, "program")),
                    "one, whose registers are the values".to_owned(),
                ),
            };
        }
        if labels.len() != count {
            let found = format!(
                "A{node} with {} and {} in its label",
                counted(count, "program"),
                counted(labels.len(), "number")
            );
            return refused(found, format!("A{node} -> P… for each number"));
        }
        let mut computed = vec![None; self.outputs()];
        for (&label, &program) in labels.iter().zip(programs) {
            let most = self.outputs() - 1;
            let Some(place) = computed.get_mut(label as usize) else {
                return refused(
                    format!("A{node} computes value {label}"),
                    format!("0 to {most}: the sidecar has no other output"),
                );
            };
            if place.replace(program).is_some() {
                return refused(format!("A{node} computes value {label} a second time"), "each value once".to_owned());
            }
        }
        // GEGELATI's values are 0 where no program computes them.
        Ok(computed.into_iter().enumerate().map(|(output, program)| self.program(program, 0, output)).collect())
    }

    /// Builds a leaf for each program that bids for an action: other registers of it are the values.
    fn of_bids(&mut self, teams: &mut [TeamDocument]) -> Result<Vec<LeafDocument>, InputError> {
        let (mut leaves, mut known) = (Vec::new(), BTreeSet::new());
        for edge in teams.iter_mut().flat_map(|team| &mut team.edges) {
            let Some(node) = edge.leaf else { continue };
            let action = self.resolver.declared.actions.get(&node);
            if let Some(DeclaredAction { line, programs, .. }) = action.filter(|action| !action.programs.is_empty()) {
                let found = format!("A{node} with {}", counted(programs.len(), "program"));
                let accepted = "actions without programs, or another field \"values\" in the sidecar";
                return self.resolver.refuse(*line, found, accepted);
            }
            let program = edge.program;
            edge.leaf = Some(program);
            if known.insert(program) {
                let values = 0..self.outputs();
                let programs = values.map(|output| self.program(Some(program), output as u32 + 1, output)).collect();
                leaves.push(LeafDocument { id: program, programs, memory: Vec::new() });
            }
        }
        if leaves.is_empty() {
            let accepted = "edges to actions: the values are registers of the programs that bid for them";
            return self.resolver.refuse(
                self.resolver.declared.close,
                "a graph without an edge to an action",
                accepted,
            );
        }
        Ok(leaves)
    }

    /// Returns the program whose result is an output: the register of another program, or 0 without one, as the output's
    /// activation leaves it.
    fn program(&mut self, program: Option<u32>, register: u32, output: usize) -> u32 {
        let sidecar = self.resolver.sidecar;
        let activation = sidecar.activations()[output].as_ref();
        if let (Some(program), 0, None) = (program, register, activation) {
            return program;
        }
        // Outputs with the same activation share a program.
        let same = sidecar.activations().iter().position(|other| other.as_ref() == activation).unwrap_or(output);
        let key = (program, register, same);
        if let Some(&made) = self.made.get(&key) {
            return made;
        }
        let base = self.programs.iter().find(|base| Some(base.id) == program);
        let mut lines = base.map_or_else(Vec::new, |base| base.lines.clone());
        let value = |register: u32| OperandDocument::Place(format!("r{register}"));
        if register > 0 {
            lines.push(LineDocument { to: 0, op: Word::Copy.name().to_owned(), args: vec![value(register)] });
        }
        if let Some(activation) = activation {
            let given = Given { operands: &[vec![value(0)]], constants: &[] };
            activation.lines(given, 0, sidecar.registers(), &mut lines);
        }
        let id = self.next;
        self.next = self.next.saturating_add(1);
        self.programs.push(ProgramDocument { id, lines });
        self.made.insert(key, id);
        id
    }
}
