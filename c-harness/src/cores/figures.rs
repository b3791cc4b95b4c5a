//! Flash and instructions on each core: compared with `cores.toml`, and written for people as `docs/cores.md`.

use super::core::{CORES, Core};
use super::images::EPISODES;
use super::shipped::{FEWER_STATES, STATES, WIDTHS};
use crate::Failure;
use crate::build;
use crate::costs::{Cost, Tolerance};
use crate::line::Line;
use askama::Template;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use tpg_cores::layers::INPUTS;
use tpg_testing::library;

const FILE: &str = "cores.toml";

/// The page for people, in the book.
const PAGE: &str = "cores.md";

/// Cores on which a policy costs nearly what it costs on a Cortex-M4F: the page leaves them out there.
const LIKE_M4F: [&str; 2] = ["Cortex-M7", "Cortex-M33"];

/// The policies on the page: formulas, teams and weighted sums, small and large.
const SHOWN: [&str; 8] =
    ["cartpole", "mountain_car", "pendulum", "lunar_lander", "hopper", "bipedal_walker", "dodge", "widowx_rs"];

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
struct OfCore {
    /// Bytes of flash of the C; of integers of so many bits, under the policy's name with the bits behind it.
    #[serde(default)]
    flash: BTreeMap<String, u64>,
    /// Instructions, by program: of the C, named alike, and of the Rust; of decisions of the hybrid, in C, by start; of networks, by the
    /// kind of their weights and activations.
    #[serde(flatten)]
    costs: BTreeMap<String, BTreeMap<String, Cost>>,
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
    pub(super) fn add(&mut self, core: &Core, program: &str, lines: &[Line]) {
        if !core.figures || !core.counts() {
            return;
        }
        let figures = self.core.entry(core.name.to_owned()).or_default();
        let costs = figures.costs.entry(program.to_owned()).or_default();
        for line in lines {
            if let [first, name, rest @ ..] = &*line.words
                && (program != "hybrid" || rest == ["hybrid"])
                && ["policy", "layers", "episode"].contains(&first.as_str())
            {
                costs.entry(name.clone()).or_default().add(line);
            }
        }
    }

    /// Differences from what is committed; a test compares the page.
    pub(super) fn differences(&self) -> Result<Vec<String>, Failure> {
        let committed: Self = build::committed(FILE)?;
        let tolerance = Tolerance::new(FILE, &committed.compilers, &self.compilers);
        let mut differences = Vec::new();
        for (name, found) in &self.core {
            let was = committed.core.get(name).cloned().unwrap_or_default();
            let place = |what: &str| format!("{name}, {what}, ");
            differences.extend(tolerance.differences(&place("flash"), &found.flash, &was.flash, |&bytes| [bytes]));
            for (program, found) in &found.costs {
                let was = was.costs.get(program).cloned().unwrap_or_default();
                differences.extend(tolerance.differences(&place(program), found, &was, Cost::numbers));
            }
        }
        Ok(differences)
    }

    /// Takes these figures as the committed ones.
    pub(super) fn commit(&self) -> Result<(), Failure> {
        let comment =
            "Flash and instructions on each core; `cargo xtask cores --update` writes this file and docs/cores.md.";
        build::commit(FILE, comment, self)?;
        let page = library::top().join("docs").join(PAGE);
        let text = CoresPage::new(self).render()? + "\n";
        build::write(&page, text)
    }

    /// A table with a row for each core of which something is known.
    fn table(&self, without: &[&str], columns: &[String], cells: impl Fn(&OfCore) -> Option<Vec<String>>) -> String {
        let mut text = format!("| core | {} |\n| --- |{}\n", columns.join(" | "), " --: |".repeat(columns.len()));
        for core in CORES.iter().filter(|core| core.figures && !without.contains(&core.name)) {
            if let Some(row) = self.core.get(core.name).and_then(&cells) {
                let _ = writeln!(text, "| {} | {} |", core.name, row.join(" | "));
            }
        }
        text
    }

