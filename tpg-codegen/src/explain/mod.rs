//! `--explain`: the removals of each pass, and the remaining bids, team by team, as readable formulas.

mod policy;
mod table;

pub use policy::{BidFormula, LeafFormulas, PolicyFormulas, TeamFormulas};
pub use table::{Bids, Destination, Value};

use policy::fast;

use crate::formula::Spelling;
use crate::ir::Module;
use crate::options::{Language, Options};
use crate::passes::log::Log;
use crate::program::{Program, compile};
use crate::shape::Shape;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::{self, Write as _};
use tpg_graph::Word;
use tpg_graph::dataflow;
use tpg_graph::{Graph, Output};
use tpg_runtime::ops::Instruction;

/// Columns of a line.
const WIDTH: usize = 120;

/// The explanation of a graph as fast C: the same graph and options give the same text.
pub fn explain(graph: &Graph, options: &Options) -> String {
    let mut out = String::new();
    let explained = Explanation::new(&compile(graph, &fast(options), Language::C)).write(&mut out);
    explained.expect("a string takes everything");
    out
}

/// The formulas of a graph as fast C: what each team's bids are, and what each leaf computes.
pub fn formulas(graph: &Graph, options: &Options) -> String {
    let mut out = String::new();
    let program = compile(graph, &fast(options), Language::C);
    Explanation::new(&program).formulas(&mut out).expect("a string takes everything");
    out.trim_start().to_owned()
}

struct Explanation<'a> {
    program: &'a Program<'a>,
    graph: &'a Graph,
    lowered: Module<'a>,
}

impl<'a> Explanation<'a> {
    fn new(program: &'a Program<'a>) -> Self {
        Self { program, graph: program.graph(), lowered: Module::lower(program.graph()) }
    }

    fn write(&self, out: &mut String) -> fmt::Result {
        writeln!(out, "Graph SHA-256: {}", self.program.graph_sha256())?;
        writeln!(out, "Computes in {} with {} maths.", self.graph.scalar().name(), self.graph.maths().name())?;
        if let Some(conversion) = &self.program.options.conversion {
            writeln!(out, "The graph says {}: {}.", conversion.from.name(), conversion.agreement)?;
        }
        writeln!(out, "\nWhat the passes did\n")?;
        self.introns(out)?;
        self.removed(out)?;
        self.guards(out)?;
        self.formulas(out)
    }

    fn formulas(&self, out: &mut String) -> fmt::Result {
        let formulas = PolicyFormulas::of_program(self.program, Spelling::Exact);
        if !formulas.teams.is_empty() {
            self.teams(out, &formulas.teams)?;
        }
        self.leaves(out, &formulas.leaves)
    }

    /// Reachability, introns, value numbering and folding.
    fn introns(&self, out: &mut String) -> fmt::Result {
        let computing = self.graph.leaves().iter().flat_map(|leaf| &leaf.programs);
        let reached: BTreeSet<u32> = (self.lowered.bidders.iter().map(|bidder| bidder.label))
            .chain(computing.map(|&program| self.graph.program(program).label))
            .collect();
        let programs = self.graph.programs().iter();
        let (reached, unused): (Vec<_>, Vec<_>) = programs.partition(|program| reached.contains(&program.label));
        section(out, "reachability", unused.len(), "programs that no walk runs")?;
        list(out, "programs", unused.iter().map(|program| program.label.to_string()))?;

        let mut lines = 0;
        let (mut effective, mut instructions) = (0, 0);
        let mut affected = Vec::new();
        for program in reached {
            let needed = dataflow::effective(self.graph.registers().into(), &program.lines);
            let needed = || program.lines.iter().zip(&needed).filter(|(_, needed)| **needed).map(|(line, _)| line);
            let count = needed().count();
            instructions += needed().map(|line| line.instruction.instructions()).sum::<usize>();
            let all = program.lines.len();
            lines += all;
            effective += count;
            if count < all {
                affected.push(format!("{} ({} of {all})", program.label, all - count));
            }
        }
        section(out, "introns", lines - effective, &format!("of {lines} lines, that no result depends on"))?;
        list(out, "programs", affected.into_iter())?;
        let distinct = self.lowered.nodes.iter().filter(|node| node.is_computed()).count();
        let merged = instructions - distinct;
        let what = format!("of {instructions} instructions compute what another one does");
        section(out, "value numbering", merged, &what)?;
        let what =
            format!("of {distinct} operations are constant, equal to an operand, or of use to no result that is left");
        section(out, "folding", self.program.log.operations, &what)
    }

    fn removed(&self, out: &mut String) -> fmt::Result {
        let Log { duplicate_bids, hopeless_bids, teams_without_choice, twin_teams, unreachable_teams, .. } =
            &self.program.log;
        section(out, "duplicate bids", duplicate_bids.len(), "edges that bid as a later one of their team does")?;
        let bids = duplicate_bids.iter().map(|bid| (bid.team, format!("{} (as {})", bid.program, bid.same_as)));
        by_team(out, bids)?;
        section(out, "hopeless bids", hopeless_bids.len(), "edges that another one of their team always outbids")?;
        by_team(out, hopeless_bids.iter().map(|bid| (bid.team, bid.program.to_string())))?;
        section(out, "no choice", teams_without_choice.len(), "teams whose edges all lead to one place")?;
        list(out, "teams", teams_without_choice.iter().map(u32::to_string))?;
        section(out, "twins", twin_teams.len(), "teams that decide as another one does")?;
        list(out, "teams", twin_teams.iter().map(|twin| format!("{} (as {})", twin.team, twin.same_as)))?;
        section(out, "unreachable", unreachable_teams.len(), "teams that no edge leads to any more")?;
        list(out, "teams", unreachable_teams.iter().map(u32::to_string))
    }

