//! Conversion of a graph to the document that `graph.json` holds.

use super::document::{
    Document, EdgeDocument, FORMAT, LeafDocument, LineDocument, MemoryDocument, OperandDocument, OutputDocument,
    ProgramDocument, TeamDocument,
};
use super::graph::{Destination, Edge, Graph, Line, Operand, Output, ProgramId};

impl Graph {
    /// Converts the graph to a document.
    pub fn to_document(&self) -> Document {
        let operand = |operand: &Operand| match *operand {
            Operand::Register(reg) => OperandDocument::Place(format!("r{}", reg.0)),
            Operand::Input(input) => OperandDocument::Place(self.input_name(input)),
            Operand::Constant(value) => OperandDocument::Constant(value),
        };
        let edge = |edge: &Edge| {
            let mut document = EdgeDocument { program: self.program(edge.program).label, ..EdgeDocument::default() };
            match edge.to {
                Destination::Team(id) => document.team = Some(self.team(id).label),
                Destination::Action(id) => match self.leaves.get(usize::from(id.0)) {
                    Some(leaf) => document.leaf = Some(leaf.label),
                    None => document.action = Some(u32::from(id.0)),
                },
            }
            document
        };
        let line = |line: &Line| LineDocument {
            to: u32::from(line.to.0),
            op: line.instruction.name().to_owned(),
            args: line.operands.iter().take(line.instruction.arity()).map(operand).collect(),
        };
        let (outputs, memory) = self.outputs.split_at(self.outputs.len() - self.memory);
        Document {
            format: FORMAT.to_owned(),
            version: if self.outputs.is_empty() && !self.has_counts() && !self.sees() { 1 } else { 2 },
            scalar: self.scalar,
            maths: self.maths,
            registers: u32::from(self.registers),
            sources: self.observed().to_vec(),
            instructions: self.instructions.iter().map(|i| i.name().to_owned()).collect(),
            actions: self.actions.clone(),
            outputs: outputs.iter().map(output_document).collect(),
            memory: memory.iter().map(memory_document).collect(),
            root: (!self.is_formula).then(|| self.team(self.root).label),
            teams: (self.teams.iter().filter(|_| !self.is_formula))
                .map(|team| TeamDocument { id: team.label, edges: team.edges.iter().map(edge).collect() })
                .collect(),
            leaves: (self.leaves.iter())
                .map(|leaf| {
                    let labels = |programs: &[ProgramId]| programs.iter().map(|&id| self.program(id).label).collect();
                    let (programs, memory) = leaf.programs.split_at(outputs.len());
                    LeafDocument { id: leaf.label, programs: labels(programs), memory: labels(memory) }
                })
                .collect(),
            programs: (self.programs.iter())
                .map(|program| ProgramDocument { id: program.label, lines: program.lines.iter().map(line).collect() })
                .collect(),
            provenance: self.provenance.clone(),
        }
    }
}

fn output_document(output: &Output) -> OutputDocument {
    let Output { name, unit, range, nan, counts } = output;
    let (name, unit) = (name.clone(), unit.clone());
    OutputDocument { name, unit, min: range.min, max: range.max, nan: *nan, counts: *counts }
}

fn memory_document(memory: &Output) -> MemoryDocument {
    let Output { name, range, nan, .. } = memory;
    MemoryDocument { name: name.clone(), min: range.min, max: range.max, initial: *nan }
}
