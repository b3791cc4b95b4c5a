//! The worst case of one decision of the shipped hybrids, found without running it: instructions and stack.

use crate::Failure;
use crate::facts::{self, Facts};
use crate::line::Line;
use cortex_bound::{Analyser, Bound, Calls, Limit, Listing, LoopBounds, Turns, disassemble};
use std::path::Path;

/// The facts about an image, by the names that its functions have there.
struct WorstTold {
    listing: Listing,
    loops: LoopBounds,
    calls: Calls,
    limits: Vec<Limit>,
    /// The functions that begin a decision: the ones that are counted, and the ones whose stack is measured.
    roots: Vec<String>,
    stack_roots: Vec<String>,
}

impl WorstTold {
    /// Reads an image. A fact that speaks of nothing in it is a failure: it would be believed and say nothing.
    fn read(image: &Path) -> Result<Self, Failure> {
        let listing = disassemble(image).map_err(Failure::new)?;
        let Facts { roots, stack_roots, loops, calls, limits } = facts::control();
        let names = |part: &str| -> Result<Vec<String>, Failure> {
            let all = listing.functions().iter().map(|function| function.name.clone());
            let found: Vec<String> = all.filter(|name| name.contains(part)).collect();
            if found.is_empty() { Err(Failure::at(image, format!("no function {part:?}"))) } else { Ok(found) }
        };
        let mut told = Self {
            roots: names(roots)?,
            stack_roots: names(stack_roots)?,
            loops: LoopBounds::new(),
            calls: Calls::new(),
            limits: Vec::new(),
            listing: listing.clone(),
        };
        for (part, turns) in loops {
            for name in names(part)? {
                told.loops.insert(name, Turns::Each(turns.clone()));
            }
        }
        for (part, callees) in calls {
            for name in names(part)? {
                told.calls.insert(name, callees.iter().map(|&callee| callee.to_owned()).collect());
            }
        }
        for (part, times) in limits {
            for within in &told.roots {
                for function in names(part)? {
                    told.limits.push(Limit { within: within.clone(), function, times });
                }
            }
        }
        Ok(told)
    }

    fn analyser(&self) -> Analyser<'_> {
        Analyser::new(&self.listing, &self.loops).calling(&self.calls).limited(&self.limits)
    }

    /// The worst case of every decision.
    fn bound(&self) -> Result<Bound, Failure> {
        let mut analyser = self.analyser();
        let mut worst = Bound { instructions: 0, stack: 0 };
        for name in &self.roots {
            worst.instructions = worst.instructions.max(analyser.bound(name).map_err(Failure::new)?.instructions);
        }
        for name in &self.stack_roots {
            worst.stack = worst.stack.max(analyser.bound(name).map_err(Failure::new)?.stack);
        }
        Ok(worst)
    }
}

/// Checks that no measurement exceeds the bound.
pub(crate) fn check(image: &Path, lines: &[Line]) -> Result<(), Failure> {
    let bound = WorstTold::read(image)?.bound()?;
    let most = |first: &str, last: &str, value: &str| {
        let matching = |line: &&Line| line.starts_with(first) && line.words.last().is_some_and(|word| word == last);
        lines.iter().filter(matching).map(|line| line.number(value)).max().unwrap_or(0)
    };
    let (instructions, stack) =
        (most("episode", "hybrid", "worst"), most("decision", "fs", "stack").max(most("decision", "rs", "stack")));
    println!(
        "a decision takes at most {} instructions (counted: {instructions}) and {} bytes of stack \
         (painted: {stack})",
        bound.instructions, bound.stack
    );
    if instructions == 0 || stack == 0 || instructions > bound.instructions || stack > bound.stack {
        return Err(Failure::new("a decision took more than its bound"));
    }
    Ok(())
}
