//! The removals of the passes.

use serde::Serialize;

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

/// An edge that bids the same as a later one of its team. Teams and programs by their ids in the source file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct DuplicateBid {
    /// The team.
    pub team: u32,
    /// The program whose edge was removed.
    pub program: u32,
    /// The program of the remaining edge; the same if it had two.
    pub same_as: u32,
}

/// An edge whose bid provably never wins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct HopelessBid {
    /// The team.
    pub team: u32,
    /// The program whose edge was removed.
    pub program: u32,
}

/// A team that is equivalent to another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct TwinTeam {
    /// The removed team.
    pub team: u32,
    /// The remaining team.
    pub same_as: u32,
}

/// The removals of the passes, in order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Log {
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
    /// The number of each.
    pub(crate) fn counts(&self) -> Removed {
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
