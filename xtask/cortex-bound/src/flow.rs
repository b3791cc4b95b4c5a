//! The control flow of one function.

use super::facts::Calls;
use super::instruction::{Kind, Stack, kind, stack};
use super::listing::{Function, Line, Listing};
use super::refusal::Refusal;
use std::collections::{BTreeMap, BTreeSet};

/// The control-flow graph of a function; its nodes are instructions.
#[derive(Clone, Debug)]
pub(super) struct Flow {
    /// Successors of each instruction.
    pub(super) next: Vec<Vec<usize>>,
    /// Functions that each instruction may call, including tail calls, as indices into the listing.
    pub(super) calls: Vec<Vec<usize>>,
    /// Bytes of stack of the function itself.
    pub(super) frame: u64,
}

impl Flow {
    /// Builds the graph of a function of a listing. Unreachable instructions (padding before data) are ignored.
    pub(super) fn new(listing: &Listing, function: &Function, through: &Calls) -> Result<Self, Refusal> {
        let place: BTreeMap<u64, usize> = (function.lines.iter().map(|line| line.address)).zip(0..).collect();
        let count = function.lines.len();
        let mut flow = Self { next: vec![Vec::new(); count], calls: vec![Vec::new(); count], frame: 0 };
        let mut open: Vec<usize> = (0..count.min(1)).collect();
        let mut seen = vec![false; count];
        while let Some(index) = open.pop() {
            if !std::mem::replace(&mut seen[index], true) {
                flow.add(listing, function, &place, through, index)?;
                open.extend(&flow.next[index]);
            }
        }
        if through.contains_key(&function.name) && !function.lines.iter().any(goes_by_register) {
            return Err(Refusal::NotIndirect { function: function.name.clone() });
        }
        Ok(flow)
    }

    /// Returns every function that it may call.
    pub(super) fn callees(&self) -> BTreeSet<usize> {
        self.calls.iter().flatten().copied().collect()
    }

    /// Adds an instruction.
    fn add(
        &mut self,
        listing: &Listing,
        function: &Function,
        place: &BTreeMap<u64, usize>,
        through: &Calls,
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
                    To::Function(callee) => self.calls[index] = vec![callee],
                }
            }
            Kind::Call => {
                self.calls[index] = match target(listing, function, line)? {
                    To::Function(callee) => vec![callee],
                    To::Here(_) => return Err(astray(function, line)),
                };
                // A call that no instruction follows never returns.
                goes_on = follower(function, index).is_some();
            }
            Kind::Return { conditional } => goes_on = conditional,
            Kind::Trap => goes_on = false,
            Kind::Indirect { goes_on: and_on } => {
                let Some(callees) = through.get(&function.name) else {
                    return Err(Refusal::Indirect { function: name(), address, text });
                };
                for callee in callees {
                    let place = listing.named(callee).ok_or_else(|| Refusal::NoFunction { name: callee.clone() })?;
                    self.calls[index].push(place);
                }
                goes_on = and_on;
            }
            Kind::JumpTable => {
                let targets = table(function, line).ok_or(Refusal::JumpTable { function: name(), address, text })?;
                for target in targets {
                    self.next[index].push(*place.get(&target).ok_or_else(|| astray(function, line))?);
                }
                self.next[index].sort_unstable();
                self.next[index].dedup();
                goes_on = false;
            }
        }
        if goes_on {
            self.next[index].push(follower(function, index).ok_or_else(|| astray(function, line))?);
        }
        Ok(())
    }
}

fn goes_by_register(line: &Line) -> bool {
    matches!(kind(line), Kind::Indirect { .. })
}

/// Returns the instruction directly after another one, with no data in between.
fn follower(function: &Function, index: usize) -> Option<usize> {
    let [here, next] = [function.lines.get(index)?, function.lines.get(index + 1)?];
    (next.address - here.address <= 4).then_some(index + 1)
}

/// Returns the targets of a `tbb` or `tbh`: every entry of the table that follows it. Other data in that place is also
/// read as entries, which either adds paths or leads to an invalid target.
fn table(function: &Function, line: &Line) -> Option<Vec<u64>> {
    let width = match line.mnemonic.as_str() {
        "tbb" => 1,
        "tbh" => 2,
        _ => return None,
    };
    if !line.operands.starts_with("[pc,") {
        return None;
    }
    let base = line.address + 4;
    let mut bytes: Vec<u8> = (base..).map_while(|address| function.data.get(&address).copied()).collect();
    // Alignment of the following code, a nop. As entries it would lead into the table, or 97 KB away.
    while bytes.len().is_multiple_of(2) && bytes.ends_with(&[0x00, 0xbf]) {
        bytes.truncate(bytes.len() - 2);
    }
    let entries = bytes.chunks_exact(width).map(|entry| entry.iter().rfold(0, |sum, &byte| sum << 8 | u64::from(byte)));
    // An entry of 0 would lead into the table: it aligns the following code.
    let targets: Vec<u64> = entries.filter(|&entry| entry > 0).map(|entry| base + 2 * entry).collect();
    (!targets.is_empty()).then_some(targets)
}

enum To {
    /// An address within the function.
    Here(u64),
    /// The start of a function.
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
        // A branch to the function's own start is a loop, a call of it is a recursion.
        Some(callee) if kind(line) == Kind::Call || !inside => Ok(To::Function(callee)),
        _ if inside => Ok(To::Here(address)),
        _ => Err(astray(function, line)),
    }
}

fn astray(function: &Function, line: &Line) -> Refusal {
    Refusal::Astray { function: function.name.clone(), address: line.address, text: line.text() }
}
