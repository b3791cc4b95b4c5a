//! Translation of programs from the numbers of the file to the names of the document.

use super::Fault;
use super::statement::{OperandText, ProgramLine};
use crate::error::counted;
use crate::model::{Document, LineDocument, OperandDocument};
use tpg_runtime::ops::Instruction;

/// Context that gives the numbers in a program's lines their meaning.
#[derive(Clone, Copy, Debug)]
pub(super) struct Meaning<'d> {
    /// The document described by the sidecar.
    pub(super) document: &'d Document,
    /// The same instruction set as the runtime's instructions.
    pub(super) instructions: &'d [Instruction],
    /// Constants of the program. If programs have any, they are source 1, before the environment's sources.
    pub(super) constants: &'d [f64],
}

impl Meaning<'_> {
    /// Translates all lines of the program.
    pub(super) fn lines(&self, lines: &[ProgramLine]) -> Result<Vec<LineDocument>, Fault> {
        (1..)
            .zip(lines)
            .map(|(place, line)| {
                self.line(line)
                    .map_err(|fault| Fault::new(format!("program line {place}: {}", fault.found), fault.accepted))
            })
            .collect()
    }

    fn line(&self, line: &ProgramLine) -> Result<LineDocument, Fault> {
        let Some(instruction) = self.instructions.get(line.instruction as usize) else {
            let known = self.document.instructions.join(", ");
            let accepted = format!("0 to {}: {known}", self.instructions.len() - 1);
            return Err(Fault::new(format!("instruction {}", line.instruction), accepted));
        };
        if line.to >= self.document.registers {
            let accepted = format!("0 to {}", self.document.registers - 1);
            return Err(Fault::new(format!("register {}", line.to), accepted));
        }
        // Operands beyond the arity are present in the file but never read.
        let Some(operands) = line.operands.get(..instruction.arity()).filter(|_| instruction.arity() <= line.written)
        else {
            let found = format!("{} of {}", counted(line.written, "operand"), instruction.name());
            return Err(Fault::new(found, format!("at least {}", instruction.arity())));
        };
        let args = operands.iter().map(|operand| self.operand(*operand)).collect::<Result<_, _>>()?;
        Ok(LineDocument { to: line.to, op: instruction.name().to_owned(), args })
    }

    /// Translates an operand. GEGELATI takes every location modulo the size of its source, so every number is valid.
    fn operand(&self, operand: OperandText) -> Result<OperandDocument, Fault> {
        let first = if self.constants.is_empty() { 1 } else { 2 };
        let place = |size: usize| (operand.location % size as u64) as usize;
        if operand.source == 0 {
            return Ok(OperandDocument::Place(format!("r{}", place(self.document.registers as usize))));
        }
        let Some(index) = (operand.source as usize).checked_sub(first) else {
            return Ok(OperandDocument::Constant(self.constants[place(self.constants.len())]));
        };
        match self.document.sources.get(index) {
            Some(source) => Ok(OperandDocument::Place(format!("{}[{}]", source.name, place(source.ranges.len())))),
            None => Err(Fault::new(format!("source {}", operand.source), self.sources(first))),
        }
    }

    /// Lists all sources by number, for messages.
    fn sources(&self, first: usize) -> String {
        let constants = if self.constants.is_empty() { "" } else { ", 1 constants" };
        let named: Vec<String> = (first..)
            .zip(&self.document.sources)
            .map(|(number, source)| format!(", {number} {}", source.name))
            .collect();
        format!("0 registers{constants}{}", named.concat())
    }
}
