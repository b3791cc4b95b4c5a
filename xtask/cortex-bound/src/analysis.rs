//! Analysis of a function together with its callees.

use super::facts::{Calls, LoopBounds, Turns, in_libgcc};
use super::flow::Flow;
use super::instruction::{cycles, is_decision};
use super::listing::{Line, Listing, Site};
use super::longest::{Header, headers, longest};
use super::refusal::Refusal;
use std::collections::{BTreeMap, BTreeSet};

/// The worst case of a function, including its callees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bound {
    /// Instructions on the longest path, from the first to the return; of an AVR, cycles.
    pub instructions: u64,
    /// Bytes of stack.
    pub stack: u64,
}

static NO_CALLS: Calls = Calls::new();

/// Finds bounds in a listing and caches the results.
#[derive(Debug)]
pub struct Analyser<'a> {
    listing: &'a Listing,
    bounds: &'a LoopBounds,
    calls: &'a Calls,
    flows: BTreeMap<usize, Flow>,
    known: BTreeMap<usize, u64>,
    stacks: BTreeMap<usize, u64>,
}

impl<'a> Analyser<'a> {
    /// Creates the analyser of a listing, with bounds for loops that have none of their own.
    pub fn new(listing: &'a Listing, bounds: &'a LoopBounds) -> Self {
        let (flows, known, stacks) = (BTreeMap::new(), BTreeMap::new(), BTreeMap::new());
        Self { listing, bounds, calls: &NO_CALLS, flows, known, stacks }
    }

    /// Adds the targets of calls through registers.
    #[must_use]
    pub fn calling(self, calls: &'a Calls) -> Self {
        Self { calls, ..self }
    }

    /// Returns the worst case of a function.
    ///
    /// # Errors
    /// The reason why there is none.
    pub fn bound(&mut self, name: &str) -> Result<Bound, Refusal> {
        let place = self.place(name)?;
        let stack = self.stack(place, &mut Vec::new())?;
        Ok(Bound { instructions: self.worst(place)?, stack })
    }

    /// Returns every instruction whose control flow depends on data, in a function and its callees.
    ///
    /// # Errors
    /// If the control flow is unknown: calls through registers, missing callees.
    pub fn decisions(&self, name: &str) -> Result<Vec<Site>, Refusal> {
        let mut open = vec![self.place(name)?];
        let mut seen: BTreeSet<usize> = open.iter().copied().collect();
        let mut sites = Vec::new();
        while let Some(place) = open.pop() {
            let function = &self.listing.functions()[place];
            let decisions = function.lines.iter().filter(|line| is_decision(line));
            sites.extend(decisions.map(|line| function.site(line)));
            let flow = Flow::new(self.listing, function, self.calls)?;
            open.extend(flow.calls.into_iter().flatten().filter(|&callee| seen.insert(callee)));
        }
        Ok(sites)
    }

    fn place(&self, name: &str) -> Result<usize, Refusal> {
        self.listing.named(name).ok_or_else(|| Refusal::NoFunction { name: name.to_owned() })
    }

    fn name(&self, place: usize) -> &str {
        &self.listing.functions()[place].name
    }

    fn flow(&mut self, place: usize) -> Result<&Flow, Refusal> {
        if !self.flows.contains_key(&place) {
            let function = &self.listing.functions()[place];
            let flow = Flow::new(self.listing, function, self.calls)?;
            if flow.next.is_empty() {
                return Err(Refusal::NoFunction { name: function.name.clone() });
            }
            self.flows.insert(place, flow);
        }
        Ok(&self.flows[&place])
    }

    /// Returns the bytes of stack; this traversal also detects recursion.
    fn stack(&mut self, place: usize, open: &mut Vec<usize>) -> Result<u64, Refusal> {
        if let Some(&stack) = self.stacks.get(&place) {
            return Ok(stack);
        }
        if let Some(first) = open.iter().position(|&other| other == place) {
            let circle = open[first..].iter().chain([&place]);
            return Err(Refusal::Recursion { functions: circle.map(|&place| self.name(place).to_owned()).collect() });
        }
        open.push(place);
        let (frame, callees) = self.flow(place).map(|flow| (flow.frame, flow.callees()))?;
        let mut deepest = 0;
        for callee in callees {
            // An AVR pushes the address of the return.
            let back = if self.listing.is_avr { 2 } else { 0 };
            deepest = deepest.max(back + self.stack(callee, open)?);
        }
        open.pop();
        self.stacks.insert(place, frame + deepest);
        Ok(frame + deepest)
    }

