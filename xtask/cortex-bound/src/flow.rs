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
                match target(listing, function, line)? {
                    To::Function(callee) => {
                        self.calls[index] = vec![callee];
                        let callee = &listing.functions()[callee].name;
                        if callee.starts_with("__gnu_thumb1_case") {
                            let targets = table(function, line, callee);
                            let targets = targets.ok_or(Refusal::JumpTable { function: name(), address, text })?;
                            self.jump(function, place, index, targets)?;
                            goes_on = false;
                        } else {
                            // A call that no instruction follows never returns.
                            goes_on = follower(function, index).is_some();
                        }
                    }
                    // Thumb of a Cortex-M0 jumps far by `bl`, in functions that have saved the register of the return.
                    To::Here(address) if function.saves_return() => {
                        self.next[index].push(*place.get(&address).ok_or_else(|| astray(function, line))?);
                        goes_on = false;
                    }
                    To::Here(_) => return Err(astray(function, line)),
                }
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
                let targets = table(function, line, "").or_else(|| table_elsewhere(listing, function, index));
                let targets = targets.ok_or(Refusal::JumpTable { function: name(), address, text })?;
                self.jump(function, place, index, targets)?;
                goes_on = false;
            }
        }
        if goes_on {
            self.next[index].push(follower(function, index).ok_or_else(|| astray(function, line))?);
        }
        Ok(())
    }

    /// Adds the targets of a table.
    fn jump(
        &mut self,
        function: &Function,
        place: &BTreeMap<u64, usize>,
        index: usize,
        targets: Vec<u64>,
    ) -> Result<(), Refusal> {
        for target in targets {
            self.next[index].push(*place.get(&target).ok_or_else(|| astray(function, &function.lines[index]))?);
        }
        self.next[index].sort_unstable();
        self.next[index].dedup();
        Ok(())
    }
}

fn goes_by_register(line: &Line) -> bool {
    matches!(kind(line), Kind::Indirect { .. })
}

/// Returns the instruction directly after another one, with no data in between.
fn follower(function: &Function, index: usize) -> Option<usize> {
    let [here, next] = [function.lines.get(index)?, function.lines.get(index + 1)?];
    (1..=4).contains(&next.address.wrapping_sub(here.address)).then_some(index + 1)
}

/// Returns the addresses outside a function at which it goes on without a call: the middles of others that it branches to, and what
/// follows its end.
pub(super) fn continues_at(function: &Function) -> BTreeSet<u64> {
    let end = function.lines.last();
    // Behind the last instruction there may be padding.
    let acts = function.lines.iter().rev().find(|line| !line.mnemonic.starts_with("nop"));
    let runs_on = acts.is_some_and(|line| match kind(line) {
        Kind::Plain => true,
        Kind::Branch { conditional } | Kind::Return { conditional } => conditional,
        _ => false,
    });
    let after = |line: &Line| [line.address + 2, line.address + 4];
    let branches =
        function.lines.iter().filter(|line| matches!(kind(line), Kind::Branch { .. }) && line.symbol.is_none());
    let targets = branches.filter_map(address).chain(end.filter(|_| runs_on).into_iter().flat_map(after));
    let inside: BTreeSet<u64> = function.lines.iter().map(|line| line.address).collect();
    targets.filter(|target| !inside.contains(target)).collect()
}

/// Returns the address that an instruction branches to, its last operand: `10 <f+0x8>`.
fn address(line: &Line) -> Option<u64> {
    let operands = line.operands.split(" <").next().unwrap_or_default();
    u64::from_str_radix(operands.rsplit(',').next().unwrap_or_default().trim(), 16).ok()
}

/// Returns the targets of a `tbb` or `tbh`, or of a call of the function that does the same on a Cortex-M0: every entry of the table that
/// follows it. Other data behind it ends the table, or adds paths.
fn table(function: &Function, line: &Line, callee: &str) -> Option<Vec<u64>> {
    let (width, is_signed) = match (line.mnemonic.as_str(), callee) {
        ("tbb", _) | (_, "__gnu_thumb1_case_uqi") => (1, false),
        ("tbh", _) | (_, "__gnu_thumb1_case_uhi") => (2, false),
        (_, "__gnu_thumb1_case_sqi") => (1, true),
        (_, "__gnu_thumb1_case_shi") => (2, true),
        (_, "__gnu_thumb1_case_si") => (4, true),
        _ => return None,
    };
    if kind(line) != Kind::Call && !line.operands.starts_with("[pc,") {
        return None;
    }
    // Entries are in halfwords, but those of four bytes, which are aligned.
    let (base, unit) = if width == 4 { ((line.address + 4).next_multiple_of(4), 1) } else { (line.address + 4, 2) };
    let bytes: Vec<u8> = (base..).map_while(|address| function.data.get(&address).copied()).collect();
    let number = |entry: &[u8]| match *entry {
        [byte] if is_signed => i64::from(byte.cast_signed()),
        [byte] => i64::from(byte),
        [low, high] if is_signed => i64::from(i16::from_le_bytes([low, high])),
        [low, high] => i64::from(u16::from_le_bytes([low, high])),
        [a, b, c, d] => i64::from(i32::from_le_bytes([a, b, c, d]) & !1),
        _ => 0,
    };
    let addresses: BTreeSet<u64> = function.lines.iter().map(|line| line.address).collect();
    let targets = bytes.chunks_exact(width).map(|entry| base.wrapping_add_signed(unit * number(entry)));
    let targets: Vec<u64> = targets.take_while(|target| addresses.contains(target)).collect();
    (!targets.is_empty()).then_some(targets)
}

