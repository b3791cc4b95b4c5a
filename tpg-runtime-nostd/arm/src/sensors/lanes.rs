//! Four motor positions in two words, compared two at a time: a control step has few instructions to spare.
//!
//! A position has 12 bits and its lane 16. An interval is kept so that one addition or subtraction leaves the highest bit of
//! a lane, [`TOP`], where a position is inside. What does not fit into 12 bits, negative positions above all, may carry into
//! the lane above; its own lane says by then that it is outside.

use crate::arm::{Move, Pose};

/// Positions in lanes: base and shoulder, elbow and wrist.
pub(super) type Lanes = [u32; 2];

/// The highest bit of both lanes of a word.
pub(super) const TOP: u32 = 0x8000_8000;

/// The positions of a pose.
#[inline(always)]
pub(super) const fn from_pose(Pose([base, shoulder, elbow, wrist]): Pose) -> Lanes {
    const fn pair(low: i16, high: i16) -> u32 {
        low as u16 as u32 | (high as u16 as u32) << 16
    }
    [pair(base, shoulder), pair(elbow, wrist)]
}

/// A fixed interval for each position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ranges {
    /// [`TOP`] less the lower ends: at `a` the sum has the bit where `a` is not less.
    below: Lanes,
    /// [`TOP`] and the upper ends: at `a` the difference has the bit where `a` is not greater.
    above: Lanes,
}

impl Ranges {
    /// From `lower` to `upper`, positions of 12 bits and none of the lower greater than its upper.
    pub(super) fn new(lower: Lanes, upper: Lanes) -> Self {
        Self { below: lower.map(|pair| TOP - pair), above: upper.map(|pair| TOP | pair) }
    }

    /// Leaves the [`TOP`] bits of both words where all positions are in their intervals, for any 16 bits.
    ///
    /// For a negative one: the sum overflows its lane and loses the bit, or the difference lies below it.
    #[inline(always)]
    pub(super) const fn hold(&self, [low, high]: Lanes) -> u32 {
        let Self { below, above } = self;
        low.wrapping_add(below[0])
            & above[0].wrapping_sub(low)
            & high.wrapping_add(below[1])
            & above[1].wrapping_sub(high)
    }
}

/// An interval of one width around each position that is expected.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Expected {
    /// [`TOP`] less the lower ends.
    below: Lanes,
    /// The width in both lanes, and one more in the upper: the lower always borrows it.
    width: u32,
}

impl Expected {
    /// Around positions of 12 bits, by up to 4096 on either side.
    pub(super) fn around(at: Lanes, by: u16) -> Self {
        let by = u32::from(by) * 0x0001_0001;
        Self { below: at.map(|pair| (TOP | by).wrapping_sub(pair)), width: (2 * by).wrapping_add(0x0001_0000) }
    }

    /// The same width around other positions.
    pub(super) fn anew(&self, at: Lanes) -> Self {
        Self::around(at, (self.width as u16) / 2)
    }

    /// Leaves the [`TOP`] bits of both words where all positions, of 12 bits, are in their intervals.
    #[inline(always)]
    pub(super) const fn hold(&self, [low, high]: Lanes) -> u32 {
        // The bit, and the distance from the lower end. Less than the bit where there is none, and then nothing else matters.
        let (low, high) = (low.wrapping_add(self.below[0]), high.wrapping_add(self.below[1]));
        // Width − distance − 2¹⁵, which is 2¹⁵ + width − distance: it has the bit where the distance is not greater.
        low & self.width.wrapping_sub(low) & high & self.width.wrapping_sub(high)
    }

    /// Moves the intervals.
    #[inline(always)]
    pub(super) const fn shift(&mut self, Move([base, shoulder, elbow, wrist]): Move) {
        // A negative change borrows from the lane above: adding the next one there makes that good.
        const fn pair(low: i8, high: i8) -> u32 {
            (low as u32).wrapping_add((high as u32) << 16)
        }
        let [low, high] = self.below;
        self.below = [low.wrapping_sub(pair(base, shoulder)), high.wrapping_sub(pair(elbow, wrist))];
    }
}
