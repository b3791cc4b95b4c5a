//! Columns of values: what lanes show to programs.

/// Lanes of a block: one vector of the widest there are.
pub const BLOCK: usize = 16;

/// The values of some neighbouring lanes.
pub type Block<T> = [T; BLOCK];

/// Where the values of the flat state go: a column for each that some program reads.
#[derive(Debug)]
pub struct View<'a, S> {
    pub(super) columns: &'a mut [Block<S>],
    pub(super) blocks: usize,
    /// For each value of the flat state, the place of its column; `u32::MAX` where nobody reads it.
    pub(super) places: &'a [u32],
}

impl<S> View<'_, S> {
    /// The column of a value of the flat state, in whole blocks of lanes; `None` where nobody reads it.
    #[inline]
    pub fn column(&mut self, input: usize) -> Option<&mut [[S; BLOCK]]> {
        let place = *self.places.get(input)? as usize;
        self.columns.get_mut(place * self.blocks..)?.get_mut(..self.blocks)
    }
}
