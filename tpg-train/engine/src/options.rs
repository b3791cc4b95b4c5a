//! Settings of the engine.

use crate::parts::MOST_LANES;

/// Settings of the engine; none of them changes a result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EngineOptions {
    /// Number of parallel episodes, 1 to [`MOST_LANES`](Self::MOST_LANES).
    pub lanes: usize,
    /// Compute bounded, expensive bids only where they could win.
    pub lazy: bool,
}

impl EngineOptions {
    /// Greatest number of parallel episodes.
    pub const MOST_LANES: usize = MOST_LANES;
}

impl Default for EngineOptions {
    fn default() -> Self {
        Self { lanes: 112, lazy: true }
    }
}
