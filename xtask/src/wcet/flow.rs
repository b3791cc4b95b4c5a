//! The control flow of one function.

use super::instruction::{Kind, Stack, kind, stack};
use super::listing::{Function, Line, Listing};
use super::refusal::Refusal;
use std::collections::BTreeMap;

/// A function as a graph: its instructions are the nodes.
#[derive(Clone, Debug)]
pub(super) struct Flow {
    /// The instructions that may follow each.
    pub(super) next: Vec<Vec<usize>>,
    /// The function that each calls, a call at the end included: its place in the listing.
    pub(super) calls: Vec<Option<usize>>,
    /// Bytes of stack of the function itself.
    pub(super) frame: u64,
}

impl Flow {
    /// Of a function of a listing. What cannot be reached (padding before data) is left out.
    pub(super) fn of(listing: &Listing, function: &Function) -> Result<Self, Refusal> {
        let place: BTreeMap<u64, usize> = (function.lines.iter().map(|line| line.address)).zip(0..).collect();
        let count = function.lines.len();
        let mut flow = Self { next: vec![Vec::new(); count], calls: vec![None; count], frame: 0 };
        let mut open: Vec<usize> = (0..count.min(1)).collect();
        let mut seen = vec![false; count];
        while let Some(index) = open.pop() {
            if !std::mem::replace(&mut seen[index], true) {
                flow.add(listing, function, &place, index)?;
                open.extend(&flow.next[index]);
            }
        }
        Ok(flow)
    }

    /// Adds an instruction.
    fn add(
        &mut self,
        listing: &Listing,
        function: &Function,
        place: &BTreeMap<u64, usize>,
        index: usize,
    ) -> Result<(), Refusal> {
        let line = &function.lines[index];
        let name = || function.name.clone();
        let (address, text) = (line.address, line.text());
        match stack(line) {
            Stack::Same => {}
            Stack::Down(bytes) => self.frame += bytes,
            Stack::Unknown => return Err(Refusal::DynamicStack { function: name(), address, text }),
        }
        let mut goes_on = true;
        match kind(line) {
            Kind::Plain => {}
            Kind::Branch { conditional } => {
                goes_on = conditional;
                match target(listing, function, line)? {
                    To::Here(address) => {
                        self.next[index].push(*place.get(&address).ok_or_else(|| astray(function, line))?);
                    }
                    To::Function(callee) => self.calls[index] = Some(callee),
                }
            }
            Kind::Call => {
                self.calls[index] = match target(listing, function, line)? {
                    To::Function(callee) => Some(callee),
                    To::Here(_) => return Err(astray(function, line)),
                };
                // What follows no instruction is never come back to: the callee does not return.
                goes_on = follower(function, index).is_some();
            }
            Kind::Return { conditional } => goes_on = conditional,
            Kind::Trap => goes_on = false,
            Kind::Indirect => return Err(Refusal::Indirect { function: name(), address, text }),
            Kind::JumpTable => return Err(Refusal::JumpTable { function: name(), address, text }),
        }
        if goes_on {
            self.next[index].push(follower(function, index).ok_or_else(|| astray(function, line))?);
        }
        Ok(())
    }
}

/// The instruction right behind another, without data between them.
fn follower(function: &Function, index: usize) -> Option<usize> {
    let [here, next] = [function.lines.get(index)?, function.lines.get(index + 1)?];
    (next.address - here.address <= 4).then_some(index + 1)
}

enum To {
    /// An address in the function itself.
    Here(u64),
    /// A function's beginning.
    Function(usize),
}

fn target(listing: &Listing, function: &Function, line: &Line) -> Result<To, Refusal> {
    if let Some(symbol) = &line.symbol {
        return listing.named(symbol).map(To::Function).ok_or_else(|| Refusal::NotHere {
            function: function.name.clone(),
            address: line.address,
            callee: symbol.clone(),
        });
    }
    // The last operand is the target: `10 <f+0x8>`.
    let operand = line.operands.rsplit(", ").next().unwrap_or_default();
    let number = operand.split_whitespace().next().unwrap_or_default();
    let address = u64::from_str_radix(number, 16).map_err(|_| astray(function, line))?;
    let inside = function.lines.iter().any(|line| line.address == address);
    match listing.at(&function.section, address) {
        // A branch to the own beginning is a loop, a call of it a recursion.
        Some(callee) if kind(line) == Kind::Call || !inside => Ok(To::Function(callee)),
        _ if inside => Ok(To::Here(address)),
        _ => Err(astray(function, line)),
    }
}

fn astray(function: &Function, line: &Line) -> Refusal {
    Refusal::Astray { function: function.name.clone(), address: line.address, text: line.text() }
}
