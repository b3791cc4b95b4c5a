//! A function with all that it calls.

use super::flow::Flow;
use super::instruction::is_decision;
use super::listing::Listing;
use super::longest::{Endless, longest};
use super::refusal::Refusal;
use std::collections::{BTreeMap, BTreeSet};

/// The worst case of a function, what it calls included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bound {
    /// Instructions on the longest path, from the first to the return.
    pub instructions: u64,
    /// Bytes of stack.
    pub stack: u64,
}

/// How often a loop turns at most, by function: every loop of it.
pub type LoopBounds = BTreeMap<String, u64>;

/// An instruction that decides by data what runs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Site {
    /// The function.
    pub function: String,
    /// Where.
    pub address: u64,
    /// The instruction.
    pub text: String,
}

/// Finds bounds in a listing; what was found is kept.
#[derive(Debug)]
pub struct Analyser<'a> {
    listing: &'a Listing,
    bounds: &'a LoopBounds,
    known: BTreeMap<usize, Bound>,
    open: Vec<usize>,
}

impl<'a> Analyser<'a> {
    /// Of a listing, with bounds for loops that have none themselves.
    pub fn new(listing: &'a Listing, bounds: &'a LoopBounds) -> Self {
        Self { listing, bounds, known: BTreeMap::new(), open: Vec::new() }
    }

    /// The worst case of a function.
    ///
    /// # Errors
    /// Why there is none.
    pub fn bound(&mut self, name: &str) -> Result<Bound, Refusal> {
        self.of(self.place(name)?)
    }

    /// Every instruction that decides by data what runs, in a function and all that it calls.
    ///
    /// # Errors
    /// When the control flow is not known: calls through registers, callees that are not there.
    pub fn decisions(&self, name: &str) -> Result<Vec<Site>, Refusal> {
        let mut open = vec![self.place(name)?];
        let mut seen: BTreeSet<usize> = open.iter().copied().collect();
        let mut sites = Vec::new();
        while let Some(place) = open.pop() {
            let function = &self.listing.functions()[place];
            let decisions = function.lines.iter().filter(|line| is_decision(line));
            let site = |line: &super::listing::Line| Site {
                function: function.name.clone(),
                address: line.address,
                text: line.text(),
            };
            sites.extend(decisions.map(site));
            let flow = Flow::of(self.listing, function)?;
            open.extend(flow.calls.into_iter().flatten().filter(|&callee| seen.insert(callee)));
        }
        Ok(sites)
    }

    fn place(&self, name: &str) -> Result<usize, Refusal> {
        self.listing.named(name).ok_or_else(|| Refusal::NoFunction { name: name.to_owned() })
    }

    fn of(&mut self, place: usize) -> Result<Bound, Refusal> {
        if let Some(&bound) = self.known.get(&place) {
            return Ok(bound);
        }
        let listing = self.listing;
        let function = &listing.functions()[place];
        if let Some(first) = self.open.iter().position(|&open| open == place) {
            let circle = self.open[first..].iter().chain([&place]);
            let functions = circle.map(|&place| listing.functions()[place].name.clone()).collect();
            return Err(Refusal::Recursion { functions });
        }
        self.open.push(place);
        let flow = Flow::of(listing, function)?;
        let mut costs = Vec::with_capacity(flow.calls.len());
        let mut deepest = 0;
        for call in &flow.calls {
            let callee = call.map_or(Ok(Bound { instructions: 0, stack: 0 }), |callee| self.of(callee))?;
            costs.push(1 + callee.instructions);
            deepest = deepest.max(callee.stack);
        }
        self.open.pop();
        let turns = self.bounds.get(&function.name).copied();
        let endless = |endless| match endless {
            Endless::Loop(node) => {
                Refusal::Loop { function: function.name.clone(), address: function.lines[node].address }
            }
            Endless::Tangled(node) => {
                Refusal::TangledLoop { function: function.name.clone(), address: function.lines[node].address }
            }
        };
        if flow.next.is_empty() {
            return Err(Refusal::NoFunction { name: function.name.clone() });
        }
        let found = longest(&flow.next, &costs, 0, turns).map_err(endless)?;
        let instructions = found.into_iter().flatten().max().unwrap_or(0);
        let bound = Bound { instructions, stack: flow.frame + deepest };
        self.known.insert(place, bound);
        Ok(bound)
    }
}
