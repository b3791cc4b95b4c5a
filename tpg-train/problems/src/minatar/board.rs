//! Boards of ten by ten cells as bits, and the random numbers of a game.

use crate::sight::mixed;

/// A channel: cell (row, column) is bit 10 · row + column.
pub(crate) type Board = u128;

/// Rows, and columns.
pub(crate) const SIDE: i32 = 10;

/// Returns a cell.
pub(crate) const fn cell(row: i32, column: i32) -> Board {
    1 << (SIDE * row + column)
}

/// Returns the cells of a block: from its first row and column to those before the ends.
pub(crate) const fn block([top, bottom]: [i32; 2], [left, right]: [i32; 2]) -> Board {
    let mut board = 0;
    let mut place = 0;
    while place < SIDE * SIDE {
        let (row, column) = (place / SIDE, place % SIDE);
        if row >= top && row < bottom && column >= left && column < right {
            board |= cell(row, column);
        }
        place += 1;
    }
    board
}

/// Every cell.
pub(crate) const ALL: Board = block([0, SIDE], [0, SIDE]);
pub(crate) const FIRST_COLUMN: Board = block([0, SIDE], [0, 1]);
pub(crate) const LAST_COLUMN: Board = block([0, SIDE], [SIDE - 1, SIDE]);

/// Tests for a number of a row or column.
pub(crate) fn is_inside(place: i32) -> bool {
    (0..SIDE).contains(&place)
}

/// The random numbers of an episode: SplitMix64.
#[derive(Clone, Debug)]
pub(crate) struct Draws {
    pub(super) seed: u64,
    pub(super) drawn: u64,
}

impl Draws {
    /// Returns a number from 0 to below 1.
    pub(crate) fn unit(&mut self) -> f64 {
        self.drawn += 1;
        (mixed(self.seed, self.drawn) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Returns a whole number below `end`.
    pub(crate) fn below(&mut self, end: usize) -> usize {
        (self.unit() * end as f64) as usize
    }
}
