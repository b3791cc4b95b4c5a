
/// From an entry of a table to the next.
fn span<T: Copy + Into<u32>>(table: &[T], place: usize) -> core::ops::Range<usize> {
    let at = |place: usize| table.get(place).map_or(0, |&entry| entry.into() as usize);
    at(place)..at(place + 1)
}
