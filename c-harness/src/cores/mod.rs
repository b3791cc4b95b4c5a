//! Every core, bit for bit: `cargo xtask cores`.
//!
//! | module | subject |
//! | --- | --- |
//! | [`core`] | the cores: what compiles for each, and what runs it |
//! | [`shipped`] | the policies, their states, their answers on this machine |
//! | [`images`] | what runs on a core |
//! | [`figures`] | flash and instructions beside `cores.toml`, and `docs/cores.md` |

mod core;
mod figures;
mod images;
mod shipped;

use crate::Failure;
use crate::emulate;
use crate::expected;
use crate::line::Line;
use core::{CORES, Core};
use figures::{Figures, Program};
use images::{EPISODES, Place};
use shipped::{Bits, STATES, Shipped};
use std::collections::BTreeMap;
use std::fs;
use tpg_cores::layers;
use tpg_kernels::Kind;

/// A hash of the answers of each policy, by name.
type Hashes = BTreeMap<String, String>;

/// The lines that every core must print: the hashes are of any bits, and of neither tiny nor huge ones.
struct Expected {
    shipped: Vec<Shipped>,
    hashes: [Hashes; 2],
    episodes: Vec<Line>,
}

/// Runs everything on every core whose title holds `only`, and compares it with this machine and with the committed figures.
pub(crate) fn check(update: bool, only: &str) -> Result<(), Failure> {
    let shipped = shipped::all()?;
    let hashes = [Bits::Any, Bits::NeitherTinyNorHuge].map(|bits| {
        shipped.iter().map(|one| (one.prefix.to_string(), format!("{:016x}", one.expected(bits).0))).collect()
    });
    let expected = Expected { episodes: episodes()?, hashes, shipped };
    let place = Place::new(&expected.shipped)?;
    let mut figures = Figures::new();
    let mut all = true;
    for core in CORES.iter().filter(|core| core.title().contains(only)) {
        if !there(core) {
            all = false;
            continue;
        }
        all &= one(core, &expected, &place, &mut figures)?;
    }
    if update && all {
        return figures.commit();
    }
    let differences = figures.differences()?;
    if differences.is_empty() { Ok(()) } else { Err(Failure::new(differences.join("\n"))) }
}

impl Expected {
    fn hashes(&self, core: &Core) -> &Hashes {
        let [any, neither] = &self.hashes;
        if core.bits() == Bits::Any { any } else { neither }
    }
}

/// The lines of the hybrid's episodes, and of its parts', that the cores run.
fn episodes() -> Result<Vec<Line>, Failure> {
    let few = |line: &Line| {
        let hybrid = line.words.get(2).is_some_and(|name| name == "hybrid");
        line.number("index") < if hybrid { EPISODES as u64 } else { 1 }
    };
    Ok(expected::lines()?.into_iter().filter(few).collect())
}

/// True where a core's compiler and emulator are installed; otherwise the core is skipped, or that is a failure.
fn there(core: &Core) -> bool {
    let what = format!("policies on {}", core.title());
    let (compiler, package) = core.compiler();
    // QEMU can do without, but its answer would be another one.
    if core.flags.contains(&"-mfma") && !fs::read_to_string("/proc/cpuinfo").is_ok_and(|text| text.contains(" fma ")) {
        tpg_testing::skip(&format!("{what}: this machine has none"));
        return true;
    }
    tpg_testing::tool(compiler, package, &what)
        && core.emulator().is_none_or(|(program, package)| tpg_testing::tool(program, package, &what))
}

/// Runs everything on a core; false where a part was skipped.
fn one(core: &Core, expected: &Expected, place: &Place, figures: &mut Figures) -> Result<bool, Failure> {
    let run = |image: &std::path::Path| emulate::until_done(&mut core.run(image, &place.wasi()));
    figures.add_flash(core, place.policies(core, &expected.shipped)?);
    let mut lines = Vec::new();
    for image in place.in_c(core, &expected.shipped)? {
        lines.extend(run(&image)?);
    }
    let count = compare(core, "C", expected.hashes(core), &lines, expected.shipped.len())?;
    figures.add(core, Program::C, &lines);
    let mut said = format!("C of {count} policies on {STATES} states each");
    let mut all = true;
    match place.in_rust(core)? {
        Some([policies, layers]) => {
            let lines = run(&policies)?;
            let shipped = expected.shipped.iter().filter(|one| one.in_rust()).count();
            let count = compare(core, "Rust", expected.hashes(core), &lines, shipped)?;
            figures.add(core, Program::Rust, &lines);
            said.push_str(&format!(", Rust of {count}"));
            let lines = run(&layers)?;
            networks(core, &lines)?;
            said.push_str(&format!(", networks of {} kinds", Kind::ALL.len()));
            figures.add(core, Program::Layers, &lines);
        }
        None => all &= core.target.is_none(),
    }
    if let Some(image) = place.hybrid(core)? {
        let lines = run(&image)?;
        crate::compare(&core.title(), &expected.episodes, &lines)?;
        figures.add(core, Program::Hybrid, &lines);
    }
    println!("{}: {said}: the same bits as on the host", core.title());
    Ok(all)
}

/// Compares the hashes of the policies; how many there were.
fn compare(core: &Core, language: &str, hashes: &Hashes, lines: &[Line], wanted: usize) -> Result<usize, Failure> {
    let mut count = 0;
    for line in lines.iter().filter(|line| line.words.first().is_some_and(|word| word == "policy")) {
        let name = line.words.get(1).cloned().unwrap_or_default();
        let place = format!("{}, {language}, {name}", core.title());
        if line.number("states") != STATES as u64 {
            return Err(Failure::new(format!("{place}: {} states, not {STATES}", line.number("states"))));
        }
        let (found, wanted) = (line.values.get("hash"), hashes.get(&name));
        if found.is_none() || found != wanted {
            return Err(Failure::new(format!(
                "{place}: other answers than the interpreter's: {found:?}, not {wanted:?}"
            )));
        }
        count += 1;
    }
    if count != wanted {
        return Err(Failure::new(format!("{}, {language}: {count} policies, not {wanted}", core.title())));
    }
    Ok(count)
}

/// Compares the hashes of what the networks answer with this machine's.
fn networks(core: &Core, lines: &[Line]) -> Result<(), Failure> {
    for kind in Kind::ALL {
        let place = format!("{}, network {}", core.title(), kind.name());
        let line = lines.iter().find(|line| line.words == ["layers", kind.name()]);
        let line = line.ok_or_else(|| Failure::new(format!("{place}: no answers")))?;
        let here = layers::ask(kind, || (), || 0).ok_or_else(|| Failure::new(format!("{place}: no model")))?;
        if line.number("inputs") != u64::from(here.inputs)
            || line.values.get("hash") != Some(&format!("{:016x}", here.hash))
        {
            return Err(Failure::new(format!("{place}: other answers than on this machine: {line:?}, not {here:?}")));
        }
    }
    Ok(())
}
