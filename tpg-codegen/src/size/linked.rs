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
use tpg_graph::image::{Feature, Find, Vision};

/// The parts of an image that a decision reaches.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Linked {
    /// Bytes, with those of library functions.
    pub size: Size,
    /// The worst case of a decision; none for cores that are not analysed, and the reason where there is none.
    pub bound: Option<Result<Bound, String>>,
    /// The worst case of reading an image; none where there is no image, or no bound.
    pub look: Option<Bound>,
}

/// Links an object file of a folder, from `entry` on.
pub(super) fn link(folder: &Path, target: Target, entry: &str, program: &Program<'_>) -> io::Result<Linked> {
    let mut command = target.compiler()?;
    command.current_dir(folder).args(["-nostartfiles", "-Wl,--gc-sections"]).arg(format!("-Wl,-e,{entry}"));
    command.args(["policy.o", "-o", "image", "-lm"]);
    super::run(command, "cannot link it", |line| line.contains("undefined") || line.contains("cannot"))?;
    let image = folder.join("image");
    let size = measure(&fs::read(&image)?)?;
    if !target.has_bound(matches!(program.shape, Shape::Integers(_))) {
        return Ok(Linked { size, bound: None, look: None });
    }
    let listing = disassemble(&image).map_err(|error| error.to_string());
    let look = listing.as_ref().ok().and_then(|listing| look(program, listing));
    let bound = listing.and_then(|listing| {
        // What is accepted are options of `cortex-bound`.
        let reason = |refusal: Refusal| refusal.to_string().split("; accepted").next().unwrap_or_default().to_owned();
        let bound = |loops: &LoopBounds| Analyser::new(&listing, loops).bound(entry);
        let found = bound(&loops(program, entry, &listing));
        let unrolled = || unrolled(program, entry).filter(|_| target.unit() == "instructions");
        found.or_else(|refusal| unrolled().map_or(Err(refusal), |loops| bound(&loops))).map_err(reason)
    });
    Ok(Linked { size, bound: Some(bound), look })
}

/// Bounds what reads an image. Its loops go through all cells, and in some of these through a window.
fn look(program: &Program<'_>, listing: &Listing) -> Option<Bound> {
    let vision = Vision::new(program.graph().sources())?;
    let [rows, columns, _] = vision.shape();
    let windows = vision.features().map(|(_, feature, _)| match (feature, feature.find()) {
        (Feature::Sum { height, width, .. }, _) => height.max(width),
        (_, Some(Find::Brightest { size, .. } | Find::Darkest { size, .. })) => size,
        _ => 0,
    });
    let (cells, window) = (rows.max(columns) as u64 + 1, u64::from(windows.max().unwrap_or(0)) + 1);
    let prefix = &program.options.prefix;
    let sum = format!("{prefix}_sum");
    let depths = |name: &str| if name.starts_with(&sum) { vec![window; 2] } else { vec![cells, cells, window, window] };
    let own = listing.functions().iter().map(|function| &function.name).filter(|name| name.starts_with(prefix.lower()));
    let loops = own.map(|name| (name.clone(), Turns::Depths(depths(name)))).collect();
    Analyser::new(listing, &loops).bound(&format!("{prefix}_look")).ok()
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
