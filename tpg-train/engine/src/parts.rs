//! Sets of parts of blocks of lanes.

use crate::view::{BLOCK, PART};

/// A set of parts of blocks, of neighbouring lanes each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Parts(u64);

/// Most lanes that a set of parts can cover.
pub(super) const MOST_LANES: usize = u64::BITS as usize * PART;

const _: () = assert!(BLOCK == 2 * PART, "`Parts::blocks` joins two parts");

impl Parts {
    /// The set of no part.
    pub(super) const NONE: Self = Self(0);

    /// Adds a part.
    #[inline(always)]
    pub(super) fn insert(&mut self, part: usize) {
        self.0 |= 1 << part;
    }

    /// Adds the parts of another set.
    #[inline(always)]
    pub(super) fn add(&mut self, other: Self) {
        self.0 |= other.0;
    }

    /// Returns the parts that are not in another set.
    #[inline(always)]
    pub(super) fn without(self, other: Self) -> Self {
        Self(self.0 & !other.0)
    }

    #[inline(always)]
    pub(super) fn contains(self, part: usize) -> bool {
        self.0 & (1 << part) != 0
    }

    #[inline(always)]
    pub(super) fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// Returns the number of lanes.
    #[inline(always)]
    pub(super) fn lanes(self) -> usize {
        self.0.count_ones() as usize * PART
    }

    /// Returns the blocks that have one of the parts, in ascending order.
    #[inline(always)]
    pub(super) fn blocks(self) -> impl Iterator<Item = usize> {
        let first_parts = u64::MAX / 3;
        Self((self.0 | self.0 >> 1) & first_parts).map(|part| part / 2)
    }
}

impl Iterator for Parts {
    type Item = usize;

    /// Removes the first part and returns it.
    #[inline(always)]
    fn next(&mut self) -> Option<usize> {
        if self.0 == 0 {
            return None;
        }
        let first = self.0.trailing_zeros() as usize;
        self.0 &= self.0 - 1;
        Some(first)
    }
}

#[cfg(test)]
mod tests {
    use super::Parts;

    fn set(parts: &[usize]) -> Parts {
        let mut set = Parts::NONE;
        parts.iter().for_each(|&part| set.insert(part));
        set
    }

    #[test]
    fn parts_come_in_ascending_order() {
        let parts = set(&[63, 0, 5, 5]);
        assert_eq!((parts.lanes(), parts.collect::<Vec<_>>()), (24, vec![0, 5, 63]));
        assert_eq!(parts.without(set(&[5])), set(&[0, 63]));
        assert!(parts.contains(5) && !parts.contains(6) && !parts.is_empty() && Parts::NONE.is_empty());
    }

    #[test]
    fn blocks_come_once_for_both_of_their_parts() {
        assert_eq!(set(&[1, 4, 5, 62]).blocks().collect::<Vec<_>>(), [0, 2, 31]);
        assert_eq!(Parts(u64::MAX).blocks().collect::<Vec<_>>(), (0..32).collect::<Vec<_>>());
    }
}
