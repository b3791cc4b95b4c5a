//! Subsets of an environment's sources.

use tpg_graph::SourceDocument;

/// Returns the number of values in the flat state of some sources.
pub fn state_length(sources: &[SourceDocument]) -> usize {
    sources.iter().map(|source| source.length as usize).sum()
}

/// A set of an environment's sources, by index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SourceSet(u64);

impl SourceSet {
    /// Every source.
    pub const ALL: Self = Self(u64::MAX);
    /// No source.
    pub const NONE: Self = Self(0);

    /// Returns the set with the source at that index added.
    #[must_use]
    pub fn with(self, place: usize) -> Self {
        Self(self.0 | 1 << place)
    }

    /// Returns the sources that contain the given inputs of the flat state.
    pub fn of_inputs(sources: &[SourceDocument], inputs: impl Iterator<Item = u16>) -> Self {
        assert!(sources.len() <= 64, "an environment has at most 64 sources");
        let mut ends = Vec::new();
        let mut end = 0;
        for source in sources {
            end += source.length;
            ends.push(end);
        }
        let bits = inputs.map(|input| 1u64 << ends.partition_point(|&end| end <= u32::from(input)));
        Self(bits.fold(0, |set, bit| set | bit))
    }

    /// True if the source at that index is in the set.
    #[inline]
    pub fn contains(self, place: usize) -> bool {
        place < 64 && self.0 & (1 << place) != 0
    }
}

#[cfg(test)]
mod tests {
    use crate::SourceSet;
    use tpg_graph::SourceDocument;

    #[test]
    fn an_input_belongs_to_the_source_it_lies_in() {
        let source = |length| SourceDocument::new(format!("s{length}"), "", vec![[0.0, 1.0]; length]);
        let sources = [source(3), source(1), source(2)];
        let set = |inputs: &[u16]| {
            let set = SourceSet::of_inputs(&sources, inputs.iter().copied());
            [0, 1, 2].map(|place| set.contains(place))
        };
        assert_eq!(set(&[0]), [true, false, false]);
        assert_eq!(set(&[2, 3]), [true, true, false]);
        assert_eq!(set(&[4, 5]), [false, false, true]);
        assert_eq!(set(&[]), [false; 3]);
    }
}
