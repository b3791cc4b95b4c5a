//! Four motor positions in two words, compared two at a time: a control step has few instructions to spare.

use crate::arm::{Move, Pose};

/// Positions of 15 bits in lanes of 16: base and shoulder, elbow and wrist.
pub(super) type Lanes = [u32; 2];

/// The highest bit of both lanes of a word: where a comparison leaves its answer.
pub(super) const TOP: u32 = 0x8000_8000;

/// One lane's number in both lanes of a word.
pub(super) const fn both(number: u16) -> u32 {
    number as u32 | (number as u32) << 16
}

/// The positions of a pose. A negative one has its [`TOP`] bit set.
#[inline(always)]
pub(super) const fn of(Pose([base, shoulder, elbow, wrist]): Pose) -> Lanes {
    const fn pair(low: i16, high: i16) -> u32 {
        low as u16 as u32 | (high as u16 as u32) << 16
    }
    [pair(base, shoulder), pair(elbow, wrist)]
}

/// Leaves the [`TOP`] bit of a lane where `a ≥ b`. For lanes below 2¹⁵; a greater one spoils its neighbour's answer, too.
#[inline(always)]
pub(super) const fn not_less(a: u32, b: u32) -> u32 {
    (a | TOP).wrapping_sub(b)
}

/// Adds a move to positions. Exact where no sum leaves its lane.
#[inline(always)]
pub(super) const fn moved([low, high]: Lanes, Move([base, shoulder, elbow, wrist]): Move) -> Lanes {
    // A negative change borrows from the lane above, which is what adding the next one there expects.
    const fn add(pair: u32, low: i8, high: i8) -> u32 {
        pair.wrapping_add(low as u32).wrapping_add((high as u32) << 16)
    }
    [add(low, base, shoulder), add(high, elbow, wrist)]
}
