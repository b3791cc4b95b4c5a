//! Outputs and leaves: the part of a document that makes a policy answer with values.

use super::{KnownNames, MAX_NUMBERED, Validator};
use crate::error::{InputError, counted};
use crate::model::document::{MemoryDocument, OutputDocument};
use crate::model::graph::Destination;
use crate::model::graph::{Edge, Leaf, Output, Range, Team};
use std::collections::{BTreeMap, BTreeSet};
use tpg_runtime::policy::ActionId;

impl Validator<'_> {
    pub(super) fn outputs(&self) -> Result<Vec<Output>, InputError> {
        let document = self.document;
        if document.outputs.is_empty() {
            return Ok(Vec::new());
        }
        let found = || counted(document.outputs.len(), "output");
        if document.version < 2 {
            return self.refuse("$.outputs", found(), "none in version 1: a policy with outputs is version 2");
        }
        if !document.actions.is_empty() {
            let found = format!("{} beside {}", counted(document.actions.len(), "action"), found());
            return self.refuse("$.actions", found, "either \"actions\" or \"outputs\"");
        }
        if document.outputs.len() > MAX_NUMBERED {
            return self.refuse("$.outputs", found(), format!("1 to {MAX_NUMBERED}"));
        }
        let mut names = BTreeSet::new();
        (document.outputs.iter().enumerate())
            .map(|(index, output)| {
                let path = format!("$.outputs[{index}]");
                let output = self.output(&path, "nan", output)?;
                if names.insert(output.name.clone()) {
                    return Ok(output);
                }
                let found = format!("{:?} a second time", output.name);
                self.refuse(format!("{path}.name"), found, "a name that no other output has")
            })
            .collect()
    }

    /// Checks an output; `nan` is the name of the field that holds its value in place of NaN.
    fn output(&self, path: &str, field: &str, output: &OutputDocument) -> Result<Output, InputError> {
        let OutputDocument { name, unit, min, max, nan, counts } = output;
        self.name_and_unit(path, name, unit)?;
        let scalar = self.document.scalar.name();
        if !(min <= max && self.is_exact(*min) && self.is_exact(*max)) {
            let accepted = format!("min not above max, both finite and exact in {scalar}");
            return self.refuse(path, format!("min {min} and max {max}"), accepted);
        }
        if !((min..=max).contains(&nan) && self.is_exact(*nan)) {
            let accepted = format!("a number from {min} to {max}, exact in {scalar}");
            return self.refuse(format!("{path}.{field}"), nan.to_string(), accepted);
        }
        self.output_counts(path, output)?;
        let range = Range { min: *min, max: *max };
        Ok(Output { name: name.clone(), unit: unit.clone(), range, nan: *nan, counts: *counts })
    }

    /// Checks the memory, and adds to `sources` how programs read it: behind the sources, one value each.
    pub(super) fn memory<'d>(
        &'d self,
        sources: &mut BTreeMap<&'d str, (usize, usize)>,
    ) -> Result<Vec<Output>, InputError> {
        let document = self.document;
        if !document.memory.is_empty() && document.outputs.is_empty() {
            let found = format!("{} of a policy without outputs", counted(document.memory.len(), "value"));
            return self.refuse("$.memory", found, "\"outputs\" beside them: leaves compute the memory");
        }
        let mut next = sources.values().map(|(_, length)| length).sum();
        (document.memory.iter().enumerate())
            .map(|(index, MemoryDocument { name, min, max, initial })| {
                let path = format!("$.memory[{index}]");
                let as_output = OutputDocument {
                    name: name.clone(),
                    unit: "memory".to_owned(),
                    min: *min,
                    max: *max,
                    nan: *initial,
                    counts: None,
                };
                let memory = self.output(&path, "initial", &as_output)?;
                let is_output = document.outputs.iter().any(|output| output.name == *name);
                if is_output || sources.insert(name, (next, 1)).is_some() {
                    let found = format!("{name:?} a second time");
                    let accepted = "a name that no source, no output and no other value of the memory has";
                    return self.refuse(format!("{path}.name"), found, accepted);
                }
                next += 1;
                if next > MAX_NUMBERED {
                    let found = format!("{next} values with those of the sources");
                    return self.refuse(path, found, format!("1 to {MAX_NUMBERED} values"));
                }
                Ok(memory)
            })
            .collect()
    }

    pub(super) fn leaf_ids(&self) -> Result<BTreeMap<u32, ActionId>, InputError> {
        let count = self.document.leaves.len();
        if count > MAX_NUMBERED {
            return self.refuse("$.leaves", format!("{count} leaves"), format!("1 to {MAX_NUMBERED}"));
        }
        self.numbered("leaves", self.document.leaves.iter().map(|leaf| leaf.id), |index| ActionId(index as u16))
    }

    pub(super) fn leaves(&self, names: &KnownNames<'_>) -> Result<Vec<Leaf>, InputError> {
        let (leaves, outputs) = (&self.document.leaves, self.document.outputs.len());
        match (outputs, leaves.len()) {
            (0, 0) => return Ok(Vec::new()),
            (0, count) => {
                let found = format!("{count} leaves of a policy without outputs");
                return self.refuse("$.leaves", found, "\"outputs\" beside them");
            }
            (_, 0) => return self.refuse("$.leaves", "an empty list", "at least one leaf: there are outputs"),
            _ => {}
        }
        (leaves.iter().enumerate())
            .map(|(index, leaf)| {
                let path = format!("$.leaves[{index}].programs");
                if leaf.programs.len() != outputs {
                    let found = counted(leaf.programs.len(), "program");
                    return self.refuse(path, found, format!("{outputs}, one for each output"));
                }
                let of_memory = format!("$.leaves[{index}].memory");
                let memory = self.document.memory.len();
                if leaf.memory.len() != memory {
                    let found = counted(leaf.memory.len(), "program");
                    return self.refuse(of_memory, found, format!("{memory}, one for each value of the memory"));
                }
                let outputs = (leaf.programs.iter().enumerate()).map(|(place, id)| (format!("{path}[{place}]"), *id));
                let memory = (leaf.memory.iter().enumerate()).map(|(place, id)| (format!("{of_memory}[{place}]"), *id));
                let program = |(path, id)| self.known(path, "program", &names.programs, id);
                let programs = outputs.chain(memory).map(program).collect::<Result<_, _>>()?;
                Ok(Leaf { label: leaf.id, programs })
            })
            .collect()
    }

    pub(super) fn every_leaf_is_reached(&self, teams: &[Team]) -> Result<(), InputError> {
        let ends = teams.iter().flat_map(|team| &team.edges).map(|edge| edge.to);
        let reached: BTreeSet<Destination> = ends.collect();
        let is_reached = |index: usize| reached.contains(&Destination::Action(ActionId(index as u16)));
        match self.document.leaves.iter().enumerate().find(|&(index, _)| !is_reached(index)) {
            Some((index, leaf)) => {
                let found = format!("leaf {}, which no edge leads to", leaf.id);
                self.refuse(format!("$.leaves[{index}]"), found, "leaves that some edge leads to")
            }
            None => Ok(()),
        }
    }

    /// Tests for a leaf without a team, where nothing needs to be decided.
    pub(super) fn is_formula(&self) -> Result<bool, InputError> {
        let document = self.document;
        if document.outputs.is_empty() || !document.teams.is_empty() {
            return Ok(false);
        }
        if document.leaves.len() > 1 {
            let found = format!("no team to choose among {} leaves", document.leaves.len());
            return self.refuse("$.teams", found, "at least one team, or a single leaf");
        }
        match document.root {
            Some(root) => self.refuse("$.root", format!("team {root}, but there are no teams"), "no root"),
            None => Ok(true),
        }
    }
}

impl Team {
    /// Makes the team that stands for a leaf without a team: its only edge leads there, so its bid does not matter.
    pub(super) fn leading_to(leaf: &Leaf) -> Self {
        let edge = Edge { program: leaf.programs[0], to: Destination::Action(ActionId(0)) };
        Self { label: 0, edges: vec![edge] }
    }
}
