//! Instructions of an action, compared with the counts committed in `costs.toml`.

use crate::Failure;
use crate::build;
use crate::line::Line;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

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

    /// Counts what a firmware printed; names get its language in front.
    pub(crate) fn add(&mut self, language: &str, lines: &[Line]) {
        for line in lines {
            match line.words.iter().map(String::as_str).collect::<Vec<_>>()[..] {
                ["episode", set, name] => {
                    let cost = self.cost.entry(format!("{language} {set} {name}")).or_default();
                    cost.actions += line.number("actions");
                    cost.instructions += line.number("instructions");
                    cost.worst = cost.worst.max(line.number("worst"));
                }
                ["cost", ref names @ ..] => {
                    let cost = self.cost.entry(format!("{language} {}", names.join(" "))).or_default();
                    cost.actions += line.number("actions");
                    cost.instructions += line.number("instructions");
                    cost.worst = cost.worst.max(line.number("worst"));
                }
                ["around"] => {
                    for name in ["observe", "switch"] {
                        let count = line.number(name);
                        let cost = Cost { actions: 1, instructions: count, worst: count };
                        self.cost.insert(format!("{language} {name}"), cost);
                    }
                }
                _ => {}
            }
        }
    }

    /// Prints a table: what, actions, mean and worst.
    pub(crate) fn print(&self) {
        println!("\n{:<34} {:>9} {:>12} {:>9}", "instructions an action", "actions", "mean", "worst");
        for (name, cost) in &self.cost {
            let mean = cost.instructions as f64 / cost.actions.max(1) as f64;
            println!("{name:<34} {:>9} {mean:>12.1} {:>9}", cost.actions, cost.worst);
        }
    }

    /// Differences from the committed counts. With other compilers 2 % are allowed, and a line says so.
    pub(crate) fn differences(&self) -> Result<Vec<String>, Failure> {
        let committed: Self = toml::from_str(&build::committed(FILE)?).map_err(Failure::new)?;
        let exact = committed.compilers == self.compilers;
        if !exact {
            println!("{FILE} was made with other compilers ({:?}): 2 % are allowed", committed.compilers);
        }
        let near = |a: u64, b: u64| if exact { a == b } else { a.abs_diff(b) * 50 <= b };
        let mut differences = Vec::new();
        for (name, cost) in &self.cost {
            match committed.cost.get(name) {
                Some(was)
                    if cost.actions == was.actions
                        && near(cost.instructions, was.instructions)
                        && near(cost.worst, was.worst) => {}
                was => differences.push(format!("{name}: {cost:?}, {FILE} has {was:?}")),
            }
        }
        Ok(differences)
    }

    /// Takes these counts as the committed ones.
    pub(crate) fn commit(&self) -> Result<(), Failure> {
        let text = toml::to_string(self).map_err(Failure::new)?;
        let head = "# Instructions counted under QEMU; `cargo xtask qemu --update` writes this file.\n\n";
        build::commit(FILE, &format!("{head}{text}"))
    }
}
