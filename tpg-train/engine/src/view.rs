//! Columns of observed values, one value per lane.

/// Lanes per block: one vector of the widest supported kind.
pub const BLOCK: usize = 16;

/// Half of a block.
pub(super) const HALF: usize = BLOCK / 2;

/// The values of neighbouring lanes.
pub type Block<T> = [T; BLOCK];

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
