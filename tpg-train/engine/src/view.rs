//! Columns of observed values, one value per lane.

/// Lanes per block: one vector of the widest supported kind.
pub const BLOCK: usize = 16;

/// The values of neighbouring lanes.
pub type Block<T> = [T; BLOCK];

/// Lanes of a part of a block: functions that take long are computed by so many.
pub(super) const PART: usize = 8;

/// Returns the values of a part, counted from the first block on.
#[inline(always)]
pub(super) fn part<T>(blocks: &[Block<T>], part: usize) -> &[T; PART] {
    &blocks.as_flattened().as_chunks().0[part]
}

/// As [`part`], to be changed.
#[inline(always)]
pub(super) fn part_mut<T>(blocks: &mut [Block<T>], part: usize) -> &mut [T; PART] {
    &mut blocks.as_flattened_mut().as_chunks_mut().0[part]
}

/// Destination of observed values: a column for each value of the flat state that some program reads.
#[derive(Debug)]
pub struct View<'a, S> {
    pub(super) columns: &'a mut [Block<S>],
    pub(super) blocks: usize,
    /// Index of the column of each value of the flat state; `u32::MAX` if nothing reads it.
    pub(super) places: &'a [u32],
}

impl<S> View<'_, S> {
    /// Returns the column of a value of the flat state, in whole blocks of lanes; `None` if nothing reads it.
    #[inline]
    pub fn column(&mut self, input: usize) -> Option<&mut [[S; BLOCK]]> {
        let place = *self.places.get(input)? as usize;
        self.columns.get_mut(place * self.blocks..)?.get_mut(..self.blocks)
    }
}
