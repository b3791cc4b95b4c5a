//! What the analyser is told, because the code alone does not show it. A bound holds where these hold.

use std::collections::BTreeMap;

/// How often the loops of a function turn at most: how often control comes to a loop's first instruction.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Turns {
    /// Every loop.
    Every(u64),
    /// Each loop, in the order of their first instructions. Where the function has another number of loops there is no
    /// bound: it is not the code that these were found for.
    Each(Vec<u64>),
}

/// Turns of loops, by function.
pub type LoopBounds = BTreeMap<String, Turns>;

/// The functions that a function's calls through a register may reach, by the caller.
pub type Calls = BTreeMap<String, Vec<String>>;

/// No more than so many runs of one function while another one runs once: less than its calls say.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Limit {
    /// While this one runs once,
    pub within: String,
    /// this one, wherever it is called from,
    pub function: String,
    /// runs no more than so many times.
    pub times: u64,
}
