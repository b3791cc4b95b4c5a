//! Translation of programs from the numbers of the file to the names of the document.

use super::declared::{OperandText, ProgramLine};
use super::fault::{Fault, refuse};
use crate::Word;
use crate::error::counted;
use crate::import::composed::{FORM, Given, Operator};
use crate::import::sidecar::Sidecar;
use crate::model::{LineDocument, OperandDocument};

/// Context that gives the numbers in a program's lines their meaning.
#[derive(Clone, Copy, Debug)]
pub(super) struct Meaning<'d> {
    pub(super) sidecar: &'d Sidecar,
    /// Constants of the program. If programs have any, they are source 1, before the environment's sources.
    pub(super) constants: &'d [f64],
    /// Constants of the lines, as many for each; empty where no instruction reads one.
    pub(super) of_lines: &'d [f64],
}

impl Meaning<'_> {
    /// Translates all lines of the program.
    pub(super) fn lines(&self, lines: &[ProgramLine]) -> Result<Vec<LineDocument>, Fault> {
        let each = self.of_lines.len().checked_div(lines.len()).unwrap_or(0);
        if each * lines.len() != self.of_lines.len() {
            let found = format!("{} on {}", counted(self.of_lines.len(), "constant"), counted(lines.len(), "line"));
            return refuse(found, "as many for each line: instructions of the sidecar read k0");
        }
        let mut document = Vec::new();
        for (place, line) in (1..).zip(lines) {
            let constants = &self.of_lines[(place - 1) * each..place * each];
            self.line(line, constants, &mut document)
                .map_err(|fault| Fault::new(format!("program line {place}: {}", fault.found), fault.accepted))?;
        }
        Ok(document)
    }

    fn line(&self, line: &ProgramLine, constants: &[f64], document: &mut Vec<LineDocument>) -> Result<(), Fault> {
        let Some(Operator { name, value, windows }) = self.sidecar.instructions().get(line.instruction as usize) else {
            let known: Vec<&str> = self.sidecar.instructions().iter().map(|operator| &*operator.name).collect();
            let known = known.join(", ");
            let accepted = format!("0 to {}: {known}", self.sidecar.instructions().len() - 1);
            return refuse(format!("instruction {}", line.instruction), accepted);
        };
        let Some(value) = value else {
            let found = format!("instruction {}, {name}, whose meaning the sidecar does not give", line.instruction);
            return refuse(found, format!("{{ name = {name:?}, is = … }} in the sidecar, {FORM}"));
        };
        if line.to >= self.sidecar.registers() {
            let accepted = format!("0 to {}", self.sidecar.registers() - 1);
            return refuse(format!("register {}", line.to), accepted);
        }
        // Operands beyond the arity are present in the file but never read.
        let arity = value.arity();
        let Some(operands) = line.operands.get(..arity).filter(|_| arity <= line.written) else {
            let found = format!("{} of {name}", counted(line.written, "operand"));
            let has_constants = !self.constants.is_empty() || !constants.is_empty();
            let hint = match Word::from_name(name) {
                None if has_constants => "; constants of the line itself are k0 to k3, not operands",
                _ => "",
            };
            return refuse(found, format!("at least {arity}{hint}"));
        };
        let needed = value.constants();
        if constants.len() < needed {
            let found = format!("{} of a line for {name}", counted(constants.len(), "constant"));
            return refuse(found, format!("at least {needed}"));
        }
        let operands = (operands.iter().zip(windows))
            .map(|(operand, window)| match window.as_slice() {
                [] => Ok(vec![self.operand(*operand)?]),
                window => self.window(*operand, window),
            })
            .collect::<Result<Vec<_>, _>>()?;
        value.lines(Given { operands: &operands, constants }, line.to, self.sidecar.registers(), document);
        Ok(())
    }

    /// Translates an operand. GEGELATI takes every location modulo the size of its source, so every number is valid.
    fn operand(&self, operand: OperandText) -> Result<OperandDocument, Fault> {
        let first = if self.constants.is_empty() { 1 } else { 2 };
        let place = |size: usize| (operand.location % size as u64) as usize;
        if operand.source == 0 {
            return Ok(OperandDocument::Place(format!("r{}", place(self.sidecar.registers() as usize))));
        }
        let Some(index) = (operand.source as usize).checked_sub(first) else {
            return Ok(OperandDocument::Constant(self.constants[place(self.constants.len())]));
        };
        match self.sidecar.document().sources.get(index) {
            Some(source) => Ok(OperandDocument::Place(format!("{}[{}]", source.name, place(source.ranges.len())))),
            None => refuse(format!("source {}", operand.source), self.sources(first)),
        }
    }

    /// Translates a window on an array: its values, row by row. Windows of a source are numbered row by row, too.
    fn window(&self, operand: OperandText, window: &[u32]) -> Result<Vec<OperandDocument>, Fault> {
        let first = if self.constants.is_empty() { 1 } else { 2 };
        let (name, [rows, columns]) = match (operand.source as usize).checked_sub(first) {
            _ if operand.source == 0 => (None, [1, self.sidecar.registers()]),
            None => return refuse("a window on the constants", "a source of numbers, or the registers"),
            Some(index) => match self.sidecar.document().sources.get(index) {
                Some(source) => (Some(&source.name), self.sidecar.shapes()[index].unwrap_or([1, source.length])),
                None => return refuse(format!("source {}", operand.source), self.sources(first)),
            },
        };
        let [height, width] = match *window {
            [width] => [1, width],
            [height, width] => [height, width],
            _ => return refuse(format!("a window of {} dimensions", window.len()), "1 or 2"),
        };
        let (Some(down), Some(across)) = (rows.checked_sub(height), columns.checked_sub(width)) else {
            let found = format!("a window of {height} by {width} on {rows} by {columns} values");
            return refuse(found, "a window that is not larger than its source");
        };
        let across = u64::from(across) + 1;
        let place = operand.location % ((u64::from(down) + 1) * across);
        let (row, column) = ((place / across) as u32, (place % across) as u32);
        let values =
            (row..row + height).flat_map(|row| (column..column + width).map(move |column| row * columns + column));
        Ok(values
            .map(|value| {
                OperandDocument::Place(name.map_or_else(|| format!("r{value}"), |name| format!("{name}[{value}]")))
            })
            .collect())
    }

    /// Lists all sources by number, for messages.
    fn sources(&self, first: usize) -> String {
        let constants = if self.constants.is_empty() { "" } else { ", 1 constants" };
        let named: Vec<String> = (first..)
            .zip(&self.sidecar.document().sources)
            .map(|(number, source)| format!(", {number} {}", source.name))
            .collect();
        format!("0 registers{constants}{}", named.concat())
    }
}
