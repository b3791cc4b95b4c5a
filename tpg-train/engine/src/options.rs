//! Settings of the engine.

use crate::parts::MOST_LANES;

/// Settings of the engine; none of them changes a result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EngineOptions {
    /// Number of parallel episodes, 1 to [`MOST_LANES`](Self::MOST_LANES).
    pub lanes: usize,
    /// Compute equal values once, and drop bids that cannot win.
    pub share: bool,
    /// Compute bounded, expensive bids only where they could win.
    pub lazy: bool,
    /// Look for cycles at every step, not only at the end of an episode.
    pub look_for_cycles: bool,
}

impl EngineOptions {
    /// Greatest number of parallel episodes.
    pub const MOST_LANES: usize = MOST_LANES;
}

impl Default for EngineOptions {
    fn default() -> Self {
        Self { lanes: 112, share: true, lazy: true, look_for_cycles: true }
    }
}
