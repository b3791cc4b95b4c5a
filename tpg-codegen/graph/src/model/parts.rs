//! What a graph with memory sees of the world, and what it tells it.

use super::{Graph, Output, Range, SourceDocument};

impl Graph {
    /// The sources, without those of the memory.
    pub fn observed(&self) -> &[SourceDocument] {
        &self.sources()[..self.sources().len() - self.memory()]
    }

    /// The number of values of a state that are observed.
    pub fn observed_length(&self) -> usize {
        self.state_length() - self.memory()
    }

    /// The outputs that are answered, and those that the memory keeps.
    pub fn split_outputs(&self) -> (&[Output], &[Output]) {
        self.outputs().split_at(self.outputs().len() - self.memory())
    }
}

impl Range {
    /// The greatest magnitude in it.
    pub fn magnitude(self) -> f64 {
        self.min.abs().max(self.max.abs())
    }
}
