//! Settings of the engine.

/// Settings of the engine; none of them changes a result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EngineOptions {
    /// Number of parallel episodes.
    pub lanes: usize,
    /// Compute equal values once, and drop bids that cannot win.
    pub share: bool,
    /// Compute bounded, expensive bids only where they could win.
    pub lazy: bool,
    /// Look for cycles at every step, not only at the end of an episode.
    pub look_for_cycles: bool,
}

impl Default for EngineOptions {
    fn default() -> Self {
        Self { lanes: 112, share: true, lazy: true, look_for_cycles: true }
    }
}
