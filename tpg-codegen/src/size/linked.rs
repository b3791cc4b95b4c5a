//! Compiled C linked with the library functions that it calls: the flash that they take, and the worst case of a decision.

use super::object::{Size, measure};
use super::target::Target;
use crate::emit::integers;
use crate::program::Program;
use crate::shape::Shape;
use cortex_bound::{Analyser, Bound, Listing, LoopBounds, Refusal, Turns, disassemble};
use std::path::Path;
use std::{fs, io};
use tpg_graph::ScalarType;

/// The parts of an image that a decision reaches.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Linked {
    /// Bytes, with those of library functions.
    pub size: Size,
    /// The worst case of a decision; none for cores that are not analysed, and the reason where there is none.
    pub bound: Option<Result<Bound, String>>,
}

/// Links an object file of a folder, from `entry` on.
pub(super) fn link(folder: &Path, target: Target, entry: &str, program: &Program<'_>) -> io::Result<Linked> {
    let (mut command, _) = target.compiler()?;
    command.current_dir(folder).args(["-nostartfiles", "-Wl,--gc-sections"]).arg(format!("-Wl,-e,{entry}"));
    command.args(["policy.o", "-o", "image", "-lm"]);
    super::run(command, "cannot link it", |line| line.contains("undefined") || line.contains("cannot"))?;
    let image = folder.join("image");
    let size = measure(&fs::read(&image)?)?;
    let bound = target.has_bound(matches!(program.shape, Shape::Integers(_))).then(|| {
        let listing = disassemble(&image).map_err(|error| error.to_string())?;
        // What is accepted are options of `cortex-bound`.
        let reason = |refusal: Refusal| refusal.to_string().split("; accepted").next().unwrap_or_default().to_owned();
        let bound = |loops: &LoopBounds| Analyser::new(&listing, loops).bound(entry);
        let found = bound(&loops(program, entry, &listing));
        let unrolled = || unrolled(program, entry).filter(|_| target.unit() == "instructions");
        found.or_else(|refusal| unrolled().map_or(Err(refusal), |loops| bound(&loops))).map_err(reason)
    });
    Ok(Linked { size, bound })
}

/// The turns of the loops in generated C: control comes once more to a loop's first instruction than to its body. Code with other loops has
/// no bound, for a compiler may merge or remove some.
fn loops(program: &Program<'_>, entry: &str, listing: &Listing) -> LoopBounds {
    let module = &program.module;
    let edges = module.teams.iter().map(|team| team.edges.len() as u64).max().unwrap_or(0);
    let turns = |counts: &[u64]| Turns::Nested(counts.iter().map(|count| count + 1).collect());
    // A walk of one team is no loop.
    let walk: Vec<u64> = Some(module.depth as u64).filter(|&depth| depth > 1).into_iter().chain([edges]).collect();
    match &program.shape {
        Shape::Balanced(_) => LoopBounds::from([(entry.to_owned(), turns(&walk))]),
        Shape::Small(code) => {
            let longest = code.programs.windows(2).map(|ends| ends[1] - ends[0]).max().unwrap_or(0);
            let value = if program.graph().scalar() == ScalarType::F32 { 4 } else { 8 };
            // Programs run in a function of their own, of which the compiler makes variants, or in the loops of the walk.
            let run = format!("{}_run", program.options.prefix);
            let names = listing.functions().iter().map(|function| &function.name).filter(|name| name.starts_with(&run));
            let mut loops: LoopBounds = names.map(|name| (name.clone(), turns(&[longest]))).collect();
            let inlined = Some(longest).filter(|_| loops.is_empty());
            loops.insert(entry.to_owned(), turns(&walk.into_iter().chain(inlined).collect::<Vec<_>>()));
            loops.insert("memcpy".to_owned(), Turns::Every(value * code.first_result as u64 + 1));
            loops
        }
        _ => table(program).map(|counts| (entry.to_owned(), turns(&counts))).into_iter().collect(),
    }
}

/// The turns where a compiler writes the few rows of a table one by one: only inner loops are left. On an AVR, a shift is a loop, too.
fn unrolled(program: &Program<'_>, entry: &str) -> Option<LoopBounds> {
    let [rows, columns] = table(program)?;
    Some(LoopBounds::from([(entry.to_owned(), Turns::Every(rows.max(columns) + 1))]))
}

/// Rows and columns of a table of sums in integers.
fn table(program: &Program<'_>) -> Option<[u64; 2]> {
    match &program.shape {
        Shape::Integers(integers) => integers::turns(program, integers),
        _ => None,
    }
}
