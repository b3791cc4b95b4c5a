//! The removals of the passes.

use serde::Serialize;
use std::ops::AddAssign;

/// The number of removals of each kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Removed {
    /// Operations that were constant, equal to one of their operands, or dead.
    pub operations: usize,
    /// Edges that bid the same as a later one of their team.
    pub duplicate_bids: usize,
    /// Edges whose bid provably never wins.
    pub hopeless_bids: usize,
    /// Teams whose edges all have one destination.
    pub teams_without_choice: usize,
    /// Teams that are equivalent to another.
    pub twin_teams: usize,
    /// Teams that have become unreachable.
    pub unreachable_teams: usize,
}

impl AddAssign for Removed {
    fn add_assign(&mut self, more: Self) {
        self.operations += more.operations;
        self.duplicate_bids += more.duplicate_bids;
        self.hopeless_bids += more.hopeless_bids;
        self.teams_without_choice += more.teams_without_choice;
        self.twin_teams += more.twin_teams;
        self.unreachable_teams += more.unreachable_teams;
    }
}