    /// A table of what each shown policy costs in floats and in integers.
    fn policies(&self, cells: impl Fn(&OfCore) -> Option<Vec<String>>) -> String {
        let mut columns: Vec<String> = SHOWN.iter().map(|name| format!("`{name}`")).collect();
        columns.push("integers / floats".to_owned());
        self.table(&LIKE_M4F, &columns, cells)
    }
}

/// The costs of each shown policy in floats and in integers, and the geometric means of the ratios of all policies.
fn costs_of<T>(costs: &BTreeMap<String, T>, number: impl Fn(&T) -> u64) -> Option<Vec<String>> {
    let pair = |name: &str, bits: u32| -> Option<[u64; 2]> {
        Some([costs.get(name)?, costs.get(&format!("{name}_{bits}"))?].map(&number))
    };
    let shown: Option<Vec<[u64; 2]>> = SHOWN.iter().map(|name| pair(name, WIDTHS[0])).collect();
    let mut cells: Vec<String> = shown?.iter().map(|[floats, integers]| format!("{floats} · {integers}")).collect();
    let logarithm = |[floats, integers]: [u64; 2]| (integers as f64 / floats as f64).ln();
    let means = WIDTHS.map(|bits| {
        let logarithms: Vec<f64> = costs.keys().filter_map(|name| pair(name, bits)).map(logarithm).collect();
        format!("{:.2}", (logarithms.iter().sum::<f64>() / logarithms.len() as f64).exp())
    });
    cells.push(means.join(" · "));
    Some(cells)
}

/// The costs of decisions of the hybrid and of a network; nothing where one of them was not counted.
fn parts_of(figures: &OfCore) -> Option<Vec<String>> {
    let shown = [("hybrid", "fs"), ("hybrid", "rs"), ("layers", "w16a16"), ("layers", "w8a16")];
    let all: Option<Vec<&Cost>> = shown.iter().map(|(program, name)| figures.costs.get(*program)?.get(*name)).collect();
    Some(all?.iter().map(|cost| format!("{:.0} · {}", cost.mean(), cost.worst)).collect())
}

/// The cores with or without programs in Rust and the library.
fn compared(rust: bool, in_library: bool) -> String {
    let is_in_library = |core: &Core| core.target.is_some_and(|target| library::TARGETS.contains(&target));
    let cores = CORES.iter().filter(|core| core.target.is_some() == rust && is_in_library(core) == in_library);
    cores.map(Core::title).collect::<Vec<_>>().join(", ")
}

/// The page for people.
#[derive(Template)]
#[template(path = "cores.md", escape = "none")]
struct CoresPage {
    bits: u32,
    few_bits: u32,
    like: [&'static str; 2],
    states: usize,
    fewer_states: usize,
    episodes: usize,
    inputs: u32,
    flash: String,
    instructions: String,
    parts: String,
    in_library: String,
    in_rust: String,
    in_c: String,
}

impl CoresPage {
    fn new(figures: &Figures) -> Self {
        let [bits, few_bits] = WIDTHS;
        let columns = ["hybrid, `fs`", "hybrid, `rs`", "network `w16a16`", "network `w8a16`"].map(str::to_owned);
        Self {
            bits,
            few_bits,
            like: LIKE_M4F,
            states: STATES,
            fewer_states: FEWER_STATES,
            episodes: EPISODES,
            inputs: INPUTS,
            flash: figures.policies(|figures| costs_of(&figures.flash, |&bytes| bytes)),
            instructions: figures.policies(|figures| costs_of(figures.costs.get("c")?, |cost| cost.worst)),
            parts: figures.table(&[], &columns, parts_of),
            in_library: compared(true, true),
            in_rust: compared(true, false),
            in_c: compared(false, false),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_of_cores_is_fresh() {
        let figures: Figures = build::committed(FILE).expect("the figures");
        tpg_testing::book::page(PAGE, &(CoresPage::new(&figures).render().expect("a page") + "\n"));
    }
}
