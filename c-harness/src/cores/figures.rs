//! Flash and instructions on each core: compared with `cores.toml`, and written for people as `docs/cores.md`.

use super::core::{CORES, Core};
use super::images::EPISODES;
use super::shipped::{Bits, FEWER_STATES, STATES, WIDTHS};
use crate::Failure;
use crate::build;
use crate::costs::{Cost, Tolerance};
use crate::line::Line;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::fs;
use tpg_cores::layers::INPUTS;
use tpg_testing::library;

const FILE: &str = "cores.toml";

/// The page for people, in the book.
const PAGE: &str = "cores.md";

/// Cores that compute integers nearly as a Cortex-M4F does: the page leaves them out there.
const LIKE_M4F: [&str; 2] = ["Cortex-M7", "Cortex-M33"];

/// `cores.toml`.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Figures {
    /// The compilers that these figures belong to, by their own words.
    compilers: BTreeMap<String, String>,
    /// By core.
    core: BTreeMap<String, OfCore>,
}

/// The figures of a core, by policy.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct OfCore {
    /// Bytes of flash of the C; of integers of so many bits, under the policy's name with the bits behind it.
    #[serde(default)]
    flash: BTreeMap<String, u64>,
    /// Instructions of the C, named alike.
    #[serde(default)]
    c: BTreeMap<String, Cost>,
    /// Instructions of the Rust.
    #[serde(default)]
    rust: BTreeMap<String, Cost>,
    /// Instructions of decisions of the hybrid, in C, by start.
    #[serde(default)]
    hybrid: BTreeMap<String, Cost>,
    /// Instructions of a network, by the kind of its weights and activations.
    #[serde(default)]
    layers: BTreeMap<String, Cost>,
}

/// The programs of one language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Program {
    C,
    Rust,
    Hybrid,
    Layers,
}

impl Figures {
    /// None yet, with the compilers in use.
    pub(super) fn new() -> Self {
        let programs: BTreeSet<&str> = CORES.iter().filter(|core| core.figures).map(|core| core.compiler().0).collect();
        let compilers = programs.into_iter().chain(["rustc"]).map(|name| (name.to_owned(), build::version(name)));
        Self { compilers: compilers.collect(), core: BTreeMap::new() }
    }

    /// Notes bytes of flash.
    pub(super) fn add_flash(&mut self, core: &Core, flash: Vec<(String, u64)>) {
        if core.figures {
            self.core.entry(core.name.to_owned()).or_default().flash.extend(flash);
        }
    }

    /// Notes what a program printed.
    pub(super) fn add(&mut self, core: &Core, program: Program, lines: &[Line]) {
        if !core.figures || !core.counts() {
            return;
        }
        let figures = self.core.entry(core.name.to_owned()).or_default();
        let costs = match program {
            Program::C => &mut figures.c,
            Program::Rust => &mut figures.rust,
            Program::Hybrid => &mut figures.hybrid,
            Program::Layers => &mut figures.layers,
        };
        for line in lines {
            if let [first, name, rest @ ..] = &*line.words
                && (program != Program::Hybrid || rest == ["hybrid"])
                && ["policy", "layers", "episode"].contains(&first.as_str())
            {
                costs.entry(name.clone()).or_default().add(line);
            }
        }
    }

    /// Differences from what is committed; a test compares the page.
    pub(super) fn differences(&self) -> Result<Vec<String>, Failure> {
        let committed: Self = toml::from_str(&build::committed(FILE)?).map_err(Failure::new)?;
        let tolerance = Tolerance::new(FILE, &committed.compilers, &self.compilers);
        let mut differences = Vec::new();
        for (name, found) in &self.core {
            let was = committed.core.get(name).cloned().unwrap_or_default();
            let place = |what: &str| format!("{name}, {what}, ");
            differences.extend(tolerance.differences(&place("flash"), &found.flash, &was.flash, |&bytes| [bytes]));
            for (what, found, was) in [
                ("C", &found.c, &was.c),
                ("Rust", &found.rust, &was.rust),
                ("hybrid", &found.hybrid, &was.hybrid),
                ("layers", &found.layers, &was.layers),
            ] {
                differences.extend(tolerance.differences(&place(what), found, was, Cost::numbers));
            }
        }
        Ok(differences)
    }

    /// Takes these figures as the committed ones.
    pub(super) fn commit(&self) -> Result<(), Failure> {
        let text = toml::to_string(self).map_err(Failure::new)?;
        let head = "# Flash and instructions on each core; `cargo xtask cores --update` writes this file and docs/cores.md.\n\n";
        build::commit(FILE, &format!("{head}{text}"))?;
        let page = library::top().join("docs").join(PAGE);
        fs::write(&page, self.to_string()).map_err(|error| Failure::at(&page, error))
    }

    /// A table with a row for each core and a column for each policy; empty where nothing is known.
    fn table(&self, without: &[&str], columns: impl Fn(&OfCore) -> BTreeMap<String, String>) -> String {
        // In the order of the cores, each once.
        let mut rows: Vec<(&str, BTreeMap<String, String>)> = Vec::new();
        for core in CORES.iter().filter(|core| core.figures && !without.contains(&core.name)) {
            let row = self.core.get(core.name).map(&columns).unwrap_or_default();
            if !row.is_empty() {
                rows.push((core.name, row));
            }
        }
        let names: BTreeSet<&String> = rows.iter().flat_map(|(_, row)| row.keys()).collect();
        let mut text = "| core |".to_owned();
        names.iter().for_each(|name| text.push_str(&format!(" `{name}` |")));
        text.push_str("\n| --- |");
        names.iter().for_each(|_| text.push_str(" --- |"));
        text.push('\n');
        for (core, row) in &rows {
            let _ = write!(text, "| {core} |");
            for &name in &names {
                let _ = write!(text, " {} |", row.get(name).map_or("", String::as_str));
            }
            text.push('\n');
        }
        text
    }
}

