//! The walk from the root to an action in GEGELATI's shape: a bounded loop around a switch.
//!
//! Compilers put a function with one caller into that caller, so one switch over thousands of teams becomes one function
//! of thousands of blocks, and some of their passes take more than linear time in those. Many teams are therefore split
//! over several switches: 10,000 teams compile in a fifth of the time.

use super::expression::Printer;
use crate::ir::Module;
use askama::Template;

/// Teams of one switch.
const GROUP: usize = 64;

#[derive(Template)]
#[template(path = "c/walk.c", escape = "none")]
struct CWalk<'a> {
    prefix: &'a str,
    upper: &'a str,
    groups: Vec<&'a [CCase]>,
    group_size: usize,
}

struct CCase {
    vertex: usize,
    label: u32,
}

/// Renders GEGELATI's entry point.
pub(super) fn render(printer: &Printer<'_>, module: &Module<'_>, upper: &str) -> String {
    let cases: Vec<CCase> =
        module.teams.iter().enumerate().map(|(vertex, team)| CCase { vertex, label: team.label }).collect();
    let groups = cases.chunks(GROUP).collect();
    let walk = CWalk { prefix: printer.prefix, upper, groups, group_size: GROUP };
    walk.render().expect("the template renders")
}
