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
use crate::line::{self, Line};
use crate::record::Hash;
use core::{CORES, Core};
use figures::Figures;
use images::{EPISODES, Place};
use shipped::{ImageKind, Shipped};
use std::fs;
use tpg_cores::layers;
use tpg_runtime::net::Kind as Network;

/// Runs everything on every core whose title holds `only`, and compares it with this machine and with the committed figures.
pub(crate) fn check(update: bool, only: &str) -> Result<(), Failure> {
    let shipped = shipped::all()?;
    let episodes = episodes()?;
    let integers = shipped::integers(&shipped)?;
    let place = Place::new(&shipped, &integers)?;
    let mut figures = Figures::new();
    let mut all = true;
    for core in CORES.iter().filter(|core| core.title().contains(only)) {
        if !there(core) {
            all = false;
            continue;
        }
        all &= one(core, [&shipped, &integers], &episodes, &place, &mut figures)?;
    }
    if update && all {
        return figures.commit();
    }
    Failure::unless_none(figures.differences()?)
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
fn one(
    core: &Core,
    [shipped, integers]: [&[Shipped]; 2],
    episodes: &[Line],
    place: &Place,
    figures: &mut Figures,
) -> Result<bool, Failure> {
    let run = |image: &std::path::Path| emulate::until_done(&mut core.run(image, &place.wasi()));
    for (language, kind, policies) in [("C", ImageKind::C, shipped), ("C in integers", ImageKind::Integers, integers)] {
        figures.add_flash(core, place.policies(core, policies)?);
        let mut lines = Vec::new();
        for image in place.in_c(core, kind, policies)? {
            lines.extend(run(&image)?);
        }
        compare(core, language, policies, &lines)?;
        figures.add(core, "c", &lines);
    }
    let [states, fewer] = [false, true].map(|integers| core.bits().states(integers));
    let mut said = format!("C of {} policies on {states} states each, in integers on {fewer}", shipped.len());
    let mut all = true;
    match place.in_rust(core)? {
        Some([policies, layers]) => {
            let lines = run(&policies)?;
            compare(core, "Rust", shipped.iter().filter(|one| one.in_rust()), &lines)?;
            figures.add(core, "rust", &lines);
            let lines = run(&layers)?;
            networks(core, &lines)?;
            said.push_str(&format!(", their Rust, networks of {} kinds", Network::ALL.len()));
            figures.add(core, "layers", &lines);
        }
        None => all &= core.target.is_none(),
    }
    if let Some(image) = place.hybrid(core)? {
        let lines = run(&image)?;
        expected::same(&core.title(), episodes, &lines)?;
        figures.add(core, "hybrid", &lines);
    }
    println!("{}: {said}: the same bits as on the host", core.title());
    Ok(all)
}

/// Compares the answers of some policies with the interpreter's.
fn compare<'a>(
    core: &Core,
    language: &str,
    shipped: impl IntoIterator<Item = &'a Shipped>,
    lines: &[Line],
) -> Result<(), Failure> {
    let place = format!("{}, {language}", core.title());
    for one in shipped {
        line::check(
            &place,
            lines,
            &format!("policy {}", one.prefix),
            one.states(core.bits()) as u64,
            one.expected(core.bits()),
        )?;
    }
    Ok(())
}

/// Compares what the networks answer with this machine.
fn networks(core: &Core, lines: &[Line]) -> Result<(), Failure> {
    for kind in Network::ALL {
        let place = format!("{}, network {}", core.title(), kind.name());
        let here = layers::ask(kind, || (), || 0).ok_or_else(|| Failure(format!("{place}: no model")))?;
        line::check(&place, lines, &format!("layers {}", kind.name()), here.inputs.into(), &Hash(here.hash))?;
    }
    Ok(())
}
