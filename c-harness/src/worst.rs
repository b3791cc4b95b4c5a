//! The worst case of one decision of the shipped hybrids, found without running it: instructions and stack.

use crate::Failure;
use crate::line::Line;
use std::path::Path;
use xtask::wcet::{Analyser, Bound, LoopBounds, disassemble};

/// How often a loop turns at most, by a part of the name of the function that has it, and why.
const LOOPS: [(&str, u64); 14] = [
    ("tpg_kernels3dsp", 8),      // 64 columns, eight a turn
    ("tpg_kernels6hidden", 16),  // 64 rows, four a block
    ("tpg_kernels8portable", 1), // not reached: a parsed model's inputs are whole turns
    ("pair_inputs", 10),         // 38 features, four a turn
    ("split_inputs", 10),        // not reached: the shipped network has `i16` activations
    ("quantise", 38),            // features
    ("preferences", 2),          // hidden layers
    ("memclr", 16),              // 64 words of scratch memory, four a turn
    ("memcpy", 32),              // the greatest structure, four words a turn
    ("Source", 4),               // sources of a graph; values of a source
    ("nearest", 4),              // edges of the base
    ("Iter", 4),                 // faces of the arm
    ("hybrid_decide", 14),       // ways to hold joints
    ("", 4),                     // joints
];

/// The worst case of every decision function in a Rust image.
pub(crate) fn decisions(image: &Path) -> Result<Bound, Failure> {
    let listing = disassemble(image).map_err(Failure::new)?;
    let mut bounds = LoopBounds::new();
    let mut decisions = Vec::new();
    for function in listing.functions() {
        if let Some((_, turns)) = LOOPS.iter().find(|(part, _)| function.name.contains(part)) {
            bounds.insert(function.name.clone(), *turns);
        }
        if function.name.contains("hybrid_decide") {
            decisions.push(function.name.clone());
        }
    }
    let mut analyser = Analyser::new(&listing, &bounds);
    let mut worst = Bound { instructions: 0, stack: 0 };
    for name in &decisions {
        let bound = analyser.bound(name).map_err(Failure::new)?;
        worst.instructions = worst.instructions.max(bound.instructions);
        worst.stack = worst.stack.max(bound.stack);
    }
    if decisions.len() == 2 { Ok(worst) } else { Err(Failure::new(format!("decisions: {decisions:?}"))) }
}

/// What was measured must not exceed the bound.
pub(crate) fn check(image: &Path, lines: &[Line]) -> Result<(), Failure> {
    let bound = decisions(image)?;
    let of = |first: &str, last: &str, value: &str| {
        let matching = |line: &&Line| {
            line.words.first().is_some_and(|word| word == first) && line.words.last().is_some_and(|word| word == last)
        };
        lines.iter().filter(matching).map(|line| line.number(value)).max().unwrap_or(0)
    };
    let (instructions, stack) =
        (of("episode", "hybrid", "worst"), of("decision", "fs", "stack").max(of("decision", "rs", "stack")));
    println!(
        "Rust: a decision takes at most {} instructions (counted: {instructions}) and {} bytes of stack (painted: {stack})",
        bound.instructions, bound.stack
    );
    if instructions == 0 || stack == 0 || instructions > bound.instructions || stack > bound.stack {
        return Err(Failure::new("a decision took more than its bound"));
    }
    Ok(())
}