    /// Bound-guarded evaluation, which only the profile fast does.
    fn guards(&self, out: &mut String) -> fmt::Result {
        let Shape::Fast { schedule, .. } = &self.program.shape else { return Ok(()) };
        let lazy = schedule.plans.iter().flat_map(|plan| &plan.lazy);
        let guarded = lazy.filter(|lazy| lazy.bound.is_some()).count();
        let edges: usize = self.program.module.teams.iter().map(|team| team.edges.len()).sum();
        let what = format!("of {edges} bids are computed only where a bound says that they can win (profile fast)");
        section(out, "lazy bids", guarded, &what)?;
        let teams = self.program.module.teams.len();
        let operations = self.program.module.nodes.iter().filter(|node| node.is_computed()).count();
        let programs = self.program.module.bidders.len();
        writeln!(out, "{:<16}{teams} teams, {edges} edges, {programs} programs, {operations} operations", "left")
    }

    fn teams(&self, out: &mut String, teams: &[TeamFormulas]) -> fmt::Result {
        writeln!(out, "\nWhat the teams compute\n")?;
        writeln!(out, "The highest bid wins, of equal bids the last; a NaN is the lowest.")?;
        self.words(out)?;
        for (index, team) in teams.iter().enumerate() {
            writeln!(out, "\nteam {}{}", team.id, if index == 0 { ", the root" } else { "" })?;
            write_shared(out, &team.shared)?;
            for BidFormula { program, to, formula, .. } in &team.bids {
                writeln!(out, "  program {program} -> {to}: {formula}")?;
            }
        }
        Ok(())
    }
}

impl Explanation<'_> {
    /// The meaning of words that do not explain themselves.
    fn words(&self, out: &mut String) -> fmt::Result {
        let negates = |word: &Word| *word == Instruction::NegateIfLess.into();
        if self.graph.instructions().iter().any(negates) {
            writeln!(out, "negate_if_less(a, b) is -a where a < b, else a.")?;
        }
        Ok(())
    }

    /// The outputs of each leaf as formulas.
    fn leaves(&self, out: &mut String, leaves: &[LeafFormulas]) -> fmt::Result {
        let outputs = self.graph.outputs();
        if outputs.is_empty() {
            return Ok(());
        }
        writeln!(out, "\nWhat the leaves compute\n")?;
        let (answers, memory) = outputs.split_at(outputs.len() - self.graph.memory());
        for Output { name, unit, range, nan, .. } in answers {
            writeln!(out, "{name} is limited to {range} {unit}; {nan} takes the place of NaN.")?;
        }
        for Output { name, range, nan, .. } in memory {
            writeln!(
                out,
                "{name}[0] is what {name} was at the last decision, and {nan} at the first; {name} is limited to {range}; \
                 {nan} takes the place of NaN."
            )?;
        }
        self.words(out)?;
        for leaf in leaves {
            writeln!(out, "\nleaf {}", leaf.id)?;
            write_shared(out, &leaf.shared)?;
            for (name, formula) in &leaf.values {
                writeln!(out, "  {name} = {formula}")?;
            }
        }
        Ok(())
    }
}

fn write_shared(out: &mut String, shared: &[(String, String)]) -> fmt::Result {
    shared.iter().try_for_each(|(name, formula)| writeln!(out, "    {name} = {formula}"))
}

fn section(out: &mut String, name: &str, count: usize, what: &str) -> fmt::Result {
    writeln!(out, "{name:<16}{count} {what}")
}

/// A list over as many lines as it takes, or nothing.
fn list(out: &mut String, what: &str, items: impl Iterator<Item = String>) -> fmt::Result {
    const INDENT: usize = 16;
    let mut line = String::new();
    for item in items {
        if line.is_empty() {
            line = format!("{:INDENT$}{what} {item}", "");
        } else if line.len() + 2 + item.len() > WIDTH {
            writeln!(out, "{line},")?;
            line = format!("{:INDENT$}  {item}", "");
        } else {
            write!(line, ", {item}")?;
        }
    }
    if line.is_empty() { Ok(()) } else { writeln!(out, "{line}") }
}

/// Lists, each behind its team, by the teams' ids.
fn by_team(out: &mut String, items: impl Iterator<Item = (u32, String)>) -> fmt::Result {
    let mut teams: BTreeMap<u32, Vec<String>> = BTreeMap::new();
    for (team, item) in items {
        teams.entry(team).or_default().push(item);
    }
    for (team, items) in teams {
        list(out, &format!("team {team}: programs"), items.into_iter())?;
    }
    Ok(())
}