    /// Returns the bounds of a function's loops, by their headers.
    fn turns(&self, place: usize, headers: &[Header]) -> Result<BTreeMap<usize, u64>, Refusal> {
        let name = self.name(place);
        let (lines, next) = (&self.listing.functions()[place].lines, &self.flows[&place].next);
        let counted = |header: &Header| Some((header.node, counted(lines, next, header.node)?));
        let mut turns: BTreeMap<usize, u64> = headers.iter().filter_map(counted).collect();
        let headers: Vec<&Header> = headers.iter().filter(|header| !turns.contains_key(&header.node)).collect();
        let nodes = headers.iter().map(|header| header.node);
        turns.extend(match self.bounds.get(name) {
            None => {
                let known = |header: &Header| Some((header.node, in_libgcc(name, header.is_tangled)?));
                headers.iter().filter_map(|header| known(header)).collect()
            }
            Some(Turns::Every(turns)) => nodes.map(|node| (node, *turns)).collect::<Vec<_>>(),
            Some(Turns::Each(turns)) if turns.len() == headers.len() => nodes.zip(turns.iter().copied()).collect(),
            Some(Turns::Nested(turns)) if is_chain(&headers, turns.len()) => {
                headers.iter().map(|header| (header.node, turns[header.depth])).collect()
            }
            Some(Turns::Depths(turns)) => {
                headers.iter().filter_map(|header| Some((header.node, *turns.get(header.depth)?))).collect()
            }
            Some(Turns::Each(turns) | Turns::Nested(turns)) => {
                let found = nodes.map(|node| lines[node].address).collect();
                return Err(Refusal::OtherLoops { function: name.to_owned(), found, given: turns.len() });
            }
        });
        Ok(turns)
    }

    /// Returns the refusal of a loop without a bound.
    fn endless(&self, place: usize, header: &Header) -> Refusal {
        let found = &self.listing.functions()[place];
        let site = found.site(&found.lines[header.node]);
        if header.is_tangled { Refusal::TangledLoop(site) } else { Refusal::Loop(site) }
    }

    /// Returns the instructions of a function at most.
    fn worst(&mut self, place: usize) -> Result<u64, Refusal> {
        if let Some(&known) = self.known.get(&place) {
            return Ok(known);
        }
        let flow = self.flow(place)?.clone();
        let turns = self.turns(place, &headers(&flow.next, 0))?;
        let mut costs = Vec::with_capacity(flow.calls.len());
        for (callees, line) in flow.calls.iter().zip(&self.listing.functions()[place].lines) {
            let mut most = 0;
            for &callee in callees {
                most = most.max(self.worst(callee)?);
            }
            costs.push(if self.listing.is_avr { cycles(line) } else { 1 } + most);
        }
        let worst = longest(&flow.next, &costs, 0, &turns).map_err(|header| self.endless(place, &header))?;
        self.known.insert(place, worst);
        Ok(worst)
    }
}

/// The instructions of an AVR that shift by a bit.
const SHIFTS: [&str; 7] = ["asr", "ror", "lsr", "lsl", "rol", "add", "adc"];

/// Tests for instructions that shift by a bit without a change of the counter.
fn shifts(lines: &[Line], counter: &str) -> bool {
    lines.iter().all(|line| SHIFTS.contains(&line.mnemonic.as_str()) && !line.operands.starts_with(counter))
}

/// Returns the turns of a loop of an AVR that shifts, by a constant: `ldi r18, 0x0C`, shifts, `dec r18`, `brne`; or by a variable, which
/// is below 32 in C: into the middle of shifts, `dec r24`, `brpl`.
fn counted(lines: &[Line], next: &[Vec<usize>], header: usize) -> Option<u64> {
    if lines[header].mnemonic == "dec" && lines.get(header + 1)?.mnemonic == "brpl" {
        let first = *next[header + 1].iter().find(|&&to| to < header)?;
        return shifts(&lines[first..header], &lines[header].operands).then_some(32);
    }
    let before: Vec<usize> = (0..next.len()).filter(|&node| next[node].contains(&header)).collect();
    let [start, latch] = before[..] else { return None };
    let (counter, turns) = lines[start].operands.split_once(", 0x").filter(|_| lines[start].mnemonic == "ldi")?;
    let (down, body) = lines.get(header..latch)?.split_last()?;
    let is_down = down.mnemonic == "dec" && down.operands == counter && lines[latch].mnemonic == "brne";
    let turns = u64::from_str_radix(turns, 16).ok()?;
    (is_down && shifts(body, counter) && turns > 0).then_some(turns)
}

/// Tests for so many loops, each but the first in the one before; or none.
fn is_chain(headers: &[&Header], count: usize) -> bool {
    let depths: BTreeSet<usize> = headers.iter().map(|header| header.depth).collect();
    headers.is_empty() || headers.len() == count && depths.into_iter().eq(0..count)
}