/// Returns the targets of a jump whose table lies elsewhere: the one whose address goes into the jump, or any whose address the function
/// computes. An entry is a target, or its distance from the table.
fn table_elsewhere(listing: &Listing, function: &Function, index: usize) -> Option<Vec<u64>> {
    let addresses: BTreeSet<u64> = function.lines.iter().map(|line| line.address).collect();
    let starts: BTreeSet<u64> =
        listing.functions().iter().flat_map(|function| &function.lines).filter_map(|line| line.refers_to).collect();
    let target = |base: u64, word: u32| {
        let targets = [word & !1, word.wrapping_add(base as u32)].map(u64::from);
        targets.into_iter().find(|target| addresses.contains(target))
    };
    let table = |address: u64| -> Vec<u64> {
        // Thumb reads the table's address from beside the code.
        let bases = [Some(address), listing.words_from(address).next().map(u64::from)];
        // What the code refers to next is another table or a constant.
        let end = |base| starts.range(base + 1..).next().copied().unwrap_or(u64::MAX);
        let words = |base| (base..end(base)).step_by(4).zip(listing.words_from(base)).map(|(_, word)| word);
        let entries = |base| words(base).map_while(|word| target(base, word)).collect::<Vec<u64>>();
        bases.into_iter().flatten().map(entries).find(|entries| !entries.is_empty()).unwrap_or_default()
    };
    let found = |lines: &mut dyn Iterator<Item = &Line>| {
        lines.filter_map(|line| line.refers_to).flat_map(&table).collect::<Vec<u64>>()
    };
    // The registers that the address comes from, backwards to the last branch.
    let mut from: BTreeSet<&str> = registers(&function.lines[index].operands).collect();
    for line in function.lines[..index].iter().rev().take_while(|line| kind(line) == Kind::Plain) {
        if written(line).is_some_and(|register| from.remove(register)) {
            let nearest = found(&mut std::iter::once(line));
            if !nearest.is_empty() {
                return Some(nearest);
            }
            from.extend(registers(&line.operands).skip(1));
        }
    }
    let earlier = found(&mut function.lines.iter().filter(|line| written(line).is_some_and(|to| from.contains(to))));
    let all = || found(&mut function.lines.iter());
    let targets = if earlier.is_empty() { all() } else { earlier };
    (!targets.is_empty()).then_some(targets)
}

/// Returns the names among operands: registers, and the names of shifts.
fn registers(operands: &str) -> impl Iterator<Item = &str> {
    let names = operands.split(|c: char| !c.is_ascii_alphanumeric());
    names.filter(|name| name.starts_with(|c: char| c.is_ascii_lowercase()))
}

/// Returns the register that an instruction writes: its first operand, but for stores and comparisons.
fn written(line: &Line) -> Option<&str> {
    let reads = ["sw", "sh", "sb", "fsw", "cmp", "cmn", "tst", "teq", "push", "vcmp"];
    let name = line.mnemonic.trim_end_matches(".n").trim_end_matches(".w");
    let is_read = reads.contains(&name) || name.starts_with("st") || name.starts_with("vst");
    registers(&line.operands).next().filter(|_| !is_read)
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
    let address = address(line).ok_or_else(|| astray(function, line))?;
    let inside = function.lines.iter().any(|line| line.address == address);
    match listing.at(&function.section, address) {
        // A branch to the function's own start is a loop, a call of it is a recursion.
        Some(callee) if kind(line) == Kind::Call || address != function.address => Ok(To::Function(callee)),
        _ if inside => Ok(To::Here(address)),
        _ => Err(astray(function, line)),
    }
}

fn astray(function: &Function, line: &Line) -> Refusal {
    Refusal::Astray { function: function.name.clone(), address: line.address, text: line.text() }
}
