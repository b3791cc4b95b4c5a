//! The control flow of one function.

use super::facts::Calls;
use super::instruction::{Kind::*, Stack, kind, stack};
use super::listing::{Function, Line, Listing};
use super::refusal::Refusal;
use super::table::{table, table_elsewhere};
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
        let place = (function.lines.iter().map(|line| line.address)).zip(0..).collect();
        let count = function.lines.len();
        let flow = Self { next: vec![Vec::new(); count], calls: vec![Vec::new(); count], frame: 0 };
        let mut builder = FlowBuilder { listing, function, through, place, flow };
        let mut open: Vec<usize> = (0..count.min(1)).collect();
        let mut seen = vec![false; count];
        while let Some(index) = open.pop() {
            if !std::mem::replace(&mut seen[index], true) {
                builder.add(index)?;
                open.extend(&builder.flow.next[index]);
            }
        }
        if through.contains_key(&function.name) && !function.lines.iter().any(goes_by_register) {
            return Err(Refusal::NotIndirect { function: function.name.clone() });
        }
        Ok(builder.flow)
    }

    /// Returns every function that it may call.
    pub(super) fn callees(&self) -> BTreeSet<usize> {
        self.calls.iter().flatten().copied().collect()
    }
}

struct FlowBuilder<'a> {
    listing: &'a Listing,
    function: &'a Function,
    /// The targets of calls through registers.
    through: &'a Calls,
    /// The instruction at each address.
    place: BTreeMap<u64, usize>,
    flow: Flow,
}

impl FlowBuilder<'_> {
    /// Adds an instruction.
    fn add(&mut self, index: usize) -> Result<(), Refusal> {
        let (listing, function) = (self.listing, self.function);
        let line = &function.lines[index];
        match stack(line, index.checked_sub(1).map(|before| &function.lines[before])) {
            Stack::Same => {}
            Stack::Down(bytes) => self.flow.frame += bytes,
            Stack::Unknown => return Err(Refusal::DynamicStack(function.site(line))),
        }
        let mut goes_on = true;
        match kind(line) {
            Plain => {}
            Branch { conditional } => {
                goes_on = conditional;
                match target(listing, function, line)? {
                    To::Here(address) => self.go(index, [address])?,
                    To::Function(callee) => self.flow.calls[index] = vec![callee],
                }
            }
            Call => match target(listing, function, line)? {
                To::Function(callee) => {
                    self.flow.calls[index] = vec![callee];
                    let callee = &listing.functions()[callee].name;
                    if callee.starts_with("__gnu_thumb1_case") {
                        self.jump(index, table(function, line, callee))?;
                        goes_on = false;
                    } else {
                        // A call that no instruction follows never returns.
                        goes_on = follower(function, index).is_some();
                    }
                }
                // Thumb of a Cortex-M0 jumps far by `bl`, in functions that have saved the register of the return.
                To::Here(address) if function.saves_return() => {
                    self.go(index, [address])?;
                    goes_on = false;
                }
                To::Here(_) => return Err(Refusal::Astray(function.site(line))),
            },
            Return { conditional } => goes_on = conditional,
            Trap => goes_on = false,
            Skip => self.follow(index, follower(function, index).and_then(|next| follower(function, next)))?,
            Indirect { goes_on: and_on } => {
                let Some(callees) = self.through.get(&function.name) else {
                    return Err(Refusal::Indirect(function.site(line)));
                };
                for callee in callees {
                    let place = listing.named(callee).ok_or_else(|| Refusal::NoFunction { name: callee.clone() })?;
                    self.flow.calls[index].push(place);
                }
                goes_on = and_on;
            }
            JumpTable => {
                let targets = table(function, line, "").or_else(|| table_elsewhere(listing, function, index));
                self.jump(index, targets)?;
                goes_on = false;
            }
        }
        if goes_on { self.follow(index, follower(function, index)) } else { Ok(()) }
    }

    /// Adds a successor of an instruction.
    fn follow(&mut self, index: usize, next: Option<usize>) -> Result<(), Refusal> {
        let astray = || Refusal::Astray(self.function.site(&self.function.lines[index]));
        self.flow.next[index].push(next.ok_or_else(astray)?);
        Ok(())
    }

    /// Adds the targets of a branch.
    fn go(&mut self, index: usize, targets: impl IntoIterator<Item = u64>) -> Result<(), Refusal> {
        targets.into_iter().try_for_each(|target| self.follow(index, self.place.get(&target).copied()))
    }

    /// Adds the targets of a table.
    fn jump(&mut self, index: usize, targets: Option<Vec<u64>>) -> Result<(), Refusal> {
        let unknown = || Refusal::JumpTable(self.function.site(&self.function.lines[index]));
        self.go(index, targets.ok_or_else(unknown)?)?;
        self.flow.next[index].sort_unstable();
        self.flow.next[index].dedup();
        Ok(())
    }
}

fn goes_by_register(line: &Line) -> bool {
    matches!(kind(line), Indirect { .. })
}

/// Returns the instruction directly after another one, with no data in between; what follows a function's end may be joined anywhere.
fn follower(function: &Function, index: usize) -> Option<usize> {
    let here = function.lines.get(index)?.address;
    let follows = |line: &Line| (1..=4).contains(&line.address.wrapping_sub(here));
    match function.lines.get(index + 1) {
        Some(next) if follows(next) => Some(index + 1),
        _ => (0..function.lines.len())
            .filter(|&place| follows(&function.lines[place]))
            .min_by_key(|&place| function.lines[place].address),
    }
}

/// Returns the addresses outside a function at which it goes on without a call: the middles of others that it branches to, and what
/// follows its end.
pub(super) fn continues_at(function: &Function) -> BTreeSet<u64> {
    let end = function.lines.last();
    // Behind the last instruction there may be padding.
    let mut acts = function.lines.iter().rev().filter(|line| !line.mnemonic.starts_with("nop"));
    let runs_on = acts.next().is_some_and(|line| match kind(line) {
        Plain | Skip => true,
        Branch { conditional } | Return { conditional } => conditional,
        // The library of an AVR goes on in the next function; elsewhere, a call at the end never returns.
        Call => line.mnemonic.ends_with("call"),
        _ => false,
    });
    let runs_on = runs_on || acts.next().is_some_and(|line| kind(line) == Skip);
    let after = |line: &Line| [line.address + 2, line.address + 4];
    let branches = function.lines.iter().filter(|line| matches!(kind(line), Branch { .. }) && line.symbol.is_none());
    let targets = branches.filter_map(address).chain(end.filter(|_| runs_on).into_iter().flat_map(after));
    let inside: BTreeSet<u64> = function.lines.iter().map(|line| line.address).collect();
    targets.filter(|target| !inside.contains(target)).collect()
}

/// Returns the address that an instruction branches to, its last operand: `10 <f+0x8>`.
fn address(line: &Line) -> Option<u64> {
    let operands = line.operands.split(" <").next().unwrap_or_default();
    let last = operands.rsplit(',').next().unwrap_or_default().trim();
    u64::from_str_radix(last.strip_prefix("0x").unwrap_or(last), 16).ok()
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
    let address = address(line).ok_or_else(|| Refusal::Astray(function.site(line)))?;
    let inside = function.lines.iter().any(|line| line.address == address);
    match listing.at(&function.section, address) {
        // A branch to the function's own start is a loop, a call of it is a recursion.
        Some(callee) if kind(line) == Call || address != function.address => Ok(To::Function(callee)),
        _ if inside => Ok(To::Here(address)),
        _ => Err(Refusal::Astray(function.site(line))),
    }
}