/// Tests for the name of a policy in integers.
fn is_integers(name: &str) -> bool {
    WIDTHS.iter().any(|bits| name.ends_with(&format!("_{bits}")))
}

/// The integers of each policy, and the geometric mean of their shares of the floats.
fn in_integers<T>(figures: &BTreeMap<String, T>, number: impl Fn(&T) -> f64) -> BTreeMap<String, String> {
    let mut cells = BTreeMap::new();
    let mut shares = WIDTHS.map(|_| Vec::new());
    for (name, one) in figures {
        let whole = WIDTHS.map(|bits| figures.get(&format!("{name}_{bits}")));
        if let [Some(first), Some(second)] = whole {
            let [float, first, second] = [one, first, second].map(&number);
            cells.insert(name.clone(), format!("{first:.0} · {second:.0}"));
            for (shares, whole) in shares.iter_mut().zip([first, second]) {
                shares.push((whole / float).ln());
            }
        }
    }
    if !cells.is_empty() {
        let mean = |shares: &Vec<f64>| (shares.iter().sum::<f64>() / shares.len() as f64).exp();
        let means: Vec<String> = shares.iter().map(|shares| format!("{:.3}", mean(shares))).collect();
        // Behind every name.
        cells.insert("~ share".to_owned(), means.join(" · "));
    }
    cells
}

/// The page for people.
impl std::fmt::Display for Figures {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let cost = |costs: &BTreeMap<String, Cost>| {
            let floats = costs.iter().filter(|(name, _)| !is_integers(name));
            floats.map(|(name, one)| (name.clone(), format!("{:.0} · {}", one.mean(), one.worst))).collect()
        };
        writeln!(
            f,
            "# Cores\n\n\
             Generated code on emulated cores, compared with the interpreter bit for bit by `cargo xtask cores`.\n\n\
             ## What acts the same\n\n\
             - C: each shipped policy and one with memory, profile `fast`, GNU C, `-Os`, {STATES} states, a third of them any bits.\n\
             - Rust: profile `constant-time`, the same states; networks in integers of every kind, {INPUTS} inputs.\n\
             - Library: {} episodes of the shipped hybrids and of four parts, every motor position, with `libtpg_runtime.a`.\n\n\
             | core | runs on | C | Rust | library |\n| --- | --- | --- | --- | --- |",
            2 * EPISODES,
        )?;
        let yes = |yes: bool| if yes { "yes" } else { "" };
        for core in &CORES {
            let of_c = if core.bits() == Bits::Any { "yes" } else { "yes, but for denormals" };
            let library = core.target.is_some_and(|target| library::TARGETS.contains(&target));
            let rust = yes(core.target.is_some());
            writeln!(f, "| {} | {} | {of_c} | {rust} | {} |", core.name, core.machine, yes(library))?;
        }
        writeln!(
            f,
            "\nOn an AVR {FEWER_STATES} states are compared, without denormals: avr-libc rounds the last bit of a denormal quotient differently.\n"
        )?;
        writeln!(
            f,
            "## Flash of the C\n\nBytes of code and constants, `-Os`, with picolibc (`report`: newlib). Without an FPU an image also has the functions for floats, once.\n\n{}",
            self.table(&[], |figures| {
                figures
                    .flash
                    .iter()
                    .filter(|(name, _)| !is_integers(name))
                    .map(|(name, bytes)| (name.clone(), bytes.to_string()))
                    .collect()
            })
        )?;
        writeln!(
            f,
            "## Instructions of the C\n\nMean · worst of {STATES} states, counted by QEMU with `-icount`. An instruction is not a cycle; AVR: cycles, by simavr.\n\n{}",
            self.table(&[], |figures| cost(&figures.c))
        )?;
        writeln!(
            f,
            "## In integers\n\nThe same policies [in integers](no-fpu.md), by `tpg-codegen quantise` with scales from the declared ranges. Mean instructions \
             (AVR: cycles) of\n{FEWER_STATES} states with 16 · 8 bits; the last column is the geometric mean of their shares of the floats. {} and {} \
             are close to the Cortex-M4F.\n\n{}",
            LIKE_M4F[0],
            LIKE_M4F[1],
            self.table(&LIKE_M4F, |figures| in_integers(&figures.c, Cost::mean))
        )?;
        writeln!(
            f,
            "Bytes of flash:\n\n{}",
            self.table(&LIKE_M4F, |figures| in_integers(&figures.flash, |&bytes| bytes as f64))
        )?;
        writeln!(
            f,
            "## Instructions of a decision of the hybrid\n\nMean · worst, in {EPISODES} test episodes from each start: `fs` fixed, `rs` random.\n\n{}",
            self.table(&[], |figures| cost(&figures.hybrid))
        )?;
        write!(
            f,
            "## Instructions of a network\n\nMean · worst of {INPUTS} inputs of a network 38-64-64-4 in integers (6,784 multiplications), by bits of \
             weights and activations.\n\n{}",
            self.table(&[], |figures| cost(&figures.layers))
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_of_cores_is_fresh() {
        let committed = build::committed(FILE).expect("the figures");
        let figures: Figures = toml::from_str(&committed).expect("figures");
        tpg_testing::book::page(PAGE, &figures.to_string());
    }
}
