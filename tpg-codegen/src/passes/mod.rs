//! What makes generated code small and fast without changing what it does.
//!
//! Every pass is exact, for every state there is, NaN and infinities included: the compiled policy takes the
//! interpreter's action. Two of them need no module here, for [`Module::lower`] does them by the way it works:
//! **reachability** (teams are found from the root) and **intron removal** (lines that do not reach register 0 leave no
//! node); and so is **value numbering**: equal expressions are one node, whichever programs compute them. What of them is
//! computed already where a team decides, [`available`] finds.
//!
//! With [`Assumption::DeclaredRanges`] the passes believe the ranges that the graph declares. Then, and only then, a state
//! outside of them may get another action (still one of the graph's, and nothing undefined).

pub mod arithmetic;
pub mod available;
pub mod bound;
pub mod bytecode;
mod collect;
mod duplicates;
pub mod estimate;
pub(crate) mod evaluate;
mod fold;
pub mod functions;
mod hopeless;
pub mod interval;
pub mod schedule;
mod teams;
pub mod wins;

use crate::ir::{Module, Node};
use arithmetic::Arithmetic;
use interval::Assumption;
use serde::Serialize;
use tpg_graph::Graph;

/// What the passes removed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Removed {
    /// Operations that were constant, or equal to one of their operands, or of no use to any bid.
    pub operations: usize,
    /// Edges that bid the same as a later one of their team.
    pub duplicate_bids: usize,
    /// Edges whose bid provably never wins.
    pub hopeless_bids: usize,
    /// Teams whose edges all lead to one place.
    pub teams_without_choice: usize,
    /// Teams that decide like another.
    pub twin_teams: usize,
    /// Teams that nothing leads to any more.
    pub unreachable_teams: usize,
}

/// An edge that bids the same as a later one of its team. Teams and programs by their ids in the source file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DuplicateBid {
    /// The team.
    pub team: u32,
    /// The program whose edge went.
    pub program: u32,
    /// The program of the edge that stayed; the same one where it had two.
    pub same_as: u32,
}

/// An edge whose bid provably never wins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HopelessBid {
    /// The team.
    pub team: u32,
    /// The program whose edge went.
    pub program: u32,
}

/// A team that decides like another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TwinTeam {
    /// The team that went.
    pub team: u32,
    /// The team that stayed.
    pub same_as: u32,
}

/// What exactly the passes removed, in the order they did.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Log {
    /// See [`Removed::operations`].
    pub operations: usize,
    /// See [`Removed::duplicate_bids`].
    pub duplicate_bids: Vec<DuplicateBid>,
    /// See [`Removed::hopeless_bids`].
    pub hopeless_bids: Vec<HopelessBid>,
    /// See [`Removed::teams_without_choice`].
    pub teams_without_choice: Vec<u32>,
    /// See [`Removed::twin_teams`].
    pub twin_teams: Vec<TwinTeam>,
    /// See [`Removed::unreachable_teams`].
    pub unreachable_teams: Vec<u32>,
}

impl Log {
    /// How many of each.
    pub fn counts(&self) -> Removed {
        Removed {
            operations: self.operations,
            duplicate_bids: self.duplicate_bids.len(),
            hopeless_bids: self.hopeless_bids.len(),
            teams_without_choice: self.teams_without_choice.len(),
            twin_teams: self.twin_teams.len(),
            unreachable_teams: self.unreachable_teams.len(),
        }
    }
}

/// Lowers a graph and optimises it.
pub fn optimise(graph: &Graph, assumption: Assumption) -> (Module<'_>, Removed) {
    let (module, log) = optimise_logged(graph, assumption);
    (module, log.counts())
}

/// As [`optimise`], and says what exactly went.
pub fn optimise_logged(graph: &Graph, assumption: Assumption) -> (Module<'_>, Log) {
    let arithmetic = Arithmetic::of(graph);
    let mut module = Module::lower(graph);
    let mut log = Log::default();
    let before = operations(&module);
    fold::run(&mut module, arithmetic);
    // Each round can make the next one find more; a round that finds nothing is the last.
    loop {
        let duplicates = duplicates::run(&mut module);
        let intervals = interval::analyse(&module, assumption);
        let hopeless = hopeless::run(&mut module, &intervals);
        let teams = teams::run(&mut module);
        collect::run(&mut module);
        let finished = duplicates.is_empty() && hopeless.is_empty() && teams.is_empty();
        log.duplicate_bids.extend(duplicates);
        log.hopeless_bids.extend(hopeless);
        log.teams_without_choice.extend(teams.bypassed);
        log.twin_teams.extend(teams.merged);
        log.unreachable_teams.extend(teams.unreachable);
        if finished {
            break;
        }
    }
    log.operations = before - operations(&module);
    (module, log)
}

fn operations(module: &Module<'_>) -> usize {
    module.nodes.iter().filter(|node| matches!(node, Node::Operation(..))).count()
}
