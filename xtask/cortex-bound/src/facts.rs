//! Facts supplied by the user that the code alone does not show. A bound holds only if these hold.

use std::collections::BTreeMap;

/// Maximum iterations of a function's loops: how often control reaches a loop's first instruction.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Turns {
    /// Every loop.
    Every(u64),
    /// One bound for each loop, in the order of their first instructions. If the function has a different number of
    /// loops there is no bound: the code has changed since the bounds were determined.
    Each(Vec<u64>),
}

/// Iterations of loops, by function.
pub type LoopBounds = BTreeMap<String, Turns>;

/// The possible targets of a function's calls through a register, by the caller.
pub type Calls = BTreeMap<String, Vec<String>>;

/// A limit on the runs of one function while another one runs once, below the number implied by its calls.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Limit {
    /// While this function runs once,
    pub within: String,
    /// this function, regardless of its caller,
    pub function: String,
    /// runs at most this number of times.
    pub times: u64,
}
