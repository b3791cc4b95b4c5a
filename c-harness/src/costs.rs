//! Instructions of an action, compared with the counts committed in `costs.toml`.

use crate::Failure;
use crate::build;
use crate::line::Line;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fmt::Debug;

const FILE: &str = "costs.toml";

/// Instructions of many actions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Cost {
    /// Number of actions.
    pub(crate) actions: u64,
    /// Instructions of all of them.
    pub(crate) instructions: u64,
    /// Instructions of the most expensive one.
    pub(crate) worst: u64,
}

impl Cost {
    /// Adds what a line says.
    pub(crate) fn add(&mut self, line: &Line) {
        self.actions += line.number("actions");
        self.instructions += line.number("instructions");
        self.worst = self.worst.max(line.number("worst"));
    }

    /// Instructions of an action in the mean.
    pub(crate) fn mean(&self) -> f64 {
        self.instructions as f64 / self.actions.max(1) as f64
    }

    /// All of it, to compare.
    pub(crate) fn numbers(&self) -> [u64; 3] {
        [self.actions, self.instructions, self.worst]
    }
}

/// Tolerance of figures beside the committed ones in a file: 2 % with other compilers.
pub(crate) struct Tolerance {
    file: &'static str,
    exact: bool,
}

impl Tolerance {
    /// Compares the compilers, and says so where they differ.
    pub(crate) fn new(
        file: &'static str,
        committed: &BTreeMap<String, String>,
        used: &BTreeMap<String, String>,
    ) -> Self {
        let exact = committed == used;
        if !exact {
            println!("{file} was made with other compilers ({committed:?}): 2 % are allowed");
        }
        Self { file, exact }
    }

    /// A line for each figure that is not near the committed one of its name.
    pub(crate) fn differences<T: Debug, const N: usize>(
        &self,
        place: &str,
        found: &BTreeMap<String, T>,
        committed: &BTreeMap<String, T>,
        numbers: impl Fn(&T) -> [u64; N],
    ) -> Vec<String> {
        let near = |(found, was): (u64, u64)| found == was || (!self.exact && found.abs_diff(was) * 50 <= was);
        let differs = |(name, found): (&String, &T)| {
            let was = committed.get(name);
            let same = was.is_some_and(|was| numbers(found).into_iter().zip(numbers(was)).all(near));
            (!same).then(|| format!("{place}{name}: {found:?}, {} has {was:?}", self.file))
        };
        found.iter().filter_map(differs).collect()
    }
}

/// `costs.toml`.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Costs {
    /// The compilers that these counts belong to, by their own words.
    pub(crate) compilers: BTreeMap<String, String>,
    /// Counts, by name.
    #[serde(default)]
    pub(crate) cost: BTreeMap<String, Cost>,
}

impl Costs {
    /// Nothing counted, with the compilers in use.
    pub(crate) fn new() -> Self {
        let compilers =
            [("rustc", "rustc"), ("gcc", "arm-none-eabi-gcc")].map(|(name, p)| (name.to_owned(), build::version(p)));
        Self { compilers: compilers.into(), cost: BTreeMap::new() }
    }

    /// Counts what a firmware printed.
    pub(crate) fn add(&mut self, lines: &[Line]) {
        for line in lines {
            if let Some((first, names)) = line.words.split_first()
                && ["episode", "cost"].contains(&first.as_str())
            {
                self.cost.entry(names.join(" ")).or_default().add(line);
            }
        }
    }

    /// Prints a table: what, actions, mean and worst.
    pub(crate) fn print(&self) {
        println!("\n{:<34} {:>9} {:>12} {:>9}", "instructions an action", "actions", "mean", "worst");
        for (name, cost) in &self.cost {
            println!("{name:<34} {:>9} {:>12.1} {:>9}", cost.actions, cost.mean(), cost.worst);
        }
    }

    /// Differences from the committed counts.
    pub(crate) fn differences(&self) -> Result<Vec<String>, Failure> {
        let committed: Self = build::committed(FILE)?;
        let tolerance = Tolerance::new(FILE, &committed.compilers, &self.compilers);
        Ok(tolerance.differences("", &self.cost, &committed.cost, Cost::numbers))
    }

    /// Takes these counts as the committed ones.
    pub(crate) fn commit(&self) -> Result<(), Failure> {
        build::commit(FILE, "Instructions counted under QEMU; `cargo xtask qemu --update` writes this file.", self)
    }
}
